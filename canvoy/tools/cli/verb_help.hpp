// Common texts of the help of all verbs.
//
//     command.add({{"bus", options.bus, bus_text, required}});
#pragma once

namespace canvoy::tools {

/// Possible forms of a bus argument.
inline constexpr const char* bus_text =
    "can0, udp:239.74.163.2:43113, or tcp:HOST:PORT/can0 of a socketcand";

}  // namespace canvoy::tools
