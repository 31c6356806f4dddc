// A CiA 418 battery module and a CiA 419 charger on a bus, with the battery and the power stage
// behind them, and the CANopen manager of the vehicle where there is one.
//
//     ChargerDevices devices(world, options, world.add_bus());
//     devices.on_set_point(told);
//     devices.start();
//     devices.plant().step();
#pragma once

#include <memory>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charger_options.hpp"
#include "canvoy/worlds/charger/handshake_monitor.hpp"
#include "canvoy/worlds/charger/lossy_port.hpp"
#include "canvoy/worlds/charger/vehicle_manager.hpp"

namespace canvoy::charger {

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
