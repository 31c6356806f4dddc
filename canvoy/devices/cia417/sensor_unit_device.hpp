// A whole sensor unit of CiA 417-4: its dictionary, its node with all services, and its behaviour.
//
//     SensorUnitDevice<8> device(port, 30, {.sensors = sensors});
//     device.node().start(now);
//     device.unit().set_level(0, true, now);
#pragma once

#include <array>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/sensor_unit.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// A group of `sensors` with all their parameters, and a heartbeat each second. The PDO of 6012h is
/// there, and invalid until it is given its COB-ID: 380h and the node-ID. A maker has a description
/// of his own with his identity.
template <std::uint8_t sensors, LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_sensor_unit = describe(
    lift_device<VirtualDevice::sensor_unit, options>(
        {0x6012, {0x6500, sensors}, {0x6520, sensors}, {0x6540, sensors}, {0x6560, sensors}}),
    cia301::identity({.product_code = 41711}),
    cia301::names({.device = "Canvoy CiA 417 sensor unit",
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::sync_consumer(), cia301::heartbeat_producer(1000), cia301::emergency(),
    cia301::error_history(8));
template <std::uint8_t sensors, LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_sensor_unit_layout =
    lay_out_device<full_sensor_unit<sensors, options>>();

/// `layout` is that of a description with sensor groups and 6012h in a TPDO.
template <std::uint8_t sensors, LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = full_sensor_unit_layout<sensors, options>,
          std::size_t own_routes = 0>
class SensorUnitDevice {
 public:
  SensorUnitDevice(const Port& port, NodeId node_id, const SensorSettings& settings)
      : device_(port, node_id),
        unit_(device_.node(), device_.tpdos(), {states_, queue_}, settings) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  SensorUnit& unit() { return unit_; }
  const SensorUnit& unit() const { return unit_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr std::size_t count = count_in_groups(layout.tables(), sensor_group_object.index);

  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  std::array<SensorState, count> states_{};
  std::array<std::uint32_t, count> queue_{};
  SensorUnit unit_;
};

}  // namespace canvoy::cia417
