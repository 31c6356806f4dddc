// The nodes of a lift as its description has them, each with the plant that it senses and moves.
#include <bit>
#include <cmath>
#include <utility>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/sim/lift/lift_shaft_parts.hpp"
#include "canvoy/sim/lift/shaft_cams.hpp"

namespace canvoy::lift {

namespace {

using cia417::LiftDeviceOptions;

/// A light barrier unit for all doors that there can be: of those that a car does not have it says
/// that they are not installed.
constexpr LiftDeviceOptions all_doors{.doors = 0b1111};

/// Of the rated speed: what a governor trips at (EN 81-20).
constexpr double governor_share = 1.15;

/// How the PDO of a light barrier at this door is made invalid, in a device of lift 1.
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

void LiftShaft::Parts::add_nodes() {
  for (const NodeDescription& node : description.nodes) {
    const bool is_mine = node.lift == lift && node.kind != DeviceKind::group_controller;
    if (is_mine && node.played) add_node(node);
  }
  follow_real_devices();
}

/// Which of them are elsewhere. A drive that is not described at all is one, too.
RealDevices::Wanted LiftShaft::Parts::real_devices() const {
  RealDevices::Wanted wanted{.drive = !is_played(DeviceKind::drive)};
  for (const NodeDescription& node : description.nodes) {
    if (node.lift != lift || node.played) continue;
    const bool is_panel =
        node.kind == DeviceKind::car_panel || node.kind == DeviceKind::landing_panel;
    if (is_panel) wanted.panels.insert(node.id);
    if (node.kind == DeviceKind::door) wanted.doors |= node.doors;
    if (node.kind == DeviceKind::light_barrier) wanted.light_barriers |= node.doors;
    if (node.kind == DeviceKind::load) wanted.load = true;
  }
  return wanted;
}

/// What real devices say is what their plants do: the car goes where the drive says that it goes.
void LiftShaft::Parts::follow_real_devices() {
  const RealDevices::Wanted wanted = real_devices();
  if (!wanted.any()) return;
  RealDevices::Hands hands;
  hands.door = [this](DoorNumber door, const cia417::DoorReport& said,
                      std::optional<std::uint16_t> position_mm) {
    doors.at(door - 1U)->plant.lead(now(), said, position_mm);
    kick();
  };
  hands.light_barrier = [this](DoorNumber door, cia417::Detection seen) {
    doors.at(door - 1U)->is_barred = seen == cia417::Detection::yes;
    see_again(door);
  };
  hands.load = [this](const LoadSaid& said) {
    real_load = said;
    weigh_again();
  };
  hands.drive = [this](const Frame& frame) {
    if (real_car.hear(frame)) kick();
  };
  hands.keys = [this] { kick(); };
  real = std::make_unique<RealDevices>(wanted, std::move(hands));
  const SlotIndex slot = world.add_slot(bus, {.accept_all = true});
  world.occupy(slot, *real);
  world.start(slot);
  if (wanted.drive)
    car.lead_by(Callback<cia417::MotionState()>::to<&CarFollower::motion>(real_car));
}

void LiftShaft::Parts::add_node(const NodeDescription& node) {
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
    case DeviceKind::car_panel:
    case DeviceKind::landing_panel:
      return add_panel(node);
    case DeviceKind::group_controller:
      return;
  }
}

template <class Device>
LiftShaft::Parts::SimulatedNode& LiftShaft::Parts::keep(const NodeDescription& node, SlotIndex slot,
                                                        std::shared_ptr<Device> device) {
  world.occupy(slot, device->node());
  nodes.push_back({node, slot, &device->node(), device});
  return nodes.back();
}

std::optional<NodeId> LiftShaft::Parts::id_of(DeviceKind kind, DoorNumber door) const {
  for (const NodeDescription& node : description.nodes) {
    const bool suits = door == 0 || (node.doors >> (door - 1U) & 1U) != 0;
    if (node.lift == lift && node.kind == kind && suits) return node.id;
  }
  return std::nullopt;
}

bool LiftShaft::Parts::is_played(DeviceKind kind, DoorNumber door) const {
  const std::optional<NodeId> id = id_of(kind, door);
  return id && find(*id) != nullptr;
}

ShaftControllerOptions LiftShaft::Parts::controller_options(const NodeDescription& node) const {
  ShaftControllerOptions options{
      .id = node.id,
      .doors = design.doors,
      .drive = id_of(DeviceKind::drive).value_or(node_id::drive),
      .position = id_of(DeviceKind::position).value_or(node_id::position),
      .load = id_of(DeviceKind::load).value_or(0),
      .speed_m_s = design.speed_m_s,
      .acceleration_m_s2 = design.acceleration_m_s2,
      .jerk_m_s3 = design.jerk_m_s3,
      .door_zone_m = design.door_zone_m,
      .fire_floor = description.service.fire_floor,
      .dwell = description.service.door_dwell,
      .parking_floor = description.service.parking_floor,
      .parking_after = description.service.parking_after};
  for (DoorNumber door = 1; door <= doors_max; ++door) {
    if ((design.doors >> (door - 1U) & 1U) == 0) continue;
    options.door_units.at(door - 1U) = id_of(DeviceKind::door, door).value_or(0);
    options.light_barriers.at(door - 1U) = id_of(DeviceKind::light_barrier, door).value_or(0);
  }
  for (const NodeDescription& other : description.nodes) {
    const bool is_on_bus = other.lift == lift && other.kind != DeviceKind::group_controller;
    if (is_on_bus && other.id != node.id) options.others.push_back(other.id);
  }
  for (unsigned i = 1; i <= description.building.floor_count(); ++i) {
    const auto floor = static_cast<FloorNumber>(i);
    options.heights_m.push_back(description.building.height_m(floor));
    const unsigned there = description.building.doors_at(lift, floor);
    for (std::size_t door = 0; door < options.served.size(); ++door) {
      if ((there >> door & 1U) != 0) options.served.at(door).push_back(floor);
    }
  }
  options.locked_by_key = design.locked_by_key;
  options.outputs = outputs_of_panels();
  return options;
}

std::vector<cia417::VirtualOutput> LiftShaft::Parts::outputs_of_panels() const {
  std::vector<cia417::VirtualOutput> all;
  for (const NodeDescription& node : description.nodes) {
    const bool is_panel =
        node.kind == DeviceKind::car_panel || node.kind == DeviceKind::landing_panel;
    if (node.lift != lift || !is_panel) continue;
    const PanelControls controls = controls_of(node);
    all.insert(all.end(), controls.outputs.begin(), controls.outputs.end());
  }
  return all;
}

void LiftShaft::Parts::add_controller(const NodeDescription& node) {
  const SlotIndex slot = world.add_slot(bus, controller_slot);
  auto device = std::make_shared<ShaftController>(world.port(slot), controller_options(node));
  controller = device.get();
  controller_node = nodes.size();
  keep(node, slot, std::move(device));
}

/// One device with two CAN interfaces.
void LiftShaft::join_group(BusIndex group_bus, NodeId group_controller) {
  Parts& parts = *parts_;
  if (parts.controller == nullptr) return;
  const Parts::SimulatedNode& own = parts.nodes[parts.controller_node];
  const SlotIndex slot = parts.world.add_slot(group_bus, controller_slot);
  Node& member = parts.controller->join_group(parts.world.port(slot), parts.lift, group_controller);
  parts.on_own_bus = std::make_unique<LinkedNode>(parts.world, *own.node, slot);
  parts.on_group_bus = std::make_unique<LinkedNode>(parts.world, member, own.slot);
  parts.world.occupy(own.slot, *parts.on_own_bus);
  parts.world.occupy(slot, *parts.on_group_bus);
  parts.group_slot = slot;
}

void LiftShaft::Parts::add_drive(const NodeDescription& node) {
  const SlotIndex slot = world.add_slot(bus);
  const auto in_millimetres = [](double value) {
    return static_cast<std::uint32_t>(std::lround(value * 1000));
  };
  const cia417::CarDriveSettings settings{
      .tuning = {.velocity = in_millimetres(design.speed_m_s),
                 .acceleration = in_millimetres(design.acceleration_m_s2),
                 .jerk = in_millimetres(design.jerk_m_s3)},
      .stops_for = {id_of(DeviceKind::position).value_or(node_id::position)},
      .controller = id_of(DeviceKind::lift_controller).value_or(node_id::lift_controller),
      .travel = (description.building.top_m() - description.building.height_m(1) +
                 2 * design.overtravel_m) *
                1000};
  auto device = std::make_shared<cia417::CarDriveDevice<>>(world.port(slot), node.id,
                                                           car.drive_hardware(), settings);
  drive = nodes.size();
  drive_changed = [unit = device.get()] { unit->unit().hardware_changed(); };
  keep(node, slot, std::move(device));
}

void LiftShaft::Parts::add_position(const NodeDescription& node) {
  const SlotIndex slot = world.add_slot(bus);
  const double overspeed_mm_s = design.speed_m_s * 1000 * governor_share;
  std::vector<double> heights_m;
  heights_m.reserve(description.building.floors.size());
  for (const Floor& floor : description.building.floors) heights_m.push_back(floor.height_m);
  cams = cams_of_shaft(heights_m, {.door_zone_m = design.door_zone_m,
                                   .speed_m_s = design.speed_m_s,
                                   .acceleration_m_s2 = design.acceleration_m_s2,
                                   .jerk_m_s3 = design.jerk_m_s3});
  auto device = std::make_shared<cia417::CarPositionDevice<>>(
      world.port(slot), node.id, car.position_hardware(),
      cia417::CarPositionSettings{.overspeed_millimetre_per_second = overspeed_mm_s, .cams = cams});
  keep(node, slot, std::move(device));
}

template <unsigned mask>
void LiftShaft::Parts::add_door_unit(const NodeDescription& node) {
  Door& door = *doors.at(lowest_door(mask) - 1U);
  const SlotIndex slot = world.add_slot(bus);
  const NodeId controller_id =
      id_of(DeviceKind::lift_controller).value_or(node_id::lift_controller);
  auto device = std::make_shared<cia417::CarDoorDevice<LiftDeviceOptions{.doors = mask}>>(
      world.port(slot), node.id, door.hardware(),
      cia417::CarDoorSettings{.controller = controller_id,
                              .velocity_profiles = DoorPlantOptions::profile_count,
                              .width_profiles = DoorPlantOptions::profile_count});
  door.unit = nodes.size();
  door.unit_changed = [unit = device.get()] { unit->unit().hardware_changed(); };
  keep(node, slot, std::move(device));
}

void LiftShaft::Parts::add_door(const NodeDescription& node) {
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

void LiftShaft::Parts::add_light_barrier(const NodeDescription& node) {
  const SlotIndex slot = world.add_slot(bus);
  auto device = std::make_shared<cia417::LightBarrierDevice<all_doors>>(
      world.port(slot), node.id,
      cia417::LightBarrierHardware{
          .sense = Callback<cia417::Detection(unsigned)>::to<&Parts::see>(*this)},
      cia417::LightBarrierSettings{.sensing_period = Duration{0}});
  barrier = nodes.size();
  barrier_changed = [unit = device.get()] { unit->unit().hardware_changed(); };
  leave_doors_to_others(node, device->node());
  keep(node, slot, std::move(device));
}

/// A PDO has one producer.
void LiftShaft::Parts::leave_doors_to_others(const NodeDescription& watching, Node& device) {
  auto made = std::make_unique<LeftOut>();
  for (DoorNumber door = 1; door <= doors_max; ++door) {
    const bool is_mine = (watching.doors >> (door - 1U) & 1U) != 0;
    const bool is_watched = id_of(DeviceKind::light_barrier, door).has_value();
    if (!is_mine && is_watched) made->values.push_back(without_pdo_of(door));
  }
  if (made->values.empty()) return;
  made->configuration = std::make_unique<NodeConfiguration>(device, made->values);
  left_out.push_back(std::move(made));
}

void LiftShaft::Parts::add_load(const NodeDescription& node) {
  const SlotIndex slot = world.add_slot(bus);
  const double rated_kg = design.car.rated_load_kg;
  const auto kilograms = [](double value) { return static_cast<std::uint16_t>(value); };
  auto device = std::make_shared<cia417::LoadMeasuringDevice<>>(
      world.port(slot), node.id, cell.hardware(),
      cia417::LoadSettings{.tare_kg = design.car.mass_kg,
                           .zero_load = 30,
                           .norm_load = kilograms(rated_kg * 0.5),
                           .full_load = kilograms(rated_kg * full_share),
                           .overload = kilograms(rated_kg * design.car.overload_share),
                           .sensing_period = Duration{0}});
  load = nodes.size();
  load_changed = [unit = device.get()] { unit->unit().hardware_changed(); };
  keep(node, slot, std::move(device));
}

/// What is lit and pressed where a panel hangs.
PanelControls LiftShaft::Parts::controls_of(const NodeDescription& panel) const {
  const FloorNumber highest = description.building.floor_count();
  if (panel.kind == DeviceKind::landing_panel) {
    return landing_controls({.lift = lift_of_bus,
                             .floors = panel.floors,
                             .doors = panel.doors,
                             .highest = highest,
                             .destinations = description.service.destination_control,
                             .fire_floor = description.service.fire_floor,
                             .place = {&description.building, lift},
                             .panel = panel.panel});
  }
  CarPanelOptions options{.lift = lift_of_bus,
                          .floors = panel.floors,
                          .doors = panel.doors,
                          .keys = panel.id == id_of(DeviceKind::car_panel),
                          .place = {&description.building, lift},
                          .panel = panel.panel};
  for (unsigned floor = 1; panel.floors.empty() && floor <= highest; ++floor) {
    options.floors.push_back(static_cast<FloorNumber>(floor));
  }
  return car_controls(options);
}

void LiftShaft::Parts::add_panel(const NodeDescription& node) {
  auto shown_by = [this, node](const cia417::VirtualOutput& output,
                               const cia417::OutputView& view) { shown(node, output, view); };
  panels.push_back({node, std::make_unique<LiftPanel>(world, bus, node.id, controls_of(node),
                                                      std::move(shown_by))});
}

}  // namespace canvoy::lift
