#include "canvoy/canopen/sdo/sdo_block.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

void SdoBlockSender::begin(std::uint8_t block_size, bool with_crc, const std::uint8_t* memory) {
  check_invariant(is_block_size(block_size));
  *this = {};
  memory_ = memory;
  block_size_ = block_size;
  with_crc_ = with_crc;
}

AbortCode SdoBlockSender::acknowledge(sdo::Message acknowledgement) {
  const std::uint8_t arrived = acknowledgement.acknowledged();
  if (arrived > sent_) return AbortCode::sequence_number;
  const bool all = arrived == sent_;
  const std::uint32_t end = all ? position_ : begin_ + arrived * std::uint32_t{sdo::segment_max};
  check_invariant(begin_ <= end && end <= position_);
  if (with_crc_ && memory_ != nullptr) crc_ = crc16({memory_ + begin_, end - begin_}, crc_);
  done_ = ended_ && all;
  if (done_) return AbortCode::none;
  if (!is_block_size(acknowledgement.next_block_size())) return AbortCode::block_size;
  futile_ = arrived == 0 ? static_cast<std::uint8_t>(futile_ + 1) : std::uint8_t{0};
  if (futile_ > futile_max) return AbortCode::sequence_number;
  block_size_ = acknowledgement.next_block_size();
  position_ = begin_ = end;
  sent_ = 0;
  ended_ = false;
  return AbortCode::none;
}

void SdoBlockReceiver::begin(std::uint8_t block_size, bool with_crc, const std::uint8_t* memory) {
  *this = {};
  memory_ = memory;
  block_size_ = block_size;
  with_crc_ = with_crc;
}

void SdoBlockReceiver::sum() {
  check_invariant(taken_ <= block_size_);
  if (!with_crc_ || memory_ == nullptr) return;
  check_invariant(summed_ <= written_);
  crc_ = crc16({memory_ + summed_, written_ - summed_}, crc_);
  summed_ = written_;
}

}  // namespace canvoy
