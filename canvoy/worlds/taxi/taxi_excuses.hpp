// What a fault of a taxi excuses: only what it can cause, for as long as it can.
//
//     can_cause({.kind = FaultKind::restart, .node = alarm_id}, InvariantKind::fare)    // false
#pragma once

#include "canvoy/worlds/car/excuses.hpp"
#include "canvoy/worlds/taxi/fault.hpp"
#include "canvoy/worlds/taxi/invariant.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"

namespace canvoy::taxi {

/// True if a fault of this kind, at its place, can break the invariant.
bool can_cause(const ScheduledFault& fault, InvariantKind kind);
/// True if it can keep a device of this node-ID from its work.
bool can_cost(const ScheduledFault& fault, NodeId device);
/// Time after its end in which it still can: until all that it affects is back.
Duration lasts_after(InvariantKind kind);

/// Excuses of this car, by invariant.
using TaxiExcuses =
    car::Excuses<ScheduledFault, InvariantKind, invariant_kinds, device_names.size()>;

}  // namespace canvoy::taxi
