#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"

#include <utility>

namespace canvoy::cia447 {

constexpr ServiceHandlers TaxiAlarmUnit::service_calls = {.reset = method<&TaxiAlarmUnit::reset>};

TaxiAlarmUnit::TaxiAlarmUnit(CarNetwork& network, const TaxiAlarmHardware& hardware,
                             const TaxiAlarmSettings& settings)
    : network_(network), hardware_(hardware), settings_(settings) {
  if (!settings.has_remote_key) state_.remote_key = Signal::not_available;
  network.node().attach(service_);
}

/// No message from the bus ends an alarm.
void TaxiAlarmUnit::reset(ResetScope /*scope*/) {
  tell();
}

void TaxiAlarmUnit::press_key(Signal state) {
  const Signal before = std::exchange(state_.key, state);
  if (state == Signal::yes && before != Signal::yes) raise_alarm(settings_.by_key);
  tell();
}

void TaxiAlarmUnit::press_remote_key(Signal state) {
  const Signal before = std::exchange(state_.remote_key, state);
  if (state == Signal::yes && before != Signal::yes) raise_alarm(settings_.by_remote_key);
  tell();
}

void TaxiAlarmUnit::raise_alarm(AlarmKind kind) {
  if (kind == AlarmKind::none) return;
  if (kind != AlarmKind::full) state_.silent = Signal::yes;
  if (kind != AlarmKind::silent) state_.full = Signal::yes;
  if (settings_.calls_by_radio) state_.call = Signal::yes;
  hardware_.alarm(state_.silent == Signal::yes, state_.full == Signal::yes);
  tell();
}

void TaxiAlarmUnit::reset_alarm() {
  state_.silent = state_.full = state_.call = Signal::no;
  hardware_.alarm(false, false);
  tell();
}

void TaxiAlarmUnit::radio_has_called() {
  state_.call = Signal::no;
  tell();
}

void TaxiAlarmUnit::tell() {
  const Values alarm(network_.node().dictionary());
  alarm[taxi_alarm_system_status_silent_activated] = state_.silent;
  alarm[taxi_alarm_system_status_full_activated] = state_.full;
  alarm[taxi_alarm_system_status_key_pressed] = state_.key;
  alarm[taxi_alarm_system_status_remote_key_pressed] = state_.remote_key;
  alarm[taxi_alarm_system_status_radio_emergency_call_requested] = state_.call;
}

}  // namespace canvoy::cia447
