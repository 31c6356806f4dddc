#include "canvoy/worlds/lift/lift_devices.hpp"

#include <cmath>
#include <utility>

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

namespace {

/// A hall call for no lift.
const Frame group_babble = Frame::data_frame(0x480, {0, 0, 0, 0, 0, 0});

}  // namespace

LiftDevices::LiftDevices(World& world, const LiftNetworkDescription& description,
                         LiftDevicesHooks hooks)
    : world_(&world), description_(&description), heard_(std::move(hooks.heard)) {
  add_buses();
  add_shafts(hooks.shaft);
  add_group();
  add_configurations();
}

void LiftDevices::add_buses() {
  for (std::size_t i = 0; i < description_->buses.size(); ++i) {
    buses_.push_back(world_->add_bus(
        {.bit_rate = description_->buses[i].bit_rate, .seed = description_->faults.seed + i}));
    watches_.push_back(std::make_unique<BusWatch>(
        i, [this](Time now, const BusEvent& event) { heard_(now, event); }));
    world_->bus(buses_.back()).observe(watches_.back()->tap());
  }
}

void LiftDevices::add_shafts(const ShaftHooks& hooks) {
  for (std::size_t i = 1; i <= description_->building.lifts.size(); ++i) {
    shafts_.push_back(
        std::make_unique<LiftShaft>(*world_, *description_, static_cast<LiftNumber>(i), hooks));
  }
  for (const NodeDescription& node : description_->nodes) {
    if (node.lift == 0) continue;
    const std::optional<SlotIndex> slot = shaft(node.lift).slot(node.id);
    if (slot) watches_[node.bus]->name(world_->controller(*slot), node.id);
  }
}

void LiftDevices::add_group() {
  for (const NodeDescription& node : description_->nodes) {
    if (node.kind != DeviceKind::group_controller) continue;
    if (node.played) {
      group_ = std::make_unique<LiftGroup>(*world_, buses_[node.bus], node.id, *description_);
    }
    for (const auto& each : shafts_) each->join_group(buses_[node.bus], node.id);
    return;
  }
}

void LiftDevices::add_configurations() {
  for (const NodeDescription& each : description_->nodes) {
    Node* const node = each.values.empty() ? nullptr : node_of(each);
    if (node == nullptr) continue;
    configurations_.push_back({&each, std::make_unique<NodeConfiguration>(*node, each.values)});
  }
}

void LiftDevices::start() {
  for (const auto& each : shafts_) each->start();
  if (group_) group_->start();
}

Node* LiftDevices::node_of(const NodeDescription& node) {
  if (node.kind != DeviceKind::group_controller) return shaft(node.lift).node(node.id);
  return group_ ? &group_->node() : nullptr;
}

void LiftDevices::set_fault(const ScheduledFault& fault, bool present) {
  if (fault.part == 0) return set_group_fault(fault, present);
  shaft(fault.part).set_fault(fault, present);
}

/// A node on the bus of the group: its controller (also 0), or the second node of a lift.
std::optional<SlotIndex> LiftDevices::group_slot(NodeId node) const {
  if (!group_) return std::nullopt;
  if (node >= 1 && node <= shafts_.size()) return shaft(node).group_slot();
  return group_->slot();
}

void LiftDevices::set_group_fault(const ScheduledFault& fault, bool present) {
  const std::optional<SlotIndex> slot = group_slot(fault.node);
  if (!slot) return;
  SimulatedBus& bus = world_->bus(group_->bus());
  const ControllerId controller = world_->controller(*slot);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return present ? world_->stop(group_->slot()) : world_->start(group_->slot());
    case FaultKind::cable_cut:
      return present ? bus.cut_cable(controller) : bus.mend_cable();
    case FaultKind::babbling_node:
      if (present) {
        bus.babble(controller, group_babble);
      } else {
        bus.stop_babbling(controller);
      }
      return;
    default:
      return;
  }
}

FaultPlace LiftDevices::place_of(const ScheduledFault& fault) const {
  FaultPlace place{.part = fault.part};
  if (fault.kind == FaultKind::fire_alarm && fault.part == 0) return place;
  if (fault.part != 0) place.node = shaft(fault.part).node_of(fault);
  for (const NodeDescription& node : description_->nodes) {
    const bool is_of_group = node.kind == DeviceKind::group_controller;
    if (is_of_group != (fault.part == 0) || (!is_of_group && node.lift != fault.part)) continue;
    place.bus = node.bus;
    if (is_of_group) place.node = fault.node != 0 ? fault.node : node.id;
  }
  return place;
}

bool LiftDevices::is_behind(NodeId node, const ScheduledFault& cut) const {
  const NodeId last_before = place_of(cut).node;
  bool is_behind = false;
  for (const NodeDescription& each : description_->nodes) {
    if (each.lift != cut.part || each.kind == DeviceKind::group_controller) continue;
    if (each.id == node) return is_behind || !each.played;
    is_behind = is_behind || each.id == last_before;
  }
  return false;
}

LiftNumber LiftDevices::lift_of(std::size_t bus) const {
  for (const NodeDescription& node : description_->nodes) {
    if (node.bus == bus) return node.lift;
  }
  return 0;
}

std::optional<RefusedValue> LiftDevices::refused() const {
  for (const Configuration& each : configurations_) {
    const std::optional<NodeConfiguration::Refusal>& refusal = each.values->refusal();
    if (refusal) return RefusedValue{*each.node, *refusal};
  }
  return std::nullopt;
}

std::vector<BusSnapshot> LiftDevices::bus_snapshots() const {
  std::vector<BusSnapshot> seen;
  for (const BusIndex bus : buses_) {
    const SimulatedBus& wire = world_->bus(bus);
    seen.push_back({.load = wire.load(),
                    .frames = wire.statistics().frames,
                    .error_frames = wire.statistics().error_frames});
  }
  return seen;
}

std::vector<NodeSnapshot> LiftDevices::node_snapshots() {
  std::vector<NodeSnapshot> seen;
  for (const NodeDescription& each : description_->nodes) {
    Node* const node = node_of(each);
    if (node == nullptr) continue;
    const std::optional<SlotIndex> slot =
        each.lift == 0 ? group_->slot() : shaft(each.lift).slot(each.id);
    if (!slot) continue;
    NodeSnapshot look = played_snapshot(*world_, buses_[each.bus], *slot, *node);
    look.bus = each.bus;
    look.id = each.id;
    seen.push_back(look);
  }
  return seen;
}

}  // namespace canvoy::lift
