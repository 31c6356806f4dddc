#include "canvoy/decoder/sdo_follower.hpp"

#include <algorithm>

namespace canvoy::decoder {

SdoStep SdoFollower::request(const Frame& frame) {
  const sdo::Message message(frame);
  if (message.first_byte() == sdo::command(sdo::Request::abort)) return abort();
  if (is_in(Phase::block, true)) return take_block_segment(message);
  switch (message.request()) {
    case sdo::Request::initiate_download:
      initiate_download(message);
      return {SdoMessage::write};
    case sdo::Request::download_segment:
      if (is_in(Phase::segments, true)) take_segment(message);
      return {SdoMessage::write_segment};
    case sdo::Request::initiate_upload:
      begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
      return {SdoMessage::read};
    case sdo::Request::upload_segment:
      return {SdoMessage::read_segment};
    case sdo::Request::block_upload:
      return block_upload_request(message);
    case sdo::Request::block_download:
      return block_download_request(message);
    case sdo::Request::abort:
      return abort();
  }
  return {};
}

SdoStep SdoFollower::response(const Frame& frame) {
  const sdo::Message message(frame);
  if (message.first_byte() == sdo::command(sdo::Response::abort)) return abort();
  if (is_in(Phase::block, false)) return take_block_segment(message);
  switch (message.response()) {
    case sdo::Response::initiate_upload:
      return initiate_upload(message);
    case sdo::Response::upload_segment:
      return upload_segment_response(message);
    case sdo::Response::initiate_download:
      return initiate_download_response(message);
    case sdo::Response::download_segment:
      return {SdoMessage::segment_written,
              is_in(Phase::segments, true) && last_ ? finish() : nullptr};
    case sdo::Response::block_upload:
      return block_upload_response(message);
    case sdo::Response::block_download:
      return block_download_response(message);
    case sdo::Response::abort:
      return abort();
  }
  return {};
}

SdoStep SdoFollower::abort() {
  phase_ = Phase::idle;
  return {SdoMessage::abort};
}

void SdoFollower::begin(bool is_write, SdoTransfer::Kind kind, sdo::Multiplexer multiplexer) {
  transfer_.is_write = is_write;
  transfer_.kind = kind;
  transfer_.index = multiplexer.index();
  transfer_.sub = multiplexer.sub();
  transfer_.bytes.clear();
  transfer_.size = 0;
  phase_ = Phase::asked;
  is_named_ = true;
  last_ = false;
  sequence_ = 0;
}

const SdoTransfer* SdoFollower::finish() {
  phase_ = Phase::idle;
  return is_named_ ? &transfer_ : nullptr;
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
SdoStep SdoFollower::initiate_upload(const sdo::Message& message) {
  begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
  if (message.is_expedited()) {
    const auto bytes = message.bytes();
    const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
    take(std::span(bytes).subspan(4, size));
    return {SdoMessage::value, finish()};
  }
  transfer_.kind = SdoTransfer::Kind::segmented;
  phase_ = Phase::segments;
  return {SdoMessage::value};
}

SdoStep SdoFollower::initiate_download_response(const sdo::Message& message) {
  const bool confirms = is_in(Phase::asked, true) &&
                        transfer_.kind == SdoTransfer::Kind::expedited &&
                        message.multiplexer() == sdo::Multiplexer(transfer_.index, transfer_.sub);
  return {SdoMessage::written, confirms ? finish() : nullptr};
}

SdoStep SdoFollower::upload_segment_response(const sdo::Message& message) {
  if (!is_in(Phase::segments, false)) return {SdoMessage::segment};
  take_segment(message);
  return {SdoMessage::segment, last_ ? finish() : nullptr};
}

void SdoFollower::take_segment(const sdo::Message& message) {
  const auto bytes = message.bytes();
  take(std::span(bytes).subspan(1, message.segment_size()));
  last_ = message.is_last();
}

// Block

SdoStep SdoFollower::take_block_segment(const sdo::Message& message) {
  // What does not come in order is sent again.
  if (message.sequence_number() == sequence_ + 1U) {
    ++sequence_;
    const auto bytes = message.bytes();
    take(std::span(bytes).subspan(1));
    last_ = message.is_block_last();
  }
  return {SdoMessage::block_segment};
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

SdoStep SdoFollower::block_upload_request(const sdo::Message& message) {
  switch (message.block_command()) {
    case sdo::block_initiate:
      begin(false, SdoTransfer::Kind::block, message.multiplexer());
      return {SdoMessage::block_upload};
    case sdo::block_start:
      start_block_upload();
      return {SdoMessage::block_upload_start};
    case sdo::block_acknowledge:
      if (is_in(Phase::block, false)) acknowledge_block(message);
      return {SdoMessage::block_upload_got};
    default:
      return {SdoMessage::block_upload_done, is_in(Phase::block_end, false) ? finish() : nullptr};
  }
}

/// Who began to listen here does not know of what the segments are.
void SdoFollower::start_block_upload() {
  const bool was_asked = is_in(Phase::asked, false) && transfer_.kind == SdoTransfer::Kind::block;
  if (!was_asked) {
    begin(false, SdoTransfer::Kind::block, {});
    is_named_ = false;
  }
  phase_ = Phase::block;
}

SdoStep SdoFollower::block_upload_response(const sdo::Message& message) {
  if (!message.is_block_end()) return {SdoMessage::block_upload_ready};
  if (is_in(Phase::block_end, false)) end_block(message);
  return {SdoMessage::block_upload_end};
}

SdoStep SdoFollower::block_download_request(const sdo::Message& message) {
  if (!message.is_block_end()) {
    begin(true, SdoTransfer::Kind::block, message.multiplexer());
    return {SdoMessage::block_download};
  }
  if (is_in(Phase::block_end, true)) end_block(message);
  return {SdoMessage::block_download_end};
}

SdoStep SdoFollower::block_download_response(const sdo::Message& message) {
  switch (message.block_command()) {
    case sdo::block_initiate:
      // Who began to listen after the request knows what it was from the answer.
      begin(true, SdoTransfer::Kind::block, message.multiplexer());
      phase_ = Phase::block;
      return {SdoMessage::block_download_ready};
    case sdo::block_acknowledge:
      if (is_in(Phase::block, true)) acknowledge_block(message);
      return {SdoMessage::block_download_got};
    case sdo::block_end:
      return {SdoMessage::block_download_done, is_in(Phase::block_end, true) ? finish() : nullptr};
    default:
      return {};
  }
}

}  // namespace canvoy::decoder
