// How a master watches over slaves that send no heartbeat: node guarding, which somebody else does
// (CiA 301, 7.2.8.3.2.1; guard time and retry factor from 1F81h).
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"

namespace canvoy {

/// As NodeGuardingMaster has them. Empty hooks: nobody is guarded, and 1F83h cannot be written.
struct GuardingHooks {
  /// Guards a slave from now on; false where that is not possible.
  Callback<bool(NodeId, Duration guard_time, std::uint8_t factor)> start = {};
  Callback<void(NodeId)> stop = {};
  Callback<bool(NodeId)> is_guarded = {};
};

}  // namespace canvoy
