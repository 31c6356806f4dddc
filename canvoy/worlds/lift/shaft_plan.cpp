#include "canvoy/worlds/lift/shaft_plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "canvoy/worlds/lift/shaft_cams.hpp"
#include "canvoy/worlds/lift/shaft_load.hpp"

namespace canvoy::lift {

namespace {

/// On its own bus each lift is lift 1.
constexpr LiftNumber lift_of_bus = 1;

/// Share of the rated speed at which a governor trips (EN 81-20).
constexpr double governor_share = 1.15;

}  // namespace

ShaftPlan::ShaftPlan(const LiftNetworkDescription& description, LiftNumber lift)
    : description_(&description), lift_(lift) {
  for (const NodeDescription& node : description.nodes) {
    if (node.lift != lift) continue;
    bus_ = node.bus;
    break;
  }
}

bool ShaftPlan::is_of_lift(const NodeDescription& node) const {
  return node.lift == lift_ && node.kind != DeviceKind::group_controller;
}

std::vector<const NodeDescription*> ShaftPlan::nodes() const {
  std::vector<const NodeDescription*> all;
  for (const NodeDescription& node : description_->nodes) {
    if (is_of_lift(node)) all.push_back(&node);
  }
  return all;
}

const NodeDescription* ShaftPlan::find(DeviceKind kind, DoorNumber door) const {
  for (const NodeDescription& node : description_->nodes) {
    const bool suits = door == 0 || (node.doors >> (door - 1U) & 1U) != 0;
    if (node.lift == lift_ && node.kind == kind && suits) return &node;
  }
  return nullptr;
}

std::optional<NodeId> ShaftPlan::id_of(DeviceKind kind, DoorNumber door) const {
  const NodeDescription* const node = find(kind, door);
  return node == nullptr ? std::nullopt : std::optional(node->id);
}

DoorNumber ShaftPlan::lowest_door() const {
  return static_cast<DoorNumber>(std::countr_zero(design().doors) + 1);
}

RealDevices::Wanted ShaftPlan::real_devices() const {
  RealDevices::Wanted wanted{};
  const NodeDescription* const drive = find(DeviceKind::drive);
  wanted.drive = drive == nullptr || !drive->played;
  for (const NodeDescription& node : description_->nodes) {
    if (node.lift != lift_ || node.played) continue;
    if (is_panel(node.kind)) wanted.panels.insert(node.id);
    if (node.kind == DeviceKind::door) wanted.doors |= node.doors;
    if (node.kind == DeviceKind::light_barrier) wanted.light_barriers |= node.doors;
    if (node.kind == DeviceKind::load) wanted.load = true;
    if (node.kind == DeviceKind::position) wanted.position = true;
  }
  return wanted;
}

ShaftControllerOptions ShaftPlan::controller_options(NodeId controller) const {
  ShaftControllerOptions options{
      .id = controller,
      .doors = design().doors,
      .drive = id_of(DeviceKind::drive).value_or(node_id::drive),
      .position = id_of(DeviceKind::position).value_or(node_id::position),
      .load = id_of(DeviceKind::load).value_or(0),
      .speed_m_s = design().speed_m_s,
      .acceleration_m_s2 = design().acceleration_m_s2,
      .jerk_m_s3 = design().jerk_m_s3,
      .door_zone_m = design().door_zone_m,
      .fire_floor = service().fire_floor,
      .dwell = service().door_dwell,
      .parking_floor = service().parking_floor,
      .parking_after = service().parking_after};
  for (DoorNumber door = 1; door <= doors_max; ++door) {
    if ((design().doors >> (door - 1U) & 1U) == 0) continue;
    options.door_units.at(door - 1U) = id_of(DeviceKind::door, door).value_or(0);
    options.light_barriers.at(door - 1U) = id_of(DeviceKind::light_barrier, door).value_or(0);
  }
  for (const NodeDescription* other : nodes()) {
    if (other->id != controller) options.others.push_back(other->id);
  }
  for (unsigned i = 1; i <= building().floor_count(); ++i) {
    const auto floor = static_cast<FloorNumber>(i);
    options.heights_m.push_back(building().height_m(floor));
    const unsigned there = building().doors_at(lift_, floor);
    for (std::size_t door = 0; door < options.served.size(); ++door) {
      if ((there >> door & 1U) != 0) options.served.at(door).push_back(floor);
    }
  }
  options.locked_by_key = design().locked_by_key;
  options.outputs = outputs_of_panels();
  return options;
}

std::vector<cia417::VirtualOutput> ShaftPlan::outputs_of_panels() const {
  std::vector<cia417::VirtualOutput> all;
  for (const NodeDescription& node : description_->nodes) {
    if (node.lift != lift_ || !is_panel(node.kind)) continue;
    const PanelControls controls = controls_of(node);
    all.insert(all.end(), controls.outputs.begin(), controls.outputs.end());
  }
  return all;
}

cia417::CarDriveSettings ShaftPlan::drive_settings() const {
  const auto in_millimetres = [](double value) {
    return static_cast<std::uint32_t>(std::lround(value * 1000));
  };
  return {
      .tuning = {.velocity = in_millimetres(design().speed_m_s),
                 .acceleration = in_millimetres(design().acceleration_m_s2),
                 .jerk = in_millimetres(design().jerk_m_s3)},
      .stops_for = {id_of(DeviceKind::position).value_or(node_id::position)},
      .controller = id_of(DeviceKind::lift_controller).value_or(node_id::lift_controller),
      .travel = (building().top_m() - building().height_m(1) + 2 * design().overtravel_m) * 1000};
}

cia417::LoadSettings ShaftPlan::load_settings() const {
  const CarDesign& car = design().car;
  const auto kilograms = [](double value) { return static_cast<std::uint16_t>(value); };
  return {.tare_kg = car.mass_kg,
          .zero_load = 30,
          .norm_load = kilograms(car.rated_load_kg * 0.5),
          .full_load = kilograms(car.rated_load_kg * full_share),
          .overload = kilograms(car.rated_load_kg * car.overload_share),
          .sensing_period = Duration{0}};
}

std::vector<cia417::Cam> ShaftPlan::cams() const {
  std::vector<double> heights_m;
  heights_m.reserve(building().floors.size());
  for (const Floor& floor : building().floors) heights_m.push_back(floor.height_m);
  return cams_of_shaft(heights_m, {.door_zone_m = design().door_zone_m,
                                   .speed_m_s = design().speed_m_s,
                                   .acceleration_m_s2 = design().acceleration_m_s2,
                                   .jerk_m_s3 = design().jerk_m_s3});
}

double ShaftPlan::overspeed_mm_s() const {
  return design().speed_m_s * 1000 * governor_share;
}

PanelControls ShaftPlan::controls_of(const NodeDescription& panel) const {
  const FloorNumber highest = building().floor_count();
  if (panel.kind == DeviceKind::landing_panel) {
    return landing_controls({.lift = lift_of_bus,
                             .floors = panel.floors,
                             .doors = panel.doors,
                             .highest = highest,
                             .destinations = service().destination_control,
                             .fire_floor = service().fire_floor,
                             .place = {&building(), lift_},
                             .panel = panel.panel});
  }
  CarPanelOptions options{.lift = lift_of_bus,
                          .floors = panel.floors,
                          .doors = panel.doors,
                          .keys = panel.id == id_of(DeviceKind::car_panel),
                          .place = {&building(), lift_},
                          .panel = panel.panel};
  for (unsigned floor = 1; panel.floors.empty() && floor <= highest; ++floor) {
    options.floors.push_back(static_cast<FloorNumber>(floor));
  }
  return car_controls(options);
}

NodeId ShaftPlan::node_of(const ScheduledFault& fault) const {
  const auto named_or = [&](DeviceKind kind) {
    return fault.node != 0 ? fault.node : id_of(kind).value_or(0);
  };
  switch (fault.kind) {
    case FaultKind::lost_node:
      return named_or(DeviceKind::drive);
    case FaultKind::cable_cut:
      return named_or(DeviceKind::lift_controller);
    case FaultKind::babbling_node:
      return named_or(DeviceKind::car_panel);
    case FaultKind::light_barrier:
      return id_of(DeviceKind::light_barrier).value_or(0);
    case FaultKind::dead_encoder:
      return id_of(DeviceKind::position).value_or(0);
    case FaultKind::finger_protector:
    case FaultKind::motion_detector:
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
      return named_or(DeviceKind::door);
    case FaultKind::rope_sensor:
      return id_of(DeviceKind::load).value_or(0);
    case FaultKind::smoke:
      return id_of(DeviceKind::light_barrier).value_or(0);
    case FaultKind::brake:
    case FaultKind::weak_brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      return id_of(DeviceKind::drive).value_or(0);
    case FaultKind::stuck_button:
    case FaultKind::fire_alarm:
    case FaultKind::fire_brigade:
      break;
  }
  return 0;
}

bool ShaftPlan::needs(NodeId id) const {
  const auto all = nodes();
  return std::ranges::any_of(
      all, [id](const NodeDescription* node) { return node->id == id && is_needed(node->kind); });
}

CallKey ShaftPlan::stuck_button(const ScheduledFault& fault) const {
  const FloorNumber main = building().main_floor;
  const bool is_at_main = fault.spot == main;
  if (fault.spot == no_floor) return {.lift = lift_, .floor = main};
  if (service().destination_control) {
    const FloorNumber other = main == 1 ? 2 : 1;
    return {.floor = fault.spot, .to = is_at_main ? other : main};
  }
  return {.floor = fault.spot, .direction = is_at_main ? Direction::up : Direction::down};
}

std::optional<std::size_t> ShaftPlan::key_for(const CallKey& button) const {
  if (button.lift == 0) return std::nullopt;
  for (std::size_t key = 0; key < design().locked_by_key.size(); ++key) {
    if (has_floor(design().locked_by_key.at(key), button.floor)) return key;
  }
  return std::nullopt;
}

}  // namespace canvoy::lift
