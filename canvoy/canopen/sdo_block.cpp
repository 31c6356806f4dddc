#include "canvoy/canopen/sdo_block.hpp"

namespace canvoy {

void SdoBlockSender::begin(std::uint8_t block_size, bool with_crc) {
  *this = {};
  block_size_ = block_size;
  with_crc_ = with_crc;
}

AbortCode SdoBlockSender::acknowledge(sdo::Message acknowledgement) {
  const std::uint8_t arrived = acknowledgement.acknowledged();
  if (arrived > sent_) return AbortCode::sequence_number;
  done_ = ended_ && arrived == sent_;
  if (done_) return AbortCode::none;
  if (!is_block_size(acknowledgement.next_block_size())) return AbortCode::block_size;
  futile_ = arrived == 0 ? static_cast<std::uint8_t>(futile_ + 1) : std::uint8_t{0};
  if (futile_ > futile_max) return AbortCode::sequence_number;
  block_size_ = acknowledgement.next_block_size();
  begin_ += arrived * static_cast<std::uint32_t>(sdo::segment_max);
  position_ = begin_;
  sent_ = 0;
  ended_ = false;
  return AbortCode::none;
}

void SdoBlockReceiver::begin(std::uint8_t block_size, bool with_crc) {
  *this = {};
  block_size_ = block_size;
  with_crc_ = with_crc;
}

}  // namespace canvoy
