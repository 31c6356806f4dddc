#include "canvoy/worlds/lift/shaft_controller.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"
#include "canvoy/devices/cia417/group/group_device.hpp"

namespace canvoy::lift {

namespace {

/// A building with 254 floors has more lamps than one group.
constexpr cia417::LiftControllerOptions with_outputs{.outputs = 8 * 254};

std::int32_t micrometres(double metres) {
  return static_cast<std::int32_t>(std::lround(metres * 1e6));
}

std::vector<std::int32_t> in_micrometres(const std::vector<double>& heights_m) {
  std::vector<std::int32_t> floors(heights_m.size());
  std::transform(heights_m.begin(), heights_m.end(), floors.begin(), micrometres);
  return floors;
}

cia417::FloorSet set_of(const FloorList& floors) {
  cia417::FloorSet set;
  for (const FloorNumber floor : floors) set.insert(floor);
  return set;
}

}  // namespace

struct ShaftController::Body {
  Body(const Port& port, const ShaftControllerOptions& wanted)
      : options(wanted),
        floors(in_micrometres(wanted.heights_m)),
        device(port, wanted.id,
               {.calls = call_settings(),
                .doors = door_settings(),
                .drive = drive_settings(),
                .lift = lift_settings(),
                .load_unit = wanted.load,
                .others = options.others,
                .outputs = options.outputs}) {}

  cia417::CallControllerSettings call_settings() const;
  cia417::CarDoorControllerSettings door_settings() const;
  cia417::CarDriveControllerSettings drive_settings() const;
  cia417::LiftControllerSettings lift_settings() const;

  ShaftControllerOptions options;
  std::vector<std::int32_t> floors;
  cia417::LiftControllerDevice<with_outputs> device;
  std::unique_ptr<cia417::GroupMemberDevice<>> member;
};

cia417::CallControllerSettings ShaftController::Body::call_settings() const {
  cia417::CallControllerSettings settings;
  for (std::size_t door = 0; door < settings.served.size(); ++door) {
    const bool is_there = (options.doors >> door & 1U) != 0;
    const auto top = static_cast<std::uint8_t>(options.heights_m.size());
    settings.served.at(door) = cia417::FloorSet{};
    if (!is_there) continue;
    settings.served.at(door) = options.served.at(door).empty() ? cia417::FloorSet::between(1, top)
                                                               : set_of(options.served.at(door));
  }
  for (std::size_t key = 0; key < settings.locked_by_key.size(); ++key) {
    settings.locked_by_key.at(key) = set_of(options.locked_by_key.at(key));
  }
  return settings;
}

cia417::CarDoorControllerSettings ShaftController::Body::door_settings() const {
  return {.doors = static_cast<cia417::DoorMask>(options.doors),
          .door_units = options.door_units,
          .light_barrier_units = options.light_barriers};
}

cia417::CarDriveControllerSettings ShaftController::Body::drive_settings() const {
  const double jerk = options.jerk_m_s3 * 1000;
  return {.drive = options.drive,
          .position_unit = options.position,
          .ramps = {.velocity = options.speed_m_s * 1000,
                    .acceleration = options.acceleration_m_s2 * 1000,
                    .deceleration = options.acceleration_m_s2 * 1000,
                    .jerk = {jerk, jerk, jerk, jerk}}};
}

cia417::LiftControllerSettings ShaftController::Body::lift_settings() const {
  return {.floors = floors,
          .door_zone_micrometre = micrometres(options.door_zone_m),
          .fire_floor = options.fire_floor,
          .parking_floor = options.parking_floor,
          .times = {.dwell_car = options.dwell,
                    .dwell_hall = options.dwell,
                    .parking = options.parking_after}};
}

ShaftController::ShaftController(const Port& port, const ShaftControllerOptions& options)
    : body_(std::make_unique<Body>(port, options)) {}

ShaftController::~ShaftController() = default;

Node& ShaftController::node() {
  return body_->device.node();
}

EmergencyProducer& ShaftController::emergency_producer() {
  return body_->device.emergency_producer();
}

Node& ShaftController::join_group(const Port& port, LiftNumber lift, NodeId group_controller) {
  body_->member = std::make_unique<cia417::GroupMemberDevice<>>(
      port, lift, body_->device.node(), body_->device.calls(), body_->device.lift(),
      group_controller);
  return body_->member->node();
}

void ShaftController::set(cia417::SpecialFunction function, bool on) {
  body_->device.calls().set(function, on);
  body_->device.lift().update();
}

LiftMode ShaftController::mode() const {
  const cia417::LiftController& lift = body_->device.lift();
  if (lift.fault() != cia417::LiftFault::none) return LiftMode::fault;
  if (lift.is_starting()) return LiftMode::starting;
  switch (lift.service()) {
    case cia417::LiftService::normal:
      return LiftMode::normal;
    case cia417::LiftService::fire_recall:
      return LiftMode::fire_recall;
    case cia417::LiftService::fire_brigade:
      return LiftMode::fire_brigade;
    case cia417::LiftService::out_of_order:
      return LiftMode::out_of_order;
    default:
      return LiftMode::special;
  }
}

Direction ShaftController::direction() const {
  const cia417::Direction direction = body_->device.lift().direction();
  if (direction == cia417::Direction::up) return Direction::up;
  return direction == cia417::Direction::down ? Direction::down : Direction::none;
}

}  // namespace canvoy::lift
