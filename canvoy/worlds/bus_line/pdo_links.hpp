// Configures the devices of a bus as before they are mounted: the messages that each receives, and
// the heartbeats that it watches (CiA 407, 8.1.5).
//
//     configure(nodes);      // before they have power
#pragma once

#include "canvoy/worlds/bus_line/bus_nodes.hpp"

namespace canvoy::bus_line {

/// Call it when all devices are added.
void configure(BusNodes& nodes);

}  // namespace canvoy::bus_line
