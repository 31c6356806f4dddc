#include "canvoy/devices/cia417/sensor/sensor_unit.hpp"

#include <algorithm>

#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/devices/cia417/sensor/sensor_place.hpp"

namespace canvoy::cia417 {

namespace {

constexpr std::int16_t value_min = -8192;
constexpr std::int16_t value_max = 8191;
/// A sensor without a record of its own: basic function 00h is reserved, a generic sensor has no
/// data.
constexpr VirtualSensor unassigned{.function = SensorFunction::generic};

}  // namespace

constexpr AccessHandlers SensorUnit::parameter_hook = {
    .first = sensor_parameter_1_object.index,
    .last = sensor_parameter_3_object.index + group_count - 1,
    .before_write = method<&SensorUnit::before_parameter_write>,
    .after_write = method<&SensorUnit::parameter_written>};
constexpr AccessHandlers SensorUnit::hook_calls[] = {
    in_lift(1, parameter_hook), in_lift(2, parameter_hook), in_lift(3, parameter_hook),
    in_lift(4, parameter_hook), in_lift(5, parameter_hook), in_lift(6, parameter_hook),
    in_lift(7, parameter_hook), in_lift(8, parameter_hook)};
constexpr ServiceHandlers SensorUnit::service_calls = {
    .reset = method<&SensorUnit::reset>,
    .state_entered = method<&SensorUnit::state_entered>,
    .hooks = hook_calls};

SensorUnit::SensorUnit(Node& node, Tpdos& tpdos, const SensorMemory& memory,
                       const SensorSettings& settings)
    : node_(node),
      groups_(node.dictionary().tables(), sensor_group_object.index),
      states_(memory.states),
      queue_(memory.queue),
      settings_(settings),
      mapping_(node, tpdos, virtual_sensor_mapping_object.index,
               {callback<&SensorUnit::waits>(*this), callback<&SensorUnit::next>(*this)}),
      timer_(callback<&SensorUnit::expire>(*this)) {
  node.attach(service_);
}

// Calls from outside

void SensorUnit::set_level(std::uint32_t number, bool high, Time now) {
  node_.advance(now);
  if (number >= states_.size()) return;
  SensorState& state = states_[number];
  state.level = high;
  state.debouncing = false;
  const IoPlace place = groups_.place(number);
  const std::uint8_t milliseconds = parameter(place, 3, debounce_byte);
  const bool is_debounced = milliseconds != 0 && milliseconds != parameter_not_used;
  if (state.level != state.stable && is_debounced) {
    state.debouncing = true;
    state.stable_at = low_ticks(now) + milliseconds * 1000U;
  } else if (state.level != state.stable) {
    level_changed(number, place);
  }
  wake();
}

void SensorUnit::set_value(std::uint32_t number, std::int16_t value, Time now) {
  node_.advance(now);
  if (number >= states_.size()) return;
  states_[number].value = std::clamp(value, value_min, value_max);
  update(number, groups_.place(number), true);
  wake();
}

void SensorUnit::report(std::uint32_t number, SensorSignal condition, Time now,
                        std::uint8_t error_code) {
  node_.advance(now);
  if (number >= states_.size()) return;
  const bool works = condition == SensorSignal::not_set || condition == SensorSignal::set;
  states_[number].condition = works ? SensorSignal::not_set : condition;
  const IoPlace place = groups_.place(number);
  set_parameter_byte(node_.dictionary(), place, 1, error_code_byte, error_code);
  update(number, place, false);
}

VirtualSensor SensorUnit::sensor(std::uint32_t number) const {
  const IoPlace place = groups_.place(number);
  return decode_sensor(node_.dictionary().number(place.index, place.sub));
}

// Life of the node

void SensorUnit::reset(ResetScope) {
  node_.timers().disarm(timer_);
  queue_.clear();
  begun_ = false;
  groups_.for_each([this](std::uint32_t number, IoPlace place) {
    if (number >= states_.size()) return;
    SensorState& state = states_[number];
    state.stable = state.level;
    state.debouncing = state.counting = state.held = state.queued = state.missed = false;
    const bool is_assigned = number < settings_.sensors.size();
    VirtualSensor record = is_assigned ? settings_.sensors[number] : unassigned;
    record.data = data_of(state, place, record.function);
    state.told = record.data;
    node_.dictionary().set_number(place.index, place.sub, encode(record));
    // A reset of the node has ended all errors: this one still exists.
    if (record.signal() == SensorSignal::defective) node_.raise(defect_of(number));
  });
}

void SensorUnit::state_entered(NmtState state) {
  // The PDO may already be working, and have requested a record.
  if (state == NmtState::operational && waits()) return mapping_.announce();
  begun_ = begun_ && state == NmtState::operational;
}

bool SensorUnit::waits() {
  if (node_.state() != NmtState::operational) return false;
  if (!begun_) begin();
  return !queue_.empty();
}

/// Finds the sensors to send first: their state is not yet known on the bus.
void SensorUnit::begin() {
  begun_ = true;
  queue_.clear();
  for (std::uint32_t i = 0; i < states_.size(); ++i) {
    const VirtualSensor record = sensor(i);
    SensorState& state = states_[i];
    state.queued = record.signal() != SensorSignal::not_set || is_measured(record.function);
    state.missed = false;
    if (state.queued) queue_.push(i);
  }
  if (states_.empty()) return;
  begin_mapping(node_.dictionary(), virtual_sensor_mapping_object.index, encode(sensor(0)));
}

// Parameters

AbortCode SensorUnit::before_parameter_write(const Entry& entry,
                                             std::span<const std::uint8_t> value) {
  return check_event_counts(entry, value, sensor_parameter_2_object.index);
}

void SensorUnit::parameter_written(const Entry& entry, Source) {
  const IoPlace place = place_of_parameter({entry.index, entry.sub}, sensor_group_object.index);
  const std::uint32_t number = groups_.position(place);
  if (number < states_.size()) update(number, place, false);
}

/// The present function data of a sensor.
std::uint16_t SensorUnit::data_of(const SensorState& state, IoPlace place,
                                  SensorFunction function) const {
  const std::uint8_t edges = parameter(place, 3, edge_byte);
  const bool is_inverted = edges != parameter_not_used && (edges & polarity_bit) != 0;
  SensorSignal signal = state.stable != is_inverted ? SensorSignal::set : SensorSignal::not_set;
  if (state.condition != SensorSignal::not_set) signal = state.condition;
  if ((parameter(place, 1, enable_byte) & 1) == 0) signal = SensorSignal::not_set;
  // Reserved bits are 1.
  return sensor_data(signal, is_measured(function) ? state.value : std::int16_t{-1});
}

/// True if edges allow a change: those of the signal; a failure and a value always pass.
bool SensorUnit::is_told(IoPlace place, SensorSignal before, const VirtualSensor& record) const {
  const SensorSignal signal = record.signal();
  const bool is_edge =
      signal != before && (signal == SensorSignal::set || signal == SensorSignal::not_set);
  const unsigned bit = signal == SensorSignal::set ? rising_bit : falling_bit;
  return !is_edge || (parameter(place, 3, edge_byte) & bit) != 0;
}

// Changes

void SensorUnit::level_changed(std::uint32_t number, IoPlace place) {
  states_[number].debouncing = false;
  states_[number].stable = states_[number].level;
  update(number, place, true);
}

/// Stores the present state of the sensor, and sends it if that is a message.
void SensorUnit::update(std::uint32_t number, IoPlace place, bool by_event) {
  SensorState& state = states_[number];
  VirtualSensor record = this->sensor(number);
  const VirtualSensor before = record;
  record.data = data_of(state, place, record.function);
  if (record == before) return;
  node_.dictionary().set_number(place.index, place.sub, encode(record));
  node_.report(defect_of(number), record.signal() == SensorSignal::defective);
  const bool is_message_now =
      !by_event || (is_told(place, before.signal(), record) && is_message(state, place));
  if (is_message_now) tell(number, record.signal());
}

/// Counts the event against limitation and sending event.
bool SensorUnit::is_message(SensorState& state, IoPlace place) {
  const std::uint8_t limitation = parameter(place, 2, limitation_byte);
  const std::uint8_t sending_event = parameter(place, 2, start_event_byte);
  if (limitation == parameter_not_used && sending_event == parameter_not_used) return true;
  if (!state.counting) {
    state.counting = true;
    state.events = 0;
    state.second_at = low_ticks(node_.now()) + one_second;
  }
  if (state.events < parameter_not_used) ++state.events;
  if (state.events > limitation) {
    state.held = true;
    return false;
  }
  return sending_event == parameter_not_used || sending_event == 0 ||
         state.events % sending_event == 0;
}

void SensorUnit::tell(std::uint32_t number, SensorSignal signal) {
  SensorState& state = states_[number];
  state.missed = (state.queued && state.missed) || signal == SensorSignal::set;
  if (!state.queued) queue_.push(number);
  state.queued = true;
  if (mapping_.is_working()) return mapping_.announce();
  // A reader of 6012h finds the last change.
  node_.dictionary().set_number(virtual_sensor_mapping_object.index, 0,
                                encode(this->sensor(number)));
}

// Time

void SensorUnit::expire(Time now) {
  const std::uint32_t ticks = low_ticks(now);
  for (std::uint32_t i = 0; i < states_.size(); ++i) {
    SensorState& state = states_[i];
    if (state.debouncing && is_over(state.stable_at, ticks)) level_changed(i, groups_.place(i));
    if (!state.counting || !is_over(state.second_at, ticks)) continue;
    const bool held = state.held;
    state.counting = state.held = false;
    const VirtualSensor record = sensor(i);
    const auto told = static_cast<SensorSignal>(state.told & 3);
    if (held && !state.queued && record.data != state.told &&
        is_told(groups_.place(i), told, record)) {
      tell(i, record.signal());
    }
  }
  wake();
}

/// At the next end of a debounce time or of a second.
void SensorUnit::wake() {
  const std::uint32_t now = low_ticks(node_.now());
  std::uint32_t left = UINT32_MAX;
  for (const SensorState& state : states_) {
    if (state.debouncing) left = std::min(left, state.stable_at - now);
    if (state.counting) left = std::min(left, state.second_at - now);
  }
  node_.timers().arm(timer_, left == UINT32_MAX ? never : node_.now() + Duration(left));
}

/// The next record. For a sensor with a signal that has come and gone, first the signal.
std::uint64_t SensorUnit::next() {
  const std::uint32_t position = queue_.pop();
  SensorState& state = states_[position];
  state.queued = false;
  VirtualSensor record = sensor(position);
  const bool has_gone = state.missed && record.signal() == SensorSignal::not_set;
  state.missed = false;
  if (has_gone) {
    record.data = sensor_data(SensorSignal::set, record.value());
    const VirtualSensor now = sensor(position);
    if (is_told(groups_.place(position), SensorSignal::set, now)) {
      state.queued = true;
      queue_.push(position);
    }
  }
  state.told = record.data;
  return encode(record);
}

}  // namespace canvoy::cia417
