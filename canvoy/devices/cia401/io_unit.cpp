#include "canvoy/devices/cia401/io_unit.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/devices/cia401/digital_event.hpp"
#include "canvoy/devices/cia401/scaling.hpp"
#include "canvoy/profiles/model/reactions.hpp"

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
      timer_(callback<&DigitalInputs::expired>(*this)) {
  std::size_t next = 0;
  for_each_element(node.dictionary(), read_input_8_bit_object.index, [&](std::uint8_t sub) {
    if (next < groups_.size()) groups_[next++].number = sub;
  });
  groups_ = groups_.first(next);
}

void DigitalInputs::begin() {
  for (DigitalInputGroup& inputs : groups_) inputs.sensed = inputs.accepted = sense_(inputs.number);
  node_.timers().disarm(timer_);
  report_all(Telling::nothing);
}

/// Without a change, which is nearly always the case, no object is looked up.
void DigitalInputs::look(Time now) {
  node_.timers().disarm(timer_);
  bool has_changed = false;
  for (DigitalInputGroup& inputs : groups_) {
    inputs.has_changed = filter(inputs, now);
    has_changed = inputs.has_changed || has_changed;
  }
  if (has_changed) report_all(Telling::events);
}

void DigitalInputs::show() {
  report_all(Telling::nothing);
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

void DigitalInputs::report_all(Telling telling) {
  const bool is_enabled =
      node_.dictionary().word(global_interrupt_enable_digital_object.index, 0, 1) != 0;
  const bool may_tell = telling == Telling::events && is_enabled;
  for (const DigitalInputGroup& inputs : groups_) {
    if (telling == Telling::nothing || inputs.has_changed) tell(inputs.number, may_tell);
  }
}

void DigitalInputs::tell(unsigned group, bool may_tell) {
  for (const Width& width : input_widths) report_element(width, element_of(group, width), may_tell);
}

void DigitalInputs::report_element(const Width& width, unsigned sub, bool may_tell) {
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
  if (width.bytes == 1) report_bits(sub, value, may_tell ? events : 0);
}

/// Shows the inputs one by one, if the device has objects for that: events are those of the 8-bit
/// object.
void DigitalInputs::report_bits(unsigned group, std::uint32_t value, std::uint32_t events) {
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

namespace {

// Distance from the object with the values.
constexpr std::uint16_t to_output_polarity = 2;
constexpr std::uint16_t to_error_mode = 6;
constexpr std::uint16_t to_error_value = 7;
constexpr std::uint16_t to_filter_mask = 8;

/// The 8 bits of a group in an object beside the values; wider objects have the same bits.
std::uint8_t of_group(const Dictionary& dictionary, std::uint16_t offset, std::size_t group) {
  const auto index = static_cast<std::uint16_t>(output_widths[0].index + offset);
  return static_cast<std::uint8_t>(dictionary.word(index, static_cast<std::uint8_t>(group + 1)));
}

/// Copies a written parameter of one width to the others.
void share(Dictionary& dictionary, const Width& written, std::uint16_t offset, std::size_t group,
           std::uint8_t value) {
  for (const Width& width : output_widths) {
    if (width.index == written.index) continue;
    const Result<Entry> entry = dictionary.find(static_cast<std::uint16_t>(width.index + offset),
                                                static_cast<std::uint8_t>(group / width.bytes + 1));
    if (entry) entry->value[group % width.bytes] = value;
  }
}

}  // namespace

void DigitalOutputs::begin() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    groups_[i] = of_group(node_.dictionary(), 0, i);
    drive(i);
  }
  show(0, groups_.size());
}

void DigitalOutputs::written(std::uint16_t index, std::uint8_t sub) {
  for (const Width& width : output_widths) {
    const auto offset = static_cast<std::uint16_t>(index - width.index);
    if (offset > to_filter_mask || sub == 0) continue;
    Dictionary& dictionary = node_.dictionary();
    const std::uint32_t value = dictionary.word(index, sub);
    const std::uint32_t which =
        dictionary.word(static_cast<std::uint16_t>(width.index + to_filter_mask), sub, ~0U);
    const std::size_t first = std::size_t{sub - 1U} * width.bytes;
    const std::size_t end = std::min(first + width.bytes, groups_.size());
    for (std::size_t group = first; group < end; ++group) {
      const std::size_t shift = 8 * (group - first);
      if (offset == 0) {
        change(group, value >> shift, which >> shift);
      } else {
        share(dictionary, width, offset, group, static_cast<std::uint8_t>(value >> shift));
      }
      drive(group);
    }
    return show(first, end);
  }
}

void DigitalOutputs::fail() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    change(i, of_group(node_.dictionary(), to_error_value, i),
           of_group(node_.dictionary(), to_error_mode, i));
    drive(i);
  }
  show(0, groups_.size());
}

void DigitalOutputs::change(std::size_t group, std::uint32_t value, std::uint32_t which) {
  groups_[group] = static_cast<std::uint8_t>((groups_[group] & ~which) | (value & which));
}

void DigitalOutputs::drive(std::size_t group) {
  const std::uint8_t polarity = of_group(node_.dictionary(), to_output_polarity, group);
  drive_(static_cast<unsigned>(group + 1), groups_[group] ^ polarity);
}

/// In all objects that have them; other elements, which the same PDO may have written, are not
/// changed.
void DigitalOutputs::show(std::size_t first, std::size_t end) {
  Dictionary& dictionary = node_.dictionary();
  for (const Width& width : output_widths) {
    for (std::size_t element = first / width.bytes; element * width.bytes < end; ++element) {
      const Result<Entry> entry =
          dictionary.find(width.index, static_cast<std::uint8_t>(element + 1));
      if (!entry) break;
      std::uint32_t value = 0;
      for (unsigned i = 0; i < width.bytes; ++i) {
        const std::size_t group = element * width.bytes + i;
        if (group < groups_.size()) value |= std::uint32_t{groups_[group]} << 8 * i;
      }
      if (entry->word() != value) put(dictionary, *entry, value);
    }
  }
}

namespace {

constexpr std::uint16_t first_index = 0x6000;
constexpr std::uint16_t last_index = 0x645F;

constexpr Error inputs_disabled = {.code = analogue_inputs_disabled.code};

constexpr bool is_one_of_inputs(std::uint16_t index) {
  return index < write_output_8_bit_object.index;
}
constexpr bool is_one_of_analogue_inputs(std::uint16_t index) {
  constexpr std::uint16_t first = analogue_input_interrupt_trigger_selection_object.index;
  constexpr std::uint16_t last = analogue_input_scaling_integer_object.index;
  return index >= first && index <= last;
}
constexpr bool is_scaling_of_inputs(std::uint16_t index) {
  return index == input_scaling.offset_integer || index == input_scaling.scaling_integer ||
         index == input_scaling.offset_real || index == input_scaling.scaling_real;
}

}  // namespace

constexpr AccessHandlers IoUnit::hook_calls[] = {
    before_read<&IoUnit::source_is_read, analogue_input_interrupt_source_object>,
    before_write<&IoUnit::check_error_mode, analogue_output_error_mode_object>,
    {.first = first_index, .last = last_index, .after_write = method<&IoUnit::written>}};
constexpr ServiceHandlers IoUnit::service_calls = {
    .reset = method<&IoUnit::reset>,
    .state_entered = method<&IoUnit::state_entered>,
    .bus_state_changed = method<&IoUnit::bus_state_changed>,
    .error_changed = method<&IoUnit::error_changed>,
    .hooks = hook_calls};

IoUnit::IoUnit(Node& node, const IoMemory& memory, const IoHardware& hardware,
               const IoSettings& settings)
    : node_(node),
      settings_(settings),
      has_analogue_inputs_(!memory.analogue_inputs.empty()),
      digital_inputs_(node, memory.digital_inputs, hardware.digital_inputs, settings.digital),
      digital_outputs_(node, memory.digital_outputs, hardware.drive_digital),
      analogue_inputs_(node, memory.analogue_inputs, hardware.analogue_input, settings.analogue,
                       memory.reals),
      analogue_outputs_(node, memory.has_analogue_outputs, hardware.drive_analogue, memory.reals),
      timer_(callback<&IoUnit::expired>(*this)) {
  node.attach(service_);
}

void IoUnit::reset(ResetScope scope) {
  digital_inputs_.begin();
  analogue_inputs_.begin();
  digital_outputs_.begin();
  analogue_outputs_.begin(scope);
  if (settings_.sensing_period > Duration::zero()) {
    node_.timers().arm(timer_, node_.now() + settings_.sensing_period);
  }
}

void IoUnit::expired(Time now) {
  digital_inputs_.look(now);
  analogue_inputs_.look();
  if (settings_.sensing_period > Duration::zero()) {
    node_.timers().arm(timer_, now + settings_.sensing_period);
  }
}

// Failures.

void IoUnit::fail() {
  digital_outputs_.fail();
  analogue_outputs_.fail();
}

void IoUnit::state_entered(NmtState state) {
  if (state == NmtState::stopped) fail();
  warn(state == NmtState::operational);
}

void IoUnit::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) fail();
}

void IoUnit::error_changed(const Error& error, bool present) {
  if (present && error.code == emergency_code::heartbeat) fail();
}

/// Called each time that the node becomes operational.
void IoUnit::warn(bool is_operational) {
  if (!has_analogue_inputs_ || !settings_.warns_of_disabled_inputs) return;
  node_.report(inputs_disabled, is_operational && !analogue_inputs_.are_enabled());
}

// Objects.

void IoUnit::source_is_read(const Entry& entry) {
  analogue_inputs_.source_is_read(entry);
}

/// Modes other than keeping the value and taking the error value are reserved.
AbortCode IoUnit::check_error_mode(const Entry& entry, std::span<const std::uint8_t> value) {
  const bool is_mode = value[0] <= static_cast<std::uint8_t>(ErrorMode::take_error_value);
  return entry.sub == 0 || is_mode ? AbortCode::none : AbortCode::value_range;
}

void IoUnit::written(const Entry& entry, Source) {
  if (is_one_of_inputs(entry.index)) return digital_inputs_.show();
  if (is_one_of_analogue_inputs(entry.index)) return analogue_parameter_written(entry);
  digital_outputs_.written(entry.index, entry.sub);
  analogue_outputs_.written(entry.index, entry.sub);
}

/// Limits and deltas count from the next check on; changes that are still to be sent are sent.
void IoUnit::analogue_parameter_written(const Entry& entry) {
  if (entry.index == analogue_input_global_interrupt_enable_object.index) {
    if (analogue_inputs_.are_enabled()) node_.clear(inputs_disabled);
  } else if (is_scaling_of_inputs(entry.index)) {
    analogue_inputs_.rescale(entry.sub);
  }
}

}  // namespace canvoy::cia401
