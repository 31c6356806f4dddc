// A record in flash: its content is written first, and last, in front of it, 32 bytes that mark it
// as complete. Without them there is no record, so that power may fail at any moment.
//
//     RecordHead head{.kind = kind, .sequence = 7, .length = 120, .crc = crc.value()};
//     flash.program(address, head.bytes());
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/storage/flash.hpp"

namespace canvoy {

/// The 32 bytes in front of the content. All numbers are little-endian.
struct RecordHead {
  static constexpr std::uint32_t size = 32;           ///< in bytes
  static constexpr std::uint32_t present_format = 1;  ///< other formats are not read
  using Bytes = std::array<std::uint8_t, size>;       ///< as in the flash

  std::uint32_t kind = 0;                       ///< subject of the record
  std::uint32_t format = present_format;        ///< of the content
  std::uint32_t sequence = 0;                   ///< the newer of two records has the higher one
  std::uint32_t length = 0;                     ///< of the content, which follows the head
  std::uint32_t crc = 0;                        ///< checksum of the content
  std::array<std::uint32_t, 2> signature = {};  ///< of the readers

  /// The members in their order, then the CRC-32 of all that.
  Bytes bytes() const;
  /// Head in these bytes; nothing if they are not a head.
  static std::optional<RecordHead> from(const Bytes& bytes);

  /// True if it is newer; sequence numbers wrap around.
  bool newer_than(const RecordHead& other) const {
    return static_cast<std::int32_t>(sequence - other.sequence) > 0;
  }
};

/// State of the memory for a head.
enum class HeadState : std::uint8_t { blank, good, bad, unreadable };

/// Reads the head at `address`; `head` is set if it is good.
HeadState read_head(const Flash& flash, std::uint32_t address, RecordHead& head);

/// CRC-32 of `length` bytes from `address` on; nothing if they cannot be read.
std::optional<std::uint32_t> crc32_of(const Flash& flash, std::uint32_t address,
                                      std::uint32_t length);

}  // namespace canvoy
