// Text of the messages of services other than SDO, PDO and LSS (CiA 301, CiA 302-2).
//
//     nmt_text(frame);  // "start node 10 (0Ah)"
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::text {

/// Text of a frame that is not a message of its service.
std::string malformed_text(const Frame& frame);

/// Text of an NMT command of two bytes (CiA 301, 7.2.8.3.1).
std::string nmt_text(const Frame& frame);
/// Text of an emergency of eight bytes, with the meaning of the code in the profile of the node, if
/// any (CiA 301, 7.2.7).
std::string emergency_message_text(const Frame& frame, const Profile& profile);
/// True for messages of the negotiation of the NMT master, from CAN-ID 071h on (CiA 302-2).
bool is_flying_master(std::uint32_t can_id);
/// Text of a frame for which is_flying_master() is true.
std::string flying_master_text(const Frame& frame);

}  // namespace canvoy::text
