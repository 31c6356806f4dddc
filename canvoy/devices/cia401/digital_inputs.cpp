#include "canvoy/devices/cia401/digital_inputs.hpp"

#include <algorithm>

#include "canvoy/devices/cia401/widths.hpp"

namespace canvoy::cia401 {

namespace {

// From the object with the values.
constexpr std::uint16_t to_input_polarity = 2;
constexpr std::uint16_t to_filter = 3;
constexpr std::uint16_t to_any_change = 6;
constexpr std::uint16_t to_low_to_high = 7;
constexpr std::uint16_t to_high_to_low = 8;

}  // namespace

DigitalInputs::DigitalInputs(Node& node, std::span<DigitalInputGroup> groups, Sense sense,
                             const DigitalInputSettings& settings)
    : node_(node),
      groups_(groups),
      sense_(sense),
      settings_(settings),
      timer_(Callback<void(Time)>::to<&DigitalInputs::expired>(*this)) {}

void DigitalInputs::begin() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    groups_[i].sensed = groups_[i].accepted = sense_(static_cast<unsigned>(i + 1));
  }
  node_.timers().disarm(timer_);
  tell(Telling::nothing);
}

void DigitalInputs::look(Time now) {
  node_.timers().disarm(timer_);
  bool has_changed = false;
  for (std::size_t i = 0; i < groups_.size(); ++i) has_changed = filter(i, now) || has_changed;
  if (has_changed) tell(Telling::events);
}

void DigitalInputs::show() {
  tell(Telling::nothing);
}

/// What has changed is accepted at once, or when it has stayed for the filter time: true, where
/// anything was accepted. Where nothing moves, which is nearly always, no object is looked up.
bool DigitalInputs::filter(std::size_t group, Time now) {
  DigitalInputGroup& inputs = groups_[group];
  const std::uint8_t sensed = sense_(static_cast<unsigned>(group + 1));
  const std::uint8_t before = inputs.accepted;
  if (sensed == before && sensed == inputs.sensed) return false;
  const std::uint8_t is_filtered = filtered(group);
  const auto ticks = static_cast<std::uint32_t>(now.time_since_epoch().count());
  const auto filter_ticks = static_cast<std::uint32_t>(settings_.filter_time.count());
  for (unsigned i = 0; i < 8; ++i) {
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

std::uint8_t DigitalInputs::filtered(std::size_t group) const {
  std::uint32_t all = 0;
  for (const Width& width : input_widths) {
    const auto sub = static_cast<std::uint8_t>(group / width.bytes + 1);
    const std::uint32_t wide =
        node_.dictionary().word(static_cast<std::uint16_t>(width.index + to_filter), sub);
    all |= wide >> 8 * (group % width.bytes);
  }
  return static_cast<std::uint8_t>(all);
}

/// The inputs of one element.
std::uint32_t DigitalInputs::accepted(unsigned sub, unsigned bytes) const {
  std::uint32_t made = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    const std::size_t group = std::size_t{sub - 1} * bytes + i;
    if (group < groups_.size()) made |= std::uint32_t{groups_[group].accepted} << 8 * i;
  }
  return made;
}

void DigitalInputs::tell(Telling telling) {
  Dictionary& dictionary = node_.dictionary();
  const bool is_enabled = Values(dictionary)[global_interrupt_enable_digital].is_set();
  for (const Width& width : input_widths) {
    for (unsigned sub = 1; sub <= channels_max; ++sub) {
      const Result<Entry> entry = dictionary.find(width.index, static_cast<std::uint8_t>(sub));
      if (!entry) break;
      const auto parameter = [&](std::uint16_t offset) {
        return dictionary.word(static_cast<std::uint16_t>(width.index + offset),
                               static_cast<std::uint8_t>(sub));
      };
      const std::uint32_t before = entry->word();
      const std::uint32_t value =
          in_bytes(accepted(sub, width.bytes) ^ parameter(to_input_polarity), width.bytes);
      const std::uint32_t changed = before ^ value;
      if (changed == 0) continue;
      const std::uint32_t events =
          changed & (parameter(to_any_change) | (value & parameter(to_low_to_high)) |
                     (~value & parameter(to_high_to_low)));
      const bool is_told = telling == Telling::events && is_enabled && events != 0;
      put(dictionary, *entry, value, is_told);
    }
  }
}

}  // namespace canvoy::cia401
