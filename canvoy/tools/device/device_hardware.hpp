// Simulated plants that the devices of one process share as sensors and actuators.
//
//     DeviceHardware hardware(options, clock);
//     hardware.join(environment);
//     hardware.step(now);   // each ChargingPlant::step_time
#pragma once

#include <vector>

#include "canvoy/devices/cia417/position/car_position_unit.hpp"
#include "canvoy/devices/cia418/battery.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/tools/device/device_options.hpp"
#include "canvoy/worlds/lift/car_follower.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/shaft_cams.hpp"

namespace canvoy::tools {

// The car of a lift that `canvoy device lift-drive` moves and `lift-position` measures.
//
//     LiftCar car(clock);
//     car.join(environment);

/// The car that the devices of one process share. If its drive is elsewhere, the car follows the
/// messages of the drive on the bus.
class LiftCar {
 public:
  explicit LiftCar(Callback<Time()> clock) : plant_({}, clock), follower_(1, clock) {
    std::vector<double> heights_m;
    for (double height = 0; height <= lift::CarPlantDesign{}.travel_m; height += floor_height_m) {
      heights_m.push_back(height);
    }
    cams_ = lift::cams_of_shaft(heights_m, {});
  }

  LiftCar(const LiftCar&) = delete;
  LiftCar& operator=(const LiftCar&) = delete;

  lift::CarPlant& plant() { return plant_; }

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment) {
    environment.provide(callback<&LiftCar::drive_hardware>(*this));
    environment.provide(callback<&LiftCar::position_hardware>(*this));
    environment.provide(callback<&LiftCar::position_settings>(*this));
    environment.watch(callback<&LiftCar::is_measured>(*this));
  }

 private:
  static constexpr double floor_height_m = 3;
  /// CAN-IDs that a car without its drive must receive: control, status, heartbeat.
  static constexpr std::uint16_t of_drive[] = {0x180, 0x181, 0x185, 0x702};

  cia417::CarDriveHardware drive_hardware() {
    has_drive_ = true;
    return plant_.drive_hardware();
  }
  cia417::CarPositionHardware position_hardware() {
    return {.sense = callback<&LiftCar::sense>(*this)};
  }
  /// Settings of a shaft with one floor every three metres.
  cia417::CarPositionSettings position_settings() { return {.cams = cams_}; }
  void is_measured(cia417::CarPositionUnit& /*unit*/, Node& node) {
    for (const std::uint16_t can_id : of_drive) {
      node.router().add(can_id, Router::Receiver::to<&LiftCar::hear>(*this));
    }
  }
  void hear(const Frame& frame, Time) { follower_.hear(frame); }

  cia417::PositionReadings sense(unsigned unit) {
    return has_drive_ ? plant_.position_hardware().sense(unit)
                      : follower_.position_hardware().sense(unit);
  }

  std::vector<cia417::Cam> cams_;
  lift::CarPlant plant_;
  lift::CarFollower follower_;
  bool has_drive_ = false;
};

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
    environment.provide(callback<&DeviceHardware::charger>(*this));
    environment.provide(callback<&BatteryPlant::hardware>(plant_.battery));
    environment.watch(battery_);
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
  Callback<void(Time)> on_step() { return callback<&DeviceHardware::step>(*this); }

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

  ChargingPlant plant_;
  LiftCar car_;
  LiftUnits units_;
  Callback<Time()> clock_;
  DeviceCar road_car_;
  const cia418::Battery* battery_ = nullptr;
  bool has_charger_ = false;
};

}  // namespace canvoy::tools
