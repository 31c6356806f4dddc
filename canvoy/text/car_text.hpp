// Text for the messages that only a network of CiA 447 has: sleep and wake-up, and the CAN-IDs of
// diagnosis by ISO-TP. Parts 1 and 4 are not available; the text follows public implementations
// (canvoy/profiles/cia447/network.hpp).
//
//     sleep_text(frame);  // "objection to sleep, reason 05h"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::text {

/// True for CAN-IDs 690h to 6A0h.
bool is_sleep_message(std::uint32_t can_id);
/// The sender; 0: a device without a node-ID.
NodeId sleeping_node(std::uint32_t can_id);
/// Text of a sleep message of eight bytes.
std::string sleep_text(const Frame& frame);

/// The node that receives ISO-TP requests on this CAN-ID; 0: none. The CAN-IDs of the answers are
/// unknown.
NodeId iso_tp_node(std::uint32_t can_id);
/// The meaning of the first byte (ISO 15765-2), and the bytes.
std::string iso_tp_text(const Frame& frame);

}  // namespace canvoy::text
