// Application of the alarm of a taxi, beside its virtual device: it has the emergency light on the
// roof blink (6106h; CiA 447-3, 4.2.16.4), and calls the control room by a radio of its own while
// 6110h requests a call (CiA 447-3, 4.2.17.1).
//
//     AlarmControl control(network, {.has_called = ...}, {.sign = 5});
//     control.alarm(true);    // TaxiAlarmHardware::alarm
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/command_keeper.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::taxi {

/// Outputs of the control.
struct AlarmControlHardware {
  /// The call has been sent and heard.
  Callback<void()> has_called = {};
};
/// Node with the sign, and the time of a call.
struct AlarmControlSettings {
  NodeId sign = 0;           ///< 1 to 16
  Duration call_takes = 2s;  ///< from the alarm to the end of the call
};

class AlarmControl {
 public:
  /// What these refer to must outlive this object.
  AlarmControl(cia447::CarNetwork& network, const AlarmControlHardware& hardware,
               const AlarmControlSettings& settings);
  AlarmControl(const AlarmControl&) = delete;
  AlarmControl& operator=(const AlarmControl&) = delete;

  /// An alarm begins, or is over.
  void alarm(bool is_on);

 private:
  void called(Time now);

  cia447::CarNetwork& network_;
  AlarmControlHardware hardware_;
  AlarmControlSettings settings_;
  cia447::CommandKeeper sign_;
  bool is_on_ = false;
  Timer call_;
};

/// Stands beside a taxi alarm.
struct AlarmControlKind
    : cia447::CarKind<AlarmControl, AlarmControlHardware, AlarmControlSettings> {
  static constexpr DeviceInfo info = {.name = "alarm-control", .title = "control of an alarm"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
};

}  // namespace canvoy::taxi
