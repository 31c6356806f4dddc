// A whole CiA 418 battery module.
//
//     cia418::BatteryDevice<> battery(port, 10, hardware, {.capacity_ampere_hours = 400});
//     battery.node().start(now);
#pragma once

#include "canvoy/devices/cia418/battery.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/profiles/cia301.hpp"

namespace canvoy::cia418 {

/// Every PDO that a charger can use, a heartbeat every second, and an SDO channel that an SDO
/// manager may assign to a charger.
struct BatteryKind : KindOf<Battery, BatteryHardware, BatterySettings> {
  /// Of the catalogue.
  static constexpr DeviceInfo info = {
      .name = "battery",
      .title = "battery module",
      .product = "Canvoy CiA 418 battery",
      .product_code = 418,
      .node_id = 10,
      .hardware = "the cells: voltage, current, temperature, charge"};
  /// The objects of the module: all PDOs and optional objects that are known.
  static constexpr auto description = describe(
      battery({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
      battery_serial_number_object, battery_id_object, cumulative_total_ah_charge_object,
      ah_expended_since_last_charge_object, cia301::identity({.product_code = info.product_code}),
      cia301::names(
          {.device = info.product, .hardware_version = "simulated", .software_version = "0.1.0"}),
      cia301::sync_consumer(), cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(2),
      cia301::emergency(), cia301::error_history(8), cia301::error_behavior(),
      cia301::sdo_servers(1));
};

/// `layout` has a description with cia418::battery(); `own_routes` are as in DeviceNode.
template <const auto& layout = layout_of<BatteryKind>, std::size_t own_routes = 0>
using BatteryDevice = Device<BatteryKind, layout, own_routes>;

}  // namespace canvoy::cia418
