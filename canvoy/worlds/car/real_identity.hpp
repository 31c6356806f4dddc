// Identity of a real device in place of one that is not simulated, as far as it is known.
//
//     options.identities = {{.id = printer_id, .identity = {.address = {{0x2F0}}, .known =
//     {true}}}};
#pragma once

#include "canvoy/canopen/lss/lss_fastscan.hpp"

namespace canvoy::car {

/// The gateway assigns the node-ID of the place to the device with this identity by LSS. A place
/// without an identity takes any device that provides the virtual device.
struct RealIdentity {
  NodeId id = 0;          ///< the place: a device that is not simulated here
  LssPattern identity{};  ///< known parts of 1018h: at least one
};

}  // namespace canvoy::car
