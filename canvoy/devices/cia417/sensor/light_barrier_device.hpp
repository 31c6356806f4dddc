// A whole light barrier unit of CiA 417-4.
//
//     LightBarrierDevice<first_door> barrier(port, 9, hardware);
//     barrier.node().start(now);
#pragma once

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"

namespace canvoy::cia417 {

/// Every object of the virtual device, and a heartbeat every 500 ms. A maker has a separate
/// description with its own identity.
template <LiftDeviceOptions options = first_door>
struct LightBarrierKind : LiftKind<LightBarrierUnit, LightBarrierHardware, LightBarrierSettings> {
  static constexpr DeviceInfo info = {.name = "lift-light-barrier",
                                      .title = "light barrier of a car door",
                                      .product = "Canvoy CiA 417 light barrier",
                                      .product_code = 41707,
                                      .node_id = 9,
                                      .hardware = "the beam of each door: broken or not"};
  static constexpr auto description = describe(
      lift_device<VirtualDevice::light_barrier_unit, options>({0x6310}), lift_basics(info, 500));

  /// Lift and doors are those of `options`.
  static constexpr LightBarrierSettings fit(LightBarrierSettings settings) {
    settings.lift = options.lift;
    settings.doors = static_cast<std::uint8_t>(options.doors);
    return settings;
  }
};

/// `layout` has a description with the objects of a light barrier unit for `options`.
template <LiftDeviceOptions options = first_door,
          const auto& layout = layout_of<LightBarrierKind<options>>, std::size_t own_routes = 0>
using LightBarrierDevice = Device<LightBarrierKind<options>, layout, own_routes>;

}  // namespace canvoy::cia417
