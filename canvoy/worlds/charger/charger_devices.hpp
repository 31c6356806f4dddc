// A CiA 418 battery module and a CiA 419 charger on a bus, with the battery and the power stage
// behind them, and the CANopen manager of the vehicle where there is one.
//
//     ChargerDevices devices(world, options, world.add_bus());
//     devices.on_set_point(told);
//     devices.start();
//     devices.plant().step();
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/sdo_manager.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charger_options.hpp"
#include "canvoy/worlds/charger/handshake_monitor.hpp"

namespace canvoy::charger {

namespace detail {

/// Two connections at a time, of two COB-IDs each, and one channel for requests.
inline constexpr unsigned vehicle_cob_ids = 6;
inline constexpr auto vehicle_manager_device =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.product_code = 302}), cia301::heartbeat_producer(1000),
             cia301::sdo_servers(2), cia302::sdo_manager(vehicle_cob_ids, 4));
inline constexpr auto vehicle_manager_layout = lay_out_device<vehicle_manager_device>();

}  // namespace detail

/// The CANopen manager of the vehicle with a charger and its battery: it gives SDO connections to
/// the nodes that request them (CiA 302-5; CiA 419, 6.1).
///
///     VehicleManager manager(world.port(slot), 1, {5, 10});
///     world.occupy(slot, manager.node());
class VehicleManager {
 public:
  /// `heartbeat_time_out`: a node that is silent for longer is lost, with its connections.
  VehicleManager(const Port& port, NodeId id, Duration heartbeat_time_out);
  VehicleManager(const VehicleManager&) = delete;
  VehicleManager& operator=(const VehicleManager&) = delete;

  /// The node of the manager.
  Node& node() { return device_.node(); }
  /// Connections at present.
  std::span<const SdoConnection> connections() const { return connections_; }
  /// Sets the function that is called whenever a connection may have been given, or begun to end.
  void on_change(Callback<void(Time)> changed) { manager_.on_change(changed); }

 private:
  static constexpr std::size_t routes = node_id_max + 2;

  void reset(ResetScope scope);

  DeviceNode<detail::vehicle_manager_layout, routes> device_;
  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;
  NmtMaster nodes_;
  std::array<SdoConnection, 4> connections_;
  SdoManager manager_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// A port on which frames of a kind can get lost: for the node they count as sent.
///
///     LossyPort lossy(world.port(slot));
///     Node node(tables, memory, lossy.port(), 10);
///     lossy.lose(0x70A, true);
class LossyPort {
 public:
  /// Frames go to `inner`, which is copied.
  explicit LossyPort(const Port& inner) : inner_(inner) {}
  LossyPort(const LossyPort&) = delete;
  LossyPort& operator=(const LossyPort&) = delete;

  /// Starts or stops losing 11-bit frames with this identifier.
  void lose(std::uint32_t can_id, bool lost) { lost_.set(can_id & Frame::id_max, lost); }

  /// Port for the node; valid as long as this object.
  Port port() {
    return {.context = this,
            .send = [](void* context, const Frame& frame) -> bool {
              const LossyPort& self = *static_cast<LossyPort*>(context);
              if (!frame.is_extended() && self.lost_.test(frame.id)) return true;
              return self.inner_.send(self.inner_.context, frame);
            },
            .accept =
                [](void* context, std::uint16_t id, bool wanted) {
                  const LossyPort& self = *static_cast<LossyPort*>(context);
                  if (self.inner_.accept == nullptr) return;
                  self.inner_.accept(self.inner_.context, id, wanted);
                }};
  }

 private:
  Port inner_;
  std::bitset<Frame::id_max + 1> lost_;
};

class ChargerDevices {
 public:
  /// Both must outlive this object. On the cable, the charger is before the battery.
  ChargerDevices(World& world, const ChargerOptions& options, BusIndex bus);
  ChargerDevices(const ChargerDevices&) = delete;
  ChargerDevices& operator=(const ChargerDevices&) = delete;

  /// Sets the function that receives each set-point of the charger for its power stage, in ampere.
  void on_set_point(Callback<void(double)> told) { set_point_ = told; }
  /// Sets the function that is called whenever the manager may have given or withdrawn a
  /// connection.
  void on_connections(Callback<void(Time)> changed) { connections_changed_ = changed; }
  /// Switches on all devices that are simulated here; the manager runs before the others, like the
  /// vehicle.
  void start();
  /// Switches the supply of the battery module; it boots only while its battery is plugged in.
  void power_battery(bool is_on);
  /// Plugs a battery in, or takes it away from cable and bus; there is one from the start on.
  void plug(bool is_in);

  /// True while it runs.
  bool battery_has_power() const { return world_->is_running(battery_slot_); }

  /// Rules by the configuration of the nodes, as it stands in their dictionaries.
  HandshakeRules rules() const;
  /// Settings of the battery module, by the options.
  cia418::BatterySettings battery_settings() const;

  /// The bus.
  BusIndex bus() const { return bus_; }
  /// Battery cells, cable and power stage.
  ChargingPlant& plant() { return plant_; }
  /// Battery cells, cable and power stage.
  const ChargingPlant& plant() const { return plant_; }
  /// The charger's device.
  cia419::ChargerDevice<>& charger() { return charger_; }
  /// The charger's device.
  const cia419::ChargerDevice<>& charger() const { return charger_; }
  /// The battery module.
  cia418::BatteryDevice<>& battery() { return battery_; }
  /// The battery module.
  const cia418::BatteryDevice<>& battery() const { return battery_; }
  /// Port of the battery to the bus.
  LossyPort& battery_port() { return battery_port_; }
  /// Slot of the charger.
  SlotIndex charger_slot() const { return charger_slot_; }
  /// Slot of the battery module.
  SlotIndex battery_slot() const { return battery_slot_; }
  /// Number of the charger on the bus.
  ControllerId charger_controller() const { return world_->controller(charger_slot_); }
  /// Number of the battery module on the bus.
  ControllerId battery_controller() const { return world_->controller(battery_slot_); }
  /// Empty where there is no manager.
  std::span<const SdoConnection> connections() const;

 private:
  cia419::ChargerHardware charger_hardware();
  void switch_battery();
  void deliver(double ampere);
  void start_manager();

  World* world_;
  const ChargerOptions* options_;
  BusIndex bus_;
  SlotIndex charger_slot_;
  SlotIndex battery_slot_;
  LossyPort battery_port_;
  ChargingPlant plant_;
  Callback<void(double)> power_stage_;
  Callback<void(double)> set_point_;
  Callback<void(Time)> connections_changed_;
  std::optional<WallClock> clock_;
  cia419::ChargerDevice<> charger_;
  cia418::BatteryDevice<> battery_;
  std::unique_ptr<VehicleManager> manager_;  ///< null where there is none
  bool has_battery_power_ = true;
  bool is_in_bay_ = true;  ///< the battery, with its module
};

/// With an error of the charger's meter that is drawn by the seed, within its tolerance.
ChargerOptions with_drawn_meter(ChargerOptions options);

}  // namespace canvoy::charger
