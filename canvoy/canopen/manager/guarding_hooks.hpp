// Monitoring of slaves without heartbeat: node guarding by another service (CiA 301, 7.2.8.3.2.1;
// guard time and retry factor from 1F81h).
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// Functions like those of NodeGuardingMaster. Empty hooks: no slave is guarded, and 1F83h cannot
/// be written.
struct GuardingHooks {
  /// Starts guarding of a slave; false if that is not possible.
  Callback<bool(NodeId, Duration guard_time, std::uint8_t factor)> start = {};
  /// Ends guarding of a slave, if it was guarded.
  Callback<void(NodeId)> stop = {};
  /// True if a slave is guarded: read in 1F83h.
  Callback<bool(NodeId)> is_guarded = {};
};

}  // namespace canvoy
