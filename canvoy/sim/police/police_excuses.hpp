// What a fault of a police car excuses: that, and only that, which it can cause, for as long as it
// can.
//
//     can_cause({.kind = FaultKind::restart, .node = roof_light_id}, InvariantKind::locks)  //
//     false
#pragma once

#include "canvoy/sim/car/excuses.hpp"
#include "canvoy/sim/police/fault.hpp"
#include "canvoy/sim/police/invariant.hpp"
#include "canvoy/sim/police/police_options.hpp"

namespace canvoy::police {

/// Whether a fault of this kind, at its place, can make what the invariant is about wrong.
bool can_cause(const ScheduledFault& fault, InvariantKind kind);
/// Whether it can keep a device of this node-ID from its work.
bool can_cost(const ScheduledFault& fault, NodeId device);
/// How long after its end it still can: until all that it has touched is back.
Duration lasts_after(InvariantKind kind);

using PoliceExcuses =
    car::Excuses<ScheduledFault, InvariantKind, invariant_kinds, device_names.size()>;

}  // namespace canvoy::police
