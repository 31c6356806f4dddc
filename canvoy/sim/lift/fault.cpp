#include "canvoy/sim/lift/fault.hpp"

#include <array>

#include "canvoy/can/random.hpp"

namespace canvoy::lift {

namespace {

constexpr FaultName names[] = {
    {FaultKind::lost_node, "lost-node", "a node has no power"},
    {FaultKind::cable_cut, "cable-cut", "the cable of a lift is cut"},
    {FaultKind::stuck_button, "stuck-button", "a button stays pressed"},
    {FaultKind::light_barrier, "light-barrier", "a light barrier is broken"},
    {FaultKind::dead_encoder, "dead-encoder", "the position unit measures nothing"},
    {FaultKind::babbling_node, "babbling-node", "a panel sends without a pause"},
    {FaultKind::fire_alarm, "fire-alarm", "all cars are called to the fire floor"},
    {FaultKind::fire_brigade, "fire-brigade", "the fire brigade drives a car"},
};

constexpr Duration rest_least = 150s;
constexpr std::uint32_t rest_more_s = 120;
constexpr Duration fault_least = 5s;
constexpr std::uint32_t fault_more_s = 55;

/// The recommended node-IDs: controller, drive, position, door, light barrier, load, panels.
constexpr std::array<std::uint8_t, 9> lost_nodes = {1, 2, 4, 6, 9, 13, 16, 21, 22};
constexpr std::array<std::uint8_t, 5> cut_behind = {1, 2, 4, 6, 16};

constexpr std::array drawn = {FaultKind::lost_node,    FaultKind::cable_cut,
                              FaultKind::stuck_button, FaultKind::light_barrier,
                              FaultKind::dead_encoder, FaultKind::babbling_node,
                              FaultKind::fire_alarm};

}  // namespace

std::span<const FaultName> fault_names() {
  return names;
}

std::string_view fault_name(FaultKind kind) {
  return names[static_cast<std::size_t>(kind)].name;
}

std::vector<ScheduledFault> random_faults(const Building& building, Time from, Time until,
                                          std::uint64_t seed) {
  std::vector<ScheduledFault> faults;
  Random random(seed);
  Time at = from;
  while (building.lift_count() > 0) {
    at += rest_least + std::chrono::seconds(random.below(rest_more_s));
    ScheduledFault fault{.kind = drawn.at(random.below(drawn.size())),
                         .start = at,
                         .duration = fault_least + std::chrono::seconds(random.below(fault_more_s)),
                         .lift = static_cast<LiftNumber>(1 + random.below(building.lift_count()))};
    if (fault.kind == FaultKind::lost_node) {
      fault.node = lost_nodes.at(random.below(lost_nodes.size()));
    }
    if (fault.kind == FaultKind::cable_cut) {
      fault.node = cut_behind.at(random.below(cut_behind.size()));
    }
    if (fault.kind == FaultKind::stuck_button) {
      fault.floor = static_cast<FloorNumber>(random.below(building.floor_count() + 1U));
    }
    at = fault.end();
    if (at + rest_least >= until) break;
    faults.push_back(fault);
  }
  return faults;
}

}  // namespace canvoy::lift
