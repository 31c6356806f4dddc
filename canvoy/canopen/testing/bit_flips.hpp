// All frames that result from a flip of one bit, for tests.
//
//     for (const Frame& flip : bit_flips(wire_frame("071#00 0A"))) node.receive(flip, now);
#pragma once

#include <vector>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// All frames that differ from `frame` in one bit of its identifier, RTR bit, length or data.
inline std::vector<Frame> bit_flips(const Frame& frame) {
  std::vector<Frame> flips;
  for (unsigned bit = 0; bit < 11; ++bit) {
    flips.push_back(frame);
    flips.back().id ^= 1U << bit;
  }
  for (unsigned bit = 0; bit < 4; ++bit) {
    const unsigned length = frame.length ^ 1U << bit;
    if (length > 8) continue;
    flips.push_back(frame);
    flips.back().length = static_cast<std::uint8_t>(length);
  }
  for (unsigned bit = 0; bit < frame.length * 8U; ++bit) {
    flips.push_back(frame);
    flips.back().data.at(bit / 8) ^= static_cast<std::uint8_t>(1U << bit % 8);
  }
  flips.push_back(frame);
  flips.back().flags = frame.is_remote() ? FrameFlags::none : FrameFlags::remote;
  for (Frame& flip : flips) {
    const std::size_t used = flip.is_remote() ? 0 : flip.length;
    for (std::size_t i = used; i < 8; ++i) flip.data.at(i) = 0;
  }
  return flips;
}

}  // namespace canvoy
