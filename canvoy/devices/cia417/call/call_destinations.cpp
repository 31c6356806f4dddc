// The destination calls of a call controller: who names his destination before he gets in, or in
// the car (CiA 417-4, 4.3.1: basic functions 08h to 0Dh).
#include <algorithm>

#include "canvoy/devices/cia417/call/call_controller.hpp"

namespace canvoy::cia417 {

namespace {

VirtualOutput answer_to(const VirtualInput& destination_call, bool on, std::uint8_t lifts) {
  return {.function = destination_call.function,
          .sub_function = destination_call.sub_function,
          .lifts = lifts,
          .floor = destination_call.floor,
          .doors = destination_call.doors,
          .data = output_data(on, Property::standard, 0, on)};
}

}  // namespace

Call source_call_of(const VirtualInput& input, DoorMask doors) {
  const bool goes_up = input.sub_function > input.floor;
  return {goes_up ? CallKind::up : CallKind::down, priority_of(input.function), input.floor, doors};
}

void CallController::take_destination(const VirtualInput& input) {
  if (input.floor == floor_of_car) return take_destination_in_car(input);
  const DoorMask there = doors_at(input.sub_function);
  const DoorMask here = doors_at(input.floor);
  const DoorMask wanted = destination_doors(input.doors);
  const bool possible = input.floor != input.sub_function && FloorSet::is_floor(input.floor) &&
                        FloorSet::is_floor(input.sub_function) && here != 0 && there != 0 &&
                        (source_doors(input.doors) & ~here) == 0 && (wanted & ~there) == 0 &&
                        (accepted_ & hall_calls) != 0 && !is_locked(input.sub_function) &&
                        !is_on(SpecialFunction::hall_call_disable);
  if (possible && offered_(input)) return;
  if (!possible) return refuse_destination(input);
  acknowledge_destination(input, add_destination(input), lift_mask());
}

/// Who names his destination in the car has no source floor to wait at: it is a car call, which his
/// panel is told of by the function that he asked with, too.
void CallController::take_destination_in_car(const VirtualInput& input) {
  const Call call = target_call_of(input);
  if (!is_car_call_possible(call)) return refuse_destination(input);
  const bool is_kept = find_or_make(input) != nullptr;
  if (is_kept) register_call(call);
  acknowledge_destination(input, is_kept, lift_mask());
}

/// One that came before, and was affirmed, is still to be answered.
void CallController::refuse_destination(const VirtualInput& input) {
  Destination* const known = find(input);
  if (known != nullptr && known->told) {
    known->wants_answer = true;
  } else {
    answer(input, false, lift_mask());
  }
  show();
}

bool CallController::add_destination(const VirtualInput& input) {
  Destination* const destination = find_or_make(input);
  if (destination == nullptr) return false;
  destination->active = true;
  const DoorMask at_panel = source_doors(input.doors);
  add(source_call_of(input, at_panel == 0 ? doors_at(input.floor) : at_panel));
  return true;
}

void CallController::withdraw_destination(const VirtualInput& input) {
  Destination* const found = find(input);
  if (found == nullptr) return;
  found->active = false;
  const Call source = source_call_of(input, 0x0F);
  if (!is_needed(source)) calls_.remove(source);
}

/// Somebody else waits there: another destination call, or a hall call that panels show, which may
/// be that of this lift.
bool CallController::is_needed(const Call& source) const {
  return shown_.contains(source) ||
         std::ranges::any_of(destinations(), [&](const Destination& other) {
           return other.active && source_call_of(other.input, 0x0F) == source;
         });
}

void CallController::acknowledge_destination(const VirtualInput& input, bool on,
                                             std::uint8_t lifts) {
  if (Destination* const destination = find_or_make(input); destination != nullptr) {
    // The passengers of one lift are gone, and another one is shown to those who came later.
    if (!on && destination->told && destination->lifts != lifts) return;
    destination->told = on;
    destination->lifts = lifts;
    destination->wants_answer = true;
  } else {
    ++destinations_without_room_;
    answer(input, on, lifts);
  }
  show();
}

/// Of a call that is not kept.
void CallController::answer(const VirtualInput& input, bool on, std::uint8_t lifts) {
  if (!answers_.push(encode(answer_to(input, on, lifts)))) ++answers_lost_;
}

void CallController::board(Destination& destination) {
  destination.end();
  register_call(target_call_of(destination.input));
}

CallController::Destination* CallController::find(const VirtualInput& input) {
  for (Destination& destination : destinations()) {
    const VirtualInput& known = destination.input;
    if (destination.is_used() && known.function == input.function &&
        known.sub_function == input.sub_function && known.floor == input.floor &&
        known.doors == input.doors) {
      return &destination;
    }
  }
  return nullptr;
}

CallController::Destination* CallController::find_or_make(const VirtualInput& input) {
  if (Destination* const found = find(input); found != nullptr) return found;
  const auto free = std::ranges::find_if_not(destinations_, &Destination::is_used);
  if (free == destinations_.end()) return nullptr;
  destinations_used_ =
      std::max(destinations_used_, static_cast<std::size_t>(free - destinations_.begin()) + 1);
  *free = {.input = input};
  return &*free;
}

bool CallController::destination_waits() const {
  return std::ranges::any_of(destinations(),
                             [](const Destination& item) { return item.wants_answer; });
}

/// One that has ended, and was asked for again since, is shown as that.
void CallController::show_destinations_again() {
  for (Destination& destination : destinations()) {
    if (destination.told || (destination.was_told && find(destination.input) == nullptr)) {
      destination.wants_answer = true;
    }
  }
}

VirtualOutput CallController::next_destination() {
  for (Destination& destination : destinations()) {
    if (!destination.wants_answer) continue;
    destination.wants_answer = false;
    destination.was_told = destination.was_told || destination.told;
    return answer_to(destination.input, destination.told, destination.lifts);
  }
  return {};
}

}  // namespace canvoy::cia417
