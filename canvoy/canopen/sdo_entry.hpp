// An entry of the dictionary, read and written piece by piece: what an SDO server does between the
// frames of a transfer, whatever these frames look like (CiA 301, 7.2.4.2).
//
//     SdoWriter writer(dictionary, buffer);
//     AbortCode answer = writer.open(entry, announced);
//     answer = writer.write(bytes);
//     answer = writer.finish();
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/dictionary.hpp"

namespace canvoy {

/// A value as it was when it was opened, or a domain as it is streamed.
class SdoReader {
 public:
  /// `value` is what the dictionary gave for `entry`. It is copied to `buffer`, unless it never
  /// changes. Abort: out_of_memory.
  AbortCode open(const Entry& entry, std::span<const std::uint8_t> value,
                 std::span<std::uint8_t> buffer);
  /// Aborts: write_only, unsupported_access (nobody serves it), the domain's own.
  AbortCode open_domain(const Dictionary& dictionary, const Entry& entry);

  /// The next bytes, as many as there are and `memory` has room for; a domain puts them there.
  /// Aborts: internal_incompatible (the domain has fewer than it told), the domain's own.
  Result<std::span<const std::uint8_t>> next(std::span<std::uint8_t> memory);
  /// Goes back to where it has been before.
  void seek(std::uint32_t offset) {
    offset_ = offset;
    ended_ = false;
  }
  /// All has been read: known where the size is, or from a next() that gave less than was asked
  /// for.
  bool ended() const { return ended_ || offset_ == size_; }

  bool is_domain() const { return domain_ != nullptr; }
  /// Nothing, where the domain does not know.
  std::optional<std::uint32_t> size() const {
    return size_ == Domain::size_unknown ? std::nullopt : std::optional(size_);
  }

 private:
  Entry entry_;
  const Domain* domain_ = nullptr;
  const std::uint8_t* value_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t offset_ = 0;
  bool ended_ = false;
};

/// Values are gathered in a buffer and written whole at the end; domains are streamed.
class SdoWriter {
 public:
  /// Both must outlive the writer.
  SdoWriter(Dictionary& dictionary, std::span<std::uint8_t> buffer)
      : dictionary_(dictionary), buffer_(buffer) {}

  /// `announced` is the size that the client told. Aborts: read_only, length_too_high,
  /// length_too_low, out_of_memory, unsupported_access (a domain that nobody serves), the domain's.
  AbortCode open(const Entry& entry, std::optional<std::uint32_t> announced);
  /// The next bytes. Aborts: length_too_high, out_of_memory, the domain's own.
  AbortCode write(std::span<const std::uint8_t> bytes);
  /// Ends a transfer of which all bytes have come. Aborts: length_too_low, those of
  /// Dictionary::write(), the domain's own.
  AbortCode finish();
  /// Ends a transfer that came to nothing. Without one, it does nothing.
  void drop();

 private:
  AbortCode check_size(std::uint32_t size) const;

  Dictionary& dictionary_;
  std::span<std::uint8_t> buffer_;
  Entry entry_;
  const Domain* domain_ = nullptr;
  std::optional<std::uint32_t> announced_;
  std::uint32_t received_ = 0;
};

/// What a server needs of a buffer to take and give every value of these tables: the length of the
/// longest.
constexpr std::size_t sdo_buffer_size(const DictionaryTables& tables) {
  std::size_t longest = 0;
  for (const EntryRow& row : tables.entries) longest = std::max<std::size_t>(longest, row.capacity);
  return longest;
}

}  // namespace canvoy
