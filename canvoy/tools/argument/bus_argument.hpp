// A bus given by the user, told by its form alone: nothing is opened.
//
//     names_bus("can0");       // true
//     names_bus("night.log");  // false
#pragma once

#include <string_view>

namespace canvoy::tools {

/// True if the word can only be a bus: an address (`udp:`, `tcp:`, `sim`), several with commas, a
/// network interface of this machine, or a name like those of CAN interfaces (`can0`, `vcan12`).
bool names_bus(std::string_view word);

}  // namespace canvoy::tools
