// What the messages of the layer setting services say, in words (CiA 305).
//
//     lss_master_text(frame);  // "set node-ID 5"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"

namespace canvoy::tools {

/// Of a frame of 8 bytes from the master (CAN-ID 7E5h), and of one from a slave (7E4h).
std::string lss_master_text(const Frame& frame);
std::string lss_slave_text(const Frame& frame);

}  // namespace canvoy::tools
