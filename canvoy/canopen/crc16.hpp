// The checksum of SDO block transfers: CRC-16 with the polynomial x^16 + x^12 + x^5 + 1, from zero,
// not reflected (CiA 301, 7.2.4.3.16).
//
// There is no table. The polynomial has few terms, so that a division by it is a few shifts: eight
// bytes at a time where registers are wide, one at a time where they are not.
//
//     std::uint16_t crc = crc16(first_half);
//     crc = crc16(second_half, crc);
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace canvoy {

namespace detail {

/// The remainder of `bits` times x^16. The quotient is `bits` divided by 1 + f, where f is what is
/// left of the polynomial when x^16 is taken out of it: shifts to the right by 4, 11 and 16. Over
/// bits, 1 / (1 + f) is (1 + f)(1 + f^2)(1 + f^4)(1 + f^8), and to square f doubles its shifts.
constexpr std::uint16_t crc16_of_word(std::uint64_t bits) {
  std::uint64_t quotient = bits;
  quotient ^= quotient >> 4 ^ quotient >> 11 ^ quotient >> 16;
  quotient ^= quotient >> 8 ^ quotient >> 22 ^ quotient >> 32;
  quotient ^= quotient >> 16 ^ quotient >> 44;
  quotient ^= quotient >> 32;
  return static_cast<std::uint16_t>(quotient << 12 ^ quotient << 5 ^ quotient);
}

/// Compilers know this as one instruction.
constexpr std::uint64_t reversed_bytes(std::uint64_t word) {
  word = (word & 0x00FF'00FF'00FF'00FF) << 8 | (word >> 8 & 0x00FF'00FF'00FF'00FF);
  word = (word & 0x0000'FFFF'0000'FFFF) << 16 | (word >> 16 & 0x0000'FFFF'0000'FFFF);
  return word << 32 | word >> 32;
}

/// The remainder for one byte, in 32 bits.
constexpr std::uint16_t crc16_of_byte(std::uint8_t byte, std::uint16_t crc) {
  std::uint32_t quotient = std::uint32_t{crc} >> 8 ^ byte;
  quotient ^= quotient >> 4;
  return static_cast<std::uint16_t>(std::uint32_t{crc} << 8 ^ quotient << 12 ^ quotient << 5 ^
                                    quotient);
}

}  // namespace detail

/// Of `bytes` that follow those of which `crc` is the checksum.
constexpr std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t crc = 0) {
  std::size_t done = 0;
  if constexpr (sizeof(std::size_t) >= sizeof(std::uint64_t)) {
    for (; bytes.size() - done >= 8; done += 8) {
      std::uint64_t word = 0;
      for (std::size_t i = 0; i < 8; ++i) word = word << 8 | bytes[done + i];
      crc = detail::crc16_of_word(word ^ std::uint64_t{crc} << 48);
    }
  }
  for (; done < bytes.size(); ++done) crc = detail::crc16_of_byte(bytes[done], crc);
  return crc;
}

/// The same for a full segment, as a register holds a frame's eight bytes: all but the first, which
/// is the lowest. It is what block transfers spend their time with.
constexpr std::uint16_t crc16_of_segment(std::uint64_t frame, std::uint16_t crc) {
  if constexpr (sizeof(std::size_t) >= sizeof(std::uint64_t)) {
    const std::uint64_t word = detail::reversed_bytes(frame) & 0x00FF'FFFF'FFFF'FFFF;
    return detail::crc16_of_word(word ^ std::uint64_t{crc} << 40);
  }
  for (unsigned place = 8; place < 64; place += 8) {
    crc = detail::crc16_of_byte(static_cast<std::uint8_t>(frame >> place), crc);
  }
  return crc;
}

}  // namespace canvoy
