// A whole CiA 419 charger: its dictionary, its node with all services, and its behaviour.
//
//     cia419::ChargerDevice charger(port, 5, hardware, {.limits = {.current_max_ampere = 40}});
//     charger.node().start(now);
#pragma once

#include <array>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia419 {

/// Every object of the profile, and a heartbeat each second. A maker has a description of his own
/// with his identity.
inline constexpr auto full_charger =
    describe(charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             cia301::identity({.product_code = 419}),
             cia301::names({.device = "Canvoy CiA 419 charger",
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(2), cia301::emergency(),
             cia301::error_history(8), cia301::error_behavior());
inline constexpr auto full_charger_layout = lay_out_device<full_charger>();

/// `layout` is that of a description with cia419::charger() in it, one heartbeat consumer at least,
/// and error behaviour.
template <const auto& layout = full_charger_layout>
class ChargerDevice {
 public:
  /// See Charger; `port`'s context, and what `hardware` refers to, must outlive the device.
  ChargerDevice(const Port& port, NodeId node_id, const ChargerHardware& hardware,
                const ChargerSettings& settings = {})
      : device_(port, node_id),
        nmt_master_(device_.node(), remote_nodes_),
        charger_(device_.node(),
                 {.rpdos = device_.rpdos(),
                  .tpdos = device_.tpdos(),
                  .heartbeats = device_.heartbeat_consumer(),
                  .error_behaviour = device_.error_behaviour(),
                  .nmt_master = &nmt_master_},
                 hardware, settings) {}

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  Charger& charger() { return charger_; }
  const Charger& charger() const { return charger_; }
  NmtMaster& nmt_master() { return nmt_master_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  /// The NMT master hears all nodes, and each SDO client one.
  static constexpr std::size_t own_routes = node_id_max + DeviceScan::requests_max + 1;

  DeviceNode<layout, own_routes> device_;
  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;
  NmtMaster nmt_master_;
  Charger charger_;
};

}  // namespace canvoy::cia419
