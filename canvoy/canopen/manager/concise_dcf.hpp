// Reads a concise DCF, the configuration of one slave in 1F22h: a count, then for each entry its
// index, sub-index, size and bytes, all little-endian (CiA 302-3).
//
// It is read in pieces from its source, and never completely in memory.
//
//     ConciseDcf dcf;
//     AbortCode bad = dcf.open(source);
//     while (!dcf.at_end()) {
//       Result<ConciseDcf::Item> item = dcf.next();
//       ...
//     }
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"

namespace canvoy {

/// Source of bytes: in flash, in a file, or behind a domain.
struct ByteSource {
  std::uint32_t size = 0;  ///< in bytes
  /// Fills `bytes` from `offset` on; called within `size` only. An abort code ends the reading.
  Callback<AbortCode(std::uint32_t offset, std::span<std::uint8_t> bytes)> read;
};

/// Reader. For malformed data, length_too_low means that it ends before all entries came,
/// length_too_high that data follows the last one. No byte beyond the size of the source is
/// requested, and every number in it is checked against that size before use.
class ConciseDcf {
 public:
  /// One entry to write.
  struct Item {
    std::uint16_t index = 0;   ///< of the object to write
    std::uint8_t sub = 0;      ///< sub-index
    std::uint32_t size = 0;    ///< of the value, in bytes
    std::uint32_t offset = 0;  ///< of the value, in the source
  };

  /// Begins with the first entry. Aborts: length_too_low, length_too_high, those of the source.
  AbortCode open(const ByteSource& source);
  /// Next entry, without its value. Aborts: those of open(); no_data if all were read.
  Result<Item> next();
  /// Reads bytes of an entry's value from `offset` on. Aborts: length_too_high, those of the
  /// source.
  AbortCode read(const Item& item, std::uint32_t offset, std::span<std::uint8_t> bytes) const;

  /// True if all entries were read.
  bool at_end() const { return position_ == count_; }
  /// Number of entries that it says to have; 0 before open().
  std::uint32_t count() const { return count_; }
  std::uint32_t position() const { return position_; }  ///< number of entries read

 private:
  ByteSource source_;
  std::uint32_t count_ = 0;
  std::uint32_t position_ = 0;
  std::uint32_t offset_ = 0;  ///< of the next data
};

/// Checks all of it except the values: data refused here changes nothing in a slave. Returns the
/// number of entries, or the aborts of ConciseDcf. Linear in the number of entries.
Result<std::uint32_t> check_concise_dcf(const ByteSource& source);

}  // namespace canvoy
