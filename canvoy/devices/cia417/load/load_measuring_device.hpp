// A whole load measuring unit of CiA 417-4.
//
//     LoadMeasuringDevice<> load(port, 13, hardware, {.tare_kg = 900});
//     load.node().start(now);
#pragma once

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"

namespace canvoy::cia417 {

/// Every object of the virtual device, and a heartbeat every 500 ms. A maker has a separate
/// description with its own identity.
template <LiftDeviceOptions options = LiftDeviceOptions{}, unsigned ropes = 1>
struct LoadKind : LiftKind<LoadMeasuringUnit, LoadHardware, LoadSettings> {
  static constexpr DeviceInfo info = {.name = "lift-load",
                                      .title = "load measuring unit of a car",
                                      .product = "Canvoy CiA 417 load measuring",
                                      .product_code = 41710,
                                      .node_id = 13,
                                      .hardware = "load cells at the ropes, in kg"};
  static constexpr auto description =
      describe(lift_device<VirtualDevice::load_measuring_unit, options>(
                   {0x6480, 0x6481, 0x6482, 0x6483, {0x6484, ropes}, 0x6485}),
               lift_basics(info, 500));

  /// An empty car without weight.
  static constexpr LoadHardware simulated() {
    return {.rope_load = {[](void*, unsigned) -> std::optional<double> { return 0; }, nullptr}};
  }
  /// Lift and ropes are those of the template.
  static constexpr LoadSettings fit(LoadSettings settings) {
    settings.lift = options.lift;
    settings.ropes = ropes;
    return settings;
  }
};

/// `layout` has a description with the objects of a load measuring unit for `options` and this
/// number of ropes.
template <LiftDeviceOptions options = LiftDeviceOptions{}, unsigned ropes = 1,
          const auto& layout = layout_of<LoadKind<options, ropes>>, std::size_t own_routes = 0>
using LoadMeasuringDevice = Device<LoadKind<options, ropes>, layout, own_routes>;

}  // namespace canvoy::cia417
