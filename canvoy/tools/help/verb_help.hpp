// What the help of all verbs has in common.
//
//     command.add({{"bus", options.bus, bus_text, required}});
#pragma once

namespace canvoy::tools {

/// What a bus may be.
inline constexpr const char* bus_text =
    "can0, udp:239.74.163.2:43113, or tcp:HOST:PORT/can0 of a socketcand";

}  // namespace canvoy::tools
