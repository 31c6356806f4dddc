#include "canvoy/canopen/sdo_server.hpp"

#include <algorithm>

#include "canvoy/canopen/little_endian.hpp"

namespace canvoy {

namespace {

bool serves_in(NmtState state) {
  return state == NmtState::operational || state == NmtState::pre_operational;
}

/// The first message of a block transfer, which tells what the transfer is to be about.
bool initiates_block(sdo::Message request) {
  if (request.request() == sdo::Request::block_upload) return (request.first_byte() & 0x03) == 0;
  return request.request() == sdo::Request::block_download && (request.first_byte() & 0x01) == 0;
}

}  // namespace

SdoServer::SdoServer(Node& node, std::uint8_t number, std::span<std::uint8_t> buffer,
                     Duration time_out)
    : node_(node),
      parameter_(static_cast<std::uint16_t>(sdo_server_parameter + number)),
      time_out_(time_out),
      buffer_(buffer.size() < small_buffer_.size() ? std::span<std::uint8_t>(small_buffer_)
                                                   : buffer),
      writer_(node.dictionary(), buffer_),
      watchdog_(node.timers(), Callback<void()>::to<&SdoServer::give_up>(*this)) {
  service_.state_entered = Callback<void(NmtState)>::to<&SdoServer::state_entered>(*this);
  node_.attach(service_);
  if (number == 0) return;
  hook_.first = hook_.last = parameter_;
  hook_.before_write = Callback<AbortCode(
      const Entry&, std::span<const std::uint8_t>)>::to<&SdoServer::before_write>(*this);
  hook_.after_write = Callback<void(const Entry&, Source)>::to<&SdoServer::after_write>(*this);
  node_.dictionary().attach(hook_);
}

void SdoServer::state_entered(NmtState) {
  follow_channel();
}

/// Who is told that a channel is valid may rely on being heard there.
AbortCode SdoServer::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const AbortCode answer = check_sdo_parameter(entry, value);
  if (answer != AbortCode::none || value.size() != sizeof(std::uint32_t)) return answer;
  const bool needs_route = !channel_.valid() && CobId{load<std::uint32_t>(value.data())}.valid();
  return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

void SdoServer::after_write(const Entry&, Source) {
  follow_channel();
}

void SdoServer::follow_channel() {
  SdoChannel wanted;
  if (serves_in(node_.state())) {
    wanted = parameter_ == sdo_server_parameter ? default_sdo_channel(node_.id())
                                                : sdo_channel(node_.dictionary(), parameter_);
  }
  if (wanted == channel_) return;
  drop();
  const auto receiver = Router::Receiver::to<&SdoServer::receive>(*this);
  if (channel_.valid()) node_.router().remove(channel_.request, receiver);
  channel_ = wanted;
  if (!channel_.valid()) return;
  answering_on_ = channel_.response;
  node_.router().add(channel_.request, receiver);
}

void SdoServer::receive(const Frame& frame, Time) {
  if (frame.length != Frame::length_max) return node_.count_malformed();
  if (state_ == State::block) return extension_->receive(frame);
  serve(frame);
}

void SdoServer::serve(const Frame& frame) {
  const sdo::Message request(frame);
  switch (request.request()) {
    case sdo::Request::initiate_upload:
      return initiate_upload(request);
    case sdo::Request::initiate_download:
      return initiate_download(request);
    case sdo::Request::upload_segment:
      return upload_segment(request);
    case sdo::Request::download_segment:
      return download_segment(frame);
    case sdo::Request::abort:
      return drop();
    default:
      return extension_ == nullptr ? refuse_service(request) : extension_->receive(frame);
  }
}

void SdoServer::initiate_upload(sdo::Message request) {
  if (busy()) drop();
  multiplexer_ = request.multiplexer();
  const Result<Entry> entry = node_.dictionary().find(multiplexer_.index(), multiplexer_.sub());
  if (!entry) return abort(entry.abort());
  const auto value = node_.dictionary().read(*entry);
  if (!value) {
    if (entry->row->type != DataType::domain) return abort(value.abort());
    return begin_upload(reader_.open_domain(node_.dictionary(), *entry));
  }
  if (value->empty() || value->size() > sdo::expedited_max) {
    return begin_upload(reader_.open(*entry, *value, buffer_));
  }
  const unsigned flags = sdo::expedited(value->size());
  const sdo::Message answer(sdo::command(sdo::Response::initiate_upload, flags), multiplexer_,
                            sdo::pack(*value));
  node_.transmitter().send(answer.frame(answering_on_));
}

void SdoServer::begin_upload(AbortCode answer) {
  if (answer != AbortCode::none) return abort(answer);
  begin(State::upload);
  const std::optional<std::uint32_t> size = reader_.size();
  const unsigned flags = size ? sdo::size_indicated : 0U;
  send(sdo::Message(sdo::command(sdo::Response::initiate_upload, flags), multiplexer_,
                    size.value_or(0)));
}

void SdoServer::upload_segment(sdo::Message request) {
  if (state_ != State::upload) return refuse_service(request);
  if (request.toggle() != toggle_) return abort(AbortCode::toggle_bit);
  std::array<std::uint8_t, sdo::segment_max> memory;
  const auto bytes = reader_.next(memory);
  if (state_ != State::upload) return;  // the domain has stopped the node
  if (!bytes) return abort(bytes.abort());
  const bool last = reader_.ended();
  const unsigned flags = sdo::segment(toggle_, bytes->size(), last);
  const sdo::Message segment =
      sdo::segment_message(sdo::command(sdo::Response::upload_segment, flags), *bytes);
  if (last) {
    state_ = State::idle;
  } else {
    expect_next_segment();
  }
  send(segment);
}

void SdoServer::initiate_download(sdo::Message request) {
  if (busy()) drop();
  multiplexer_ = request.multiplexer();
  const Result<Entry> entry = node_.dictionary().find(multiplexer_.index(), multiplexer_.sub());
  if (!entry) return abort(entry.abort());
  AbortCode answer;
  if (request.is_expedited()) {
    answer = download_expedited(*entry, request);
  } else {
    answer =
        writer_.open(*entry, request.has_size() ? std::optional(request.value()) : std::nullopt);
    if (answer == AbortCode::none) begin(State::download);
  }
  confirm(answer, sdo::Message(sdo::command(sdo::Response::initiate_download), multiplexer_));
}

void SdoServer::confirm(AbortCode answer, sdo::Message confirmation) {
  if (answer == AbortCode::deferred) {
    state_ = State::deferred;
    confirmation_ = confirmation;
    node_.await_deferred(Callback<void(AbortCode)>::to<&SdoServer::finish_deferred>(*this));
  } else if (answer != AbortCode::none) {
    abort(answer);
  } else {
    send(confirmation);
  }
}

/// The client may have asked for something else meanwhile, and then it waits no more.
void SdoServer::finish_deferred(AbortCode answer) {
  if (state_ != State::deferred) return;
  state_ = State::idle;
  confirm(answer, confirmation_);
}

/// A client that does not tell the size leaves it to the entry.
AbortCode SdoServer::download_expedited(const Entry& entry, sdo::Message request) {
  const bool is_domain = entry.row->type == DataType::domain;
  std::size_t size = sdo::expedited_max;
  if (request.has_size()) {
    size = request.expedited_size();
  } else if (!is_domain) {
    size = std::min<std::size_t>(size, entry.row->capacity);
  }
  std::array<std::uint8_t, sdo::expedited_max> data;
  store(data.data(), request.value());
  const auto bytes = std::span<const std::uint8_t>(data).first(size);
  if (!is_domain) return node_.dictionary().write(entry, bytes, Source::sdo);
  AbortCode answer = writer_.open(entry, static_cast<std::uint32_t>(size));
  if (answer == AbortCode::none) answer = writer_.write(bytes);
  return answer == AbortCode::none ? writer_.finish() : answer;
}

void SdoServer::download_segment(const Frame& frame) {
  const sdo::Message request(frame);
  if (state_ != State::download) return refuse_service(request);
  if (request.toggle() != toggle_) return abort(AbortCode::toggle_bit);
  AbortCode answer = writer_.write(std::span(frame.data).subspan(1, request.segment_size()));
  if (state_ != State::download) return;
  if (answer != AbortCode::none) return abort(answer);
  const sdo::Message confirmation(sdo::command(sdo::Response::download_segment, toggle_));
  if (!request.is_last()) {
    expect_next_segment();
  } else {
    state_ = State::idle;
    answer = writer_.finish();
  }
  confirm(answer, confirmation);
}

/// The transfer that is under way ends; a message that begins one is refused by its own name.
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
  watchdog_.restart(node_.now() + time_out_);
}

void SdoServer::expect_next_segment() {
  toggle_ ^= sdo::toggle_bit;
  watchdog_.restart(node_.now() + time_out_);
}

void SdoServer::drop() {
  state_ = State::idle;
  writer_.drop();
}

void SdoServer::give_up() {
  if (state_ == State::block && extension_->expired()) return;
  if (busy() && state_ != State::deferred) abort(AbortCode::time_out);
}

void SdoServer::abort(AbortCode code) {
  drop();
  send(sdo::Message(multiplexer_, code));
}

/// What was written may have stopped this node.
void SdoServer::send(const Frame& frame) {
  if (serves_in(node_.state())) node_.transmitter().send(frame);
}

}  // namespace canvoy
