// Which invariants of a bus cannot hold while something is missing, and which nobody can judge
// where devices are real.
//
//     referee.fault_begins(affected_by(FaultKind::lost_node, next_stop_id), now);
//     referee.cannot_judge(unknown_without(options.real));
#pragma once

#include <span>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/bus/bus_fault.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"

namespace canvoy::bus {

/// Which invariants cannot hold while a device, or what a fault is about, is missing.
InvariantSet affected_by(FaultKind kind, NodeId node);
/// What cannot be known where these are not played, or is up to them.
InvariantSet unknown_without(std::span<const NodeId> real);

}  // namespace canvoy::bus
