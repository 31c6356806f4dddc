// What an error frame tells, in words: the classes and details that SocketCAN knows.
//
//     error_frame_text(frame);  // "protocol violation: stuff error in the data field; bus error"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"

namespace canvoy::words {

/// Of a frame that is_error(); empty where it tells nothing. A detail is told where its class is
/// set; error counters also where they are not 0, since older drivers have no class for them.
std::string error_frame_text(const Frame& frame);

}  // namespace canvoy::words
