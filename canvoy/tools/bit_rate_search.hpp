// Automatic bit-rate detection on a CAN interface of this machine (CiA 801): it is restarted in
// listen-only mode at one bit rate after the other.
//
//     const std::uint32_t bit_rate = search_bit_rate("can0");
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

/// The interface is left up and taking part at the bit rate that is returned. It listens as long as
/// nobody talks. Throws Failure where the interface cannot be set, or on a signal.
std::uint32_t search_bit_rate(const std::string& interface);

}  // namespace canvoy::tools
