// What the messages of the services beside SDO, PDO and LSS say, in words (CiA 301, CiA 302-2).
//
//     nmt_text(frame);  // "start node 10 (0Ah)"
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::words {

/// Of a frame that is no message of its service.
std::string malformed_text(const Frame& frame);

/// Of two bytes (CiA 301, 7.2.8.3.1).
std::string nmt_text(const Frame& frame);
/// Of eight bytes; by the profile of the node where it gives the code a meaning (CiA 301, 7.2.7).
std::string emergency_message_text(const Frame& frame, const Profile& profile);
/// Of the negotiation who is the NMT master, from CAN-ID 071h on (CiA 302-2).
bool is_flying_master(std::uint32_t can_id);
std::string flying_master_text(const Frame& frame);

}  // namespace canvoy::words
