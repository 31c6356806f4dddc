#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"

#include <algorithm>

#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/devices/cia417/virtual_io/output_address.hpp"

namespace canvoy::cia417 {

namespace {

constexpr std::uint32_t tenth_of_second = 100'000;  // us

// Bytes of the parameters.
constexpr unsigned default_value_byte = 3;
constexpr unsigned impulse_time_byte = 3;
constexpr unsigned polarity_byte = 1;
constexpr unsigned lit_bit = 0x01;

}  // namespace

constexpr AccessHandlers OutputPanelUnit::output_hook = {
    .first = output_group_object.index,
    .last = output_parameter_4_object.index + group_count - 1,
    .before_write = method<&OutputPanelUnit::before_write>,
    .after_write = method<&OutputPanelUnit::written>};
constexpr AccessHandlers OutputPanelUnit::hook_calls[] = {
    {.first = virtual_output_mapping_object.index,
     .last = virtual_output_mapping_object.index,
     .after_write = method<&OutputPanelUnit::record_came>},
    in_lift(1, output_hook),
    in_lift(2, output_hook),
    in_lift(3, output_hook),
    in_lift(4, output_hook),
    in_lift(5, output_hook),
    in_lift(6, output_hook),
    in_lift(7, output_hook),
    in_lift(8, output_hook)};
constexpr ServiceHandlers OutputPanelUnit::service_calls = {
    .reset = method<&OutputPanelUnit::reset>, .hooks = hook_calls};

OutputPanelUnit::OutputPanelUnit(Node& node, std::span<OutputState> states,
                                 const OutputHardware& hardware,
                                 const OutputPanelSettings& settings)
    : node_(node),
      groups_(node.dictionary().tables(), output_group_object.index),
      states_(states),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&OutputPanelUnit::expire>(*this)) {
  node.attach(service_);
}

VirtualOutput OutputPanelUnit::output(std::uint32_t output) const {
  const IoPlace place = groups_.place(output);
  return decode_output(node_.dictionary().number(place.index, place.sub));
}

OutputView OutputPanelUnit::view(std::uint32_t output) const {
  const IoPlace place = groups_.place(output);
  const VirtualOutput record = this->output(output);
  OutputView view = view_of({record.data}, {.flash_rate = parameter(place, 4, 0),
                                            .scroll_rate = parameter(place, 4, 1),
                                            .color = parameter(place, 4, 2),
                                            .intensity = parameter(place, 4, 3)});
  const std::uint8_t polarity = parameter(place, 3, polarity_byte);
  view.inverted = polarity != parameter_not_used && (polarity & polarity_bit) != 0;
  view.sub_function = record.sub_function;
  view.on = view.on && is_enabled(place);
  return view;
}

std::uint32_t OutputPanelUnit::find(BasicFunction function, std::uint8_t sub_function,
                                    std::uint8_t floor) const {
  std::uint32_t found = io_nowhere;
  for_each_of(function, [&](std::uint32_t output, IoPlace place) {
    const VirtualOutput record = assigned(output, place);
    const bool is_it = record.sub_function == sub_function && record.floor == floor;
    if (is_it && found == io_nowhere) found = output;
  });
  return found;
}

void OutputPanelUnit::report(std::uint32_t output, std::uint8_t error_code) {
  if (output >= states_.size()) return;
  set_parameter_byte(node_.dictionary(), groups_.place(output), 1, error_code_byte, error_code);
}

/// A reset of communication alone changes no lamp.
void OutputPanelUnit::reset(ResetScope scope) {
  if (scope == ResetScope::communication) return;
  node_.timers().disarm(timer_);
  groups_.for_each([this](std::uint32_t output, IoPlace place) {
    if (output >= states_.size()) return;
    VirtualOutput record = this->output(output);
    if (output < settings_.outputs.size()) record = settings_.outputs[output];
    const std::uint8_t initial = parameter(place, 1, default_value_byte);
    if (initial != parameter_not_used) record.data = initial;
    states_[output] = {.assigned = record.sub_function};
    store(place, record);
    show(output);
  });
}

// Written records

AbortCode OutputPanelUnit::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  return check_event_counts(entry, value, output_parameter_2_object.index);
}

/// A record that is written into the group assigns the output, and is shown at once.
void OutputPanelUnit::written(const Entry& entry, Source) {
  const IoPlace written{entry.index, entry.sub};
  const IoPlace place = place_of_parameter(written, output_group_object.index);
  const std::uint32_t output = groups_.position(place);
  if (output >= states_.size()) return;
  if (written != place) return show(output);
  const VirtualOutput record = this->output(output);
  states_[output] = {.assigned = record.sub_function};
  apply(output, place, record.sub_function, record.data);
  wake();
}

/// Each panel of a lift receives each record, and most are for others.
void OutputPanelUnit::record_came(const Entry& entry, Source) {
  const VirtualOutput record = decode_output(canvoy::load<std::uint64_t>(entry.value));
  bool is_for_any = false;
  for_each_of(record.function, [&](std::uint32_t output, IoPlace place) {
    // The enable byte is looked up last.
    if (!is_addressed(record, assigned(output, place)) || !is_enabled(place)) return;
    is_for_any = true;
    message(output, place, record);
  });
  if (is_for_any) wake();
}

/// Calls visit(output, place) for the outputs with this function, the first byte of their records:
/// these are adjacent, so that one look-up in a group serves all.
template <class Visit>
void OutputPanelUnit::for_each_of(BasicFunction function, Visit visit) const {
  groups_.for_each_group([&](std::uint32_t output, std::uint16_t index, unsigned count) {
    Entry entry{.index = index, .sub = 1};
    const std::size_t known = std::max<std::size_t>(output, states_.size()) - output;
    const auto last = static_cast<unsigned>(std::min<std::size_t>(count, known));
    if (node_.dictionary().locate(entry) != AbortCode::none) return;
    for (unsigned sub = 1; sub <= last; ++sub, ++output, entry.value += entry.row->pitch()) {
      if (*entry.value != static_cast<std::uint8_t>(function)) continue;
      visit(output, IoPlace{index, static_cast<std::uint8_t>(sub)});
    }
  });
}

std::uint8_t OutputPanelUnit::parameter(IoPlace place, unsigned number, unsigned byte) const {
  return parameter_byte(node_.dictionary(), place, number, byte);
}

bool OutputPanelUnit::is_enabled(IoPlace place) const {
  return (parameter(place, 1, enable_byte) & 1) != 0;
}

/// The record of the output, with the sub-function by which it is addressed.
VirtualOutput OutputPanelUnit::assigned(std::uint32_t output, IoPlace place) const {
  VirtualOutput record = decode_output(node_.dictionary().number(place.index, place.sub));
  record.sub_function = states_[output].assigned;
  return record;
}

// Messages

void OutputPanelUnit::message(std::uint32_t output, IoPlace place, const VirtualOutput& record) {
  OutputState& state = states_[output];
  if (state.impulse || !is_event(state, place)) return;
  const bool shows = shows_sub_function(record.function);
  const bool all_off = record.function == BasicFunction::special_indication &&
                       record.sub_function == sub_function_of(SpecialIndication::all_off);
  const bool has_own = record.function == BasicFunction::special_indication &&
                       state.assigned != any_special_indication;
  const std::uint8_t sub_function = shows && !has_own ? record.sub_function : state.assigned;
  const auto data = static_cast<std::uint8_t>(record.data & (all_off ? ~lit_bit : 0xFFU));
  if (is_allowed(state, place)) return apply(output, place, sub_function, data);
  state.held = true;
  state.held_sub_function = sub_function;
  state.held_data = data;
}

/// Counts the message against the reception event.
bool OutputPanelUnit::is_event(OutputState& state, IoPlace place) {
  const std::uint8_t needed = parameter(place, 2, start_event_byte);
  if (needed == parameter_not_used || needed == 0) return true;
  ++state.messages;
  if (state.messages < needed) return false;
  state.messages = 0;
  return true;
}

/// Counts the event against the limitation.
bool OutputPanelUnit::is_allowed(OutputState& state, IoPlace place) {
  const std::uint8_t limitation = parameter(place, 2, limitation_byte);
  if (limitation == parameter_not_used) return true;
  if (!state.counting) {
    state.counting = true;
    state.events = 0;
    state.second_at = low_ticks(node_.now()) + one_second;
  }
  if (state.events < parameter_not_used) ++state.events;
  return state.events <= limitation;
}

void OutputPanelUnit::apply(std::uint32_t output, IoPlace place, std::uint8_t sub_function,
                            std::uint8_t data) {
  OutputState& state = states_[output];
  VirtualOutput record = this->output(output);
  record.sub_function = sub_function;
  record.data = data;
  store(place, record);
  const std::uint32_t time = impulse_time(place, {data});
  state.held = false;
  state.impulse = time != 0 && OutputData{data}.status();
  state.off_at = low_ticks(node_.now()) + time;
  show(output);
}

/// In microseconds; 0: it stays on.
std::uint32_t OutputPanelUnit::impulse_time(IoPlace place, OutputData data) const {
  if (data.property() == Property::impulse) return impulse_milliseconds[data.parameter()] * 1000U;
  const std::uint8_t tenths = parameter(place, 2, impulse_time_byte);
  return tenths == parameter_not_used ? 0 : tenths * tenth_of_second;
}

void OutputPanelUnit::store(IoPlace place, const VirtualOutput& record) {
  node_.dictionary().set_number(place.index, place.sub, encode(record));
}

void OutputPanelUnit::show(std::uint32_t output) const {
  if (hardware_.show) hardware_.show(output, view(output));
}

// Time

void OutputPanelUnit::expire(Time now) {
  const std::uint32_t ticks = low_ticks(now);
  for (std::uint32_t i = 0; i < states_.size(); ++i) {
    OutputState& state = states_[i];
    if (state.impulse && is_over(state.off_at, ticks)) {
      state.impulse = false;
      VirtualOutput record = output(i);
      record.data = static_cast<std::uint8_t>(record.data & ~lit_bit);
      store(groups_.place(i), record);
      show(i);
    }
    if (!state.counting || !is_over(state.second_at, ticks)) continue;
    state.counting = false;
    if (state.held) apply(i, groups_.place(i), state.held_sub_function, state.held_data);
  }
  wake();
}

/// At the next end of an impulse or of a second.
void OutputPanelUnit::wake() {
  const std::uint32_t now = low_ticks(node_.now());
  std::uint32_t left = UINT32_MAX;
  for (const OutputState& state : states_) {
    if (state.impulse) left = std::min(left, state.off_at - now);
    if (state.counting) left = std::min(left, state.second_at - now);
  }
  node_.timers().arm(timer_, left == UINT32_MAX ? never : node_.now() + Duration(left));
}

}  // namespace canvoy::cia417
