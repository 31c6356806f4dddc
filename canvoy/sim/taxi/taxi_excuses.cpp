#include "canvoy/sim/taxi/taxi_excuses.hpp"

namespace canvoy::taxi {

namespace {

using Nodes = std::uint16_t;

constexpr Nodes bit(NodeId id) {
  return static_cast<Nodes>(1U << id);
}
template <class... Ids>
constexpr Nodes nodes(Ids... ids) {
  return static_cast<Nodes>((bit(ids) | ...));
}

constexpr NodeId gateway_id = cia447::gateway_node_id;
constexpr Nodes no_nodes = 0;
constexpr Nodes all_nodes = nodes(gateway_id, taximeter_id, printer_id, driver_id, sign_id,
                                  terminal_id, navigation_id, alarm_id);
/// The next look comes a step of the simulation after it.
constexpr Duration one_look = 1s;

/// Who has to work, and to hear each other, for something to be right. The gateway is among all
/// that goes over the bus: it names and starts the others, and when it comes back it starts them
/// again.
///
/// A clock that is lost is none of fares: the meter goes on from what it said last. What has been
/// shown and counted is right and is kept whatever happens: `total`, `totals` and `power_cut`
/// have no excuse at all.
struct Needs {
  InvariantKind kind;
  Nodes nodes;
  Duration after;  ///< the end of the fault
};
constexpr Needs needs[] = {
    {InvariantKind::fare, nodes(gateway_id, taximeter_id), TaxiExcuses::return_bound},
    {InvariantKind::distance, nodes(gateway_id, taximeter_id), TaxiExcuses::return_bound},
    {InvariantKind::duration, nodes(taximeter_id), one_look},
    {InvariantKind::total, no_nodes, {}},
    {InvariantKind::totals, no_nodes, {}},
    {InvariantKind::receipts, nodes(gateway_id, taximeter_id, printer_id),
     TaxiExcuses::return_bound},
    {InvariantKind::receipt_lines, no_nodes, {}},
    {InvariantKind::roof_sign, nodes(gateway_id, taximeter_id, sign_id), TaxiExcuses::return_bound},
    {InvariantKind::terminal_fare, nodes(gateway_id, taximeter_id, terminal_id),
     TaxiExcuses::return_bound},
    {InvariantKind::terminal_place, nodes(gateway_id, driver_id, terminal_id, navigation_id),
     TaxiExcuses::return_bound},
    {InvariantKind::silence, all_nodes, TaxiExcuses::return_bound},
    {InvariantKind::no_service, nodes(taximeter_id), one_look},
    {InvariantKind::carried, nodes(taximeter_id), TaxiExcuses::return_bound},
    // Of each device: can_cost().
    {InvariantKind::device_missing, all_nodes, one_look},
    {InvariantKind::power_cut, no_nodes, {}},
};
static_assert(std::size(needs) == invariant_kinds);
static_assert(std::ranges::is_sorted(needs, {}, &Needs::kind));

/// Some of them are on the one side of a cut behind this node, and some on the other.
constexpr bool are_parted(Nodes which, NodeId behind) {
  const auto before = static_cast<Nodes>((bit(behind) << 1) - 1);
  return (which & before) != 0 && (which & ~before) != 0;
}

bool hinders(const ScheduledFault& fault, Nodes which) {
  switch (fault.kind) {
    case FaultKind::lost_node:
    case FaultKind::restart:
      return (which & bit(node_of(fault))) != 0;
    case FaultKind::cable_cut:
      return are_parted(which, node_of(fault));
    case FaultKind::babbling_node:
      return (which & (which - 1)) != 0;  // who needs nobody else needs no bus
    case FaultKind::corrupted_frames:
    case FaultKind::wheel_signal:
    case FaultKind::paper_out:
    case FaultKind::no_fix:
      break;
  }
  return false;
}

}  // namespace

bool can_cause(const ScheduledFault& fault, InvariantKind kind) {
  switch (fault.kind) {
    case FaultKind::wheel_signal:
      return kind == InvariantKind::fare || kind == InvariantKind::distance;
    case FaultKind::paper_out:
      return kind == InvariantKind::receipts;
    default:
      return hinders(fault, needs[static_cast<std::size_t>(kind)].nodes);
  }
}

bool can_cost(const ScheduledFault& fault, NodeId device) {
  return hinders(fault, nodes(gateway_id, device));
}

Duration lasts_after(InvariantKind kind) {
  return needs[static_cast<std::size_t>(kind)].after;
}

void TaxiExcuses::change(Excuse& excuse, Time until, int more) {
  excuse.faults += more;
  excuse.until = std::max(excuse.until, until);
  excuse.was_there = true;
}

void TaxiExcuses::change(const ScheduledFault& fault, Time now, bool does_last, int more) {
  const int count = does_last ? more : 0;
  for (std::size_t i = 0; i < invariant_kinds; ++i) {
    const auto kind = static_cast<InvariantKind>(i);
    if (can_cause(fault, kind)) change(kinds_[i], now + lasts_after(kind), count);
  }
  for (std::size_t id = 1; id < devices_.size(); ++id) {
    if (can_cost(fault, static_cast<NodeId>(id))) {
      change(devices_[id], now + lasts_after(InvariantKind::device_missing), count);
    }
  }
}

}  // namespace canvoy::taxi
