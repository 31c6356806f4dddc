// A record in flash: what is written first is its content, and last, in front of it, 32 bytes that
// say that it is whole. Without them there is no record, so that power may fail at any moment.
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

struct RecordHead {
  static constexpr std::uint32_t size = 32;
  static constexpr std::uint32_t present_format = 1;
  using Bytes = std::array<std::uint8_t, size>;

  std::uint32_t kind = 0;                       ///< what the record is about
  std::uint32_t format = present_format;        ///< of the content
  std::uint32_t sequence = 0;                   ///< the newer of two records has the higher one
  std::uint32_t length = 0;                     ///< of the content, which follows the head
  std::uint32_t crc = 0;                        ///< CRC-32 of the content
  std::array<std::uint32_t, 2> signature = {};  ///< who can read it

  /// In the order of the members, then the CRC-32 of all that.
  Bytes bytes() const;
  /// Nothing where they are no head.
  static std::optional<RecordHead> from(const Bytes& bytes);

  /// Sequence numbers go round.
  bool newer_than(const RecordHead& other) const {
    return static_cast<std::int32_t>(sequence - other.sequence) > 0;
  }
};

/// What there is in the place of a head.
enum class HeadState : std::uint8_t { blank, good, bad, unreadable };

/// Reads the head at `address`; `head` is set where it is good.
HeadState read_head(const Flash& flash, std::uint32_t address, RecordHead& head);

/// The CRC-32 of `length` bytes from `address` on; nothing where they cannot be read.
std::optional<std::uint32_t> crc32_of(const Flash& flash, std::uint32_t address,
                                      std::uint32_t length);

}  // namespace canvoy
