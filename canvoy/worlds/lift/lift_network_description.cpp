#include "canvoy/worlds/lift/lift_network_description.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "canvoy/worlds/lift/norm_bounds.hpp"

namespace canvoy::lift {

namespace {

constexpr std::array<std::string_view, 10> kind_names = {
    "lift-controller",    "lift-group-controller", "lift-drive", "lift-position",
    "lift-door",          "lift-light-barrier",    "lift-load",  "lift-car-panel",
    "lift-landing-panel", "lift-sensors"};
/// Older files leave it out.
constexpr std::string_view prefix = "lift-";

constexpr unsigned node_id_max = 127;

unsigned door_bit(DoorNumber door) {
  return 1U << (door - 1U);
}

class Standard {
 public:
  explicit Standard(LiftNetworkDescription& made) : made_(made) {}

  void add_lift(LiftNumber lift) {
    bus_ = made_.buses.size();
    lift_ = lift;
    made_.buses.push_back({.name = "lift" + std::to_string(lift)});
    add(node_id::lift_controller, DeviceKind::lift_controller);
    add(node_id::drive, DeviceKind::drive);
    add(node_id::position, DeviceKind::position);
    add_doors();
    add(node_id::load, DeviceKind::load);
    add(node_id::first_car_panel, DeviceKind::car_panel, doors());
    add_landings();
  }
  void add_group() {
    bus_ = made_.buses.size();
    lift_ = 0;
    made_.buses.push_back({.name = "group"});
    add(node_id::group_controller, DeviceKind::group_controller);
  }

 private:
  unsigned doors() const { return made_.building.lift(lift_).doors; }
  void add_doors() {
    for (DoorNumber door = 1; door <= doors_max; ++door) {
      if ((doors() & door_bit(door)) == 0) continue;
      // A fourth door has no recommended node-ID; 12, of the car top box, is free here.
      const unsigned id = door <= 3 ? node_id::first_door + door - 1U : 12U;
      add(id, DeviceKind::door, door_bit(door));
    }
    add(node_id::first_light_barrier, DeviceKind::light_barrier, doors());
  }
  /// A panel for each floor; where there are more floors than node-IDs, one for several.
  void add_landings() {
    constexpr unsigned ids = node_id::last_landing_panel - node_id::first_landing_panel + 1U;
    const unsigned all = made_.building.floor_count();
    const unsigned each = (all + ids - 1) / ids;
    for (unsigned first = 1, id = node_id::first_landing_panel; first <= all; first += each, ++id) {
      NodeDescription& panel = add(id, DeviceKind::landing_panel, doors());
      for (unsigned floor = first; floor <= std::min(all, first + each - 1); ++floor) {
        panel.floors.push_back(static_cast<FloorNumber>(floor));
      }
    }
  }
  NodeDescription& add(unsigned id, DeviceKind kind, unsigned doors = 1) {
    made_.nodes.push_back(
        {.bus = bus_, .id = static_cast<NodeId>(id), .kind = kind, .lift = lift_, .doors = doors});
    return made_.nodes.back();
  }

  LiftNetworkDescription& made_;
  std::size_t bus_ = 0;
  LiftNumber lift_ = 1;
};

std::string name_of(const NodeDescription& node) {
  return std::string(device_kind_name(node.kind)) + " with node-ID " + std::to_string(node.id);
}

/// Landing panels have at least one floor; sensors at most one: without one they are in the car.
std::string check_floor_count(const NodeDescription& node) {
  switch (node.kind) {
    case DeviceKind::landing_panel:
      return node.floors.empty() ? " needs a floor" : "";
    case DeviceKind::sensors:
      return node.floors.size() > 1 ? " has one floor, or none in the car" : "";
    default:
      return node.floors.empty() ? "" : " hangs at no floor";
  }
}

std::string check_node(const LiftNetworkDescription& description, const NodeDescription& node) {
  const Building& building = description.building;
  if (node.bus >= description.buses.size()) return name_of(node) + " is on a bus that is not there";
  if (node.id < 1 || node.id > node_id_max) return name_of(node) + ": node-IDs are 1 to 127";
  const bool needs_lift = node.kind != DeviceKind::group_controller;
  if (needs_lift && (node.lift < 1 || node.lift > building.lift_count())) {
    return name_of(node) + " belongs to a lift that is not there";
  }
  for (const FloorNumber floor : node.floors) {
    if (floor < 1 || floor > building.floor_count()) {
      return name_of(node) + " hangs at a floor that is not there";
    }
  }
  const std::string misplaced = check_floor_count(node);
  if (!misplaced.empty()) return name_of(node) + misplaced;
  if (node.doors == 0 || node.doors >= 1U << doors_max) return name_of(node) + " has no such door";
  if (!is_panel(node.kind) && node.panel != PanelDescription{})
    return name_of(node) + " is no panel";
  for (const FloorNumber floor : node.floors) {
    if (!needs_lift || building.serves(node.lift, floor)) continue;
    return name_of(node) + ": lift " + std::to_string(node.lift) + " does not serve floor " +
           std::to_string(floor) + ": leave it out";
  }
  return {};
}

std::string check_building(const Building& building) {
  if (building.floors.size() < 2 || building.floors.size() > floors_max) {
    return "a building has 2 to 254 floors";
  }
  if (building.lifts.empty() || building.lifts.size() > lifts_max) {
    return "a building has 1 to 8 lifts";
  }
  if (building.main_floor < 1 || building.main_floor > building.floor_count()) {
    return "the main floor is not there";
  }
  const auto is_higher = [](const Floor& a, const Floor& b) { return a.height_m >= b.height_m; };
  const auto& floors = building.floors;
  if (std::adjacent_find(floors.begin(), floors.end(), is_higher) != floors.end()) {
    return "a floor is not higher than the one below it";
  }
  return {};
}

/// Checks floors that a lift names.
std::string check_floors(const Building& building, const FloorList& floors,
                         const std::string& who) {
  for (const FloorNumber floor : floors) {
    if (floor >= 1 && floor <= building.floor_count()) continue;
    return who + " names floor " + std::to_string(floor) + ", which is not there";
  }
  return {};
}

std::string check_lift(const Building& building, LiftNumber number) {
  const LiftDesign& design = building.lift(number);
  const std::string who = "lift " + std::to_string(number);
  const auto is_its = [&](const Zone& zone) { return zone.name == design.zone; };
  if (!design.zone.empty() && std::ranges::none_of(building.zones, is_its)) {
    return who + ": there is no zone '" + design.zone + "'; write [[zone]] with this name";
  }
  std::string error = check_floors(building, design.floors, who);
  for (const auto& floors : design.floors_of_door) {
    if (error.empty()) error = check_floors(building, floors, who);
  }
  for (const auto& floors : design.locked_by_key) {
    if (error.empty()) error = check_floors(building, floors, who);
  }
  if (!error.empty()) return error;
  unsigned doors = 0;
  unsigned served = 0;
  for (unsigned floor = 1; floor <= building.floor_count(); ++floor) {
    const unsigned there = building.doors_at(number, static_cast<FloorNumber>(floor));
    doors |= there;
    served += there != 0 ? 1 : 0;
  }
  if (served < 2) return who + " serves " + (served == 0 ? "no floor" : "one floor alone");
  for (DoorNumber door = 1; door <= doors_max; ++door) {
    const bool is_there = (design.doors & door_bit(door)) != 0;
    const std::string its = "door " + std::to_string(door) + " of " + who;
    if (is_there && (doors & door_bit(door)) == 0) return its + " opens at no floor";
    if (!is_there && !design.floors_of_door.at(door - 1U).empty()) return its + " is not there";
  }
  return {};
}

std::string check_lifts(const LiftNetworkDescription& description) {
  const Building& building = description.building;
  const LiftService& service = description.service;
  std::set<std::string> zones;
  for (const Zone& zone : building.zones) {
    if (zone.name.empty() || !zones.insert(zone.name).second) {
      return "zone '" + zone.name + "' needs a name of its own";
    }
    std::string error = check_floors(building, zone.floors, "zone '" + zone.name + "'");
    if (!error.empty()) return error;
  }
  for (LiftNumber lift = 1; lift <= building.lift_count(); ++lift) {
    std::string error = check_lift(building, lift);
    if (!error.empty()) return error;
    error = beyond_norm(building.lift(lift));
    if (!error.empty()) return "lift " + std::to_string(lift) + ": " + error;
    const std::string who = "lift " + std::to_string(lift) + " does not serve the ";
    if (!building.serves(lift, service.fire_floor)) return who + "fire floor";
    const bool parks = service.parking_floor != no_floor;
    if (parks && !building.serves(lift, service.parking_floor)) return who + "parking floor";
  }
  for (const Arrival& arrival : description.arrivals) {
    if (building.has_way(arrival.from, arrival.to)) continue;
    return "no lift goes from floor " + std::to_string(arrival.from) + " to floor " +
           std::to_string(arrival.to);
  }
  return {};
}

/// A press of up or down does not give a group the destination.
std::string check_group(const LiftNetworkDescription& description) {
  const Building& building = description.building;
  const auto is_group = [](const NodeDescription& node) {
    return node.kind == DeviceKind::group_controller;
  };
  const bool has_group = std::ranges::any_of(description.nodes, is_group);
  if (!has_group || description.service.destination_control) return {};
  for (LiftNumber lift = 2; lift <= building.lift_count(); ++lift) {
    for (unsigned i = 1; i <= building.floor_count(); ++i) {
      const auto floor = static_cast<FloorNumber>(i);
      if (building.serves(1, floor) == building.serves(lift, floor)) continue;
      return "lifts 1 and " + std::to_string(lift) +
             " of the group do not serve the same floors: say destination_control = true, or leave "
             "the group controller out";
    }
  }
  return {};
}

std::string check_service(const LiftNetworkDescription& description) {
  const FloorNumber highest = description.building.floor_count();
  const LiftService& service = description.service;
  if (service.fire_floor < 1 || service.fire_floor > highest) return "the fire floor is not there";
  if (service.parking_floor > highest) return "the parking floor is not there";
  return {};
}

bool has_node(const LiftNetworkDescription& description, LiftNumber lift, NodeId id) {
  const auto is_it = [&](const NodeDescription& node) {
    return node.lift == lift && (id == 0 || node.id == id);
  };
  return std::any_of(description.nodes.begin(), description.nodes.end(), is_it);
}

/// Kind of the device at which a fault is, where it is at one.
std::optional<DeviceKind> place_of(FaultKind kind) {
  if (is_of_door(kind)) return DeviceKind::door;
  switch (kind) {
    case FaultKind::light_barrier:
    case FaultKind::smoke:
      return DeviceKind::light_barrier;
    case FaultKind::dead_encoder:
      return DeviceKind::position;
    case FaultKind::rope_sensor:
      return DeviceKind::load;
    case FaultKind::brake:
    case FaultKind::weak_brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      return DeviceKind::drive;
    default:
      return std::nullopt;
  }
}

/// Kind of the device where the plan names no node.
std::optional<DeviceKind> usual_place_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::lost_node:
      return DeviceKind::drive;
    case FaultKind::cable_cut:
      return DeviceKind::lift_controller;
    case FaultKind::babbling_node:
      return DeviceKind::car_panel;
    default:
      return place_of(kind);
  }
}

bool hangs_at(const NodeDescription& node, FloorNumber floor) {
  return node.kind == DeviceKind::landing_panel &&
         std::ranges::find(node.floors, floor) != node.floors.end();
}

/// True if the fault can be made at this node.
bool is_made_at(const LiftNetworkDescription& description, const ScheduledFault& fault,
                const NodeDescription& node) {
  const bool is_of_all = fault.kind == FaultKind::fire_alarm && fault.part == 0;
  if (node.lift != fault.part && !(is_of_all && node.lift != 0)) return false;
  if (fault.node != 0) return node.id == fault.node;
  if (fault.kind == FaultKind::fire_alarm) return hangs_at(node, description.service.fire_floor);
  if (fault.kind == FaultKind::fire_brigade) {
    return hangs_at(node, description.service.fire_floor) || node.kind == DeviceKind::car_panel;
  }
  if (fault.kind == FaultKind::stuck_button) {
    return fault.spot == no_floor ? node.kind == DeviceKind::car_panel : hangs_at(node, fault.spot);
  }
  return usual_place_of(fault.kind) == node.kind;
}

/// A real device can be broken by hand only.
std::string check_is_played(const LiftNetworkDescription& description,
                            const ScheduledFault& fault) {
  for (const NodeDescription& node : description.nodes) {
    if (node.played || !is_made_at(description, fault, node)) continue;
    return name_of(node) + " is a real one, and is not broken here";
  }
  return {};
}

std::string check_group_fault(const LiftNetworkDescription& description,
                              const ScheduledFault& fault) {
  if (fault.kind == FaultKind::fire_alarm) return check_is_played(description, fault);
  if (!has_node(description, 0, 0)) return "there is no group";
  const auto is_real = [](const NodeDescription& node) { return node.lift == 0 && !node.played; };
  const auto real = std::ranges::find_if(description.nodes, is_real);
  if (real != description.nodes.end()) {
    return name_of(*real) + " is a real one, and is not broken here";
  }
  const bool is_controller = fault.node == 0 || has_node(description, 0, fault.node);
  const bool is_lift = fault.node <= description.building.lift_count();
  switch (fault.kind) {
    case FaultKind::lost_node:
      return is_controller ? "" : "of a group it is its controller";
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
      if (is_controller || is_lift) return {};
      return "there is no node " + std::to_string(fault.node) + " on the bus of the group";
    default:
      return "it is no fault of a group";
  }
}

std::string check_place(const LiftNetworkDescription& description, const ScheduledFault& fault) {
  const std::string lift = "lift " + std::to_string(fault.part);
  if (!has_node(description, fault.part, fault.node)) {
    return lift + " has no node " + std::to_string(fault.node);
  }
  const std::optional<DeviceKind> kind = place_of(fault.kind);
  if (!kind) return {};
  const std::string name(device_kind_name(*kind));
  const bool is_there = std::ranges::any_of(description.nodes, [&](const NodeDescription& node) {
    const bool is_it = fault.node == 0 || node.id == fault.node;
    return is_it && node.lift == fault.part && node.kind == *kind;
  });
  if (is_there) return {};
  if (fault.node == 0) return lift + " has no " + name;
  return "node " + std::to_string(fault.node) + " of " + lift + " is no " + name;
}

std::string check_fault(const LiftNetworkDescription& description, const ScheduledFault& fault) {
  const Building& building = description.building;
  const bool has_place = fault.kind == FaultKind::lost_node || fault.kind == FaultKind::cable_cut ||
                         fault.kind == FaultKind::babbling_node || is_of_door(fault.kind);
  if (fault.part > building.lift_count()) {
    return "there is no lift " + std::to_string(fault.part);
  }
  if (fault.node != 0 && !has_place) return "it has no node";
  if (fault.spot != no_floor && fault.kind != FaultKind::stuck_button) return "it has no floor";
  if (fault.spot > building.floor_count()) return "the floor is not there";
  if (fault.part == 0) return check_group_fault(description, fault);
  const std::string error = check_place(description, fault);
  return error.empty() ? check_is_played(description, fault) : error;
}

}  // namespace

std::string_view device_kind_name(DeviceKind kind) {
  const auto place = static_cast<std::size_t>(kind);
  return place < kind_names.size() ? kind_names.at(place) : std::string_view{};
}

std::optional<DeviceKind> device_kind_of(std::string_view name) {
  const auto* const found =
      std::find_if(kind_names.begin(), kind_names.end(), [name](std::string_view whole) {
        return whole == name || whole.substr(prefix.size()) == name;
      });
  if (found == kind_names.end()) return std::nullopt;
  return static_cast<DeviceKind>(found - kind_names.begin());
}

LiftNetworkDescription standard_lift_network(const StandardLifts& options) {
  LiftNetworkDescription made;
  made.name = std::to_string(options.lifts) + (options.lifts == 1 ? " lift" : " lifts") + " of " +
              std::to_string(options.floors) + " floors";
  made.building = uniform_building({.floors = options.floors,
                                    .floor_height_m = options.floor_height_m,
                                    .lifts = options.lifts,
                                    .population_per_floor = options.population_per_floor,
                                    .lift = options.lift});
  made.service.destination_control = options.destination_control;
  made.traffic = options.traffic;
  made.people.destination_control = options.destination_control;
  made.faults.seed = made.traffic.seed = made.people.seed = options.seed;
  if (options.traffic.pattern == TrafficPattern::up_peak) {
    made.service.parking_floor = made.building.main_floor;
    made.service.parking_after = 1s;
  }
  Standard standard(made);
  for (unsigned lift = 1; lift <= options.lifts; ++lift) {
    standard.add_lift(static_cast<LiftNumber>(lift));
  }
  if (options.lifts > 1 || options.destination_control) standard.add_group();
  return made;
}

std::string check(const LiftNetworkDescription& description) {
  std::string error = check_building(description.building);
  if (error.empty()) error = check_service(description);
  if (error.empty()) error = check_lifts(description);
  if (error.empty()) error = check_group(description);
  if (!error.empty()) return error;
  std::set<std::pair<std::size_t, NodeId>> taken;
  for (const NodeDescription& node : description.nodes) {
    error = check_node(description, node);
    if (!error.empty()) return error;
    if (!taken.emplace(node.bus, node.id).second) return name_of(node) + " is not the only one";
  }
  for (const ScheduledFault& fault : description.faults.faults) {
    error = check_fault(description, fault);
    if (!error.empty()) return "fault " + std::string(fault_name(fault.kind)) + ": " + error;
  }
  return {};
}

}  // namespace canvoy::lift
