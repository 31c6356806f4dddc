// Tells by a single frame, without state, whether a listener may learn from it what changes the
// meaning of later frames. A reader that skips parts of a log must not skip such a frame.
//
//     if (may_teach(frame)) keep(block);
#pragma once

#include "canvoy/can/frame.hpp"

namespace canvoy::decoder {

/// True if the frame may be part of a transfer, on the default SDO channel of a node (CiA 301,
/// 7.3.3), of an object that Network::learn() takes, or if it is a message of LSS (CiA 305). True
/// as well for a few frames that teach nothing. Transfers on other channels are not considered.
/// Constant cost.
bool may_teach(const Frame& frame);

}  // namespace canvoy::decoder
