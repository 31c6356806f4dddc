// The checksum of SDO block transfers: CRC-16 with the polynomial x^16 + x^12 + x^5 + 1, from zero,
// not reflected (CiA 301, 7.2.4.3.16).
//
// There is no table. The polynomial has few terms, so that a division by it takes a few shifts:
// eight bytes at a time on wide registers, otherwise one at a time. Long messages are shortened
// first, by three additions for eight bytes.
//
//     std::uint16_t crc = crc16(first_half);
//     crc = crc16(second_half, crc);
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace canvoy {

namespace detail {

/// Remainder of `bits` times x^16. The quotient is `bits` divided by 1 + f, where f is the
/// polynomial without x^16: shifts to the right by 4, 11 and 16. Over bits, 1 / (1 + f) is (1 +
/// f)(1 + f^2)(1 + f^4)(1 + f^8), and squaring f doubles its shifts.
constexpr std::uint16_t crc16_of_word(std::uint64_t bits) {
  std::uint64_t quotient = bits;
  quotient ^= quotient >> 4 ^ quotient >> 11 ^ quotient >> 16;
  quotient ^= quotient >> 8 ^ quotient >> 22 ^ quotient >> 32;
  quotient ^= quotient >> 16 ^ quotient >> 44;
  quotient ^= quotient >> 32;
  return static_cast<std::uint16_t>(quotient << 12 ^ quotient << 5 ^ quotient);
}

/// Compilers recognise this as one instruction.
constexpr std::uint64_t reversed_bytes(std::uint64_t word) {
  word = (word & 0x00FF'00FF'00FF'00FF) << 8 | (word >> 8 & 0x00FF'00FF'00FF'00FF);
  word = (word & 0x0000'FFFF'0000'FFFF) << 16 | (word >> 16 & 0x0000'FFFF'0000'FFFF);
  return word << 32 | word >> 32;
}

/// Remainder for one byte, in 32 bits.
constexpr std::uint16_t crc16_of_byte(std::uint8_t byte, std::uint16_t crc) {
  std::uint32_t quotient = std::uint32_t{crc} >> 8 ^ byte;
  quotient ^= quotient >> 4;
  return static_cast<std::uint16_t>(std::uint32_t{crc} << 8 ^ quotient << 12 ^ quotient << 5 ^
                                    quotient);
}

/// Eight bytes, the first in the most significant position.
constexpr std::uint64_t word_of(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < 8; ++i) word = word << 8 | bytes[i];
  return word;
}

/// A message reduced to its last 256 bits. Over bits, squaring a polynomial doubles its exponents:
/// the sixteenth power of this one is x^256 + x^192 + x^80 + 1. As it leaves no remainder, 64 bits
/// of a message may be removed if they are added 64, 176 and 256 bits further on.
class Crc16Fold {
 public:
  /// Starts with the first 32 bytes; `crc` is that of what precedes them.
  constexpr Crc16Fold(const std::uint8_t* bytes, std::uint16_t crc)
      : first_(word_of(bytes) ^ std::uint64_t{crc} << 48),
        second_(word_of(bytes + 8)),
        third_(word_of(bytes + 16)),
        fourth_(word_of(bytes + 24)) {}

  constexpr void append(std::uint64_t word) {
    const std::uint64_t taken = first_;
    first_ = second_ ^ taken;
    second_ = third_ ^ taken >> 48;
    third_ = fourth_ ^ taken << 16;
    fourth_ = word ^ taken;
  }
  constexpr std::uint16_t crc() const {
    std::uint64_t crc = 0;
    for (const std::uint64_t word : {first_, second_, third_, fourth_}) {
      crc = crc16_of_word(word ^ crc << 48);
    }
    return static_cast<std::uint16_t>(crc);
  }

 private:
  std::uint64_t first_;
  std::uint64_t second_;
  std::uint64_t third_;
  std::uint64_t fourth_;
};

/// Number of bytes from which folding pays off.
inline constexpr std::size_t crc16_fold_min = 64;

}  // namespace detail

/// Checksum of `bytes` that follow those with the checksum `crc`.
constexpr std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t crc = 0) {
  std::size_t done = 0;
  if constexpr (sizeof(std::size_t) >= sizeof(std::uint64_t)) {
    const std::uint8_t* data = bytes.data();
    if (bytes.size() >= detail::crc16_fold_min) {
      detail::Crc16Fold fold(data, crc);
      for (done = 32; bytes.size() - done >= 8; done += 8)
        fold.append(detail::word_of(data + done));
      crc = fold.crc();
    }
    for (; bytes.size() - done >= 8; done += 8) {
      crc = detail::crc16_of_word(detail::word_of(data + done) ^ std::uint64_t{crc} << 48);
    }
  }
  for (; done < bytes.size(); ++done) crc = detail::crc16_of_byte(bytes[done], crc);
  return crc;
}

/// Like crc16(), but for a segment in a register with a frame's eight bytes: for `size` bytes after
/// the first, which is the lowest. Nearly all segments are full.
constexpr std::uint16_t crc16_of_segment(std::uint64_t frame, std::size_t size, std::uint16_t crc) {
  if constexpr (sizeof(std::size_t) >= sizeof(std::uint64_t)) {
    const std::uint64_t word = detail::reversed_bytes(frame) & 0x00FF'FFFF'FFFF'FFFF;
    if (size == 7) return detail::crc16_of_word(word ^ std::uint64_t{crc} << 40);
  }
  for (; size != 0; --size) {
    frame >>= 8;
    crc = detail::crc16_of_byte(static_cast<std::uint8_t>(frame), crc);
  }
  return crc;
}

}  // namespace canvoy
