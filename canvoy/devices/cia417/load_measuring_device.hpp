// A whole load measuring unit of CiA 417-4: its dictionary, its node with all services, and its
// behaviour.
//
//     LoadMeasuringDevice<> load(port, 13, hardware, {.tare_kg = 900});
//     load.node().start(now);
#pragma once

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/devices/cia417/load_measuring_unit.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// Every object of the virtual device, and a heartbeat each 500 ms. A maker has a description of
/// his own with his identity.
template <LiftDeviceOptions options = LiftDeviceOptions{}, unsigned ropes = 1>
inline constexpr auto full_load_unit =
    describe(lift_device<VirtualDevice::load_measuring_unit, options>(
                 {0x6480, 0x6481, 0x6482, 0x6483, {0x6484, ropes}, 0x6485}),
             cia301::identity({.product_code = 41710}),
             cia301::names({.device = "Canvoy CiA 417 load measuring",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(500), cia301::emergency(),
             cia301::error_history(8));
template <LiftDeviceOptions options = LiftDeviceOptions{}, unsigned ropes = 1>
inline constexpr auto full_load_unit_layout =
    in_any_lift(lay_out_device<full_load_unit<options, ropes>>());

/// `layout` is that of a description with the objects of a load measuring unit for `options` and so
/// many ropes.
template <LiftDeviceOptions options = LiftDeviceOptions{}, unsigned ropes = 1,
          const auto& layout = full_load_unit_layout<options, ropes>, std::size_t own_routes = 0>
class LoadMeasuringDevice {
 public:
  /// Lift and ropes in `settings` are those of the template.
  LoadMeasuringDevice(const Port& port, NodeId node_id, const LoadHardware& hardware,
                      const LoadSettings& settings = {})
      : device_(port, node_id), unit_(device_.node(), hardware, settings_of(settings)) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  LoadMeasuringUnit& unit() { return unit_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr LoadSettings settings_of(LoadSettings settings) {
    settings.lift = options.lift;
    settings.ropes = ropes;
    return settings;
  }

  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(), {}};
  LoadMeasuringUnit unit_;
};

}  // namespace canvoy::cia417
