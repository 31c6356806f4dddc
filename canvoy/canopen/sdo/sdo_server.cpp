#include "canvoy/canopen/sdo/sdo_server.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

// On a host each request has a function of its own, so that choosing it needs no place on the
// stack. A small machine has all of them in one.
#ifdef CANVOY_SMALL_MACHINE
#define CANVOY_HANDLER inline
#else
#define CANVOY_HANDLER [[gnu::noinline]]
#endif

namespace canvoy {

namespace {

/// True for the first message of a block transfer, which contains its multiplexer.
bool initiates_block(sdo::Message request) {
  if (request.request() == sdo::Request::block_upload) return (request.first_byte() & 0x03) == 0;
  return request.request() == sdo::Request::block_download && (request.first_byte() & 0x01) == 0;
}

}  // namespace

void SdoServer::on_event(NodeService& service, ServiceEvent& event) {
  SdoServer& self = static_cast<SdoServer&>(service);
  if (event.kind == ServiceEvent::state_entered) self.follow_default_channel(event.state());
  if (event.kind == ServiceEvent::frame_came) self.receive(event.frame(), self.node_.now());
}

void SdoServer::on_object_event(NodeService& service, ServiceEvent& event) {
  SdoServer& self = static_cast<SdoServer&>(service);
  switch (event.kind) {
    case ServiceEvent::state_entered:
      return self.follow_object_in(event.state());
    case ServiceEvent::before_write:
      return event.refuse(self.check(event.entry(), event.value()));
    case ServiceEvent::after_write:
      return self.follow_object_in(self.node_.state());
    case ServiceEvent::frame_came:
      return self.receive(event.frame(), self.node_.now());
    default:
      return;
  }
}

inline void SdoServer::follow_default_channel(NmtState state) {
  listen(has_services(state) ? default_sdo_channel(node_.id()) : SdoChannel{});
}

void SdoServer::follow_object_in(NmtState state) {
  const auto index = static_cast<std::uint16_t>(sdo_server_parameter + number_);
  listen(has_services(state) ? sdo_channel(node_.dictionary(), index) : SdoChannel{});
}

/// A channel that is confirmed as valid must receive.
inline AbortCode SdoServer::check(const Entry& entry, std::span<const std::uint8_t> value) const {
  if (entry.index != sdo_server_parameter + number_) return AbortCode::none;
  const AbortCode answer = check_sdo_parameter(entry, value);
  if (answer != AbortCode::none || value.size() != sizeof(std::uint32_t)) return answer;
  const bool needs_route = can_id_ == 0 && CobId{load<std::uint32_t>(value.data())}.valid();
  return needs_route && !node_.router().has_room_to_listen() ? AbortCode::out_of_memory
                                                             : AbortCode::none;
}

[[gnu::always_inline]] inline void SdoServer::listen(SdoChannel wanted) {
  if (wanted.request == can_id_ && (!wanted.valid() || wanted.response == answering_on_)) return;
  drop();
  node_.router().listen<&SdoServer::receive>(*this, can_id_, wanted.request);
  can_id_ = wanted.request;
  if (wanted.valid()) answering_on_ = wanted.response;
}

inline void SdoServer::receive(const Frame& frame, Time) {
  if (frame.length != Frame::length_max) return node_.count_malformed();
  if (state_ == State::block) return extension_->receive(frame);
  serve(frame);
}

void SdoServer::serve(const Frame& frame) {
  const sdo::Message request(frame);
  // For hosts: what values are written with goes past the table of the others.
  if (sdo::has_short_way && request.request() == sdo::Request::initiate_download) {
    return initiate_download(request);
  }
  switch (request.request()) {
    case sdo::Request::initiate_upload:
      return initiate_upload(request);
    case sdo::Request::initiate_download:
      return initiate_download(request);
    case sdo::Request::upload_segment:
      return upload_segment(request);
    case sdo::Request::download_segment:
      return download_segment(request);
    case sdo::Request::abort:
      return end();
    default:
      return serve_further(frame);
  }
}

CANVOY_HANDLER void SdoServer::end() {
  drop();
}

CANVOY_HANDLER void SdoServer::serve_further(const Frame& frame) {
  return extension_ == nullptr ? refuse_service(sdo::Message(frame)) : extension_->receive(frame);
}

/// For hosts what nearly always is the case is in its place.
[[gnu::always_inline]] inline bool SdoServer::goes_on(AbortCode answer) {
  if (!is_small_machine && state_ == State::opening && answer == AbortCode::none) [[likely]] {
    return true;
  }
  return opened(answer);
}

/// A request that begins a transfer, and ends another one.
[[gnu::always_inline]] inline bool SdoServer::find_here(sdo::Message request) {
  if (is_small_machine || busy()) drop();
  multiplexer_ = request.multiplexer();
  state_ = State::opening;
  const AbortCode answer = entry_.find(multiplexer_);
  // The application is not asked: on a host the state is still this one.
  if (!is_small_machine && answer == AbortCode::none) [[likely]]
    return true;
  return opened(answer);
}

bool SdoServer::find(sdo::Message request) {
  return find_here(request);
}

/// A small machine has it once.
[[gnu::always_inline]] inline bool SdoServer::begin_with(sdo::Message request) {
  return is_small_machine ? find(request) : find_here(request);
}

/// True if the transfer continues. The application may have ended it during its callback.
bool SdoServer::opened(AbortCode answer) {
  if (state_ == State::opening && answer == AbortCode::none) return true;
  state_ == State::opening ? abort(answer) : entry_.drop();
  return false;
}

CANVOY_HANDLER void SdoServer::initiate_upload(sdo::Message request) {
  if (begin_with(request) && goes_on(entry_.open_read())) begin_upload();
}

void SdoServer::begin_upload() {
  if (const std::optional<std::uint32_t> value = entry_.expedited()) {
    state_ = State::idle;
    const unsigned flags = sdo::expedited(entry_.size_max());
    return reply(
        sdo::Message(sdo::command(sdo::Response::initiate_upload, flags), multiplexer_, *value));
  }
  if (!opened(entry_.keep())) return;
  begin(State::upload);
  const std::optional<std::uint32_t> size = entry_.size();
  const unsigned flags = size ? sdo::size_indicated : 0U;
  reply(sdo::Message(sdo::command(sdo::Response::initiate_upload, flags), multiplexer_,
                     size.value_or(0)));
}

CANVOY_HANDLER void SdoServer::upload_segment(sdo::Message request) {
  if (state_ != State::upload) return refuse_service(request);
  if (request.toggle() != toggle_) return abort(AbortCode::toggle_bit);
  if constexpr (sdo::has_short_way) {
    if (const std::uint8_t* segment = entry_.next_full_segment()) {
      const sdo::Message message =
          sdo::full_segment_message(sdo::command(sdo::Response::upload_segment, toggle_), segment);
      expect_next_segment();
      return reply(message);
    }
  }
  send_segment();
}

/// The same of a domain that is streamed, straight into the message.
void SdoServer::send_streamed_segment() {
  std::array<std::uint8_t, Frame::length_max> message{};
  const Result<std::size_t> size = entry_.next_streamed(std::span(message).subspan(1));
  if (state_ != State::upload) return;  // the domain has stopped the node
  if (!size) return abort(size.abort());
  check_invariant(*size <= sdo::segment_max);
  const bool last = entry_.ended();
  message[0] = sdo::command(sdo::Response::upload_segment, sdo::segment(toggle_, *size, last));
  last ? drop() : expect_next_segment();
  reply(sdo::Message(message));
}

void SdoServer::send_segment() {
  if (!is_small_machine && entry_.is_streamed()) return send_streamed_segment();
  std::array<std::uint8_t, sdo::segment_max> memory;
  const auto bytes = entry_.next(memory);
  if (state_ != State::upload) return;  // the domain has stopped the node
  if (!bytes) return abort(bytes.abort());
  check_invariant(bytes->size() <= sdo::segment_max);
  const bool last = entry_.ended();
  const unsigned flags = sdo::segment(toggle_, bytes->size(), last);
  last ? drop() : expect_next_segment();
  reply(sdo::segment_message(sdo::command(sdo::Response::upload_segment, flags), *bytes));
}

CANVOY_HANDLER void SdoServer::initiate_download(sdo::Message request) {
  constexpr std::uint8_t confirmation = sdo::command(sdo::Response::initiate_download);
  if (!begin_with(request)) return;
  if (sdo::has_short_way && request.is_expedited() && entry_.row().type != DataType::domain) {
    return write_at_once(request);
  }
  const std::optional<std::uint32_t> size = size_to_come(request);
  std::array<std::uint8_t, sdo::expedited_max> data;
  store(data.data(), request.value());
  const auto bytes = std::span<const std::uint8_t>(data).first(
      request.is_expedited() ? size.value_or(sdo::expedited_max) : 0);
  if (!opened(entry_.open_write(size))) return;
  if (request.is_expedited()) {
    state_ = State::download;
    return write(bytes, true, confirmation);
  }
  begin(State::download);
  reply(sdo::Message(confirmation, multiplexer_));
}

/// For hosts: a value that is no domain, all of it in the request.
[[gnu::always_inline]] inline void SdoServer::write_at_once(sdo::Message request) {
  constexpr std::uint8_t confirmation = sdo::command(sdo::Response::initiate_download);
  std::array<std::uint8_t, sdo::expedited_max> data;
  store(data.data(), request.value());
  const std::size_t size = request.has_size()
                               ? request.expedited_size()
                               : std::min<std::size_t>(sdo::expedited_max, entry_.row().capacity);
  state_ = State::idle;
  const AbortCode answer = entry_.write_whole(std::span<const std::uint8_t>(data).first(size));
  if (answer != AbortCode::none) [[unlikely]]
    return confirm(answer, confirmation);
  send(sdo::Message(confirmation, multiplexer_));
}

/// Number of bytes that the client writes. Without a size it is determined by the entry, and is
/// four for an expedited request.
inline std::optional<std::uint32_t> SdoServer::size_to_come(sdo::Message request) const {
  if (request.is_expedited()) {
    if (request.has_size()) return static_cast<std::uint32_t>(request.expedited_size());
    const bool is_domain = entry_.row().type == DataType::domain;
    const std::size_t room = is_domain ? sdo::expedited_max : entry_.row().capacity;
    return static_cast<std::uint32_t>(std::min(sdo::expedited_max, room));
  }
  return request.has_size() ? std::optional(request.value()) : std::nullopt;
}

CANVOY_HANDLER void SdoServer::download_segment(sdo::Message request) {
  if (state_ != State::download) return refuse_service(request);
  if (request.toggle() != toggle_) return abort(AbortCode::toggle_bit);
  if constexpr (sdo::has_short_way) {
    const bool full = request.first_byte() == toggle_;
    if (std::uint8_t* room = full ? entry_.room_for_segment() : nullptr) {
      request.store_full_segment(room);
      const sdo::Message message(sdo::command(sdo::Response::download_segment, toggle_));
      expect_next_segment();
      return reply(message);
    }
    if (full && entry_.passes_segments_on()) return pass_segment_on(request);
  }
  take_segment(request);
}

/// For hosts: a full segment that is not the last one, to the domain.
void SdoServer::pass_segment_on(sdo::Message request) {
  const auto data = request.bytes();
  const AbortCode answer = entry_.pass_on(std::span(data).subspan<1>());
  if (state_ != State::download) return;  // the domain has stopped the node
  if (answer != AbortCode::none) return abort(answer);
  const sdo::Message message(sdo::command(sdo::Response::download_segment, toggle_));
  expect_next_segment();
  send(message);
}

void SdoServer::take_segment(sdo::Message request) {
  const std::uint8_t confirmation = sdo::command(sdo::Response::download_segment, toggle_);
  const auto data = request.bytes();
  write(std::span(data).subspan(1, request.segment_size()), request.is_last(), confirmation);
}

void SdoServer::write(std::span<const std::uint8_t> bytes, bool last, std::uint8_t confirmation) {
  AbortCode answer = entry_.write(bytes);
  if (state_ != State::download) return;  // the domain has stopped the node
  if (answer != AbortCode::none) return abort(answer);
  if (!last) {
    expect_next_segment();
  } else {
    state_ = State::idle;
    answer = entry_.finish();
  }
  confirm(answer, confirmation);
}

void SdoServer::confirm(AbortCode answer, std::uint8_t confirmation) {
  if (answer == AbortCode::deferred) {
    state_ = State::deferred;
    confirmation_ = confirmation;
    node_.await_deferred(Callback<void(AbortCode)>::to<&SdoServer::finish_deferred>(*this));
  } else if (answer != AbortCode::none) {
    abort(answer);
  } else {
    const bool initiated = confirmation == sdo::command(sdo::Response::initiate_download);
    send(sdo::Message(confirmation, initiated ? multiplexer_ : sdo::Multiplexer{}));
  }
}

/// The client may have sent another request meanwhile, and is then not waiting.
inline void SdoServer::finish_deferred(AbortCode answer) {
  if (state_ != State::deferred) return;
  state_ = State::idle;
  confirm(answer, confirmation_);
}

/// Ends the transfer in progress; a message that begins one is refused with its own multiplexer.
void SdoServer::refuse_service(sdo::Message request) {
  if (initiates_block(request)) {
    multiplexer_ = request.multiplexer();
  } else if (!busy()) {
    multiplexer_ = {};
  }
  abort(AbortCode::command_specifier);
}

void SdoServer::begin(State state) {
  state_ = state;
  toggle_ = 0;
  await_client(time_out_);
}

inline void SdoServer::expect_next_segment() {
  toggle_ ^= sdo::toggle_bit;
  await_client(time_out_);
}

void SdoServer::drop() {
  state_ = State::idle;
  entry_.drop();
}

void SdoServer::give_up(void* server, Time now) {
  static_cast<SdoServer*>(server)->give_up(now);
}

[[gnu::always_inline]] inline void SdoServer::give_up(Time now) {
  if (watchdog_.put_off(now)) return;
  if (state_ == State::block && extension_->expired()) return;
  if (busy() && state_ != State::deferred) abort(AbortCode::time_out);
}

void SdoServer::abort(AbortCode code) {
  drop();
  send(sdo::Message(multiplexer_, code));
}

/// The written value may have stopped this node.
void SdoServer::send(sdo::Message message) {
  if (has_services(node_.state())) reply(message);
}

}  // namespace canvoy

#undef CANVOY_HANDLER
