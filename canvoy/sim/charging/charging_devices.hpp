// A CiA 418 battery module and a CiA 419 charger on a bus, with the battery and the power stage
// behind them, and the CANopen manager of the vehicle where there is one.
//
//     ChargingDevices devices(world, options);
//     devices.on_set_point(told);
//     devices.start();
//     devices.plant().step();
#pragma once

#include <memory>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/sim/charging/charging_options.hpp"
#include "canvoy/sim/charging/handshake_monitor.hpp"
#include "canvoy/sim/charging/lossy_port.hpp"
#include "canvoy/sim/charging/vehicle_manager.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::charging {

class ChargingDevices {
 public:
  /// Both must outlive this. The charger is in front of the battery on the cable.
  ChargingDevices(World& world, const ChargingOptions& options);
  ChargingDevices(const ChargingDevices&) = delete;
  ChargingDevices& operator=(const ChargingDevices&) = delete;

  /// Whenever the charger tells its power stage how much to deliver, in ampere.
  void on_set_point(Callback<void(double)> told) { set_point_ = told; }
  /// Whenever the manager may have given a connection, or taken it back.
  void on_connections(Callback<void(Time)> changed) { connections_changed_ = changed; }
  /// Gives all power that are played here; the manager is there before the others, as the vehicle
  /// is.
  void start();
  void power_battery(bool is_on) {
    is_on ? world_->start(battery_slot_) : world_->stop(battery_slot_);
  }

  bool battery_has_power() const { return world_->is_running(battery_slot_); }

  /// What the nodes are configured to, as it stands in their dictionaries.
  HandshakeRules rules() const;
  cia418::BatterySettings battery_settings() const;

  BusIndex bus() const { return bus_; }
  ChargingPlant& plant() { return plant_; }
  const ChargingPlant& plant() const { return plant_; }
  cia419::ChargerDevice<>& charger() { return charger_; }
  const cia419::ChargerDevice<>& charger() const { return charger_; }
  cia418::BatteryDevice<>& battery() { return battery_; }
  const cia418::BatteryDevice<>& battery() const { return battery_; }
  /// The battery's way to the bus.
  LossyPort& battery_port() { return battery_port_; }
  SlotIndex charger_slot() const { return charger_slot_; }
  SlotIndex battery_slot() const { return battery_slot_; }
  ControllerId charger_controller() const { return world_->controller(charger_slot_); }
  ControllerId battery_controller() const { return world_->controller(battery_slot_); }
  /// Empty where there is no manager.
  std::span<const SdoConnection> connections() const;

 private:
  cia419::ChargerHardware charger_hardware();
  void deliver(double ampere);
  void start_manager();

  World* world_;
  const ChargingOptions* options_;
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
  std::unique_ptr<VehicleManager> manager_;  ///< where there is one
};

}  // namespace canvoy::charging
