#include "canvoy/worlds/lift/present_faults.hpp"

#include <algorithm>

namespace canvoy::lift {

namespace {

/// Time until panels send the first one.
constexpr Duration first_heartbeat = 2s;

bool takes_heartbeats(FaultKind kind) {
  return kind == FaultKind::lost_node || kind == FaultKind::cable_cut ||
         kind == FaultKind::babbling_node;
}

}  // namespace

bool PresentFaults::has_like(const ScheduledFault& fault) const {
  return std::ranges::any_of(present_, [&](std::size_t number) {
    const ScheduledFault& other = (*plan_)[number];
    if (other.kind != fault.kind) return false;
    if (fault.kind == FaultKind::fire_alarm) return other.part == 0 || other.part == fault.part;
    if (other.part != fault.part) return false;
    if (fault.kind == FaultKind::cable_cut) return true;
    return node_of(other) == node_of(fault) && other.spot == fault.spot;
  });
}

bool PresentFaults::silences(const ScheduledFault& fault) const {
  if (!takes_heartbeats(fault.kind)) return false;
  if (fault.start < Time(first_heartbeat)) return true;
  return std::ranges::any_of(present_, [&](std::size_t number) {
    const ScheduledFault& other = (*plan_)[number];
    if (other.part != fault.part || !takes_heartbeats(other.kind)) return false;
    if (fault.part == 0 || other.kind == FaultKind::babbling_node) return true;
    if (other.kind == FaultKind::lost_node) return node_of(other) == node_id::lift_controller;
    return fault.kind == FaultKind::lost_node && devices_->is_behind(node_of(fault), other);
  });
}

}  // namespace canvoy::lift
