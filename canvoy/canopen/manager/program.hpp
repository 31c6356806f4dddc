// Program download: the common definitions of both ends (CiA 302-3).
//
// A client stops the program (1F51h), clears its memory, downloads the new one (1F50h), checks the
// result (1F57h), and starts it. The sub-index is the number of the program.
#pragma once

#include <cstdint>

namespace canvoy {

namespace program {
inline constexpr std::uint16_t data = 0x1F50;           ///< the program, a domain
inline constexpr std::uint16_t control = 0x1F51;        ///< ProgramCommand
inline constexpr std::uint16_t verify = 0x1F52;         ///< sub-index 1: date, 2: time
inline constexpr std::uint16_t expected_date = 0x1F53;  ///< of the master: days since 1984
inline constexpr std::uint16_t expected_time = 0x1F54;  ///< of the master: ms since midnight
inline constexpr std::uint16_t expected_identification = 0x1F55;  ///< of the master: checksums
inline constexpr std::uint16_t identification = 0x1F56;           ///< of the slave: a checksum
inline constexpr std::uint16_t status = 0x1F57;                   ///< FlashStatus
}  // namespace program

/// Command written to 1F51h. A read returns whether the program is stopped (0) or runs (1).
enum class ProgramCommand : std::uint8_t { stop = 0, start = 1, reset = 2, clear = 3 };

/// Result of the last step: bits 1 to 7 of 1F57h.
enum class FlashError : std::uint8_t {
  none = 0,
  no_valid_program = 1,
  unknown_format = 2,
  checksum = 3,  ///< or a format error
  not_cleared = 4,
  write_error = 5,
  address_error = 6,
  secured = 7,
  unspecified = 63,
};

/// Value of 1F57h: bit 0 while the flash is busy, the error, and 16 bits of the manufacturer.
class FlashStatus {
 public:
  constexpr FlashStatus() = default;
  /// Takes a value of 1F57h.
  constexpr explicit FlashStatus(std::uint32_t raw) : raw_(raw) {}
  /// Makes a value without manufacturer-specific bits.
  constexpr explicit FlashStatus(FlashError error, bool busy = false)
      : raw_(static_cast<std::uint32_t>(error) << 1 | (busy ? 1U : 0U)) {}

  /// True while the flash works.
  constexpr bool busy() const { return (raw_ & 1) != 0; }
  /// Result of the last step; numbers that CiA 302-3 does not list are possible.
  constexpr FlashError error() const { return static_cast<FlashError>(raw_ >> 1 & 0x7F); }
  /// Upper 16 bits.
  constexpr std::uint16_t manufacturer() const { return static_cast<std::uint16_t>(raw_ >> 16); }
  /// Value for 1F57h.
  constexpr std::uint32_t raw() const { return raw_; }

 private:
  std::uint32_t raw_ = 0;
};

}  // namespace canvoy
