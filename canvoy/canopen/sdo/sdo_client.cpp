#include "canvoy/canopen/sdo/sdo_client.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

constexpr AccessHandlers SdoClient::hook_calls = {
    .first = sdo_client_parameter,
    .last = sdo_client_parameter + sdo_channels_max - 1,
    .before_write = method<&SdoClient::before_write>,
    .after_write = method<&SdoClient::after_write>};
constexpr ServiceHandlers SdoClient::service_calls = {
    .state_entered = method<&SdoClient::state_entered>, .hooks = {&hook_calls, 1}};

SdoClient::SdoClient(Node& node, std::optional<std::uint8_t> number)
    : node_(node), watchdog_(node.timers(), Callback<void(Time)>::to<&SdoClient::give_up>(*this)) {
  node_.attach(service_);
  if (number) choose_channel(*number);
}

void SdoClient::choose_channel(std::uint8_t number) {
  const auto index = static_cast<std::uint16_t>(sdo_client_parameter + number);
  parameter_ = node_.dictionary().find(index, 0) ? index : std::uint16_t{0};
  connected_to_ = nobody;
}

bool SdoClient::may_speak() const {
  return node_.state() == NmtState::pre_operational || node_.state() == NmtState::operational ||
         !is_node_id(node_.id());
}

/// Nothing is used after the callback, which may have started the next request.
void SdoClient::finish(Outcome outcome) {
  state_ = State::idle;
  ++ended_;
  const Done done = done_;
  done(outcome);
}

void SdoClient::state_entered(NmtState) {
  if (may_speak()) return;
  connected_to_ = nobody;
  if (busy()) finish(SdoEnd::cancelled(AbortCode::device_state));
}

AbortCode SdoClient::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  return entry.index == parameter_ ? check_sdo_parameter(entry, value) : AbortCode::none;
}

void SdoClient::after_write(const Entry& entry, Source) {
  if (entry.index != parameter_) return;
  connected_to_ = nobody;
  if (busy()) end_with(SdoEnd::cancelled(AbortCode::no_sdo_connection));
}

/// Only the node's own object names the node at the other end.
SdoChannel SdoClient::channel_to(NodeId server) const {
  if (!is_node_id(server)) return {};
  if (parameter_ == 0) return default_sdo_channel(server);
  if (node_.dictionary().number(parameter_, 3) != server) return {};
  return sdo_channel(node_.dictionary(), parameter_);
}

/// The route stays after a request, since the next one is likely to go to the same server.
AbortCode SdoClient::find_connection(NodeId server) {
  if (!may_speak()) return AbortCode::device_state;
  const SdoChannel channel = channel_to(server);
  if (!channel.valid()) return AbortCode::no_sdo_connection;
  if (channel != channel_) {
    const auto receiver = Router::Receiver::to<&SdoClient::receive>(*this);
    if (channel_.valid()) node_.router().remove(channel_.response, receiver);
    const bool added = node_.router().add(channel.response, receiver);
    channel_ = added ? channel : SdoChannel{};
    if (!added) return AbortCode::out_of_memory;
  }
  connected_to_ = server;
  return AbortCode::none;
}

inline AbortCode SdoClient::connect(NodeId server) {
  return server == connected_to_ ? AbortCode::none : find_connection(server);
}

/// All state is set before the message is sent: on some buses the answer comes at once.
inline void SdoClient::ask(sdo::Message message) {
  watchdog_.restart(node_.now() + time_out_);
  send(message);
}

inline void SdoClient::note(sdo::Multiplexer multiplexer, Done done, Duration time_out) {
  multiplexer_ = multiplexer;
  done_ = done;
  time_out_ = time_out;
  toggle_ = 0;
  transferred_ = 0;
}

AbortCode SdoClient::upload(NodeId server, std::uint16_t index, std::uint8_t sub,
                            std::span<std::uint8_t> destination, Done done, Duration time_out) {
  if (busy()) return AbortCode::device_state;
  note({index, sub}, done, time_out);
  destination_ = destination;
  sink_ = {};
  return initiate_upload(server);
}

AbortCode SdoClient::upload(NodeId server, std::uint16_t index, std::uint8_t sub, Sink sink,
                            Done done, Duration time_out) {
  if (busy()) return AbortCode::device_state;
  note({index, sub}, done, time_out);
  destination_ = {};
  sink_ = sink;
  return initiate_upload(server);
}

AbortCode SdoClient::download(NodeId server, std::uint16_t index, std::uint8_t sub,
                              std::span<const std::uint8_t> value, Done done, Duration time_out) {
  if (busy()) return AbortCode::device_state;
  note({index, sub}, done, time_out);
  value_ = value;
  in_memory_ = value.size();
  supply_ = {};
  announced_ = static_cast<std::uint32_t>(value.size());
  return initiate_download(server);
}

AbortCode SdoClient::download(NodeId server, std::uint16_t index, std::uint8_t sub, Supply supply,
                              std::optional<std::uint32_t> size, Done done, Duration time_out) {
  if (busy()) return AbortCode::device_state;
  note({index, sub}, done, time_out);
  value_ = {};
  in_memory_ = 0;
  supply_ = supply;
  announced_ = size;
  return initiate_download(server);
}

AbortCode SdoClient::initiate_upload(NodeId server) {
  const AbortCode answer = connect(server);
  if (answer != AbortCode::none) return answer;
  announced_.reset();
  if (extension_ != nullptr && extension_->initiate_upload()) return AbortCode::none;
  if (transfer_ == SdoTransfer::block) return AbortCode::unsupported_access;
  begin_upload();
  return AbortCode::none;
}

void SdoClient::begin_upload() {
  state_ = State::upload_initiated;
  ask(sdo::Message(sdo::command(sdo::Request::initiate_upload), multiplexer_));
}

AbortCode SdoClient::initiate_download(NodeId server) {
  const AbortCode answer = connect(server);
  if (answer != AbortCode::none) return answer;
  if (extension_ != nullptr && extension_->initiate_download()) return AbortCode::none;
  if (transfer_ == SdoTransfer::block) return AbortCode::unsupported_access;
  begin_download();
  return AbortCode::none;
}

/// A short value goes with the request itself, and nothing follows.
void SdoClient::begin_download() {
  state_ = State::download_initiated;
  nothing_follows_ = !value_.empty() && value_.size() <= sdo::expedited_max;
  unsigned flags = announced_ ? sdo::size_indicated : 0U;
  std::uint32_t data = announced_.value_or(0);
  if (nothing_follows_) {
    flags = sdo::expedited(value_.size());
    data = sdo::pack(value_);
    transferred_ = value_.size();
  }
  ask(sdo::Message(sdo::command(sdo::Request::initiate_download, flags), multiplexer_, data));
}

void SdoClient::receive(const Frame& frame, Time) {
  if (frame.length != Frame::length_max) return node_.count_malformed();
  if (state_ == State::block) return extension_->receive(frame);
  take_answer(frame);
}

inline void SdoClient::take_answer(const Frame& frame) {
  const sdo::Message answer(frame);
  switch (answer.response()) {
    case sdo::Response::initiate_upload:
      return upload_initiated(answer);
    case sdo::Response::initiate_download:
      return download_initiated(answer);
    case sdo::Response::upload_segment:
      return upload_segment(answer);
    case sdo::Response::download_segment:
      return download_segment(answer);
    case sdo::Response::abort:
      return aborted_by_server(answer);
    default:
      return unexpected();
  }
}

/// A server that does not report the size leaves it to the client.
inline SdoClient::Outcome SdoClient::take_expedited(sdo::Message answer) {
  std::size_t size = answer.has_size() ? answer.expedited_size() : sdo::expedited_max;
  if (sink_) {
    std::array<std::uint8_t, sdo::expedited_max> bytes;
    sdo::unpack(answer.value(), bytes);
    transferred_ = size;
    const AbortCode taken = sink_(std::span(bytes).first(size));
    if (taken != AbortCode::none) return taken;
    return size;
  }
  if (size > destination_.size()) {
    if (answer.has_size()) return AbortCode::out_of_memory;
    size = destination_.size();
  }
  if (size != 0) sdo::unpack(answer.value(), destination_.first(size));
  transferred_ = size;
  return size;
}

/// Another multiplexer, or another service, means a late answer to an earlier request.
void SdoClient::upload_initiated(sdo::Message answer) {
  if (state_ != State::upload_initiated || answer.multiplexer() != multiplexer_) return;
  if (answer.is_expedited()) {
    const std::uint8_t before = ended_;
    const Outcome outcome = take_expedited(answer);
    if (ended_ != before) return;
    return outcome ? finish(outcome) : end_with(outcome);
  }
  if (answer.has_size()) announced_ = answer.value();
  if (!sink_ && announced_ > destination_.size()) return fail(AbortCode::out_of_memory);
  expect_bytes();
  state_ = State::upload_segment;
  ask_for_segment();
}

/// Expects as many bytes as the server has announced, if they go to memory at all.
void SdoClient::expect_bytes() {
  in_memory_ = std::min<std::size_t>(destination_.size(), announced_.value_or(UINT32_MAX));
}

inline void SdoClient::ask_for_segment() {
  ask(sdo::Message(sdo::command(sdo::Request::upload_segment, toggle_)));
}

inline void SdoClient::upload_segment(sdo::Message answer) {
  if (state_ != State::upload_segment) return unexpected();
  if (answer.toggle() != toggle_) return fail(AbortCode::toggle_bit);
  if constexpr (sdo::has_short_way) {
    const bool full = answer.first_byte() == toggle_;
    if (std::uint8_t* room = full ? room_for_segment() : nullptr) {
      answer.store_full_segment(room);
      toggle_ ^= sdo::toggle_bit;
      return ask_for_segment();
    }
  }
  take_segment(answer);
}

void SdoClient::take_segment(sdo::Message answer) {
  const std::uint8_t before = ended_;
  const auto data = answer.bytes();
  const AbortCode taken = take(std::span(data).subspan(1, answer.segment_size()));
  if (ended_ != before) return;
  if (taken != AbortCode::none) return fail(taken);
  if (answer.is_last()) {
    if (announced_ && transferred_ < *announced_) return fail(AbortCode::length_too_low);
    return finish(transferred_);
  }
  toggle_ ^= sdo::toggle_bit;
  ask_for_segment();
}

AbortCode SdoClient::take(std::span<const std::uint8_t> bytes) {
  const std::size_t end = transferred_ + bytes.size();
  if (announced_ && end > *announced_) return AbortCode::length_too_high;
  if (!sink_ && end > destination_.size()) return AbortCode::out_of_memory;
  const std::size_t begin = std::exchange(transferred_, end);
  if (bytes.empty()) return AbortCode::none;
  if (sink_) return sink_(bytes);
  sdo::copy_segment(bytes, destination_.data() + begin);
  return AbortCode::none;
}

void SdoClient::download_initiated(sdo::Message answer) {
  if (state_ != State::download_initiated || answer.multiplexer() != multiplexer_) return;
  if (nothing_follows_) return finish(transferred_);
  state_ = State::download_segment;
  send_segment();
}

inline void SdoClient::send_segment() {
  if constexpr (sdo::has_short_way) {
    if (const std::uint8_t* segment = next_full_segment()) {
      return ask(sdo::full_segment_message(sdo::command(sdo::Request::download_segment, toggle_),
                                           segment));
    }
  }
  give_segment();
}

void SdoClient::give_segment() {
  std::array<std::uint8_t, sdo::segment_max> memory;
  const std::uint8_t before = ended_;
  const auto bytes = give(memory);
  if (ended_ != before) return;
  if (!bytes) return fail(bytes.abort());
  const unsigned flags = sdo::segment(toggle_, bytes->size(), nothing_follows_);
  ask(sdo::segment_message(sdo::command(sdo::Request::download_segment, flags), *bytes));
}

/// Next bytes of a download, no more than `memory` has room for, and whether they are the last. If
/// the supply has ended the transfer, nothing is used: it may belong to the next one.
Result<std::span<const std::uint8_t>> SdoClient::give(std::span<std::uint8_t> memory) {
  check_invariant(!announced_ || transferred_ <= *announced_);
  std::size_t wanted = memory.size();
  if (announced_) wanted = std::min<std::size_t>(wanted, *announced_ - transferred_);
  auto bytes = std::span<const std::uint8_t>(memory.first(wanted));
  if (supply_ && wanted != 0) {
    const std::uint8_t before = ended_;
    const Result<std::size_t> size = supply_(memory.first(wanted));
    if (ended_ != before) return AbortCode::general;
    if (!size) return size.abort();
    if (*size > wanted) return AbortCode::internal_incompatible;
    bytes = bytes.first(*size);
  } else if (!supply_) {
    bytes = value_.subspan(transferred_, wanted);
  }
  transferred_ += bytes.size();
  nothing_follows_ = bytes.size() < wanted || announced_ == transferred_;
  return bytes;
}

inline void SdoClient::download_segment(sdo::Message answer) {
  if (state_ != State::download_segment) return unexpected();
  if (answer.toggle() != toggle_) return fail(AbortCode::toggle_bit);
  if (nothing_follows_) return finish(transferred_);
  toggle_ ^= sdo::toggle_bit;
  send_segment();
}

/// A server that has lost a transfer cannot name it.
void SdoClient::aborted_by_server(sdo::Message answer) {
  const bool between_segments = state_ == State::upload_segment ||
                                state_ == State::download_segment || state_ == State::block;
  const bool nameless = answer.multiplexer() == sdo::Multiplexer{};
  if (!busy() || (answer.multiplexer() != multiplexer_ && !(nameless && between_segments))) return;
  finish(SdoEnd::by_server(answer.abort_code()));
}

/// A segment cannot be the answer to the beginning of a transfer: it is late. During a transfer it
/// is an error.
void SdoClient::unexpected() {
  if (state_ == State::upload_segment || state_ == State::download_segment) {
    fail(AbortCode::command_specifier);
  }
}

void SdoClient::cancel(AbortCode reason) {
  if (!busy()) return;
  done_ = {};
  fail(reason);
}

void SdoClient::give_up(Time now) {
  if (watchdog_.put_off(now)) return;
  if (!busy() || (state_ == State::block && extension_->expired())) return;
  end_with(SdoEnd::no_answer());
}

void SdoClient::end_with(SdoEnd end) {
  finish_with(sdo::Message(multiplexer_, end.abort()), end);
}

/// Code called during the transmission, such as the server on some buses, finds the client busy,
/// and may end the transfer.
void SdoClient::finish_with(sdo::Message last, Outcome outcome) {
  if (state_ == State::ending) return;
  state_ = State::ending;
  if (may_speak()) send(last);
  if (state_ == State::ending) finish(outcome);
}

}  // namespace canvoy
