// Automatic bit-rate detection on a CAN interface of this machine: restarts it in listen-only mode
// at one bit rate after the other (CiA 801).
//
//     const std::uint32_t bit_rate = search_bit_rate("can0");
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

/// Leaves the interface up and active at the returned bit rate. Listens until a node sends. Throws
/// Failure if the interface cannot be set, or on a signal. `under_way` is called when listening
/// begins and when it ends.
std::uint32_t search_bit_rate(const std::string& interface,
                              const std::function<void(bool)>& under_way = {});

}  // namespace canvoy::tools
