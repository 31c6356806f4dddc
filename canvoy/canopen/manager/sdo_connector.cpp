#include "canvoy/canopen/manager/sdo_connector.hpp"

#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

constexpr std::uint32_t closed_cob_id = CobId::bit31 | CobId::bit30;

constexpr std::uint16_t server_parameter(unsigned channel) {
  return static_cast<std::uint16_t>(sdo_server_parameter + channel);
}

}  // namespace

SdoConnector::SdoConnector(Node& node, SdoClient& client, const SdoCobIds& cob_ids,
                           const Settings& settings, Ended ended)
    : node_(node),
      client_(client),
      cob_ids_(cob_ids),
      settings_(settings),
      ended_(ended),
      writes_(node, client, settings.time_out, settings.tries) {}

void SdoConnector::reset() {
  current_ = nullptr;
  busy_ = false;
}

bool SdoConnector::may_speak() const {
  return node_.state() == NmtState::pre_operational || node_.state() == NmtState::operational;
}

void SdoConnector::open(SdoConnection& connection) {
  busy_ = true;
  current_ = &connection;
  if (!allocate(connection)) return give_up(DynamicSdoError::no_cob_id);
  if (connection.server_channel != 0) return write_ends();
  if (connection.server != node_.id()) {
    channel_ = 1;
    tries_left_ = settings_.tries;
    return try_server_channel();
  }
  connection.server_channel = free_channel_here();
  if (connection.server_channel == 0) return give_up(DynamicSdoError::no_manager_channel);
  write_ends();
}

bool SdoConnector::allocate(SdoConnection& connection) const {
  if (connection.request != 0) return true;
  const std::uint16_t request = cob_ids_.free_can_id();
  const std::uint16_t response = cob_ids_.free_can_id(request);
  if (request == 0 || response == 0) return false;
  connection.request = request;
  connection.response = response;
  return true;
}

/// Free channel; 0 if there is none.
std::uint8_t SdoConnector::free_channel_here() const {
  for (unsigned channel = 1; channel < sdo_channels_max; ++channel) {
    const Result<Entry> entry = node_.dictionary().find(server_parameter(channel), sdo_sub_request);
    if (entry && !CobId{load<std::uint32_t>(entry->value)}.valid()) {
      return static_cast<std::uint8_t>(channel);
    }
  }
  return 0;
}

/// Reads a COB-ID of the next channel from the server, which determines its free channels.
void SdoConnector::try_server_channel() {
  --tries_left_;
  buffer_ = {};
  const AbortCode refused = client_.upload(
      current_->server, server_parameter(channel_), sdo_sub_request,
      std::span<std::uint8_t>(buffer_),
      SdoClient::Done::to<&SdoConnector::server_channel_read>(*this), settings_.time_out);
  if (refused != AbortCode::none) give_up(DynamicSdoError::server_silent);
}

void SdoConnector::server_channel_read(SdoClient::Outcome outcome) {
  if (outcome.is_silence()) {
    return tries_left_ != 0 ? try_server_channel() : give_up(DynamicSdoError::server_silent);
  }
  if (!outcome) {
    const bool has_none = outcome == SdoEnd::by_server(AbortCode::no_object);
    return give_up(has_none ? DynamicSdoError::no_server_channel : DynamicSdoError::server_refused);
  }
  if (!CobId{load<std::uint32_t>(buffer_.data())}.valid()) {
    current_->server_channel = channel_;
    return write_ends();
  }
  if (++channel_ == sdo_channels_max) return give_up(DynamicSdoError::no_server_channel);
  tries_left_ = settings_.tries;
  try_server_channel();
}

void SdoConnector::write_ends() {
  const SdoConnection& c = *current_;
  const std::uint16_t server = server_parameter(c.server_channel);
  const auto client = static_cast<std::uint16_t>(sdo_client_parameter + c.client_channel);
  writes_.begin(SdoWriteList::Done::to<&SdoConnector::opened>(*this));
  writes_.add({.node = c.server,
               .index = server,
               .sub = sdo_sub_peer,
               .value = c.client,
               .size = 1,
               .may_fail = true});  // an optional entry
  writes_.add({c.server, server, sdo_sub_response, c.response | CobId::bit30});
  writes_.add({c.server, server, sdo_sub_request, c.request | CobId::bit30});
  writes_.add(
      {.node = c.client, .index = client, .sub = sdo_sub_peer, .value = c.server, .size = 1});
  writes_.add({c.client, client, sdo_sub_request, c.request | CobId::bit30});
  writes_.add({c.client, client, sdo_sub_response, c.response | CobId::bit30});
  using Status = DynamicSdoState::Status;
  const bool is_registration = c.server == node_.id();
  notify(c, !is_registration ? Status::connected
            : c.wants_all    ? Status::all_given
                             : Status::registered);
  writes_.run();
}

void SdoConnector::notify(const SdoConnection& connection, DynamicSdoState::Status status) {
  DynamicSdoState state;
  state.client_parameter =
      static_cast<std::uint16_t>(sdo_client_parameter + connection.client_channel);
  state.status = status;
  state.error = connection.error;
  state.wants_all = connection.wants_all;
  writes_.add({connection.client, dynamic_sdo::state, 0, state.value()});
}

void SdoConnector::opened(const SdoWriteList::Outcome& outcome) {
  SdoConnection& connection = *std::exchange(current_, nullptr);
  busy_ = false;
  if (connection.state == SdoConnection::State::ending) return ended_(&connection);
  if (outcome.end) {
    connection.state = SdoConnection::State::given;
    return ended_(&connection);
  }
  const bool is_silent = outcome.end.is_silence();
  connection.state = SdoConnection::State::ending;
  connection.tell_client = true;
  if (outcome.node == connection.server) {
    connection.error = is_silent ? DynamicSdoError::server_silent : DynamicSdoError::server_refused;
  } else {
    connection.client_is_gone = is_silent;
    connection.error = DynamicSdoError::device_refused;
  }
  ended_(&connection);
}

/// Nothing was written yet: only the device is notified.
void SdoConnector::give_up(DynamicSdoError error) {
  SdoConnection& connection = *std::exchange(current_, nullptr);
  busy_ = false;
  if (connection.state != SdoConnection::State::ending) {
    connection.state = SdoConnection::State::ending;
    connection.tell_client = true;
    connection.error = error;
  }
  ended_(&connection);
}

void SdoConnector::refuse(const SdoConnection& wanted) {
  busy_ = true;
  current_ = nullptr;
  writes_.begin(SdoWriteList::Done::to<&SdoConnector::closed>(*this));
  notify(wanted, DynamicSdoState::Status::failed);
  writes_.run();
}

void SdoConnector::close(SdoConnection& connection) {
  busy_ = true;
  current_ = &connection;
  const SdoConnection& c = connection;
  const std::uint16_t server = server_parameter(c.server_channel);
  const auto client = static_cast<std::uint16_t>(sdo_client_parameter + c.client_channel);
  const bool was_written = c.server_channel != 0;
  writes_.begin(SdoWriteList::Done::to<&SdoConnector::closed>(*this));
  const auto invalidate = [this](NodeId node, std::uint16_t index) {
    for (const std::uint8_t sub : {sdo_sub_request, sdo_sub_response}) {
      writes_.add(
          {.node = node, .index = index, .sub = sub, .value = closed_cob_id, .may_fail = true});
    }
  };
  if (was_written && !c.server_is_gone) invalidate(c.server, server);
  if (was_written && !c.client_is_gone) invalidate(c.client, client);
  if (c.tell_client && !c.client_is_gone) notify(c, DynamicSdoState::Status::failed);
  writes_.run();
}

void SdoConnector::closed(const SdoWriteList::Outcome&) {
  busy_ = false;
  SdoConnection* const connection = std::exchange(current_, nullptr);
  // If no device was notified, it is closed when this node may send again.
  if (connection != nullptr && may_speak()) *connection = {};
  ended_(connection);
}

}  // namespace canvoy
