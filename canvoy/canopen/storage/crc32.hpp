// CRC-32 as in Ethernet, zip and the software identification 1F56h: polynomial 04C11DB7h,
// reflected, FFFFFFFFh at the start and inverted at the end.
//
//     Crc32 crc;
//     crc.add(bytes);
//     crc.value();
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace canvoy {

/// Computes four bits at a time: 64 bytes of table instead of a kilobyte, since flash is slower
/// anyway.
class Crc32 {
 public:
  /// Adds bytes; parts added one after the other count as one.
  constexpr void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      state_ ^= byte;
      state_ = table[state_ & 0x0F] ^ state_ >> 4;
      state_ = table[state_ & 0x0F] ^ state_ >> 4;
    }
  }
  /// Checksum of all bytes so far; 0 if there were none.
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::array<std::uint32_t, 16> table = [] {
    std::array<std::uint32_t, 16> made{};
    for (std::uint32_t nibble = 0; nibble < made.size(); ++nibble) {
      std::uint32_t rest = nibble;
      for (int bit = 0; bit < 4; ++bit) rest = rest >> 1 ^ ((rest & 1) != 0 ? 0xEDB8'8320 : 0);
      made[nibble] = rest;
    }
    return made;
  }();

  std::uint32_t state_ = 0xFFFF'FFFF;
};

/// Checksum of bytes that are in memory whole. Two table look-ups for each byte.
constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace canvoy
