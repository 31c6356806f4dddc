// The CAN-ID of boot-up, heartbeat and node guarding of a node (CiA 301, 7.3.3).
#pragma once

#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// 700h plus the node-ID, which must be 1 to 127.
constexpr std::uint16_t error_control_id(NodeId node_id) {
  return static_cast<std::uint16_t>(can_id::error_control + node_id);
}

}  // namespace canvoy
