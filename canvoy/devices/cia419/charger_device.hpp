// A whole CiA 419 charger: its dictionary, its node with all services, and its behaviour.
//
//     cia419::ChargerDevice charger(port, 5, hardware, {.limits = {.current_max_ampere = 40}});
//     charger.node().start(now);
//
// In a vehicle, the board first detects the bit rate (4.2.2;
// canvoy/canopen/lss/bit_rate_detection.hpp), and then starts the node.
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/profiles/cia302/sdo_manager.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia419 {

/// Of the catalogue.
inline constexpr DeviceInfo charger_info = {
    .name = "charger",
    .title = "battery charger",
    .product = "Canvoy CiA 419 charger",
    .product_code = 419,
    .node_id = 5,
    .hardware = "a power stage with its meters, a pilot contact, a clock"};

/// Every object of the profile, and a heartbeat every second. A maker has a separate description
/// with its own identity.
inline constexpr auto full_charger =
    describe(charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             cia301::identity({.product_code = charger_info.product_code}),
             cia301::names({.device = charger_info.product,
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(2), cia301::emergency(),
             cia301::error_history(8), cia301::error_behavior(), cia301::time_producer(),
             cia302::sdo_requester());
/// Of the catalogue's charger.
inline constexpr auto full_charger_layout = lay_out_device<full_charger>();

/// `layout` has a description with cia419::charger(), at least one heartbeat consumer, and error
/// behaviour. With cia302::sdo_requester(), the charger requests an SDO connection to the battery;
/// with cia301::time_producer(), it sends the time of day. `further_routes` are those of the
/// application's own services.
template <const auto& layout = full_charger_layout, std::size_t further_routes = 0>
class ChargerDevice : public DeviceValues<ChargerDevice<layout, further_routes>, layout> {
 public:
  /// See Charger. The context of `port`, and everything to which `hardware` refers, must outlive
  /// the device.
  ChargerDevice(const Port& port, NodeId node_id, const ChargerHardware& hardware,
                const ChargerSettings& settings = {})
      : device_(port, node_id),
        network_(device_.node()),
        sdo_requester_(device_.node(),
                       SdoRequester::Settings{.manager_client = manager_connection,
                                              .time_out = settings.sdo_manager_time_out}),
        battery_client_(device_.node(), battery_connection),
        charger_(device_.node(),
                 {.rpdos = device_.rpdos(),
                  .tpdos = device_.tpdos(),
                  .heartbeats = device_.heartbeat_consumer(),
                  .error_behaviour = device_.error_behaviour(),
                  .network = &network_,
                  .sdo_requester = sdo_requester_.get(),
                  .battery_client = battery_client_.get(),
                  .time_stamp = time_stamp()},
                 hardware, settings) {}

  /// Takes a class with members that are found by their names: see ChargerStage.
  template <ChargerStage Stage>
  ChargerDevice(const Port& port, NodeId node_id, Stage& stage,
                const ChargerSettings& settings = {})
      : ChargerDevice(port, node_id, hardware_of(stage), settings) {}

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the charger, for its callbacks and totals.
  Charger& charger() { return charger_; }
  /// Behaviour of the charger.
  const Charger& charger() const { return charger_; }
  /// States of the other nodes, as the charger knows them.
  const NetworkStates& network() const { return network_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr bool has_connections =
      detail::count_objects(layout.tables(), dynamic_sdo::state, dynamic_sdo::state) != 0;
  /// Each SDO client receives one node.
  static constexpr std::size_t own_routes = NetworkStates::routes + DeviceScan::requests_max + 1 +
                                            RivalWatch::routes + 2 * has_connections +
                                            further_routes;

  TimeStamp* time_stamp() {
    if constexpr (DeviceNode<layout, own_routes>::has_time) return &device_.time_stamp();
    return nullptr;
  }

  DeviceNode<layout, own_routes> device_;
  NetworkStates network_;
  detail::Optional<SdoRequester, has_connections> sdo_requester_;
  detail::Optional<SdoClient, has_connections> battery_client_;
  Charger charger_;
};

}  // namespace canvoy::cia419
