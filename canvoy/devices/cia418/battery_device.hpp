// A whole CiA 418 battery module: its dictionary, its node with all services, and its behaviour.
//
//     cia418::BatteryDevice battery(port, 10, hardware, {.capacity_ampere_hours = 400});
//     battery.node().start(now);
#pragma once

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia418/battery.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia418 {

/// Every PDO that a charger can use, a heartbeat each second, and an SDO channel that an SDO
/// manager may give to a charger.
inline constexpr auto full_battery =
    describe(battery({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             battery_serial_number_object, battery_id_object, cumulative_total_ah_charge_object,
             ah_expended_since_last_charge_object, cia301::identity({.product_code = 418}),
             cia301::names({.device = "Canvoy CiA 418 battery",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(1000),
             cia301::heartbeat_consumers(2), cia301::emergency(), cia301::error_history(8),
             cia301::error_behavior(), cia301::sdo_servers(1));
inline constexpr auto full_battery_layout = lay_out_device<full_battery>();

/// `layout` is that of a description with cia418::battery() in it; `own_routes` as DeviceNode has
/// them.
template <const auto& layout = full_battery_layout, std::size_t own_routes = 0>
class BatteryDevice {
 public:
  /// See Battery; `port`'s context, and what `hardware` refers to, must outlive the device.
  BatteryDevice(const Port& port, NodeId node_id, const BatteryHardware& hardware,
                const BatterySettings& settings = {})
      : device_(port, node_id), battery_(device_.node(), hardware, settings) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  Battery& battery() { return battery_; }
  const Battery& battery() const { return battery_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  DeviceNode<layout, own_routes> device_;
  Battery battery_;
};

}  // namespace canvoy::cia418
