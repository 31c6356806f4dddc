// The taxi alarm system: an alarm key, a remote key, silent and full alarm, and the call for help
// by radio (6110h; CiA 447-3, 4.2.17).
//
//     TaxiAlarmUnit alarm(network, {.alarm = ...}, {});
//     alarm.press_key(true);   // a silent alarm, and the radio is to call
//     alarm.reset_alarm();
//
// The clause does not define the effect of a key: the settings do. An alarm stays until it is
// reset, regardless of the key.
#pragma once

#include <cstdint>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

/// Effect of a key.
enum class AlarmKind : std::uint8_t { none, silent, full, both };

/// What the alarm drives.
struct TaxiAlarmHardware {
  /// Called on changes of an alarm, for lights, horn and microphone.
  Callback<void(bool silent, bool full)> alarm = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TaxiAlarmHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::alarm; }, "the class has no member function of TaxiAlarmHardware: alarm");
  if constexpr (requires { &Plain::alarm; }) hardware.alarm = callback<&Plain::alarm>(plain);
}

/// Effects of the keys.
struct TaxiAlarmSettings {
  AlarmKind by_key = AlarmKind::silent;       ///< alarm key
  AlarmKind by_remote_key = AlarmKind::full;  ///< remote key
  /// An alarm requests a call by radio.
  bool calls_by_radio = true;
  bool has_remote_key = true;  ///< false: there is none
};

class TaxiAlarmUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TaxiAlarmUnit(CarNetwork& network, const TaxiAlarmHardware& hardware,
                const TaxiAlarmSettings& settings);

  /// Reports that a key is pressed, released, or out of order.
  void press_key(Signal state);
  /// Reports the alarm key.
  void press_key(bool is_pressed) { press_key(is_pressed ? Signal::yes : Signal::no); }
  /// Reports the remote key, or that its state is not known.
  void press_remote_key(Signal state);
  /// Reports the remote key.
  void press_remote_key(bool is_pressed) {
    press_remote_key(is_pressed ? Signal::yes : Signal::no);
  }
  /// Raises an alarm, as a key does.
  void raise_alarm(AlarmKind kind);
  /// Ends the alarm and the call. A key that is still held has no further effect.
  void reset_alarm();
  /// Reports that the radio has called.
  void radio_has_called();

 private:
  struct State {
    Signal silent = Signal::no;
    Signal full = Signal::no;
    Signal key = Signal::no;
    Signal remote_key = Signal::no;
    Signal call = Signal::no;
  };

  void reset(ResetScope scope);
  void tell();

  CarNetwork& network_;
  TaxiAlarmHardware hardware_;
  TaxiAlarmSettings settings_;
  State state_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the taxi alarm system (4.2.17); car_unit makes it a part of a device.
struct TaxiAlarmKind : CarKind<TaxiAlarmUnit, TaxiAlarmHardware, TaxiAlarmSettings> {
  static constexpr DeviceInfo info = {.name = "taxi-alarm",
                                      .title = "taxi alarm system",
                                      .product = "Canvoy CiA 447 taxi alarm",
                                      .product_code = 44714,
                                      .node_id = 10,
                                      .hardware = "alarm keys, lights and horn"};
  static constexpr const VirtualDeviceInfo& provides = taxi_alarm_system_device;
};

}  // namespace canvoy::cia447
