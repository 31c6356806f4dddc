// A whole car position unit: its dictionary, its node with all services, and its behaviour.
//
//     cia417::CarPositionDevice<> position(port, 4, hardware);
//     position.node().start(now);
#pragma once

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/car_position_unit.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// Every object of a position unit with `units` encoders, a work area each, eight cams, and a
/// heartbeat each 500 ms.
template <LiftDeviceOptions options = LiftDeviceOptions{}, std::uint8_t units = 1,
          std::uint8_t channels = 1>
inline constexpr auto full_car_position =
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
             cia301::identity({.product_code = 41706}),
             cia301::names({.device = "Canvoy CiA 417 car position unit",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(500), cia301::emergency(),
             cia301::error_history(8), cia301::error_behavior().initial(1, keeps_state));
template <LiftDeviceOptions options = LiftDeviceOptions{}, std::uint8_t units = 1,
          std::uint8_t channels = 1>
inline constexpr auto full_car_position_layout =
    in_any_lift(lay_out_device<full_car_position<options, units, channels>>());

/// `layout` is that of a description with a car position unit of lift `settings.lift` in it.
template <const auto& layout = full_car_position_layout<>, std::size_t own_routes = 0>
class CarPositionDevice {
 public:
  /// See CarPositionUnit; `port`'s context, and what `hardware` refers to, must outlive the device.
  CarPositionDevice(const Port& port, NodeId node_id, const CarPositionHardware& hardware,
                    const CarPositionSettings& settings = {})
      : device_(port, node_id),
        unit_(device_.node(), {.tpdos = &device_.tpdos()}, hardware, settings) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  CarPositionUnit& unit() { return unit_; }
  const CarPositionUnit& unit() const { return unit_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(), {}};
  CarPositionUnit unit_;
};

}  // namespace canvoy::cia417
