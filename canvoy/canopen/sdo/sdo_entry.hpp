// An entry of the dictionary, read and written piece by piece: what an SDO server does between the
// frames of a transfer, whatever these frames look like (CiA 301, 7.2.4.2).
//
//     SdoEntry entry(dictionary, buffer);
//     AbortCode answer = entry.find({0x2000, 0});
//     answer = entry.open_write(announced);
//     answer = entry.write(bytes);
//     answer = entry.finish();
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"

namespace canvoy {

/// One transfer at a time, to read or to write. Values that are written are gathered in a buffer
/// and written whole at the end; domains are streamed.
class SdoEntry {
 public:
  /// Both must outlive this.
  constexpr SdoEntry(Dictionary& dictionary, std::span<std::uint8_t> buffer)
      : dictionary_(dictionary), buffer_(buffer) {}

  /// Aborts: those of Dictionary::find().
  AbortCode find(sdo::Multiplexer multiplexer);
  const EntryShape& row() const { return *found_.row; }

  /// What find() has found. Aborts: those of Dictionary::read(), unsupported_access (a domain that
  /// nobody serves), the domain's own.
  AbortCode open_read();
  /// Copies what may change during a transfer in pieces to the buffer. Abort: out_of_memory.
  AbortCode keep();
  /// The value, where it is short enough to go with the answer.
  std::optional<std::uint32_t> expedited() const {
    if (is_domain() || size_ == 0 || size_ > sdo::expedited_max) return std::nullopt;
    return sdo::pack({value_, size_});
  }
  /// The next bytes, as many as there are and `memory` has room for; a domain puts them there.
  /// Aborts: internal_incompatible (the domain has fewer than it told), the domain's own.
  Result<std::span<const std::uint8_t>> next(std::span<std::uint8_t> memory);
  /// The same for a full segment that is not the last one, of a value: where it is, or null.
  const std::uint8_t* next_full_segment() {
    if (size_ - offset_ <= sdo::segment_max || is_domain()) return nullptr;
    const std::uint8_t* segment = value_ + offset_;
    offset_ += static_cast<std::uint32_t>(sdo::segment_max);
    return segment;
  }
  /// Goes back to where it has been before.
  void seek(std::uint32_t offset) {
    offset_ = offset;
    ended_ = false;
  }
  /// All has been read: known where the size is, or from a next() that gave less than was asked
  /// for.
  bool ended() const { return ended_ || offset_ == size_; }
  /// Nothing, where the domain does not know.
  std::optional<std::uint32_t> size() const {
    return size_ == Domain::size_unknown ? std::nullopt : std::optional(size_);
  }
  /// What is to be read, whole; of a domain, null.
  const std::uint8_t* value() const { return is_domain() ? nullptr : value_; }

  /// A value that has come whole. Aborts: those of Dictionary::write().
  AbortCode write_whole(std::span<const std::uint8_t> value) {
    return dictionary_.write(found_, value, Source::sdo);
  }
  /// `announced` is the size that the client told. Aborts: read_only, length_too_high,
  /// length_too_low, out_of_memory, unsupported_access (a domain that nobody serves), the domain's.
  AbortCode open_write(std::optional<std::uint32_t> announced);
  /// The next bytes. Aborts: length_too_high, out_of_memory, the domain's own.
  AbortCode write(std::span<const std::uint8_t> bytes);
  /// The same for a full segment of a value: where it is to be put, with a byte to spare behind it,
  /// or null where there is no such room.
  std::uint8_t* room_for_segment() {
    if (size_ - offset_ <= sdo::segment_max || is_domain()) return nullptr;
    std::uint8_t* room = buffer_.data() + offset_;
    offset_ += static_cast<std::uint32_t>(sdo::segment_max);
    return room;
  }
  /// The client told how many bytes it writes: more or fewer of them are an error.
  bool announced() const { return announced_; }
  /// How many bytes there are to read, or may be written.
  std::uint32_t size_max() const { return size_; }
  /// How many of them are left.
  std::uint32_t left() const { return size_ - offset_; }
  /// Where a value is gathered; of a domain, null.
  const std::uint8_t* gathered() const { return is_domain() ? nullptr : buffer_.data(); }
  /// Ends a transfer of which all bytes have come. Aborts: length_too_low, those of
  /// Dictionary::write(), the domain's own.
  AbortCode finish();
  /// Ends a transfer that came to nothing. Without one, it does nothing.
  void drop() {
    if (domain_ != nullptr) domain_->transfer->close(*this, false);
  }

 private:
  bool is_domain() const { return domain_ != nullptr; }
  AbortCode open_domain();
  // See DomainTransfer.
  friend DomainTransfer;
  static AbortCode open_domain_to_read(SdoEntry& self, const Domain& domain);
  static Result<std::span<const std::uint8_t>> read_domain(SdoEntry& self,
                                                           std::span<std::uint8_t> memory);
  static AbortCode open_domain_to_write(SdoEntry& self, const Domain& domain);
  static AbortCode write_domain(SdoEntry& self, std::span<const std::uint8_t> bytes);
  static AbortCode close_domain(SdoEntry& self, bool complete);

  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  bool ended_ = false;
  bool writes_ = false;
  bool announced_ = false;  ///< that `size_` bytes are to be written
  Dictionary& dictionary_;
  std::span<std::uint8_t> buffer_;
  Entry found_;
  const Domain* domain_ = nullptr;
  const std::uint8_t* value_ = nullptr;  ///< that is read
  std::uint32_t size_ = 0;               ///< of what is read; as much as may be written
  std::uint32_t offset_ = 0;
};

/// What a server needs of a buffer to take and give every value of these tables: the length of the
/// longest.
constexpr std::size_t sdo_buffer_size(const DictionaryTables& tables) {
  std::size_t longest = 0;
  for (const EntryShape& row : tables.entries)
    longest = std::max<std::size_t>(longest, row.capacity);
  return longest;
}

}  // namespace canvoy
