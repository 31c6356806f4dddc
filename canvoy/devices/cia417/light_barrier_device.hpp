// A whole light barrier unit of CiA 417-4: its dictionary, its node with all services, and its
// behaviour.
//
//     LightBarrierDevice<first_door> barrier(port, 9, hardware);
//     barrier.node().start(now);
#pragma once

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/devices/cia417/light_barrier_unit.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// Every object of the virtual device, and a heartbeat each 500 ms. A maker has a description of
/// his own with his identity.
template <LiftDeviceOptions options = LiftDeviceOptions{.doors = 0b0001}>
inline constexpr auto full_light_barrier =
    describe(lift_device<VirtualDevice::light_barrier_unit, options>({0x6310}),
             cia301::identity({.product_code = 41707}),
             cia301::names({.device = "Canvoy CiA 417 light barrier",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(500), cia301::emergency(),
             cia301::error_history(8));
template <LiftDeviceOptions options = LiftDeviceOptions{.doors = 0b0001}>
inline constexpr auto full_light_barrier_layout =
    in_any_lift(lay_out_device<full_light_barrier<options>>());

/// `layout` is that of a description with the objects of a light barrier unit for `options`.
template <LiftDeviceOptions options = LiftDeviceOptions{.doors = 0b0001},
          const auto& layout = full_light_barrier_layout<options>, std::size_t own_routes = 0>
class LightBarrierDevice {
 public:
  /// Lift and doors in `settings` are those of `options`.
  LightBarrierDevice(const Port& port, NodeId node_id, const LightBarrierHardware& hardware,
                     const LightBarrierSettings& settings = {})
      : device_(port, node_id), barrier_(device_.node(), hardware, settings_of(settings)) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  LightBarrierUnit& barrier() { return barrier_; }
  const LightBarrierUnit& barrier() const { return barrier_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr LightBarrierSettings settings_of(LightBarrierSettings settings) {
    settings.lift = options.lift;
    settings.doors = static_cast<std::uint8_t>(options.doors);
    return settings;
  }

  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(), {}};
  LightBarrierUnit barrier_;
};

}  // namespace canvoy::cia417
