#include "canvoy/worlds/lift/shaft_units.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"

namespace canvoy::lift {

namespace {

constexpr double near_floor_m = 0.05;

CarPlantDesign plant_of(const Building& building, const LiftDesign& design) {
  constexpr double gravity = 9.81;
  constexpr double test_share = 1.25;
  const CarDesign& of_car = design.car;
  const double test_n = gravity * (test_share - design.balance) * of_car.rated_load_kg;
  return {.car_kg = of_car.mass_kg,
          .counterweight_kg = of_car.mass_kg + design.balance * of_car.rated_load_kg,
          .travel_m = building.top_m(),
          .overtravel_m = design.overtravel_m,
          .stretch_um_per_kg = of_car.rope_stretch_um_per_kg,
          .brake_force_n = std::max(CarPlantDesign{}.brake_force_n, 2 * test_n),
          .brake_test_n = test_n,
          .has_brake_test = design.has_brake_test};
}

SafetyChainDesign chain_of(const LiftDesign& design) {
  return {.rated_speed_m_s = design.speed_m_s,
          .door_zone_m = design.door_zone_m,
          .final_limit_m = design.overtravel_m / 3,
          .is_bridged = !design.has_safety_chain};
}

}  // namespace

/// On its own bus each lift is lift 1.
ShaftCar::ShaftCar(const Building& building, LiftNumber lift, Callback<Time()> clock)
    : building_(&building),
      plant_(plant_of(building, building.lift(lift)), clock),
      chain_(chain_of(building.lift(lift))),
      real_(1, clock) {}

void ShaftCar::follow_real_drive() {
  is_led_ = true;
  plant_.lead_by(callback<&CarFollower::motion>(real_));
}

SafetySight ShaftCar::sight(Time now, const ShaftDoors& doors) {
  const CarPlant::Truth car = plant_.truth();
  const double below_m = building_->height_m(1) - car.position_m;
  SafetySight seen{.from_floor_m = 1e9,
                   .beyond_m = std::max(below_m, car.position_m - building_->top_m()),
                   .speed_m_s = std::abs(car.velocity_m_s),
                   .gear_is_caught = car.gear_is_caught,
                   .brake_slips = plant_.brake_has_slipped()};
  for (const Floor& each : building_->floors) {
    seen.from_floor_m = std::min(seen.from_floor_m, std::abs(each.height_m - car.position_m));
  }
  for (const auto& door : doors) {
    if (!door->is_there()) continue;
    const bool is_closed = door->plant().contact_is_closed(now);
    if (!is_closed || !door->plant().is_locked(now)) seen.doors_are_locked = false;
    if (!is_closed) seen.is_a_door_open = true;
  }
  return seen;
}

void ShaftCar::look_at_chain(Time now, const ShaftDoors& doors) {
  chain_.look(sight(now, doors));
  const bool is_caught = plant_.truth().gear_is_caught;
  if (chain_.wants_gear() && !is_caught && !is_cranked_) plant_.arrest();
  const bool is_cut = !chain_.is_closed() || is_stopped_by_hand_;
  if (plant_.is_cut() == is_cut) return;
  plant_.cut(is_cut);
  drive_.tell();
}

bool ShaftCar::crank(double metre_per_second) {
  if (is_led_) return false;
  const bool moves = metre_per_second != 0;
  if (moves && !is_cranked_) was_caught_ = plant_.truth().gear_is_caught;
  if (moves) plant_.release_gear();
  is_cranked_ = moves;
  plant_.crank(metre_per_second);
  if (!moves && was_caught_) plant_.arrest();
  return true;
}

FloorNumber ShaftCar::floor() {
  return building_->floor_near(plant_.truth().position_m, near_floor_m);
}

void ShaftCar::lose_drive() {
  const cia417::CarDriveHardware stage = plant_.drive_hardware();
  stage.release_brake(false);
  stage.power(false);
}

void ShaftCar::set_fault(FaultKind kind, bool present) {
  constexpr double slip_share = 0.1;
  CarPlantFaults faults = plant_.faults();
  if (kind == FaultKind::brake) has_no_brake_ = present;
  if (kind == FaultKind::weak_brake) has_weak_brake_ = present;
  faults.brake_share = has_no_brake_ ? 0 : has_weak_brake_ ? plant_.weak_brake_share() : 1;
  if (kind == FaultKind::rope_slip) faults.slip = present ? slip_share : 0;
  if (kind == FaultKind::runaway) faults.motor_runs_away = present;
  // It keeps its last position, and reports the defect.
  if (kind == FaultKind::dead_encoder) {
    faults.position_encoder_is_dead = faults.position_encoder_alarms = present;
  }
  plant_.set_faults(faults);
}

bool ShaftCar::is_whole() const {
  const CarPlantFaults& broken = plant_.faults();
  return broken.brake_share == 1 && broken.slip == 0 && !broken.motor_runs_away;
}

void ShaftCar::reset_by_hand() {
  plant_.release_gear();
  chain_.reset_by_hand();
}

void ShaftCar::reset_brake() {
  plant_.forget_brake_test();
  chain_.reset_brake();
}

namespace {

using cia417::LiftDeviceOptions;

/// A light barrier unit for the greatest number of doors: it reports those that a car does not have
/// as not installed.
constexpr LiftDeviceOptions all_doors{.doors = 0b1111};

/// Value that makes the PDO of a light barrier at this door invalid, in a device of lift 1.
NodeValue without_pdo_of(DoorNumber door) {
  constexpr std::uint16_t receive_to_transmit = 0x400;
  constexpr std::uint8_t can_id_sub = 1;
  NodeValue value{.sub = can_id_sub, .bytes = std::vector<std::uint8_t>(4)};
  for (const cia417::LiftPdo& row : cia417::lift_pdo_table<1>) {
    const bool is_it =
        row.mapping[0] == cia417::mapped_in(1, cia417::light_barrier_status_object, door);
    if (!is_it) continue;
    value.index = static_cast<std::uint16_t>(row.rpdo + receive_to_transmit);
    store(value.bytes.data(), row.cob_id | cia417::invalid_pdo);
  }
  return value;
}

DoorNumber lowest_door(unsigned doors) {
  return static_cast<DoorNumber>(std::countr_zero(doors) + 1);
}

}  // namespace

void ShaftUnits::add(const NodeDescription& node) {
  switch (node.kind) {
    case DeviceKind::lift_controller:
      return add_controller(node);
    case DeviceKind::drive:
      return add_drive(node);
    case DeviceKind::position:
      return add_position(node);
    case DeviceKind::door:
      return add_door(node);
    case DeviceKind::light_barrier:
      return add_light_barrier(node);
    case DeviceKind::load:
      return add_load(node);
    case DeviceKind::sensors:
      return add_sensors(node);
    case DeviceKind::car_panel:
    case DeviceKind::landing_panel:
    case DeviceKind::group_controller:
      return;
  }
}

template <class Device>
void ShaftUnits::keep(const NodeDescription& node, SlotIndex slot, std::shared_ptr<Device> device) {
  world_->occupy(slot, device->node());
  nodes_->add(node.id, node.kind, slot, device->node());
  devices_.push_back(std::move(device));
}

template <class Device>
ChangeSignal ShaftUnits::signal_to(Device& device, SlotIndex slot) const {
  return {*world_, slot, [&device] { device.unit().hardware_changed(); }};
}

void ShaftUnits::add_controller(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus(), controller_slot);
  auto device =
      std::make_shared<ShaftController>(world_->port(slot), plan_->controller_options(node.id));
  controller_ = device.get();
  controller_id_ = node.id;
  keep(node, slot, std::move(device));
}

void ShaftUnits::set_special(cia417::SpecialFunction function, bool on) {
  const std::optional<SlotIndex> slot = nodes_->slot(controller_id_);
  if (controller_ == nullptr || !slot || !world_->is_running(*slot)) return;
  controller_->node().advance(world_->now());
  controller_->set(function, on);
  world_->touched(*slot);
}

void ShaftUnits::join_group(BusIndex group_bus, NodeId group_controller) {
  if (controller_ == nullptr) return;
  const SlotIndex slot = world_->add_slot(group_bus, controller_slot);
  Node& member = controller_->join_group(world_->port(slot), plan_->lift(), group_controller);
  nodes_->link(controller_id_, slot, member);
}

void ShaftUnits::add_drive(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus());
  auto device = std::make_shared<cia417::CarDriveDevice<>>(
      world_->port(slot), node.id, plants_.car.plant().drive_hardware(), plan_->drive_settings());
  plants_.car.has_drive_unit(signal_to(*device, slot));
  keep(node, slot, std::move(device));
}

void ShaftUnits::add_position(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus());
  auto device = std::make_shared<cia417::CarPositionDevice<>>(
      world_->port(slot), node.id, plants_.car.plant().position_hardware(),
      cia417::CarPositionSettings{.overspeed_millimetre_per_second = plan_->overspeed_mm_s(),
                                  .cams = cams_});
  keep(node, slot, std::move(device));
}

template <unsigned mask>
void ShaftUnits::add_door_unit(const NodeDescription& node) {
  ShaftDoor& door = *plants_.doors.at(lowest_door(mask) - 1U);
  const SlotIndex slot = world_->add_slot(plan_->bus());
  const NodeId controller =
      plan_->id_of(DeviceKind::lift_controller).value_or(node_id::lift_controller);
  auto device = std::make_shared<cia417::CarDoorDevice<LiftDeviceOptions{.doors = mask}>>(
      world_->port(slot), node.id, door.hardware(),
      cia417::CarDoorSettings{.controller = controller,
                              .velocity_profiles = DoorPlantOptions::profile_count,
                              .width_profiles = DoorPlantOptions::profile_count});
  door.has_unit(node.id, signal_to(*device, slot));
  keep(node, slot, std::move(device));
}

void ShaftUnits::add_door(const NodeDescription& node) {
  switch (lowest_door(node.doors)) {
    case 1:
      return add_door_unit<0b0001>(node);
    case 2:
      return add_door_unit<0b0010>(node);
    case 3:
      return add_door_unit<0b0100>(node);
    default:
      return add_door_unit<0b1000>(node);
  }
}

void ShaftUnits::add_light_barrier(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus());
  auto device = std::make_shared<cia417::LightBarrierDevice<all_doors>>(
      world_->port(slot), node.id, plants_.barrier.hardware(),
      cia417::LightBarrierSettings{.sensing_period = Duration{0}});
  plants_.barrier.has_unit(signal_to(*device, slot));
  leave_doors_to_others(node, device->node());
  keep(node, slot, std::move(device));
}

/// A PDO has one producer.
void ShaftUnits::leave_doors_to_others(const NodeDescription& watching, Node& device) {
  auto made = std::make_unique<LeftOut>();
  for (DoorNumber door = 1; door <= doors_max; ++door) {
    const bool is_mine = (watching.doors >> (door - 1U) & 1U) != 0;
    const bool is_watched = plan_->id_of(DeviceKind::light_barrier, door).has_value();
    if (!is_mine && is_watched) made->values.push_back(without_pdo_of(door));
  }
  if (made->values.empty()) return;
  made->configuration = std::make_unique<NodeConfiguration>(device, made->values);
  left_out_.push_back(std::move(made));
}

void ShaftUnits::add_load(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus());
  auto device = std::make_shared<cia417::LoadMeasuringDevice<>>(
      world_->port(slot), node.id, plants_.load.cell().hardware(), plan_->load_settings());
  plants_.load.has_unit(signal_to(*device, slot));
  keep(node, slot, std::move(device));
}

void ShaftUnits::add_sensors(const NodeDescription& node) {
  const SlotIndex slot = world_->add_slot(plan_->bus());
  const FloorNumber floor = node.floors.empty() ? cia417::floor_of_car : node.floors.front();
  sensors_.push_back(std::make_shared<ShaftSensors>(*world_, slot, node.id, floor));
  keep(node, slot, sensors_.back());
}

ShaftSensors* ShaftUnits::sensors(NodeId id) const {
  const auto found =
      std::ranges::find_if(sensors_, [id](const auto& each) { return each->node().id() == id; });
  return found == sensors_.end() ? nullptr : found->get();
}

void ShaftUnits::smoke_in_car(bool is_there) {
  for (const auto& each : sensors_) {
    if (each->floor() != cia417::floor_of_car) continue;
    each->set_level(cia417::SensorFunction::smoke, is_there);
  }
}

}  // namespace canvoy::lift
