#include "canvoy/canopen/sdo/sdo_block_client.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

constexpr ServiceHandlers SdoBlockClient::service_calls = {
    .tx_ready = method<&SdoBlockClient::send_segments>};

SdoBlockClient::SdoBlockClient(SdoClient& client, std::span<std::uint8_t> buffer,
                               std::uint8_t block_size)
    : client_(client),
      buffer_(buffer),
      block_size_(is_block_size(block_size) ? block_size : sdo::block_size_max) {
  extension_.initiate_upload = Callback<bool()>::to<&SdoBlockClient::initiate_upload>(*this);
  extension_.initiate_download = Callback<bool()>::to<&SdoBlockClient::initiate_download>(*this);
  extension_.receive = Callback<void(const Frame&)>::to<&SdoBlockClient::receive>(*this);
  extension_.expired = Callback<bool()>::to<&SdoBlockClient::expired>(*this);
  client_.extension_ = &extension_;
  client_.node_.attach(service_);
}

inline bool SdoBlockClient::in(Phase phase) const {
  return client_.state_ == SdoClient::State::block && phase_ == phase;
}

bool SdoBlockClient::wanted(bool is_long) const {
  if (client_.transfer_ != SdoTransfer::automatic) return client_.transfer_ == SdoTransfer::block;
  return is_long && !refused_[client_.connected_to_];
}

inline void SdoBlockClient::go_on(Phase phase) {
  client_.state_ = SdoClient::State::block;
  phase_ = phase;
  prodded_ = may_be_over_ = false;
  const Duration whole = client_.time_out_;
  client_.watchdog_.restart(client_.node_.now() +
                            (phase == Phase::upload_segments ? whole / 2 : whole));
}

inline void SdoBlockClient::ask(Phase phase, sdo::Message message) {
  go_on(phase);
  client_.send(message);
}

/// The server may be waiting as well, if the end of a block was lost. If nothing of a block has
/// arrived, the acknowledgement before may have been lost: a repeated one may bring the block
/// before for the second time, which only an announced size is sure to reveal.
bool SdoBlockClient::expired() {
  if (may_be_over_) {
    end_upload(last_);
    return true;
  }
  if (phase_ != Phase::upload_segments || prodded_) return false;
  if (receiver_.has_some() || client_.announced_) acknowledge();
  prodded_ = true;
  client_.watchdog_.restart(client_.node_.now() + client_.time_out_ / 2);
  return true;
}

void SdoBlockClient::receive(const Frame& frame) {
  const sdo::Message answer(frame);
  if (phase_ == Phase::upload_segments) {
    if (answer.first_byte() != sdo::command(sdo::Response::abort)) return upload_segment(answer);
  }
  if (phase_ == Phase::upload_end && answer == last_) return take_copy_of_last_segment();
  if (answer.response() == sdo::Response::abort) return aborted_by_server(answer);
  if (phase_ == Phase::upload_initiated) return upload_initiated(answer);
  if (phase_ == Phase::download_initiated) return download_initiated(answer);
  receive_message(answer);
}

void SdoBlockClient::receive_message(sdo::Message answer) {
  if (answer.response() == sdo::Response::block_upload && answer.is_block_end()) {
    if (phase_ == Phase::upload_end) return end_upload(answer);
  }
  if (answer.response() == sdo::Response::block_download) {
    const unsigned command = answer.block_command();
    if (command == sdo::block_acknowledge) {
      if (phase_ == Phase::download_acknowledgement) return download_acknowledged(answer);
      if (phase_ == Phase::download_end) return;  // a copy of the last one
    }
    if (command == sdo::block_end && phase_ == Phase::download_end) {
      return client_.finish(client_.transferred_);
    }
  }
  if (answer != last_) client_.fail(AbortCode::command_specifier);
}

/// A server without block transfers answers with the abort code for unknown commands.
void SdoBlockClient::aborted_by_server(sdo::Message answer) {
  const bool initiated = phase_ == Phase::upload_initiated || phase_ == Phase::download_initiated;
  if (!initiated) return client_.aborted_by_server(answer);
  if (answer.multiplexer() != client_.multiplexer_) return;
  if (answer.abort_code() != AbortCode::command_specifier ||
      client_.transfer_ != SdoTransfer::automatic) {
    return client_.aborted_by_server(answer);
  }
  refused_[client_.connected_to_] = true;
  phase_ == Phase::upload_initiated ? client_.begin_upload() : client_.begin_download();
}

/// No protocol switch threshold is sent: some servers take it for a part of the block size.
bool SdoBlockClient::initiate_upload() {
  const bool is_long = client_.sink_ || client_.destination_.size() > segmented_max;
  if (!wanted(is_long)) return false;
  ask(Phase::upload_initiated,
      sdo::Message(sdo::command(sdo::Request::block_upload, sdo::block_initiate | sdo::block_crc),
                   client_.multiplexer_, block_size_));
  return true;
}

/// A server that continues without blocks considers the value short enough for that.
void SdoBlockClient::upload_initiated(sdo::Message answer) {
  if (answer.multiplexer() != client_.multiplexer_) return;
  if (answer.response() == sdo::Response::initiate_upload) {
    client_.state_ = SdoClient::State::upload_initiated;
    return client_.upload_initiated(answer);
  }
  if (answer.response() != sdo::Response::block_upload || answer.is_block_end()) return;
  if (answer.has_block_size()) client_.announced_ = answer.value();
  if (!client_.sink_ && client_.announced_ > client_.destination_.size()) {
    return client_.fail(AbortCode::out_of_memory);
  }
  client_.expect_bytes();
  receiver_.begin(block_size_, answer.has_block_crc(), client_.destination_.data());
  last_ = answer;
  ask(Phase::upload_segments,
      sdo::Message(sdo::command(sdo::Request::block_upload, sdo::block_start)));
}

inline void SdoBlockClient::upload_segment(sdo::Message segment) {
  if constexpr (sdo::has_short_way) {
    const bool plain = receiver_.is_plain(segment);
    if (std::uint8_t* room = plain ? client_.room_for_segment() : nullptr) {
      segment.store_full_segment(room);
      receiver_.count_plain(segment);
      return go_on(Phase::upload_segments);
    }
  }
  if (segment == last_ && !receiver_.is_next(segment)) return;  // a copy
  const std::uint8_t before = client_.ended_;
  const auto step = receiver_.take(
      segment, [this](std::span<const std::uint8_t> bytes) { return client_.take(bytes); });
  if (client_.ended_ != before) return;
  if (step.abort != AbortCode::none) return client_.fail(step.abort);
  if (!step.acknowledge) return go_on(Phase::upload_segments);
  last_ = segment;
  acknowledge();
}

void SdoBlockClient::acknowledge() {
  ask(receiver_.ended() ? Phase::upload_end : Phase::upload_segments,
      receiver_.acknowledge(sdo::command(sdo::Request::block_upload, sdo::block_acknowledge)));
}

/// It may look like the end: then checksum and size decide, or whether another end follows.
void SdoBlockClient::take_copy_of_last_segment() {
  if (!last_.looks_like_block_end() || !receiver_.is_right(last_)) return;
  if (client_.announced_) {
    const std::size_t end = client_.transferred_ + sdo::segment_max - last_.block_unused();
    if (end == *client_.announced_) end_upload(last_);
    return;
  }
  may_be_over_ = true;
  client_.watchdog_.restart(client_.node_.now() + client_.time_out_ / 4);
}

void SdoBlockClient::end_upload(sdo::Message answer) {
  const std::uint8_t before = client_.ended_;
  AbortCode code = receiver_.finish(
      answer, [this](std::span<const std::uint8_t> bytes) { return client_.take(bytes); });
  if (client_.ended_ != before) return;
  if (code == AbortCode::none && client_.announced_ > client_.transferred_) {
    code = AbortCode::length_too_low;
  }
  if (code != AbortCode::none) return client_.fail(code);
  client_.finish_with(sdo::Message(sdo::command(sdo::Request::block_upload, sdo::block_end)),
                      client_.transferred_);
}

bool SdoBlockClient::initiate_download() {
  const bool is_long = client_.announced_.value_or(UINT32_MAX) > segmented_max;
  const bool can_go_back = !client_.supply_ || buffer_.size() >= buffer_size;
  if (!can_go_back || !wanted(is_long)) return false;
  client_.nothing_follows_ = false;
  const unsigned flags =
      sdo::block_initiate | sdo::block_crc | (client_.announced_ ? sdo::block_size_indicated : 0U);
  ask(Phase::download_initiated,
      sdo::Message(sdo::command(sdo::Request::block_download, flags), client_.multiplexer_,
                   client_.announced_.value_or(0)));
  return true;
}

void SdoBlockClient::download_initiated(sdo::Message answer) {
  if (answer.multiplexer() != client_.multiplexer_) return;
  if (answer.response() != sdo::Response::block_download ||
      answer.block_command() != sdo::block_initiate) {
    return;
  }
  if (!is_block_size(answer.block_size())) return client_.fail(AbortCode::block_size);
  sender_.begin(answer.block_size(), answer.has_block_crc(), client_.value_.data());
  block_begin_ = 0;
  last_ = answer;
  go_on(Phase::download_acknowledgement);
  send_segments();
}

/// The server may answer while a segment is being sent: nothing is kept from one to the next.
void SdoBlockClient::send_segments() {
  if (!can_send()) return;
  go_on(Phase::download_acknowledgement);
  while (can_send()) send_segment();
}

inline bool SdoBlockClient::can_send() const {
  return in(Phase::download_acknowledgement) && sender_.has_segments() &&
         client_.node_.transmitter().idle();
}

inline void SdoBlockClient::send_segment() {
  if constexpr (sdo::has_short_way) {
    if (const std::uint8_t* segment = client_.next_full_segment()) {
      return client_.send(sender_.full_segment(segment));
    }
  }
  std::array<std::uint8_t, sdo::segment_max> memory;
  const std::uint8_t before = client_.ended_;
  const auto bytes = client_.supply_ ? fetch(memory) : client_.give(memory);
  if (client_.ended_ != before) return;
  if (!bytes) return client_.fail(bytes.abort());
  const bool reached = sender_.position() + bytes->size() == client_.transferred_;
  client_.send(sender_.segment(*bytes, reached && client_.nothing_follows_));
}

/// Lost data of a supply comes from the buffer again.
Result<std::span<const std::uint8_t>> SdoBlockClient::fetch(std::span<std::uint8_t> memory) {
  check_invariant(sender_.position() - block_begin_ <= buffer_.size());
  const auto place = buffer_.subspan(sender_.position() - block_begin_);
  const std::size_t kept = client_.transferred_ - sender_.position();
  if (kept != 0 || client_.nothing_follows_) {
    return std::span<const std::uint8_t>(place.first(std::min(kept, memory.size())));
  }
  const auto bytes = client_.give(memory);
  if (bytes) std::ranges::copy(*bytes, place.begin());
  return bytes;
}

void SdoBlockClient::download_acknowledged(sdo::Message answer) {
  if (sender_.is_stale(answer, answer == last_)) return;
  last_ = answer;
  const AbortCode code = sender_.acknowledge(answer);
  if (code != AbortCode::none) return client_.fail(code);
  if (!sender_.done()) {
    go_back(sender_.position());
    go_on(Phase::download_acknowledgement);
    return send_segments();
  }
  const std::uint16_t crc = sender_.crc();
  ask(Phase::download_end,
      sdo::Message(sdo::command(sdo::Request::block_download, sender_.end_flags()),
                   static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)));
}

/// Goes to the beginning of a block: earlier data is not needed any more.
void SdoBlockClient::go_back(std::uint32_t block) {
  if (client_.supply_) {
    const auto kept = buffer_.first(client_.transferred_ - block_begin_);
    std::ranges::copy(kept.subspan(block - block_begin_), buffer_.begin());
    block_begin_ = block;
  } else {
    client_.transferred_ = block;
  }
}

}  // namespace canvoy
