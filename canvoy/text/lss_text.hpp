// Text of the messages of the layer setting services (CiA 305).
//
//     lss_master_text(frame);  // "set node-ID 5"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/lss_follower.hpp"

namespace canvoy::text {

/// Text of a frame of 8 bytes from the master (CAN-ID 7E5h), or from a slave (7E4h).
std::string lss_master_text(const Frame& frame);
/// Text of a frame of 8 bytes from a slave (CAN-ID 7E4h).
std::string lss_slave_text(const Frame& frame);

/// The known parts of an identity: `vendor-ID 000002F0h, product code 000001A3h`.
std::string identity_text(const decoder::Identity& identity);
/// The selected device: `node 5 (05h) is vendor-ID 000002F0h`; empty if nothing is known.
std::string lss_device_text(const decoder::LssFollower::Device& device);

}  // namespace canvoy::text
