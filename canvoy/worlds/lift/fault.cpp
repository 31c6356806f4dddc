#include "canvoy/worlds/lift/fault.hpp"

#include <array>

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::lift {

namespace {

constexpr Duration rest_least = 150s;
constexpr std::uint32_t rest_more_s = 120;
constexpr Duration fault_least = 5s;
constexpr std::uint32_t fault_more_s = 55;

constexpr Duration fire_brigade_least = 60s;
constexpr std::uint32_t fire_brigade_more_s = 180;

/// The recommended node-IDs: controller, drive, position, door, light barrier, load, panels.
constexpr std::uint8_t first_door = 6;
constexpr std::array<std::uint8_t, doors_max> doors = {first_door, 7, 8, 12};
constexpr std::array<std::uint8_t, 9> lost_nodes = {1, 2, 4, first_door, 9, 13, 16, 21, 22};
constexpr std::array<std::uint8_t, 5> cut_behind = {1, 2, 4, first_door, 16};

/// A weak brake is drawn as a variant of one that holds nothing.
constexpr auto kinds = static_cast<std::uint32_t>(fault_kinds - 1);
static_assert(static_cast<std::uint32_t>(FaultKind::weak_brake) == kinds);
constexpr std::array drawn_of_group = {FaultKind::lost_node, FaultKind::cable_cut,
                                       FaultKind::babbling_node, FaultKind::fire_alarm};
/// One of this many faults of a group of lifts is one of the group.
constexpr std::uint32_t of_group_each = 5;

template <class List>
auto one_of(const List& list, Random& random) {
  return list.at(random.below(static_cast<std::uint32_t>(list.size())));
}

/// One of the doors of a lift, which need not include the first.
std::uint8_t one_of_doors(const LiftDesign& lift, Random& random) {
  while (true) {
    const std::uint32_t door = random.below(doors_max);
    if ((lift.doors >> door & 1U) != 0) return doors.at(door);
  }
}

ScheduledFault draw_of_group(const Building& building, Random& random) {
  ScheduledFault fault{.kind = one_of(drawn_of_group, random), .part = 0};
  const bool has_place =
      fault.kind == FaultKind::cable_cut || fault.kind == FaultKind::babbling_node;
  // 0 is its controller.
  if (has_place) {
    fault.node = static_cast<std::uint8_t>(random.below(building.lift_count() + 1U));
  }
  return fault;
}

ScheduledFault draw(const Building& building, Random& random) {
  const LiftNumber lifts = building.lift_count();
  if (lifts > 1 && random.below(of_group_each) == 0) return draw_of_group(building, random);
  ScheduledFault fault{.kind = static_cast<FaultKind>(random.below(kinds)),
                       .part = static_cast<LiftNumber>(1 + random.below(lifts))};
  if (fault.kind == FaultKind::lost_node) fault.node = one_of(lost_nodes, random);
  if (fault.kind == FaultKind::cable_cut) fault.node = one_of(cut_behind, random);
  if (is_of_door(fault.kind) || fault.node == first_door) {
    fault.node = one_of_doors(building.lift(fault.part), random);
  }
  if (fault.kind == FaultKind::stuck_button) {
    fault.spot = static_cast<FloorNumber>(random.below(building.floor_count() + 1U));
  }
  return fault;
}

Duration draw_duration(FaultKind kind, Random& random) {
  if (kind == FaultKind::fire_brigade) {
    return fire_brigade_least + std::chrono::seconds(random.below(fire_brigade_more_s));
  }
  return fault_least + std::chrono::seconds(random.below(fault_more_s));
}

/// Every other brake holds a little.
void vary(ScheduledFault& fault) {
  const bool is_odd = fault.start.time_since_epoch() / 1s % 2 != 0;
  if (fault.kind == FaultKind::brake && is_odd) fault.kind = FaultKind::weak_brake;
}

ScheduledFault draw_beside(const ScheduledFault& first, const Building& building, Random& random) {
  ScheduledFault second = draw(building, random);
  second.duration = draw_duration(second.kind, random);
  const auto lasts_ms = static_cast<std::uint32_t>(first.duration / 1ms);
  const std::array meets = {first.start, first.start + 1ms * random.below(lasts_ms), first.end()};
  second.start = one_of(meets, random);
  vary(second);
  return second;
}

}  // namespace

bool is_of_door(FaultKind kind) {
  return kind == FaultKind::finger_protector || kind == FaultKind::motion_detector ||
         kind == FaultKind::door_lock || kind == FaultKind::safety_contact;
}

std::vector<ScheduledFault> random_faults(const Building& building, Time from, Time until,
                                          std::uint64_t seed) {
  std::vector<ScheduledFault> faults;
  Random random(seed);
  Time at = from;
  while (building.lift_count() > 0) {
    at += rest_least + std::chrono::seconds(random.below(rest_more_s));
    ScheduledFault fault = draw(building, random);
    fault.start = at;
    fault.duration = draw_duration(fault.kind, random);
    vary(fault);
    at = fault.end();
    if (at + rest_least >= until) break;
    faults.push_back(fault);
  }
  return faults;
}

std::vector<ScheduledFault> random_fault_pairs(const Building& building, Time from, Time until,
                                               std::uint64_t seed) {
  std::vector<ScheduledFault> pairs;
  Random random(~seed);
  for (ScheduledFault first : random_faults(building, from, until, seed)) {
    if (pairs.empty() && seed % 4 == 0) first.start = Time{};
    const ScheduledFault second = draw_beside(first, building, random);
    if (second.end() + rest_least >= until) break;
    pairs.push_back(first);
    pairs.push_back(second);
  }
  return pairs;
}

}  // namespace canvoy::lift
