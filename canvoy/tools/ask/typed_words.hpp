// The words of a command line as they were meant: `help read`, a bus out of $CANVOY_BUS, `nmt can0
// start 10`, `write can0 10 1017 0 500`. What is not plain is left to the verb, or refused with the
// line to type.
//
//     const std::vector<std::string> words = typed_words({"read", "10", "1018"});
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// Whether it can only be a bus: an address (`udp:`, `tcp:`, `sim`), several with commas, a network
/// interface of this machine, or a name as those of CAN interfaces are (`can0`, `vcan12`).
bool names_bus(std::string_view word);

/// Behind the name of the program. Throws UsageError with the line that was meant.
std::vector<std::string> typed_words(std::vector<std::string> words);

/// The same of a verb and its bus: node and state in their order, index and sub-index as one.
void order_words(std::vector<std::string>& words);

}  // namespace canvoy::tools
