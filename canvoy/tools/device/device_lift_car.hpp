// The car of a lift that `canvoy device lift-drive` moves and `lift-position` measures.
//
//     LiftCar car(clock);
//     car.join(environment);
#pragma once

#include <vector>

#include "canvoy/devices/cia417/position/car_position_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/worlds/lift/car_follower.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/shaft_cams.hpp"

namespace canvoy::tools {

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
    environment.provide(Callback<cia417::CarDriveHardware()>::to<&LiftCar::drive_hardware>(*this));
    environment.provide(
        Callback<cia417::CarPositionHardware()>::to<&LiftCar::position_hardware>(*this));
    environment.provide(
        Callback<cia417::CarPositionSettings()>::to<&LiftCar::position_settings>(*this));
    environment.watch(
        Callback<void(cia417::CarPositionUnit&, Node&)>::to<&LiftCar::is_measured>(*this));
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
    return {.sense = Callback<cia417::PositionReadings(unsigned)>::to<&LiftCar::sense>(*this)};
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

}  // namespace canvoy::tools
