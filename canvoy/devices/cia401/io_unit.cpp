#include "canvoy/devices/cia401/io_unit.hpp"

#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/devices/cia401/scaling.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia401 {

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
      timer_(Callback<void(Time)>::to<&IoUnit::expired>(*this)) {
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
