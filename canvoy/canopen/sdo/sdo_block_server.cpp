#include "canvoy/canopen/sdo/sdo_block_server.hpp"

namespace canvoy {

constexpr ServiceHandlers SdoBlockServer::service_calls = {
    .tx_ready = method<&SdoBlockServer::send_segments>};

inline bool SdoBlockServer::in(Phase phase) const {
  return server_.state_ == SdoServer::State::block && phase_ == phase;
}

/// While segments are expected, nearly every first byte is one: a new request cannot be
/// distinguished from them, but an abort can.
void SdoBlockServer::receive(const Frame& frame) {
  const sdo::Message request(frame);
  if (in(Phase::download_segments) && request.first_byte() != sdo::command(sdo::Request::abort)) {
    return download_segment(request);
  }
  if (in(Phase::download_end) && request == last_) return take_copy_of_last_segment();
  switch (request.request()) {
    case sdo::Request::block_download:
      return receive_download(request);
    case sdo::Request::block_upload:
      return receive_upload(request);
    case sdo::Request::initiate_download:
    case sdo::Request::initiate_upload:
    case sdo::Request::abort:
      return server_.serve(frame);
    default:
      return server_.refuse_service(request);
  }
}

/// A copy of the last request is not refused either; it may come when its transfer is over.
void SdoBlockServer::refuse(sdo::Message request) {
  if (request != last_) server_.refuse_service(request);
}

inline void SdoBlockServer::go_on(Phase phase) {
  server_.state_ = SdoServer::State::block;
  phase_ = phase;
  prodded_ = may_be_over_ = false;
  const std::uint32_t whole = server_.time_out_;
  server_.await_client(phase == Phase::download_segments ? whole / 2 : whole);
}

/// The client may be waiting as well, if the end of a block was lost. If nothing of a block has
/// arrived, the acknowledgement before may have been lost: a repeated one may bring the block
/// before for the second time, which only an announced size is sure to reveal.
bool SdoBlockServer::expired() {
  if (may_be_over_) {
    end_download(last_);
    return true;
  }
  if (phase_ != Phase::download_segments || std::exchange(prodded_, true)) return false;
  const bool may_ask = receiver_.has_some() || server_.entry_.announced();
  server_.await_client(server_.time_out_ / 2);
  if (may_ask) {
    server_.reply(
        receiver_.acknowledge(sdo::command(sdo::Response::block_download, sdo::block_acknowledge)));
  }
  return true;
}

void SdoBlockServer::receive_download(sdo::Message request) {
  if (!request.is_block_end()) return initiate_download(request);
  if (in(Phase::download_end)) return end_download(request);
  refuse(request);
}

void SdoBlockServer::initiate_download(sdo::Message request) {
  if (!server_.find(request)) return;
  const auto size = request.has_block_size() ? std::optional(request.value()) : std::nullopt;
  if (!server_.opened(server_.entry_.open_write(size))) return;
  receiver_.begin(block_size_, request.has_block_crc(), server_.entry_.gathered());
  if (!is_small_machine && server_.entry_.gather()) receiver_.gather();
  last_ = request;
  go_on(Phase::download_segments);
  const unsigned flags = sdo::block_initiate | sdo::block_crc;
  server_.reply(sdo::Message(sdo::command(sdo::Response::block_download, flags),
                             server_.multiplexer_, block_size_));
}

inline void SdoBlockServer::download_segment(sdo::Message segment) {
  if constexpr (sdo::has_short_way) {
    const bool plain = receiver_.is_plain(segment);
    if (std::uint8_t* room = plain ? server_.entry_.room_for_segment() : nullptr) {
      segment.store_full_segment(room);
      receiver_.count_plain(segment);
      prodded_ = false;
      return server_.await_client(server_.time_out_ / 2);
    }
  }
  if (segment == last_ && !receiver_.is_next(segment)) return;  // a copy
  const auto step = receiver_.take(
      segment, [this](std::span<const std::uint8_t> bytes) { return server_.entry_.write(bytes); });
  if (!in(Phase::download_segments)) return;  // the domain has stopped the node
  if (step.abort != AbortCode::none) return server_.abort(step.abort);
  go_on(Phase::download_segments);
  if (!step.acknowledge) return;
  last_ = segment;
  acknowledge();
}

/// False if the domain has refused, or has stopped the node.
inline bool SdoBlockServer::has_passed_on() {
  if constexpr (is_small_machine) return true;
  const AbortCode answer = server_.entry_.flush();
  if (!in(Phase::download_segments)) return false;
  if (answer != AbortCode::none) server_.abort(answer);
  return answer == AbortCode::none;
}

void SdoBlockServer::acknowledge() {
  if (!has_passed_on()) return;
  if (receiver_.ended()) go_on(Phase::download_end);
  server_.reply(
      receiver_.acknowledge(sdo::command(sdo::Response::block_download, sdo::block_acknowledge)));
}

/// It may look like the end: then checksum and size decide, or whether another end follows.
void SdoBlockServer::take_copy_of_last_segment() {
  if (!last_.looks_like_block_end() || !receiver_.is_right(last_)) return;
  const SdoEntry& entry = server_.entry_;
  if (entry.announced()) {
    if (entry.left() == sdo::segment_max - last_.block_unused()) end_download(last_);
    return;
  }
  may_be_over_ = true;
  server_.await_client(server_.time_out_ / 4);
}

void SdoBlockServer::end_download(sdo::Message request) {
  last_ = request;
  AbortCode answer = receiver_.finish(
      request, [this](std::span<const std::uint8_t> bytes) { return server_.entry_.write(bytes); });
  if (answer == AbortCode::none) answer = server_.entry_.flush();
  if (!in(Phase::download_end)) return;
  if (answer != AbortCode::none) return server_.abort(answer);
  server_.state_ = SdoServer::State::idle;
  server_.confirm(server_.entry_.finish(),
                  sdo::command(sdo::Response::block_download, sdo::block_end));
}

void SdoBlockServer::receive_upload(sdo::Message request) {
  switch (request.block_command()) {
    case sdo::block_initiate:
      return initiate_upload(request);
    case sdo::block_start:
      if (!in(Phase::upload_start)) break;
      return start_upload(request);
    case sdo::block_acknowledge:
      if (in(Phase::upload_acknowledgement)) return upload_acknowledged(request);
      if (in(Phase::upload_start) && request.acknowledged() == 0) return start_upload(request);
      if (in(Phase::upload_end)) return;  // a copy of the last one
      break;
    default:
      if (!in(Phase::upload_end)) break;
      last_ = request;
      server_.state_ = SdoServer::State::idle;
      return;
  }
  refuse(request);
}

/// A value that is short enough for the client goes without blocks.
void SdoBlockServer::initiate_upload(sdo::Message request) {
  if (!server_.find(request)) return;
  if (!is_block_size(request.block_size())) return server_.abort(AbortCode::block_size);
  SdoEntry& entry = server_.entry_;
  if (!server_.opened(entry.open_read())) return;
  const std::optional<std::uint32_t> size = entry.size();
  if (size && request.switch_threshold() != 0 && *size <= request.switch_threshold()) {
    return server_.begin_upload();
  }
  if (!server_.opened(entry.keep())) return;
  sender_.begin(request.block_size(), request.has_block_crc(), entry.value());
  go_on(Phase::upload_start);
  const unsigned flags = sdo::block_crc | (size ? sdo::block_size_indicated : 0U);
  server_.reply(sdo::Message(sdo::command(sdo::Response::block_upload, flags), server_.multiplexer_,
                             size.value_or(0)));
}

/// Also if its command was lost, and the client asks again without having received anything.
void SdoBlockServer::start_upload(sdo::Message request) {
  last_ = request;
  go_on(Phase::upload_acknowledgement);
  send_segments();
}

void SdoBlockServer::upload_acknowledged(sdo::Message request) {
  if (sender_.is_stale(request, request == last_)) return;
  last_ = request;
  const AbortCode answer = sender_.acknowledge(request);
  if (answer != AbortCode::none) return server_.abort(answer);
  if (!sender_.done()) {
    server_.entry_.seek(sender_.position());
    go_on(Phase::upload_acknowledgement);
    return send_segments();
  }
  go_on(Phase::upload_end);
  const std::uint16_t crc = sender_.crc();
  server_.reply(sdo::Message(sdo::command(sdo::Response::block_upload, sender_.end_flags()),
                             static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)));
}

/// The client may answer while a segment is being sent: nothing is kept from one to the next.
void SdoBlockServer::send_segments() {
  if (!can_send()) return;
  go_on(Phase::upload_acknowledgement);
  while (can_send()) send_segment();
}

inline bool SdoBlockServer::can_send() const {
  return in(Phase::upload_acknowledgement) && sender_.has_segments() &&
         server_.node_.transmitter().idle();
}

inline void SdoBlockServer::send_segment() {
  if constexpr (sdo::has_short_way) {
    if (const std::uint8_t* segment = server_.entry_.next_full_segment()) {
      return server_.reply(sender_.full_segment(segment));
    }
  }
  send_any_segment();
}

void SdoBlockServer::send_any_segment() {
  std::array<std::uint8_t, sdo::segment_max> memory;
  const auto bytes = server_.entry_.next(memory);
  if (!in(Phase::upload_acknowledgement)) return;
  if (!bytes) return server_.abort(bytes.abort());
  server_.reply(sender_.segment(*bytes, server_.entry_.ended()));
}

}  // namespace canvoy
