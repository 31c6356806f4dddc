// Simulated plants that the devices of one process share as sensors and actuators.
//
//     DeviceHardware hardware(options, clock);
//     hardware.join(environment);
//     hardware.step(now);   // each ChargingPlant::step_time
#pragma once

#include "canvoy/devices/cia418/battery.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/tools/device/device_lift_car.hpp"
#include "canvoy/tools/device/device_options.hpp"

namespace canvoy::tools {

/// The hardware of the devices of this process. A charger and a battery are connected to each
/// other; alone, each has a partner that follows what is agreed on the bus.
class DeviceHardware {
 public:
  DeviceHardware(const DeviceOptions& options, Callback<Time()> clock, const DeviceOutput& output)
      : plant_(BatteryPlant::lead_acid_48v(), options.state_of_charge / 100),
        car_(clock),
        units_(options.unit),
        clock_(clock),
        road_car_(options.car, output) {}

  DeviceHardware(const DeviceHardware&) = delete;
  DeviceHardware& operator=(const DeviceHardware&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment) {
    environment.provide(Callback<cia419::ChargerHardware()>::to<&DeviceHardware::charger>(*this));
    environment.provide(
        Callback<cia418::BatteryHardware()>::to<&BatteryPlant::hardware>(plant_.battery));
    environment.watch(
        Callback<void(cia418::Battery&, Node&)>::to<&DeviceHardware::is_charged>(*this));
    car_.join(environment);
    units_.join(environment);
    road_car_.join(environment);
  }

  void step(Time now) {
    units_.step(now);
    road_car_.step(now);
    if (has_charger_) return plant_.step();
    const bool flows = battery_ != nullptr && battery_->charger_ready();
    plant_.battery.step(flows ? plant_.battery.requested_ampere() : 0, ChargingPlant::step_time);
  }
  /// The vehicle and clock of a device of CiA 407, which joins nothing else.
  const DeviceCar& road_car() const { return road_car_; }
  DeviceCar& road_car() { return road_car_; }
  // The charging plant that hands of other devices act on.
  ChargingPlant& charging() { return plant_; }
  LiftCar& lift_car() { return car_; }
  LiftUnits& lift_units() { return units_; }
  Callback<Time()> clock() const { return clock_; }
  Callback<void(Time)> on_step() { return Callback<void(Time)>::to<&DeviceHardware::step>(*this); }

 private:
  /// The clock of this machine, in UTC.
  static std::optional<TimeOfDay> host_time() {
    return to_time_of_day(
        std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()));
  }
  cia419::ChargerHardware charger() {
    has_charger_ = true;
    cia419::ChargerHardware hardware = plant_.stage.hardware();
    hardware.time_of_day = {[](void*) { return host_time(); }, nullptr};
    return hardware;
  }
  void is_charged(cia418::Battery& battery, Node& /*node*/) { battery_ = &battery; }

  ChargingPlant plant_;
  LiftCar car_;
  LiftUnits units_;
  Callback<Time()> clock_;
  DeviceCar road_car_;
  const cia418::Battery* battery_ = nullptr;
  bool has_charger_ = false;
};

}  // namespace canvoy::tools
