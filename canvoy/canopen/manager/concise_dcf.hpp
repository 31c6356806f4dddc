// Reads a concise DCF, the configuration of one slave as 1F22h holds it (CiA 302-3): a count, then
// for each entry its index, sub-index, size and bytes, all little-endian.
//
// It is read piece by piece from wherever it is, and never in memory whole.
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
#include "canvoy/canopen/dictionary/abort_code.hpp"

namespace canvoy {

/// Bytes in flash, in a file, or behind a domain.
struct ByteSource {
  std::uint32_t size = 0;
  /// Fills `bytes` from `offset` on; called within `size` only. Its abort code ends the reading.
  Callback<AbortCode(std::uint32_t offset, std::span<std::uint8_t> bytes)> read;
};

/// Of a malformed one, length_too_low says that it ends before all entries came, length_too_high
/// that something follows the last. No byte beyond the size of the source is ever asked for, and no
/// number in it is believed before it was held against that size.
class ConciseDcf {
 public:
  /// One entry that is to be written.
  struct Item {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::uint32_t size = 0;    ///< of the value, in bytes
    std::uint32_t offset = 0;  ///< of the value, in the source
  };

  /// Begins with the first entry. Aborts: length_too_low, length_too_high, the source's own.
  AbortCode open(const ByteSource& source);
  /// The next entry, without its value. Aborts: as those of open(); no_data where all were read.
  Result<Item> next();
  /// Bytes of an entry's value from `offset` on. Aborts: length_too_high, the source's own.
  AbortCode read(const Item& item, std::uint32_t offset, std::span<std::uint8_t> bytes) const;

  bool at_end() const { return position_ == count_; }
  std::uint32_t count() const { return count_; }
  std::uint32_t position() const { return position_; }  ///< entries that were read

 private:
  ByteSource source_;
  std::uint32_t count_ = 0;
  std::uint32_t position_ = 0;
  std::uint32_t offset_ = 0;  ///< of what follows
};

/// Reads through all of it, but for the values: what is refused here changes nothing in a slave.
/// The number of entries, or the aborts of ConciseDcf. Linear in the number of entries.
Result<std::uint32_t> check_concise_dcf(const ByteSource& source);

}  // namespace canvoy
