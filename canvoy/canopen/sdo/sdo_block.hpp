// The two ends of an SDO block transfer: one sends segments in blocks, the other takes and
// acknowledges them. A server is one or the other, and so is a client (CiA 301, 7.2.4.3.9 to
// 7.2.4.3.15).
//
//     while (sender.has_segments()) send(sender.segment(bytes, is_last).frame(can_id));
//     AbortCode answer = sender.acknowledge(message);
//     if (!sender.done()) go_back_to(sender.position());
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "canvoy/canopen/sdo/crc16.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"

namespace canvoy {

/// True for the number of segments that a block may have: 1 to 127.
constexpr bool is_block_size(unsigned segments) {
  return segments >= 1 && segments <= sdo::block_size_max;
}

/// Numbers the segments of one block after the other, and determines where to continue after lost
/// segments.
class SdoBlockSender {
 public:
  /// Number of successive blocks without one segment that arrived, after which the transfer fails.
  static constexpr std::uint8_t futile_max = 10;

  /// Begins a transfer, with a first block of `block_size` segments (1 to 127). `memory` has the
  /// data, if it stays complete there until the end: then the checksum is computed a block at a
  /// time.
  void begin(std::uint8_t block_size, bool with_crc, const std::uint8_t* memory);

  /// True if the block is not yet sent completely.
  bool has_segments() const { return sent_ < block_size_ && !ended_; }
  /// Offset of the next segment's data.
  std::uint32_t position() const { return position_; }
  /// True if all segments have arrived.
  bool done() const { return done_; }

  /// Next segment, with these bytes: fewer than 7 in the last one only.
  sdo::Message segment(std::span<const std::uint8_t> bytes, bool last) {
    const auto number = static_cast<std::uint8_t>(++sent_ | (last ? sdo::block_last : 0U));
    const sdo::Message segment = sdo::segment_message(number, bytes);
    if (with_crc_ && memory_ == nullptr) sum(segment, bytes.size());
    position_ += static_cast<std::uint32_t>(bytes.size());
    ended_ = last;
    unused_ = static_cast<std::uint8_t>(sdo::segment_max - bytes.size());
    return segment;
  }

  /// Next segment, full, not the last one, with data in memory.
  sdo::Message full_segment(const std::uint8_t* bytes) {
    const sdo::Message segment = sdo::full_segment_message(++sent_, bytes);
    if (with_crc_ && memory_ == nullptr) [[unlikely]]
      sum(segment, sdo::segment_max);
    position_ += static_cast<std::uint32_t>(sdo::segment_max);
    return segment;
  }

  /// True if an acknowledgement does not belong to this block, but is a copy of the one before: it
  /// acknowledges more than was sent, or equals that one (`looks_like_last`) before the block is
  /// sent completely.
  bool is_stale(sdo::Message acknowledgement, bool looks_like_last) const {
    const bool too_many = acknowledgement.acknowledged() > sent_;
    return has_segments() ? too_many || looks_like_last : too_many && looks_like_last;
  }
  /// Handles the acknowledgement of this block, and begins the next. Aborts: sequence_number,
  /// block_size.
  AbortCode acknowledge(sdo::Message acknowledgement);

  /// Contents of the end message, beside the command; the checksum is zero if unused.
  unsigned end_flags() const { return sdo::block_end | static_cast<unsigned>(unused_) << 2; }
  /// Checksum of all data so far; 0 if unused.
  std::uint16_t crc() const { return crc_; }

 private:
  /// Without complete memory, the checksum is computed segment by segment.
  void sum(sdo::Message segment, std::size_t size) {
    if (position_ < summed_) return;
    crc_ = segment.segment_crc(size, crc_);
    summed_ = position_ + static_cast<std::uint32_t>(size);
  }

  const std::uint8_t* memory_ = nullptr;  ///< the data, if it is complete in memory
  std::uint32_t position_ = 0;
  std::uint32_t begin_ = 0;   ///< offset of the block
  std::uint32_t summed_ = 0;  ///< end of the checksum: data that is sent again counts once
  std::uint16_t crc_ = 0;
  std::uint8_t block_size_ = 0;
  std::uint8_t sent_ = 0;    ///< segments of this block
  std::uint8_t unused_ = 0;  ///< unused bytes of the last segment
  std::uint8_t futile_ = 0;
  bool with_crc_ = false;
  bool ended_ = false;  ///< the last segment has been sent
  bool done_ = false;
};

/// Takes the segments that arrive in sequence. Only the end of the transfer gives the number of
/// data bytes in the last segment, which is kept until then. Data that is streamed, or finds no
/// room in memory, is passed on when the next segment has arrived.
class SdoBlockReceiver {
 public:
  /// Begins a transfer. `memory` is where all data is stored in sequence, if it stays there until
  /// the end: then the checksum is computed a block at a time. Null: it is streamed, or gathered.
  void begin(std::uint8_t block_size, bool with_crc, const std::uint8_t* memory);
  /// For hosts, after begin(): `write` gathers the data, and takes each segment when it arrives.
  void gather() { gathers_.value = true; }

  /// True if a segment requires only that its seven bytes are taken: it is the next one, and
  /// neither the last one nor the end of its block.
  bool is_plain(sdo::Message segment) const {
    return segment.first_byte() == taken_ + 1 && segment.first_byte() < block_size_;
  }
  /// True if a segment is the expected one.
  bool is_next(sdo::Message segment) const {
    return segment.sequence_number() == taken_ + 1 && !ended_;
  }
  /// Counts a plain segment with its bytes in memory.
  void count_plain(sdo::Message segment) {
    ++taken_;
    written_ += static_cast<std::uint32_t>(sdo::segment_max);
    if (with_crc_ && !is_in_memory()) crc_ = segment.segment_crc(sdo::segment_max, crc_);
  }

  /// Effect of a segment, in this order.
  struct Step {
    AbortCode abort = AbortCode::none;  ///< ends the transfer
    bool acknowledge = false;           ///< the block is complete
  };
  /// Takes a segment. `write` takes seven bytes and returns an abort code. Aborts: sequence_number
  /// (not a number of this block), those of `write`.
  template <class Write>
  Step take(sdo::Message segment, Write write) {
    const std::uint8_t number = segment.sequence_number();
    if (number == 0 || number > block_size_) return {AbortCode::sequence_number};
    if (is_next(segment)) {
      taken_ = number;
      ended_ = segment.is_block_last();
      const AbortCode answer = keep(segment, write);
      if (answer != AbortCode::none) return {answer};
    }
    return {AbortCode::none, number == block_size_ || segment.is_block_last()};
  }
  /// Ends the transfer; `end` has the number of unused bytes in the last segment. Aborts: crc,
  /// those of `write`.
  template <class Write>
  AbortCode finish(sdo::Message end, Write write) {
    const AbortCode answer = put(held_, sdo::segment_max - end.block_unused(), write);
    if (answer != AbortCode::none) return answer;
    sum();
    return with_crc_ && end.crc() != crc_ ? AbortCode::crc : AbortCode::none;
  }

  /// True if the checksum of a message that looks like the end is that of all segments: a copy of
  /// the last segment has it by chance only. Without checksums the end has 0 there.
  bool is_right(sdo::Message end) const {
    const std::size_t size = sdo::segment_max - end.block_unused();
    return end.crc() == (with_crc_ ? held_.segment_crc(size, crc_) : 0);
  }

  /// Acknowledgement of this block; the next block follows.
  sdo::Message acknowledge(std::uint8_t command) {
    sum();
    return {command, std::exchange(taken_, std::uint8_t{0}), block_size_};
  }
  /// True if the last segment has arrived.
  bool ended() const { return ended_; }
  /// True if a part of this block has arrived.
  bool has_some() const { return taken_ != 0; }

 private:
  bool is_in_memory() const { return memory_ != nullptr; }
  /// Stores at once what memory has room for.
  template <class Write>
  AbortCode keep(sdo::Message segment, Write write) {
    const bool gathers = !is_small_machine && gathers_.value;
    const bool at_once = (is_in_memory() || gathers) && !holds_ && !ended_;
    if (at_once) {
      const AbortCode answer = put(segment, sdo::segment_max, write);
      if (answer == AbortCode::none || gathers) return answer;
    }
    const sdo::Message before = std::exchange(held_, segment);
    return std::exchange(holds_, true) ? put(before, sdo::segment_max, write) : AbortCode::none;
  }
  template <class Write>
  AbortCode put(sdo::Message segment, std::size_t size, Write write) {
    const auto data = segment.bytes();
    const auto bytes = std::span(data).subspan(1, size);
    if (!is_in_memory()) {
      if (with_crc_) crc_ = segment.segment_crc(size, crc_);
      return write(bytes);  // the last step: it may begin another transfer
    }
    const AbortCode answer = write(bytes);
    if (answer == AbortCode::none) written_ += static_cast<std::uint32_t>(size);
    return answer;
  }
  void sum();

  sdo::Message held_{0};
  const std::uint8_t* memory_ = nullptr;
  std::uint32_t written_ = 0;  ///< bytes in memory
  std::uint32_t summed_ = 0;   ///< bytes in memory that the checksum covers
  std::uint16_t crc_ = 0;
  std::uint8_t block_size_ = 0;
  std::uint8_t taken_ = 0;  ///< last segment of this block that arrived in sequence
  bool with_crc_ = false;
  [[no_unique_address]] HostOnly<bool> gathers_;
  bool holds_ = false;
  bool ended_ = false;
};

}  // namespace canvoy
