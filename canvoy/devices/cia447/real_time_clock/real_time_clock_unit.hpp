// A real time clock: date, time, zone and summer time, sent and set over the bus (60F0h to 60F5h;
// CiA 447-3, 4.2.14). It runs on the node's time, and follows a clock chip if there is one.
//
//     RealTimeClockUnit clock(network, {.read = ..., .write = ...},
//                             {.zone = {.name = "CET", .offset_minutes = 60,
//                                       .summer = european_summer}});
//
// It sends local time; the offset from UTC includes summer time. Without a date ("no date is set"),
// the time goes on. It is valid with a date and a time that were set, or kept by the chip.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/real_time_clock/time_zone.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"
#include "canvoy/profiles/model/written_value.hpp"

namespace canvoy::cia447 {

/// The time in a clock chip.
struct ChipTime {
  Duration since_1970{};  ///< UTC; without a date: since any midnight
  bool has_date = true;   ///< false: the chip counts the time of day only
};

/// The clock chip.
struct RealTimeClockHardware {
  /// Nothing: it was without power, or has never been set. Without a callback, the clock starts at
  /// 0:00.
  Callback<std::optional<ChipTime>()> read = {};
  Callback<void(const ChipTime&)> write = {};  ///< called when the clock is set
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(RealTimeClockHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::read; } || requires { &Plain::write; },
      "the class has no member function of RealTimeClockHardware: read or write");
  if constexpr (requires { &Plain::read; }) hardware.read = callback<&Plain::read>(plain);
  if constexpr (requires { &Plain::write; }) hardware.write = callback<&Plain::write>(plain);
}

/// Zone, and what the clock runs from.
struct RealTimeClockSettings {
  TimeZone zone = {};                              ///< of the local time
  RtcSource source = RtcSource::battery_buffered;  ///< as 60F4h reports it
  /// A time that an authority has accepted cannot be set over the bus: 0800 0022h.
  RtcTrustability trustability = RtcTrustability::user_adjustable;
  /// Period of comparisons with the chip.
  Duration comparison_period = 1min;
};

class RealTimeClockUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  RealTimeClockUnit(CarNetwork& network, const RealTimeClockHardware& hardware,
                    const RealTimeClockSettings& settings);

  /// Sets the time, for example from GPS.
  void set(Duration since_1970_utc);
  /// Reads the chip at once.
  void hardware_changed() { look(); }
  /// True if date and time are known.
  bool is_valid() const { return has_date_ && has_time_; }
  /// Local time since 1970-01-01; without a date, on 1970-01-01.
  Duration local() const;

 private:
  void reset(ResetScope scope);
  void refresh();
  AbortCode check_date(Raw<std::uint32_t> raw) const;
  AbortCode check_time(Raw<std::uint32_t> wanted) const;
  void date_written(const Entry& entry);
  void time_written(const Entry& entry);
  void tick(Time now);
  void look();
  void tell();
  void report_zone();

  struct Wanted {
    std::optional<std::uint32_t> parts[3] = {};  ///< year, month, day; or hour, minute, 1/100 s
    bool is_nothing() const { return !parts[0] && !parts[1] && !parts[2]; }
  };
  Wanted wanted_date(std::uint32_t raw) const;
  Wanted wanted_time(std::uint32_t raw) const;
  AbortCode check_may_set(const Wanted& wanted) const;
  void set_date(const Wanted& wanted);
  void set_time(const Wanted& wanted);
  void set_local(Duration local);
  void forget_date();

  Duration utc() const;
  bool is_in_summer() const;
  Duration offset() const;
  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(network_.node().dictionary())[handle];
  }

  CarNetwork& network_;
  RealTimeClockHardware hardware_;
  RealTimeClockSettings settings_;
  Commands commands_;
  Duration base_{};  ///< UTC at base_at_
  Time base_at_{};
  bool has_date_ = false;
  bool has_time_ = false;
  bool has_started_ = false;
  Time looked_at_{};
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer tick_;
};

/// Catalogue row of the real time clock (4.2.14); car_unit makes it a part of a device.
struct RealTimeClockKind
    : CarKind<RealTimeClockUnit, RealTimeClockHardware, RealTimeClockSettings> {
  static constexpr DeviceInfo info = {.name = "real-time-clock",
                                      .title = "real time clock",
                                      .product = "Canvoy CiA 447 real time clock",
                                      .product_code = 44711,
                                      .node_id = 7,
                                      .hardware = "clock chip with a battery"};
  static constexpr const VirtualDeviceInfo& provides = real_time_clock_device;
};

}  // namespace canvoy::cia447
