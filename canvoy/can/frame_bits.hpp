// The exact length of a classic CAN frame on the wire in bits: fields, CRC-15 and stuff bits (ISO
// 11898-1, frame formats and bit stuffing).
//
//     unsigned bits = frame_bits(frame) + intermission_bits;   // what a frame takes of the bus
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// Number of recessive bits between two frames.
inline constexpr unsigned intermission_bits = 3;
/// Number of bits of a frame after the acknowledgement slot: its delimiter and the end of frame.
inline constexpr unsigned bits_after_acknowledgement = 1 + 7;
/// Length of the longest frame: 29 bits, eight bytes, and the greatest number of stuff bits.
inline constexpr unsigned frame_bits_max = 157;

/// Number of bits from the start of frame to the last bit of the end of frame, stuff bits included,
/// without the intermission. `frame.length` must be at most 8. An error frame counts 0. Takes a few
/// nanoseconds for each byte, no loop over bits.
unsigned frame_bits(const Frame& frame);

/// Checksum of the frame, 15 bits.
std::uint16_t frame_crc(const Frame& frame);

/// Compares two frames with the same identifier, sent at the same time: returns the first different
/// bit, counted from 1 at the start of frame with stuff bits; 0 if they are equal.
unsigned first_different_bit(const Frame& a, const Frame& b);

}  // namespace canvoy
