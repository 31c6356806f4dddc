// A whole car position unit of CiA 417-4.
//
//     CarPositionDevice<> position(port, 4, hardware);
//     position.node().start(now);
#pragma once

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/position/car_position_unit.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// Every object of a position unit with `units` encoders, one work area each, eight cams in each
/// channel, and a heartbeat every 500 ms.
template <LiftDeviceOptions options = LiftDeviceOptions{}, std::uint8_t units = 1,
          std::uint8_t channels = 1>
struct CarPositionKind : LiftKind<CarPositionUnit, CarPositionHardware, CarPositionSettings> {
  static constexpr DeviceInfo info = {.name = "lift-position",
                                      .title = "position unit of a car, with cams",
                                      .product = "Canvoy CiA 417 car position unit",
                                      .product_code = 41706,
                                      .node_id = 4,
                                      .hardware = "encoders: position, speed, acceleration"};
  static constexpr auto description =
      describe(lift_device<VirtualDevice::car_position_unit, options>({{0x6380, units},
                                                                       {0x6381, units},
                                                                       {0x6382, units},
                                                                       {0x6383, units},
                                                                       0x6384,
                                                                       0x6385,
                                                                       0x6386,
                                                                       0x6387,
                                                                       {0x6390, units},
                                                                       {0x6391, units},
                                                                       {0x63A0, channels},
                                                                       {0x63A1, channels},
                                                                       {0x63A2, channels},
                                                                       {0x63B0, channels},
                                                                       {0x63B1, channels},
                                                                       {0x63B2, channels},
                                                                       {0x63B3, channels},
                                                                       {0x63B4, channels},
                                                                       {0x63B5, channels},
                                                                       {0x63B6, channels},
                                                                       {0x63B7, channels},
                                                                       {0x63B8, channels},
                                                                       {0x63B9, channels},
                                                                       {0x63BA, channels},
                                                                       {0x63BB, channels},
                                                                       {0x63C0, units},
                                                                       {0x63C1, units},
                                                                       {0x63C2, units},
                                                                       {0x63C4, units},
                                                                       {0x63C5, units},
                                                                       {0x63C6, units},
                                                                       {0x63C7, units},
                                                                       {0x63C8, units},
                                                                       {0x63C9, units},
                                                                       0x63D0,
                                                                       0x63D1,
                                                                       0x63D2,
                                                                       0x63D3}),
               lift_basics(info, 500), cia301::error_behavior().initial(1, keeps_state));

  template <class Made, class Services>
  static Made make(Services& services, const CarPositionHardware& hardware,
                   const CarPositionSettings& settings) {
    return Made(services.node(), {.tpdos = &services.tpdos()}, hardware, settings);
  }
};

/// `layout` has a description with a car position unit of lift `settings.lift`.
template <const auto& layout = layout_of<CarPositionKind<>>, std::size_t own_routes = 0>
using CarPositionDevice = Device<CarPositionKind<>, layout, own_routes>;

}  // namespace canvoy::cia417
