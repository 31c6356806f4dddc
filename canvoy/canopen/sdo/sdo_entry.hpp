// An entry of the dictionary, read and written in pieces: the work of an SDO server between the
// frames of a transfer, independent of their form (CiA 301, 7.2.4.2).
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

/// One transfer at a time, to read or to write. Values that are written are collected in a buffer
/// and written completely at the end; domains are streamed. A host reads a streamed domain ahead by
/// what the buffer has room for, and gathers what a block transfer writes there.
class SdoEntry {
 public:
  /// Makes the object. Both arguments must outlive it.
  constexpr SdoEntry(Dictionary& dictionary, std::span<std::uint8_t> buffer)
      : dictionary_(dictionary), buffer_(buffer) {}

  /// Finds an entry. Aborts: those of Dictionary::find(). The result is filled in in place: a copy
  /// would have to wait for its parts.
  AbortCode find(sdo::Multiplexer multiplexer) {
    domain_ = nullptr;
    offset_ = 0;
    ended_ = false;
    if constexpr (!is_small_machine) window_.value = {};
    found_.index = multiplexer.index();
    found_.sub = multiplexer.sub();
    return dictionary_.locate_for_bus(found_);
  }
  /// Shape of the found entry; valid after a successful find().
  const EntryShape& row() const { return *found_.row; }

  /// Opens the found entry for reading. Aborts: those of Dictionary::read(), unsupported_access (a
  /// domain without callbacks), those of the domain.
  AbortCode open_read();
  /// Copies a value that may change during a segmented transfer to the buffer. Abort:
  /// out_of_memory.
  AbortCode keep();
  /// Value, if it is short enough for the answer itself.
  std::optional<std::uint32_t> expedited() const {
    if (is_streamed() || size_ == 0 || size_ > sdo::expedited_max) return std::nullopt;
    return sdo::pack({value_, size_});
  }
  /// Next bytes, as many as there are and `memory` has room for; a domain writes them there.
  /// Aborts: internal_incompatible (the domain has fewer than announced), those of the domain.
  Result<std::span<const std::uint8_t>> next(std::span<std::uint8_t> memory);
  /// For hosts: the same of a domain that is streamed; how many bytes there were.
  Result<std::size_t> next_streamed(std::span<std::uint8_t> memory);
  /// A domain, piece by piece.
  bool is_streamed() const { return domain_ != nullptr; }
  /// For hosts: the same for a full segment that is not the last one, and is in memory: where it
  /// is, or null.
  const std::uint8_t* next_full_segment() {
    if (!is_in_window(sdo::segment_max + 1)) return nullptr;
    const std::uint8_t* segment = value_ + (offset_ - window_.value.first);
    offset_ += static_cast<std::uint32_t>(sdo::segment_max);
    return segment;
  }
  /// Goes back to an earlier position.
  void seek(std::uint32_t offset) {
    offset_ = offset;
    ended_ = false;
    if (!is_small_machine && offset < window_.value.first) window_.value = {offset, offset};
  }
  /// True if all has been read: by the size if known, otherwise after a next() with fewer bytes
  /// than requested.
  bool ended() const { return ended_ || offset_ == size_; }
  /// Size; nothing if the domain does not report it.
  std::optional<std::uint32_t> size() const {
    return size_ == Domain::size_unknown ? std::nullopt : std::optional(size_);
  }
  /// What is to be read, whole; of a domain that is streamed, null.
  const std::uint8_t* value() const { return is_streamed() ? nullptr : value_; }

  /// Writes a value that has arrived completely. Aborts: those of Dictionary::write().
  AbortCode write_whole(std::span<const std::uint8_t> value) {
    return dictionary_.write(found_, value, Source::sdo);
  }
  /// Opens the entry for writing. `announced` is the size from the client. Aborts: read_only,
  /// length_too_high, length_too_low, out_of_memory, unsupported_access (a domain without
  /// callbacks), those of the domain.
  AbortCode open_write(std::optional<std::uint32_t> announced);
  /// Takes the next bytes. Aborts: length_too_high, out_of_memory, those of the domain.
  AbortCode write(std::span<const std::uint8_t> bytes);
  /// For hosts: like write(), but for a full segment: its position in memory, with one more byte
  /// behind it, or null if there is no such room.
  std::uint8_t* room_for_segment() {
    if (!is_in_window(sdo::segment_max + 1)) return nullptr;
    std::uint8_t* room = buffer_.data() + (offset_ - window_.value.first);
    offset_ += static_cast<std::uint32_t>(sdo::segment_max);
    return room;
  }
  /// For hosts: true if a full segment, which is not the last one, goes to the domain at once.
  bool passes_segments_on() const {
    return is_streamed() && window_.value.end == 0 && size_ - offset_ >= sdo::segment_max;
  }
  /// Writes such a segment.
  AbortCode pass_on(std::span<const std::uint8_t> bytes) {
    offset_ += static_cast<std::uint32_t>(bytes.size());
    return domain_->write(found_, bytes);
  }
  /// For hosts: from here on, what is written to a streamed domain is gathered in the buffer. False
  /// for another entry.
  bool gather() {
    if (is_small_machine || !is_streamed() || buffer_.size() < sdo::segment_max) return false;
    open_window();
    return true;
  }
  /// Passes on what is gathered. Aborts: those of the domain, which may end the transfer meanwhile.
  AbortCode flush() { return is_small_machine || !gathers() ? AbortCode::none : flush_window(); }
  /// True if the client announced the number of bytes: more or fewer are an error.
  bool announced() const { return announced_; }
  /// Number of bytes to read, or limit of bytes to write.
  std::uint32_t size_max() const { return size_; }
  /// Number of bytes left.
  std::uint32_t left() const { return size_ - offset_; }
  /// Where a value is gathered; of a domain that is streamed, null.
  const std::uint8_t* gathered() const { return is_streamed() ? nullptr : buffer_.data(); }
  /// Ends a transfer of which all bytes have come. Aborts: length_too_low, those of
  /// Dictionary::write(), the domain's own.
  AbortCode finish();
  /// Ends a transfer without effect; does nothing if there is none.
  void drop() {
    if (domain_ != nullptr) domain_->transfer->close(*this, false);
    if (!is_small_machine && placed_.value.domain != nullptr) close_placed(false);
  }

 private:
  AbortCode open_domain();
  // See DomainTransfer.
  friend DomainTransfer;
  static AbortCode open_domain_to_read(SdoEntry& self, const Domain& domain);
  static Result<std::span<const std::uint8_t>> read_domain(SdoEntry& self,
                                                           std::span<std::uint8_t> memory);
  static AbortCode open_domain_to_write(SdoEntry& self, const Domain& domain);
  Result<std::size_t> stream(std::span<std::uint8_t> memory);
  AbortCode open_view(const Domain& domain);
  AbortCode open_room(const Domain& domain);
  AbortCode close_placed(bool complete);

  /// A domain that has Domain::room, which takes the place of the buffer meanwhile.
  struct Placed {
    const Domain* domain = nullptr;
    std::span<std::uint8_t> buffer;  ///< of values
  };
  /// The part of the entry that is in memory, or has room there: offsets.
  struct Window {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };
  void set_window(std::uint32_t end) {
    if constexpr (!is_small_machine) window_.value = {0, end};
  }
  /// True if the next bytes are in it.
  bool is_in_window(std::size_t size) const { return offset_ + size <= window_.value.end; }
  /// As much as there is room for, from the present position on.
  void open_window() {
    const auto room = static_cast<std::uint32_t>(buffer_.size());
    window_.value = {offset_, offset_ + std::min(room, size_ - offset_)};
  }
  /// A window is open for what is written to a domain.
  bool gathers() const { return is_streamed() && writes_ && window_.value.end != 0; }
  AbortCode write_streamed(std::span<const std::uint8_t> bytes);
  AbortCode flush_window();
  bool read_ahead();
  static AbortCode write_domain(SdoEntry& self, std::span<const std::uint8_t> bytes);
  static AbortCode close_domain(SdoEntry& self, bool complete);

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  bool ended_ = false;
  bool writes_ = false;
  bool announced_ = false;  ///< the size in `size_` was announced
  Dictionary& dictionary_;
  std::span<std::uint8_t> buffer_;
  Entry found_;
  const Domain* domain_ = nullptr;       ///< that is streamed
  const std::uint8_t* value_ = nullptr;  ///< that is read
  [[no_unique_address]] HostOnly<Placed> placed_;
  [[no_unique_address]] HostOnly<Window> window_;
  std::uint32_t size_ = 0;  ///< of what is read; as much as may be written
  std::uint32_t offset_ = 0;
};

/// Size of the buffer with which a server can transfer every value of these tables: the length of
/// the longest.
constexpr std::size_t sdo_buffer_size(const DictionaryTables& tables) {
  std::size_t longest = 0;
  for (const EntryShape& row : tables.entries)
    longest = std::max<std::size_t>(longest, row.capacity);
  return longest;
}

}  // namespace canvoy
