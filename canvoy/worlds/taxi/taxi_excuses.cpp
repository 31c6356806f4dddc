#include "canvoy/worlds/taxi/taxi_excuses.hpp"

namespace canvoy::taxi {

namespace {

using car::Nodes;
using car::nodes;
using car::one_look;
using car::return_bound;
using Needs = car::Needs<InvariantKind>;

constexpr NodeId gateway_id = cia447::gateway_node_id;
constexpr Nodes no_nodes = 0;
constexpr Nodes all_nodes = car::all_nodes(device_names.size());

/// The gateway affects all that goes over the bus: it assigns node-IDs to the other devices and
/// starts them, and starts them again when it returns.
///
/// A lost clock does not excuse a fare: the meter continues from its last time. What has been shown
/// and counted is right and is kept whatever happens: `total`, `totals` and `power_cut` have no
/// excuse at all.
constexpr Needs needs[] = {
    {InvariantKind::fare, nodes(gateway_id, taximeter_id), return_bound},
    {InvariantKind::distance, nodes(gateway_id, taximeter_id), return_bound},
    {InvariantKind::duration, nodes(taximeter_id), one_look},
    {InvariantKind::waiting, nodes(gateway_id, taximeter_id), return_bound},
    {InvariantKind::total, no_nodes, {}},
    {InvariantKind::totals, no_nodes, {}},
    {InvariantKind::receipts, nodes(gateway_id, taximeter_id, printer_id), return_bound},
    {InvariantKind::receipt_lines, no_nodes, {}},
    {InvariantKind::shift_slip, nodes(gateway_id, taximeter_id, printer_id), return_bound},
    {InvariantKind::roof_sign, nodes(gateway_id, taximeter_id, sign_id), return_bound},
    // An alarm device that boots has lost its alarm, which the driver leaves on for a minute.
    {InvariantKind::alarm, nodes(gateway_id, sign_id, alarm_id), alarm_lasts + return_bound},
    {InvariantKind::terminal_fare, nodes(gateway_id, taximeter_id, terminal_id), return_bound},
    {InvariantKind::terminal_place, nodes(gateway_id, driver_id, terminal_id, navigation_id),
     return_bound},
    {InvariantKind::silence, all_nodes, return_bound},
    {InvariantKind::no_service, nodes(taximeter_id), one_look},
    {InvariantKind::carried, nodes(taximeter_id), return_bound},
    // For each device: can_cost().
    {InvariantKind::device_missing, all_nodes, one_look},
    {InvariantKind::power_cut, no_nodes, {}},
    {InvariantKind::tampering, no_nodes, {}},
};
static_assert(std::size(needs) == invariant_kinds);
static_assert(std::ranges::is_sorted(needs, {}, &Needs::kind));

}  // namespace

bool can_cause(const ScheduledFault& fault, InvariantKind kind) {
  switch (fault.kind) {
    case FaultKind::wheel_signal:
      return kind == InvariantKind::fare || kind == InvariantKind::distance ||
             kind == InvariantKind::waiting;
    case FaultKind::paper_out:
      return kind == InvariantKind::receipts || kind == InvariantKind::shift_slip;
    // Fraud excuses nothing of what is paid; but a meter with a duly opened seal carries no
    // passengers, and a foreign device does not sleep.
    case FaultKind::stranger_writes:
      return kind == InvariantKind::silence;
    case FaultKind::seal_opened:
      return kind == InvariantKind::no_service || kind == InvariantKind::carried;
    default:
      return car::hinders(fault, needs[static_cast<std::size_t>(kind)].nodes);
  }
}

bool can_cost(const ScheduledFault& fault, NodeId device) {
  return car::hinders(fault, nodes(gateway_id, device));
}

Duration lasts_after(InvariantKind kind) {
  return needs[static_cast<std::size_t>(kind)].after;
}

}  // namespace canvoy::taxi
