// What a fault of a police car excuses: only what it can cause, for as long as it can.
//
//     can_cause({.kind = FaultKind::restart, .node = roof_light_id}, InvariantKind::locks)  //
//     false
#pragma once

#include "canvoy/worlds/car/excuses.hpp"
#include "canvoy/worlds/police/fault.hpp"
#include "canvoy/worlds/police/invariant.hpp"
#include "canvoy/worlds/police/police_options.hpp"

namespace canvoy::police {

/// True if a fault of this kind, at its place, can break the invariant.
bool can_cause(const ScheduledFault& fault, InvariantKind kind);
/// True if it can keep a device of this node-ID from its work.
bool can_cost(const ScheduledFault& fault, NodeId device);
/// Time after its end in which it still can: until all that it affects is back.
Duration lasts_after(InvariantKind kind);

/// Excuses of this car, by invariant.
using PoliceExcuses =
    car::Excuses<ScheduledFault, InvariantKind, invariant_kinds, armoured_names.size()>;

}  // namespace canvoy::police
