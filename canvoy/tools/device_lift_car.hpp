// What `canvoy device lift-drive` and `lift-position` run: the drive and the position unit of a
// lift (CiA 417-4), with a simulated car.
//
//     LiftCar car(clock);
//     LiftDevice drive = make_lift_device("lift-drive", 2, port, car, false);
//     drive.node->start(now);
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/canopen/emergency_producer.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/sim/lift/car_follower.hpp"
#include "canvoy/sim/lift/car_plant.hpp"
#include "canvoy/sim/lift/shaft_cams.hpp"

namespace canvoy::tools {

/// The car that the devices of one process have in common. Where its drive is elsewhere, it follows
/// that by what it says on the bus.
class LiftCar {
 public:
  explicit LiftCar(Callback<Time()> clock) : plant_({}, clock), follower_(1, clock) {
    std::vector<double> heights_m;
    for (double height = 0; height <= lift::CarPlantDesign{}.travel_m; height += floor_height_m) {
      heights_m.push_back(height);
    }
    cams_ = lift::cams_of_shaft(heights_m, {});
  }

  cia417::CarDriveHardware drive_hardware() {
    has_drive_ = true;
    return plant_.drive_hardware();
  }
  cia417::CarPositionHardware position_hardware() {
    return {.sense = Callback<cia417::PositionReadings(unsigned)>::to<&LiftCar::sense>(*this)};
  }
  /// Of a shaft with a floor each three metres; valid as long as this.
  std::span<const cia417::Cam> cams() const { return cams_; }
  void hear(const Frame& frame, Time) { follower_.hear(frame); }

 private:
  static constexpr double floor_height_m = 3;

  cia417::PositionReadings sense(unsigned unit) {
    return has_drive_ ? plant_.position_hardware().sense(unit)
                      : follower_.position_hardware().sense(unit);
  }

  std::vector<cia417::Cam> cams_;
  lift::CarPlant plant_;
  lift::CarFollower follower_;
  bool has_drive_ = false;
};

struct LiftDevice {
  std::shared_ptr<void> device;
  Node* node = nullptr;
  EmergencyProducer* emergencies = nullptr;
};
template <class Device>
LiftDevice held(const std::shared_ptr<Device>& device) {
  return {.device = device, .node = &device->node(), .emergencies = &device->emergency_producer()};
}

inline constexpr std::string_view lift_drive_kind = "lift-drive";
inline constexpr std::string_view lift_position_kind = "lift-position";

/// The recommended node-ID of a kind; 0 where it is no device of a lift.
constexpr NodeId lift_node_id(std::string_view kind) {
  if (kind == lift_drive_kind) return 2;
  return kind == lift_position_kind ? NodeId{4} : NodeId{0};
}

/// `kind` is one of these two. With `stores` it has the objects of storage. `car` must outlive it.
LiftDevice make_lift_device(std::string_view kind, NodeId id, const Port& port, LiftCar& car,
                            bool stores);

}  // namespace canvoy::tools
