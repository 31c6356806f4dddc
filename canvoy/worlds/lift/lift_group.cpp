#include "canvoy/worlds/lift/lift_group.hpp"

#include <cmath>

#include "canvoy/devices/cia417/group/group_device.hpp"

namespace canvoy::lift {

namespace {

/// Transfers and dwell time of a usual stop, beside the motion of the doors.
constexpr double transfer_s = 4;

Duration of_seconds(double seconds) {
  return Duration(std::llround(seconds * 1e6));
}

cia417::GroupLift kind_of(const Building& building, LiftNumber number) {
  const LiftDesign& design = building.lift(number);
  const double floor_m = building.top_m() / (building.floor_count() - 1);
  cia417::GroupLift kind;
  for (std::size_t door = 0; door < kind.served.size(); ++door) {
    for (unsigned floor = 1; floor <= building.floor_count(); ++floor) {
      const unsigned doors = building.doors_at(number, static_cast<FloorNumber>(floor));
      if ((doors >> door & 1U) != 0) kind.served.at(door).insert(floor);
    }
  }
  kind.persons_max = static_cast<std::uint8_t>(design.car.rated_persons);
  const double ramp_s = design.speed_m_s / design.acceleration_m_s2;
  const double door_s = design.door.open_time_s + design.door.close_time_s;
  kind.times = {.flight = of_seconds(floor_m / design.speed_m_s),
                .stop = of_seconds(ramp_s + door_s + transfer_s)};
  return kind;
}

cia417::GroupControllerSettings settings_of(const LiftNetworkDescription& description) {
  cia417::GroupControllerSettings settings{
      .lifts = description.building.lift_count(),
      .up_peak = {.main_floor = description.building.main_floor}};
  for (unsigned i = 1; i <= settings.lifts; ++i) {
    settings.lift.at(i - 1) = kind_of(description.building, static_cast<LiftNumber>(i));
  }
  return settings;
}

}  // namespace

struct LiftGroup::Device {
  Device(const Port& port, NodeId id, const LiftNetworkDescription& description)
      : controller(port, settings_of(description), id) {}
  cia417::GroupControllerDevice<> controller;
};

LiftGroup::LiftGroup(World& world, BusIndex bus, NodeId id,
                     const LiftNetworkDescription& description)
    : world_(&world),
      bus_(bus),
      slot_(world.add_slot(bus, controller_slot)),
      device_(std::make_unique<Device>(world.port(slot_), id, description)) {
  world.occupy(slot_, device_->controller.node());
}

LiftGroup::~LiftGroup() = default;

Node& LiftGroup::node() {
  return device_->controller.node();
}

void LiftGroup::start() {
  world_->start(slot_);
}

}  // namespace canvoy::lift
