// Time fixing: UTC, and the offset of the local time (CiA 407, 6.18, 9.2.22). Without a signal, the
// time keeps its value, since 6680h has no code for that, and there is an error (FF02h).
//
//     TimeFixingUnit clock(device, {.utc = ...}, {.offset_hours = 1});
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/devices/cia407/kit/errors.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The receiver of a time signal.
struct TimeFixingHardware {
  /// Nothing: no signal.
  Callback<std::optional<CivilTime>()> utc = {};
  /// Present offset of the local time from UTC: -23 h 59 min to 23 h 59 min. Empty: that of the
  /// settings, in summer and winter.
  Callback<std::chrono::minutes()> local_offset = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TimeFixingHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::utc; } || requires { &Plain::local_offset; },
      "the class has no member function of TimeFixingHardware: utc or local_offset");
  if constexpr (requires { &Plain::utc; }) hardware.utc = callback<&Plain::utc>(plain);
  if constexpr (requires { &Plain::local_offset; })
    hardware.local_offset = callback<&Plain::local_offset>(plain);
}
/// Offset of the local time, and period.
struct TimeFixingSettings {
  int offset_hours = 0;    ///< of the local time: -23 to 23
  int offset_minutes = 0;  ///< -59 to 59
  Duration period = 1s;    ///< of readings
};

class TimeFixingUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TimeFixingUnit(VirtualDevice& device, const TimeFixingHardware& hardware,
                 const TimeFixingSettings& settings)
      : device_(device),
        hardware_(hardware),
        settings_(settings),
        timer_(callback<&TimeFixingUnit::look>(*this)) {
    device.on_reset = callback<&TimeFixingUnit::reset>(*this);
  }

 private:
  void reset(ResetScope /*scope*/) { look(device_.node().now()); }
  void look(Time now) {
    device_.node().timers().arm(timer_, now + settings_.period);
    const std::optional<CivilTime> utc = hardware_.utc ? hardware_.utc() : std::nullopt;
    const bool is_known = utc && can_be_told(without_leap_second(*utc));
    if (is_known) report_clock(device_, universal_clock, utc);
    const std::chrono::minutes offset = local_offset();
    device_.tell(universal_local_hour, static_cast<double>(offset / 1h));
    device_.tell(universal_local_minute, static_cast<double>((offset % 1h).count()));
    device_.report(bus_error::no_signal, !is_known);
  }
  std::chrono::minutes local_offset() const {
    if (hardware_.local_offset) return hardware_.local_offset();
    return settings_.offset_hours * 1h + settings_.offset_minutes * 1min;
  }

  VirtualDevice& device_;
  TimeFixingHardware hardware_;
  TimeFixingSettings settings_;
  Timer timer_;
};

/// Catalogue row of the time fixing device (6.18); bus_unit makes it a part of a device.
struct TimeFixingKind : BusKind<TimeFixingUnit, TimeFixingHardware, TimeFixingSettings> {
  static constexpr DeviceInfo info = {.name = "time-fixing",
                                      .title = "time fixing: UTC",
                                      .product = "Canvoy CiA 407 time fixing",
                                      .product_code = 40717,
                                      .node_id = 17,
                                      .hardware = "a receiver of time"};
  static constexpr const VirtualDeviceInfo& provides = time_fixing;
  static constexpr std::array pdos = {own_pdo<universal_time_tpdo>, own_pdo<position_rpdo>};
};

}  // namespace canvoy::cia407
