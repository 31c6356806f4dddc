// What the messages say that only a network of CiA 447 has: sleep and wake-up, and the CAN-IDs on
// which a node's diagnosis is asked by ISO-TP. Parts 1 and 4 are not at hand: this is what public
// implementations agree on (canvoy/profiles/cia447/network.hpp).
//
//     sleep_text(frame);  // "objection to sleep, reason 05h"
#pragma once

#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"

namespace canvoy::words {

/// CAN-IDs 690h to 6A0h.
bool is_sleep_message(std::uint32_t can_id);
/// Who sends it; 0: a device without a node-ID.
NodeId sleeping_node(std::uint32_t can_id);
/// Of eight bytes.
std::string sleep_text(const Frame& frame);

/// The node that is asked on this CAN-ID by ISO-TP; 0: it is no such CAN-ID. Those of the answers
/// are not known.
NodeId iso_tp_node(std::uint32_t can_id);
/// What ISO 15765-2 says of the first byte, and the bytes.
std::string iso_tp_text(const Frame& frame);

}  // namespace canvoy::words
