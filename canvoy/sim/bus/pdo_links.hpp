// How the devices of a bus are configured before they are mounted (CiA 407, 8.1.5): whose messages
// arrive where, and whose heartbeat each of them watches.
//
//     configure(nodes);      // before they have power
#pragma once

#include "canvoy/sim/bus/bus_nodes.hpp"

namespace canvoy::bus {

/// The CAN-ID by which the gateway of the second car says that somebody there wants to get off.
inline constexpr std::uint16_t train_stop_request_id = 0x180 + train_gateway_id;

/// All devices are there.
void configure(BusNodes& nodes);

}  // namespace canvoy::bus
