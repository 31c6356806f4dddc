#include "canvoy/devices/cia401/digital_inputs.hpp"

#include <algorithm>

#include "canvoy/devices/cia401/digital_event.hpp"

namespace canvoy::cia401 {

namespace {

constexpr std::uint16_t to_filter = 3;  ///< from the object with the values

constexpr unsigned inputs_of_group = 8;
constexpr unsigned inputs_of_bit_object = 128;

/// Position of this group, counted from 0, among the groups of an element of this number of bytes.
constexpr unsigned element_of(unsigned group, const Width& width) {
  return (group - 1) / width.bytes + 1;
}

}  // namespace

DigitalInputs::DigitalInputs(Node& node, std::span<DigitalInputGroup> groups, Sense sense,
                             const DigitalInputSettings& settings)
    : node_(node),
      groups_(groups),
      sense_(sense),
      settings_(settings),
      timer_(Callback<void(Time)>::to<&DigitalInputs::expired>(*this)) {
  std::size_t next = 0;
  for_each_element(node.dictionary(), read_input_8_bit_object.index, [&](std::uint8_t sub) {
    if (next < groups_.size()) groups_[next++].number = sub;
  });
  groups_ = groups_.first(next);
}

void DigitalInputs::begin() {
  for (DigitalInputGroup& inputs : groups_) inputs.sensed = inputs.accepted = sense_(inputs.number);
  node_.timers().disarm(timer_);
  tell_all(Telling::nothing);
}

/// Without a change, which is nearly always the case, no object is looked up.
void DigitalInputs::look(Time now) {
  node_.timers().disarm(timer_);
  bool has_changed = false;
  for (DigitalInputGroup& inputs : groups_) {
    inputs.has_changed = filter(inputs, now);
    has_changed = inputs.has_changed || has_changed;
  }
  if (has_changed) tell_all(Telling::events);
}

void DigitalInputs::show() {
  tell_all(Telling::nothing);
}

/// Accepts a change at once, or after it has been stable for the filter time. True if any was
/// accepted.
bool DigitalInputs::filter(DigitalInputGroup& inputs, Time now) {
  const std::uint8_t sensed = sense_(inputs.number);
  const std::uint8_t before = inputs.accepted;
  if (sensed == before && sensed == inputs.sensed) return false;
  const std::uint8_t is_filtered = filtered(inputs.number);
  const auto ticks = static_cast<std::uint32_t>(now.time_since_epoch().count());
  const auto filter_ticks = static_cast<std::uint32_t>(settings_.filter_time.count());
  for (unsigned i = 0; i < inputs_of_group; ++i) {
    const auto bit = static_cast<std::uint8_t>(1U << i);
    if (((sensed ^ inputs.sensed) & bit) != 0) inputs.since[i] = ticks;
    if (((sensed ^ inputs.accepted) & bit) == 0) continue;
    const std::uint32_t age = ticks - inputs.since[i];
    if ((is_filtered & bit) == 0 || age >= filter_ticks) {
      inputs.accepted ^= bit;
    } else {
      const Time over = now + Duration(filter_ticks - age);
      if (!timer_.armed() || over < timer_.at()) node_.timers().arm(timer_, over);
    }
  }
  inputs.sensed = sensed;
  return inputs.accepted != before;
}

std::uint8_t DigitalInputs::filtered(unsigned group) const {
  std::uint32_t all = 0;
  for (const Width& width : input_widths) {
    const auto sub = static_cast<std::uint8_t>(element_of(group, width));
    const std::uint32_t wide =
        node_.dictionary().word(static_cast<std::uint16_t>(width.index + to_filter), sub);
    all |= wide >> 8 * ((group - 1) % width.bytes);
  }
  return static_cast<std::uint8_t>(all);
}

const DigitalInputGroup* DigitalInputs::find_group(unsigned number) const {
  // Without gaps, it is at its own index.
  if (number <= groups_.size() && groups_[number - 1].number == number) return &groups_[number - 1];
  const auto found = std::ranges::find(groups_, number, &DigitalInputGroup::number);
  return found == groups_.end() ? nullptr : &*found;
}

/// The inputs of one element.
std::uint32_t DigitalInputs::accepted(unsigned sub, unsigned bytes) const {
  std::uint32_t made = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    const DigitalInputGroup* group = find_group((sub - 1) * bytes + i + 1);
    if (group != nullptr) made |= std::uint32_t{group->accepted} << 8 * i;
  }
  return made;
}

void DigitalInputs::tell_all(Telling telling) {
  const bool is_enabled =
      node_.dictionary().word(global_interrupt_enable_digital_object.index, 0, 1) != 0;
  const bool may_tell = telling == Telling::events && is_enabled;
  for (const DigitalInputGroup& inputs : groups_) {
    if (telling == Telling::nothing || inputs.has_changed) tell(inputs.number, may_tell);
  }
}

void DigitalInputs::tell(unsigned group, bool may_tell) {
  for (const Width& width : input_widths) tell_element(width, element_of(group, width), may_tell);
}

void DigitalInputs::tell_element(const Width& width, unsigned sub, bool may_tell) {
  Dictionary& dictionary = node_.dictionary();
  const auto number = static_cast<std::uint8_t>(sub);
  const Result<Entry> entry = dictionary.find(width.index, number);
  if (!entry) return;
  const std::uint32_t before = entry->word();
  const std::uint32_t value = in_bytes(
      with_polarity(dictionary, width.index, number, accepted(sub, width.bytes)), width.bytes);
  if (value == before) return;
  const std::uint32_t events = events_of_change(dictionary, width.index, number, before, value);
  put(dictionary, *entry, value, may_tell && events != 0);
  if (width.bytes == 1) tell_bits(sub, value, may_tell ? events : 0);
}

/// Shows the inputs one by one, if the device has objects for that: events are those of the 8-bit
/// object.
void DigitalInputs::tell_bits(unsigned group, std::uint32_t value, std::uint32_t events) {
  Dictionary& dictionary = node_.dictionary();
  for (unsigned i = 0; i < inputs_of_group; ++i) {
    const unsigned input = (group - 1) * inputs_of_group + i;
    const Result<Entry> entry = dictionary.find(
        static_cast<std::uint16_t>(read_input_bit_object.index + input / inputs_of_bit_object),
        static_cast<std::uint8_t>(input % inputs_of_bit_object + 1));
    if (!entry) return;
    const std::uint32_t is_on = value >> i & 1;
    if (entry->word() != is_on) put(dictionary, *entry, is_on, (events >> i & 1) != 0);
  }
}

}  // namespace canvoy::cia401
