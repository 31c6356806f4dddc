// What the messages of SDO say, in words (CiA 301, 7.2.4).
//
//     const decoder::SdoStep step = follower.request(frame);
//     sdo_text(step.message, frame, cia418::profile);  // "read 6010h:00h temperature"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/sdo_follower.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

/// Of a frame of eight bytes; `profile` is that of the server.
std::string sdo_text(decoder::SdoMessage message, const Frame& frame, const Profile& profile);

}  // namespace canvoy::tools
