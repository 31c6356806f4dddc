// The two ends of an SDO block transfer: who sends segments in blocks, and who takes and
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

#include "canvoy/canopen/crc16.hpp"
#include "canvoy/canopen/sdo.hpp"

namespace canvoy {

constexpr bool is_block_size(unsigned segments) {
  return segments >= 1 && segments <= sdo::block_size_max;
}

/// Numbers the segments of one block after the other, and says from where to go on when some of
/// them were lost.
class SdoBlockSender {
 public:
  /// Blocks in a row of which not one segment arrived; then it is in vain.
  static constexpr std::uint8_t futile_max = 10;

  /// A transfer begins, with a first block of `block_size` segments (1 to 127).
  void begin(std::uint8_t block_size, bool with_crc);

  /// The block is not yet sent whole.
  bool has_segments() const { return sent_ < block_size_ && !ended_; }
  /// Offset of the next segment's data.
  std::uint32_t position() const { return position_; }
  /// All segments have arrived.
  bool done() const { return done_; }

  /// The next segment, with these bytes: fewer than 7 in the last one only.
  sdo::Message segment(std::span<const std::uint8_t> bytes, bool last) {
    const auto number = static_cast<std::uint8_t>(++sent_ | (last ? sdo::block_last : 0U));
    const sdo::Message segment = sdo::segment_message(number, bytes);
    if (with_crc_ && position_ >= summed_) {
      crc_ = segment.segment_crc(bytes.size(), crc_);
      summed_ = position_ + static_cast<std::uint32_t>(bytes.size());
    }
    position_ += static_cast<std::uint32_t>(bytes.size());
    ended_ = last;
    unused_ = static_cast<std::uint8_t>(sdo::segment_max - bytes.size());
    return segment;
  }

  /// The block is not yet sent whole, and more of it is acknowledged than was sent: that can only
  /// be a copy of the acknowledgement before, and says nothing of this block.
  bool is_stale(sdo::Message acknowledgement) const {
    return has_segments() && acknowledgement.acknowledged() > sent_;
  }
  /// Begins the next block where this one was acknowledged. Aborts: sequence_number, block_size.
  AbortCode acknowledge(sdo::Message acknowledgement);

  /// What is told at the end, beside the command; the checksum is zero without.
  unsigned end_flags() const { return sdo::block_end | static_cast<unsigned>(unused_) << 2; }
  std::uint16_t crc() const { return crc_; }

 private:
  std::uint32_t position_ = 0;
  std::uint32_t begin_ = 0;   ///< offset of the block
  std::uint32_t summed_ = 0;  ///< the checksum goes to here: what is sent again counts once
  std::uint16_t crc_ = 0;
  std::uint8_t block_size_ = 0;
  std::uint8_t sent_ = 0;    ///< segments of this block
  std::uint8_t unused_ = 0;  ///< bytes of the last segment
  std::uint8_t futile_ = 0;
  bool with_crc_ = false;
  bool ended_ = false;  ///< the last segment has been sent
  bool done_ = false;
};

/// Takes the segments that come in sequence. The last one is kept until its successor or the end of
/// the transfer comes: only the end tells how many of its bytes are data.
class SdoBlockReceiver {
 public:
  void begin(std::uint8_t block_size, bool with_crc);

  /// What a segment brings about, in this order.
  struct Step {
    AbortCode abort = AbortCode::none;
    bool acknowledge = false;  ///< the block has come to its end
  };
  /// `write` takes seven bytes and answers an abort code. Aborts: sequence_number (no number of
  /// this block), those of `write`.
  template <class Write>
  Step take(const Frame& frame, Write write) {
    const sdo::Message segment(frame);
    const std::uint8_t number = segment.sequence_number();
    if (number == 0 || number > block_size_) return {AbortCode::sequence_number};
    if (number == taken_ + 1 && !ended_) {
      const AbortCode answer = release(sdo::segment_max, write);
      if (answer != AbortCode::none) return {answer};
      held_ = segment;
      holds_ = true;
      taken_ = number;
      ended_ = segment.is_block_last();
    }
    return {AbortCode::none, number == block_size_ || segment.is_block_last()};
  }
  /// The transfer ends, and of the last segment so many bytes are not data. Aborts: crc, those of
  /// `write`.
  template <class Write>
  AbortCode finish(sdo::Message end, Write write) {
    const AbortCode answer = release(sdo::segment_max - end.block_unused(), write);
    if (answer != AbortCode::none) return answer;
    return with_crc_ && end.crc() != crc_ ? AbortCode::crc : AbortCode::none;
  }

  /// The acknowledgement of this block; what follows is the next.
  sdo::Message acknowledge(std::uint8_t command) {
    return {command, std::exchange(taken_, std::uint8_t{0}), block_size_};
  }
  /// The last segment has come.
  bool ended() const { return ended_; }
  /// Something of this block has come.
  bool has_some() const { return taken_ != 0; }

 private:
  template <class Write>
  AbortCode release(std::size_t size, Write write) {
    if (!holds_) return AbortCode::none;
    holds_ = false;
    if (with_crc_) crc_ = held_.segment_crc(size, crc_);
    const auto data = held_.bytes();
    return write(std::span(data).subspan(1, size));
  }

  sdo::Message held_{0};
  std::uint16_t crc_ = 0;
  std::uint8_t block_size_ = 0;
  std::uint8_t taken_ = 0;  ///< the last segment of this block that came in sequence
  bool with_crc_ = false;
  bool holds_ = false;
  bool ended_ = false;
};

}  // namespace canvoy
