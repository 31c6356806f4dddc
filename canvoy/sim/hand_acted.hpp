// An action by hand at a device, from a plan outside of the world, as an event.
#pragma once

#include <string>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

/// An action at a device that is simulated here.
struct HandActed {
  BusIndex bus = 0;       ///< of the device
  NodeId node = 0;        ///< its node-ID
  std::string what;       ///< the action: `paper=no`
  std::string refused{};  ///< reason why it changed nothing; empty: it changed something
};

}  // namespace canvoy
