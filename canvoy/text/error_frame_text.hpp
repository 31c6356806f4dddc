// Text of an error frame: the classes and details that SocketCAN defines.
//
//     error_frame_text(frame);  // "protocol violation: stuff error in the data field; bus error"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"

namespace canvoy::text {

/// Text of a frame with is_error(); empty if it has no information. Includes a detail if its class
/// is set; error counters also if they are not 0, since older drivers have no class for them.
std::string error_frame_text(const Frame& frame);

}  // namespace canvoy::text
