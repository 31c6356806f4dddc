// The vehicle driver indicator, display only or with a keyboard: shows the driver time, doors,
// temperatures, fuel, brake and errors that it receives (CiA 407, 6.12).
//
//     DriverIndicatorUnit indicator(device, {.show = ...}, {});
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// Empty values are not known.
struct DriverView {
  std::optional<CivilTime> time = {};                   ///< driver time, local
  bool has_open_door = false;                           ///< one of them at least
  bool left_released = false;                           ///< doors on the left side
  bool right_released = false;                          ///< doors on the right side
  std::optional<double> ambient_celsius = {};           ///< of the air outside
  std::optional<double> coolant_celsius = {};           ///< of the engine
  std::optional<double> fuel_rate_l_per_h = {};         ///< at present
  std::optional<double> average_economy_km_per_l = {};  ///< of the trip
  std::optional<double> engine_hours = {};              ///< in all
  bool is_braking = false;                              ///< the pedal is pressed
  std::uint32_t last_error = 0;                         ///< as in 6740h; 0: none

  friend constexpr bool operator==(const DriverView&, const DriverView&) = default;
};
/// The display.
struct DriverIndicatorHardware {
  /// Called when the view changes.
  Callback<void(const DriverView&)> show = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(DriverIndicatorHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::show; },
      "the class has no member function of DriverIndicatorHardware: show");
  if constexpr (requires { &Plain::show; }) hardware.show = callback<&Plain::show>(plain);
}

class DriverIndicatorUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  DriverIndicatorUnit(VirtualDevice& device, const DriverIndicatorHardware& hardware,
                      const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware) {
    device.on_reset = callback<&DriverIndicatorUnit::reset>(*this);
    device.react(*this, reactions());
  }
  DriverIndicatorUnit(const DriverIndicatorUnit&) = delete;
  DriverIndicatorUnit& operator=(const DriverIndicatorUnit&) = delete;

 private:
  static std::span<const AccessHandlers> reactions();
  void reset(ResetScope /*scope*/) {
    shown_ = std::nullopt;
    show();
  }
  void show() {
    const DriverView view = {.time = local_time(device_.values()),
                             .has_open_door = device_[all_doors].is(Doors::open),
                             .left_released = device_[left_side_doors].is(Release::released),
                             .right_released = device_[right_side_doors].is(Release::released),
                             .ambient_celsius = device_[ambient_air_temperature].value(),
                             .coolant_celsius = device_[engine_coolant_temperature].value(),
                             .fuel_rate_l_per_h = device_[fuel_rate].value(),
                             .average_economy_km_per_l = device_[average_fuel_economy].value(),
                             .engine_hours = device_[total_engine_hours].value(),
                             .is_braking = device_[brake_switch].is(BrakePedal::depressed),
                             .last_error = device_.node().dictionary().word(
                                 short_diagnostic_error_field_object.index, 1)};
    if (shown_ == view) return;
    shown_ = view;
    if (hardware_.show) hardware_.show(view);
  }

  VirtualDevice& device_;
  DriverIndicatorHardware hardware_;
  std::optional<DriverView> shown_;
};

inline std::span<const AccessHandlers> DriverIndicatorUnit::reactions() {
  static constexpr AccessHandlers rows[] = {after_any_write<&DriverIndicatorUnit::show>};
  return rows;
}

/// Vehicle driver indicator, display only.
struct DriverDisplayKind : BusKind<DriverIndicatorUnit, DriverIndicatorHardware> {
  static constexpr DeviceInfo info = {.name = "driver-display",
                                      .title = "vehicle driver indicator, display only",
                                      .product = "Canvoy CiA 407 driver display",
                                      .product_code = 40711,
                                      .node_id = 13,
                                      .hardware = "what the driver sees"};
  static constexpr const VirtualDeviceInfo& provides = driver_display;
  static constexpr std::array pdos = {own_pdo<doors_rpdo>};
};
/// Vehicle driver indicator, display with keyboard.
struct DriverDisplayWithKeyboardKind : BusKind<DriverIndicatorUnit, DriverIndicatorHardware> {
  static constexpr DeviceInfo info = {.name = "driver-display-keyboard",
                                      .title = "vehicle driver indicator with a keyboard",
                                      .product = "Canvoy CiA 407 display and keys",
                                      .product_code = 40744,
                                      .node_id = 14,
                                      .hardware = "what the driver sees"};
  static constexpr const VirtualDeviceInfo& provides = driver_display_with_keyboard;
  static constexpr std::array pdos = {own_pdo<doors_rpdo>};
};

}  // namespace canvoy::cia407
