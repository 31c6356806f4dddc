#include "canvoy/devices/cia417/call/destination_calls.hpp"

#include <algorithm>

namespace canvoy::cia417 {

void DestinationCalls::begin_anew() {
  std::ranges::fill(slots_, Slot{});
  used_ = 0;
}

bool DestinationCalls::add(const VirtualInput& input) {
  Slot* const slot = find_or_make(input);
  if (slot != nullptr) slot->active = true;
  return slot != nullptr;
}

bool DestinationCalls::withdraw(const VirtualInput& input) {
  Slot* const slot = find(input);
  if (slot != nullptr) slot->active = false;
  return slot != nullptr;
}

bool DestinationCalls::has_source(const Call& source) const {
  return std::ranges::any_of(used(), [&](const Slot& slot) {
    return slot.active && source_call_of(slot.input, all_doors) == source;
  });
}

DestinationCalls::Answer DestinationCalls::tell(const VirtualInput& input, bool on,
                                                std::uint8_t lifts) {
  Slot* const slot = find_or_make(input);
  if (slot == nullptr) return Answer::no_room;
  // The passengers of one lift are gone, and later ones are shown another lift.
  if (!on && slot->told && slot->lifts != lifts) return Answer::others;
  slot->told = on;
  slot->lifts = lifts;
  slot->wants_answer = true;
  return Answer::kept;
}

bool DestinationCalls::report_again(const VirtualInput& input) {
  Slot* const slot = find(input);
  const bool is_shown = slot != nullptr && slot->told;
  if (is_shown) slot->wants_answer = true;
  return is_shown;
}

void DestinationCalls::report_all_again() {
  for (Slot& slot : slots_.first(used_)) {
    const bool has_ended = slot.was_told && find(slot.input) == nullptr;
    if (slot.told || has_ended) slot.wants_answer = true;
  }
}

void DestinationCalls::cancel(CallKinds kinds) {
  for (Slot& slot : slots_.first(used_)) {
    const CallKinds its_kinds = slot.is_in_car() ? car_calls : hall_calls;
    if ((kinds & its_kinds) == its_kinds) slot.end();
  }
}

bool DestinationCalls::waits() const {
  return std::ranges::any_of(used(), &Slot::wants_answer);
}

VirtualOutput DestinationCalls::next() {
  for (Slot& slot : slots_.first(used_)) {
    if (!slot.wants_answer) continue;
    slot.wants_answer = false;
    slot.was_told = slot.was_told || slot.told;
    return answer_to(slot.input, slot.told, slot.lifts);
  }
  return {};
}

DestinationCalls::Slot* DestinationCalls::find(const VirtualInput& input) {
  for (Slot& slot : slots_.first(used_)) {
    const VirtualInput& known = slot.input;
    if (slot.is_used() && known.function == input.function &&
        known.sub_function == input.sub_function && known.floor == input.floor &&
        known.doors == input.doors) {
      return &slot;
    }
  }
  return nullptr;
}

DestinationCalls::Slot* DestinationCalls::find_or_make(const VirtualInput& input) {
  if (Slot* const found = find(input); found != nullptr) return found;
  const auto free = std::ranges::find_if_not(slots_, &Slot::is_used);
  if (free == slots_.end()) return nullptr;
  used_ = std::max(used_, static_cast<std::size_t>(free - slots_.begin()) + 1);
  *free = {.input = input};
  return &*free;
}

}  // namespace canvoy::cia417
