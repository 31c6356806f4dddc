// Automatic bit-rate detection on a CAN interface of this machine (CiA 801): it is restarted in
// listen-only mode at one bit rate after the other.
//
//     const std::uint32_t bit_rate = search_bit_rate("can0");
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

/// The interface is left up and taking part at the bit rate that is returned. It listens as long as
/// nobody talks. Throws Failure where the interface cannot be set, or on a signal.
/// `under_way` is told when it begins to listen, and when it has ended.
std::uint32_t search_bit_rate(const std::string& interface,
                              const std::function<void(bool)>& under_way = {});

}  // namespace canvoy::tools
