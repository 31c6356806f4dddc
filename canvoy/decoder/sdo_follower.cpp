#include "canvoy/decoder/sdo_follower.hpp"

#include <algorithm>

namespace canvoy::decoder {

const SdoTransfer* SdoFollower::request(const Frame& frame) {
  const sdo::Message message(frame);
  const bool is_abort = message.first_byte() == sdo::command(sdo::Request::abort);
  if (is_abort) {
    phase_ = Phase::idle;
    return nullptr;
  }
  if (is_in(Phase::block, true)) {
    take_block_segment(message);
    return nullptr;
  }
  switch (message.request()) {
    case sdo::Request::initiate_download:
      initiate_download(message);
      break;
    case sdo::Request::download_segment:
      if (is_in(Phase::segments, true)) take_segment(message);
      break;
    case sdo::Request::initiate_upload:
      begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
      break;
    case sdo::Request::block_upload:
      return block_upload_request(message);
    case sdo::Request::block_download:
      block_download_request(message);
      break;
    case sdo::Request::upload_segment:
    case sdo::Request::abort:
      break;
  }
  return nullptr;
}

const SdoTransfer* SdoFollower::response(const Frame& frame) {
  const sdo::Message message(frame);
  if (message.first_byte() == sdo::command(sdo::Response::abort)) {
    phase_ = Phase::idle;
    return nullptr;
  }
  if (is_in(Phase::block, false)) {
    take_block_segment(message);
    return nullptr;
  }
  switch (message.response()) {
    case sdo::Response::initiate_upload:
      return initiate_upload(message);
    case sdo::Response::upload_segment:
      if (!is_in(Phase::segments, false)) return nullptr;
      take_segment(message);
      return last_ ? finish() : nullptr;
    case sdo::Response::initiate_download: {
      const bool confirms =
          is_in(Phase::asked, true) && transfer_.kind == SdoTransfer::Kind::expedited &&
          message.multiplexer() == sdo::Multiplexer(transfer_.index, transfer_.sub);
      return confirms ? finish() : nullptr;
    }
    case sdo::Response::download_segment:
      return is_in(Phase::segments, true) && last_ ? finish() : nullptr;
    case sdo::Response::block_upload:
      if (message.is_block_end() && is_in(Phase::block_end, false)) end_block(message);
      return nullptr;
    case sdo::Response::block_download:
      return block_download_response(message);
    case sdo::Response::abort:
      break;
  }
  return nullptr;
}

void SdoFollower::begin(bool is_write, SdoTransfer::Kind kind, sdo::Multiplexer multiplexer) {
  transfer_.is_write = is_write;
  transfer_.kind = kind;
  transfer_.index = multiplexer.index();
  transfer_.sub = multiplexer.sub();
  transfer_.bytes.clear();
  transfer_.size = 0;
  phase_ = Phase::asked;
  last_ = false;
  sequence_ = 0;
}

const SdoTransfer* SdoFollower::finish() {
  phase_ = Phase::idle;
  return &transfer_;
}

void SdoFollower::take(std::span<const std::uint8_t> bytes) {
  const std::size_t room = bytes_max - std::min(bytes_max, transfer_.bytes.size());
  const auto kept = bytes.first(std::min(room, bytes.size()));
  transfer_.bytes.insert(transfer_.bytes.end(), kept.begin(), kept.end());
  transfer_.size += bytes.size();
}

// Expedited and segmented

void SdoFollower::initiate_download(const sdo::Message& message) {
  begin(true, SdoTransfer::Kind::expedited, message.multiplexer());
  if (message.is_expedited()) {
    const auto bytes = message.bytes();
    const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
    return take(std::span(bytes).subspan(4, size));
  }
  transfer_.kind = SdoTransfer::Kind::segmented;
  phase_ = Phase::segments;
}

/// Who began to listen after the request knows what it was from the answer.
const SdoTransfer* SdoFollower::initiate_upload(const sdo::Message& message) {
  begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
  if (message.is_expedited()) {
    const auto bytes = message.bytes();
    const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
    take(std::span(bytes).subspan(4, size));
    return finish();
  }
  transfer_.kind = SdoTransfer::Kind::segmented;
  phase_ = Phase::segments;
  return nullptr;
}

void SdoFollower::take_segment(const sdo::Message& message) {
  const auto bytes = message.bytes();
  take(std::span(bytes).subspan(1, message.segment_size()));
  last_ = message.is_last();
}

// Block

void SdoFollower::take_block_segment(const sdo::Message& message) {
  // What does not come in order is sent again.
  if (message.sequence_number() != sequence_ + 1U) return;
  ++sequence_;
  const auto bytes = message.bytes();
  take(std::span(bytes).subspan(1));
  last_ = message.is_block_last();
}

void SdoFollower::acknowledge_block(const sdo::Message& message) {
  const unsigned got = std::min<unsigned>(message.acknowledged(), sequence_);
  const std::size_t again = (sequence_ - got) * sdo::segment_max;
  transfer_.size -= again;
  transfer_.bytes.resize(std::min(transfer_.bytes.size(), transfer_.size));
  if (last_ && again == 0) phase_ = Phase::block_end;
  if (again != 0) last_ = false;
  sequence_ = 0;
}

void SdoFollower::end_block(const sdo::Message& message) {
  transfer_.size -= std::min(transfer_.size, message.block_unused());
  transfer_.bytes.resize(std::min(transfer_.bytes.size(), transfer_.size));
}

const SdoTransfer* SdoFollower::block_upload_request(const sdo::Message& message) {
  switch (message.block_command()) {
    case sdo::block_initiate:
      begin(false, SdoTransfer::Kind::block, message.multiplexer());
      break;
    case sdo::block_start:
      if (is_in(Phase::asked, false) && transfer_.kind == SdoTransfer::Kind::block) {
        phase_ = Phase::block;
      }
      break;
    case sdo::block_acknowledge:
      if (is_in(Phase::block, false)) acknowledge_block(message);
      break;
    default:
      return is_in(Phase::block_end, false) ? finish() : nullptr;
  }
  return nullptr;
}

void SdoFollower::block_download_request(const sdo::Message& message) {
  if (!message.is_block_end()) {
    return begin(true, SdoTransfer::Kind::block, message.multiplexer());
  }
  if (is_in(Phase::block_end, true)) end_block(message);
}

const SdoTransfer* SdoFollower::block_download_response(const sdo::Message& message) {
  switch (message.block_command()) {
    case sdo::block_initiate: {
      const bool begins = is_in(Phase::asked, true) && transfer_.kind == SdoTransfer::Kind::block;
      if (begins) phase_ = Phase::block;
      return nullptr;
    }
    case sdo::block_acknowledge:
      if (is_in(Phase::block, true)) acknowledge_block(message);
      return nullptr;
    default:
      return is_in(Phase::block_end, true) ? finish() : nullptr;
  }
}

}  // namespace canvoy::decoder
