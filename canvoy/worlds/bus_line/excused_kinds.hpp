// Invariants of a bus that cannot hold while something is missing, and those that cannot be judged
// where devices are real.
//
//     referee.fault_begins(affected_by(FaultKind::lost_node, next_stop_id), now);
//     referee.cannot_judge(unknown_without(options.real));
#pragma once

#include <span>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/bus_line/bus_fault.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"

namespace canvoy::bus_line {

/// Invariants that cannot hold while a device, or the object of a fault, is missing.
InvariantSet affected_by(FaultKind kind, DeviceKey device);
/// Invariants that cannot be judged, or depend on real devices, where these are not simulated here.
InvariantSet unknown_without(std::span<const DeviceKey> real);

}  // namespace canvoy::bus_line
