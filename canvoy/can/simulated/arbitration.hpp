// Arbitration: the bits of the arbitration field in the order in which they are sent (ISO 11898-1,
// bus access).
//
//     bool first_wins = arbitration_key(first) < arbitration_key(second);
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// The arbitration field as a number: a dominant bit is a zero, so the lower number wins. Frames
/// with the same key do not arbitrate: they continue together until a bit differs.
///
/// From the top: 11 bits of identifier; RTR (11-bit frame) or SRR (29-bit frame, recessive); IDE;
/// then, in a 29-bit frame, 18 bits of identifier and RTR. A data frame thus wins over the remote
/// frame with its identifier, and an 11-bit frame over a 29-bit frame that begins with the same 11
/// bits.
constexpr std::uint32_t arbitration_key(const Frame& frame) {
  const std::uint32_t remote = frame.is_remote() ? 1 : 0;
  if (!frame.is_extended()) return frame.id << 21 | remote << 20;
  const std::uint32_t recessive = 1U << 20 | 1U << 19;  // SRR and IDE
  return (frame.id >> 18) << 21 | recessive | (frame.id & 0x3'FFFF) << 1 | remote;
}

}  // namespace canvoy
