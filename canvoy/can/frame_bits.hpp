// The length of a classic CAN frame on the wire, to the bit: fields, CRC-15 and stuff bits (ISO
// 11898-1, frame formats and bit stuffing).
//
//     unsigned bits = frame_bits(frame) + intermission_bits;   // what a frame takes of the bus
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// Recessive bits between two frames.
inline constexpr unsigned intermission_bits = 3;
/// Bits of a frame behind the acknowledgement slot: its delimiter and the end of frame.
inline constexpr unsigned bits_after_acknowledgement = 1 + 7;
/// The longest frame: 29 bits, eight bytes, and as many stuff bits as can be.
inline constexpr unsigned frame_bits_max = 157;

/// Bits from the start of frame to the last bit of the end of frame, stuff bits included, without
/// the intermission. `frame.length` must be at most 8. An error frame counts 0. Takes a few
/// nanoseconds for each byte, no loop over bits.
unsigned frame_bits(const Frame& frame);

/// The checksum of the frame, 15 bits.
std::uint16_t frame_crc(const Frame& frame);

/// Of two frames with the same identifier, sent at the same time: the bit, counted from 1 at the
/// start of frame with stuff bits, in which they first differ; 0 where they are the same.
unsigned first_different_bit(const Frame& a, const Frame& b);

}  // namespace canvoy
