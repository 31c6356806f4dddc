#include "canvoy/canopen/remote/remote_access.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t abort_byte = sdo::command(sdo::Request::abort);
constexpr std::uint8_t block_upload_end = sdo::command(sdo::Request::block_upload, sdo::block_end);
constexpr std::uint8_t block_download_end =
    sdo::command(sdo::Response::block_download, sdo::block_end);
constexpr std::uint8_t least_free_command = 0xE0;

bool is_data_of(const Frame& frame, unsigned first, unsigned last, unsigned length) {
  return frame.is_plain() && frame.id >= first && frame.id <= last && frame.length == length;
}

bool is_initiate(sdo::Message request) {
  switch (request.request()) {
    case sdo::Request::initiate_download:
    case sdo::Request::initiate_upload:
      return true;
    case sdo::Request::block_upload:
      return request.block_command() == sdo::block_initiate;
    case sdo::Request::block_download:
      return !request.is_block_end();
    default:
      return false;
  }
}

}  // namespace

void RemoteChannel::expired(Time /*now*/) {
  access_->expired(*this);
}

constexpr ServiceHandlers RemoteAccess::service_calls = {
    .reset = method<&RemoteAccess::reset>, .state_entered = method<&RemoteAccess::state_entered>};

RemoteAccess::RemoteAccess(Node& node, const Port& embedded, std::span<RemoteChannel> channels,
                           const RemoteSettings& settings)
    : node_(node), embedded_(embedded), channels_(channels), settings_(settings) {
  check_invariant(settings.indication >= least_free_command);
  for (RemoteChannel& channel : channels) channel.access_ = this;
  node.attach(service_);
}

SdoChannel RemoteAccess::ids_of(const RemoteChannel& channel) const {
  if (channel.ids_.valid() || &channel != channels_.data()) return channel.ids_;
  return is_node_id(node_.id()) ? default_sdo_channel(node_.id()) : SdoChannel{};
}

RemoteChannel* RemoteAccess::channel_of(const Frame& frame) {
  if (!is_data_of(frame, 1, Frame::id_max, Frame::length_max)) return nullptr;
  const NmtState state = node_.state();
  if (state != NmtState::pre_operational && state != NmtState::operational) return nullptr;
  for (RemoteChannel& channel : channels_) {
    if (ids_of(channel).request == frame.id) return &channel;
  }
  return nullptr;
}

void RemoteAccess::receive(const Frame& frame, Time now) {
  if (RemoteChannel* const channel = channel_of(frame)) {
    node_.advance(now);
    if (take(*channel, sdo::Message(frame))) return;
  }
  node_.receive(frame, now);
}

/// False if it is for the node itself.
bool RemoteAccess::take(RemoteChannel& channel, sdo::Message request) {
  const bool is_segment = channel.phase_ == Phase::block_download_data;
  if (!is_segment && request.first_byte() == settings_.indication) {
    indicate(channel, request);
    return true;
  }
  switch (channel.phase_) {
    case Phase::idle:
      return false;
    case Phase::expired: {
      channel.phase_ = Phase::idle;
      if (!is_initiate(request)) return false;
      channel.multiplexer_ = request.multiplexer();
      refuse(channel, AbortCode::time_out);
      return true;
    }
    case Phase::indicated:
      if (!begin(channel, request)) return false;
      break;
    default:
      if (is_segment || !is_initiate(request)) break;
      // Another transfer, without a selection of the device.
      give_up(channel);
      return false;
  }
  pass_on(channel, request);
  return true;
}

void RemoteAccess::indicate(RemoteChannel& channel, sdo::Message request) {
  give_up(channel);
  const auto bytes = request.bytes();
  const auto network = load<std::uint16_t>(&bytes[1]);
  const NodeId device = bytes[3];
  channel.multiplexer_ = request.multiplexer();
  if (request != remote_indication(settings_, network, device)) {
    return refuse(channel, AbortCode::command_specifier);
  }
  if (network != settings_.network || !is_node_id(device)) {
    return refuse(channel, AbortCode::no_sdo_connection);
  }
  for (const RemoteChannel& other : channels_) {
    if (other.phase_ == Phase::idle || other.phase_ == Phase::expired) continue;
    // Its default server has one client at a time.
    if (other.target_ == device) return refuse(channel, AbortCode::device_state);
  }
  // An unfinished transfer of the client with the node itself would interfere.
  const sdo::Message left_off = {sdo::Multiplexer(), AbortCode::general};
  node_.receive(left_off.frame(ids_of(channel).request), node_.now());
  channel.target_ = device;
  channel.phase_ = Phase::indicated;
  node_.timers().arm(channel.timer_, node_.now() + settings_.time_out);
  answer(channel, request);
}

/// A new request of the client ends the transfer in progress.
void RemoteAccess::give_up(RemoteChannel& channel) {
  if (channel.is_busy()) {
    send_behind(channel.target_, {channel.multiplexer_, AbortCode::general});
  }
  end(channel);
}

/// False if the request begins nothing: the selection is used up nevertheless.
bool RemoteAccess::begin(RemoteChannel& channel, sdo::Message request) {
  if (!is_initiate(request)) {
    end(channel);
    return false;
  }
  channel.multiplexer_ = request.multiplexer();
  switch (request.request()) {
    case sdo::Request::initiate_download:
      channel.phase_ = Phase::download;
      break;
    case sdo::Request::block_upload:
      channel.phase_ = Phase::block_upload;
      break;
    case sdo::Request::block_download:
      channel.phase_ = Phase::block_download;
      break;
    default:
      channel.phase_ = Phase::upload;
  }
  ++counters_.transfers;
  return true;
}

void RemoteAccess::pass_on(RemoteChannel& channel, sdo::Message request) {
  if (channel.phase_ == Phase::download) {
    const bool is_segment_of_it = request.request() == sdo::Request::download_segment;
    channel.answer_ends_ = is_segment_of_it ? request.is_last() : request.is_expedited();
  }
  if (!send_behind(channel.target_, request)) {
    return abort_both(channel, AbortCode::device_state);
  }
  const bool ends =
      request.first_byte() == abort_byte ||
      (channel.phase_ == Phase::block_upload_data && request.first_byte() == block_upload_end);
  if (ends) return end(channel);
  node_.timers().arm(channel.timer_, node_.now() + settings_.time_out);
}

void RemoteAccess::receive_embedded(const Frame& frame, Time now) {
  node_.advance(now);
  if (is_data_of(frame, can_id::sdo_response + 1, can_id::sdo_response + 127, Frame::length_max)) {
    const auto device = static_cast<NodeId>(frame.id - can_id::sdo_response);
    for (RemoteChannel& channel : channels_) {
      if (channel.is_busy() && channel.target_ == device) answered(channel, sdo::Message(frame));
    }
  } else if (is_data_of(frame, can_id::emergency + 1, can_id::emergency + 127, Frame::length_max)) {
    emergency(static_cast<NodeId>(frame.id - can_id::emergency), frame);
  } else if (is_data_of(frame, can_id::error_control + 1, can_id::error_control + 127, 1)) {
    if (frame.data[0] == 0) lost(static_cast<NodeId>(frame.id - can_id::error_control));
  }
}

void RemoteAccess::answered(RemoteChannel& channel, sdo::Message message) {
  const bool ends = is_end(channel, message);
  answer(channel, message);
  if (ends) return end(channel);
  node_.timers().arm(channel.timer_, node_.now() + settings_.time_out);
}

bool RemoteAccess::is_end(RemoteChannel& channel, sdo::Message answer) {
  if (answer.first_byte() == abort_byte) return true;
  switch (channel.phase_) {
    case Phase::download:
      return channel.answer_ends_;
    case Phase::block_upload: {
      const bool is_without_blocks = answer.response() == sdo::Response::initiate_upload;
      channel.phase_ = is_without_blocks ? Phase::upload : Phase::block_upload_data;
      return is_without_blocks && answer.is_expedited();
    }
    case Phase::upload:
      if (answer.response() == sdo::Response::initiate_upload) return answer.is_expedited();
      return answer.response() == sdo::Response::upload_segment && answer.is_last();
    case Phase::block_download:
      channel.phase_ = Phase::block_download_data;
      return false;
    case Phase::block_download_data:
      return answer.first_byte() == block_download_end;
    default:
      return false;
  }
}

// Failures

void RemoteAccess::expired(RemoteChannel& channel) {
  if (channel.phase_ == Phase::indicated) {
    channel.phase_ = Phase::expired;
  } else if (channel.is_busy()) {
    abort_both(channel, AbortCode::time_out);
  }
}

/// A device that boots has no record of a transfer.
void RemoteAccess::lost(NodeId device) {
  for (RemoteChannel& channel : channels_) {
    if (!channel.is_busy() || channel.target_ != device) continue;
    refuse(channel, AbortCode::general);
    end(channel);
  }
}

void RemoteAccess::reset(ResetScope /*scope*/) {
  drop_all();
}
void RemoteAccess::state_entered(NmtState state) {
  if (state == NmtState::stopped) drop_all();
}
/// The node may not send to its clients.
void RemoteAccess::drop_all() {
  for (RemoteChannel& channel : channels_) {
    if (channel.is_busy()) {
      send_behind(channel.target_, {channel.multiplexer_, AbortCode::device_state});
    }
    end(channel);
  }
  counters_.emergencies_lost += static_cast<std::uint32_t>(count_);
  count_ = 0;
  node_.timers().disarm(inhibit_);
}

bool RemoteAccess::send_behind(NodeId device, sdo::Message message) {
  return embedded_.send(embedded_.context,
                        message.frame(static_cast<std::uint16_t>(can_id::sdo_request + device)));
}
void RemoteAccess::answer(const RemoteChannel& channel, sdo::Message message) {
  node_.transmitter().send(message.frame(ids_of(channel).response));
}
void RemoteAccess::refuse(const RemoteChannel& channel, AbortCode code) {
  answer(channel, {channel.multiplexer_, code});
}
void RemoteAccess::abort_both(RemoteChannel& channel, AbortCode code) {
  send_behind(channel.target_, {channel.multiplexer_, code});
  refuse(channel, code);
  end(channel);
}
void RemoteAccess::end(RemoteChannel& channel) {
  channel.phase_ = Phase::idle;
  channel.answer_ends_ = false;
  node_.timers().disarm(channel.timer_);
}

// Emergencies

void RemoteAccess::emergency(NodeId device, const Frame& frame) {
  if ((settings_.emergency_cob_id & RemoteSettings::invalid_cob_id) != 0) return;
  const NmtState state = node_.state();
  const bool may_speak = state == NmtState::pre_operational || state == NmtState::operational;
  if (!may_speak || count_ == waiting_max) {
    ++counters_.emergencies_lost;
    return;
  }
  Frame told = frame;
  told.id = settings_.emergency_cob_id & Frame::id_max;
  told.data[3] = static_cast<std::uint8_t>(settings_.network);
  told.data[4] = device;
  for (std::size_t i = 5; i < Frame::length_max; ++i) told.data[i] = frame.data[i - 2];
  if (!inhibit_.armed()) return notify(told);
  waiting_[(first_ + count_) % waiting_max] = told;
  ++count_;
}

void RemoteAccess::notify(const Frame& frame) {
  ++counters_.emergencies;
  node_.transmitter().send(frame);
  node_.timers().arm(inhibit_, node_.now() + settings_.emergency_inhibit);
}

void RemoteAccess::may_tell(Time /*now*/) {
  if (count_ == 0) return;
  const Frame& next = waiting_[first_];
  first_ = (first_ + 1) % waiting_max;
  --count_;
  notify(next);
}

sdo::Message remote_indication(const RemoteSettings& settings, std::uint16_t network,
                               NodeId device) {
  return sdo::Message(std::array<std::uint8_t, Frame::length_max>{
      settings.indication, static_cast<std::uint8_t>(network),
      static_cast<std::uint8_t>(network >> 8), device});
}

}  // namespace canvoy
