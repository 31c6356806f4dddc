// Common part of all kinds of devices of a lift: emergency 0010h, the lift number, and the basics
// of CiA 301.
//
//     template <LiftDeviceOptions options = LiftDeviceOptions{}>
//     struct LoadKind : LiftKind<LoadMeasuringUnit, LoadHardware, LoadSettings> { ... };
#pragma once

#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"

namespace canvoy::cia417 {

/// For a device that belongs to no single lift: a panel, a sensor unit.
class BusBehaviour {
 public:
  /// Attaches to the node of the device.
  template <class Unit>
  BusBehaviour(Node& node, Unit& /*unit*/) : bus_warning_(node) {}

 private:
  BusWarning bus_warning_;
};

/// For a device of one lift (6001h). A unit may refuse another lift number with
/// refuses_lift_number(), and is notified of it by lift_changed().
class LiftBehaviour {
 public:
  /// Attaches to the node of the device; `unit` must outlive this.
  template <class Unit>
  LiftBehaviour(Node& node, Unit& unit) : bus_warning_(node), lift_number_(node, settings(unit)) {}

 private:
  template <class Unit>
  static LiftNumberSettings settings(Unit& unit) {
    LiftNumberSettings made;
    if constexpr (requires { unit.refuses_lift_number(); }) {
      made.refuses = callback<&Unit::refuses_lift_number>(unit);
    }
    if constexpr (requires { unit.lift_changed(std::uint8_t{}); }) {
      made.changed = callback<&Unit::lift_changed>(unit);
    }
    return made;
  }

  BusWarning bus_warning_;
  LiftNumber lift_number_;
};

template <class UnitType, class HardwareType, class SettingsType>
struct LiftKind : KindOf<UnitType, HardwareType, SettingsType> {
  using ProfileBehaviour = LiftBehaviour;  ///< lift number and warnings

  template <const auto& device>
  static constexpr auto lay_out() {
    return in_any_lift(lay_out_device<device>());
  }
};

/// Identity, names, SYNC, heartbeat, emergencies and the last errors.
constexpr auto lift_basics(const DeviceInfo& info, std::uint16_t heartbeat_ms,
                           std::uint8_t errors_kept = 8) {
  return describe(
      cia301::identity({.product_code = info.product_code}),
      cia301::names(
          {.device = info.product, .hardware_version = "simulated", .software_version = "0.1.0"}),
      cia301::sync_consumer(), cia301::heartbeat_producer(heartbeat_ms), cia301::emergency(),
      cia301::error_history(errors_kept));
}

inline constexpr LiftDeviceOptions first_door = {.doors = 0b0001};  ///< a device of door 1 only

}  // namespace canvoy::cia417
