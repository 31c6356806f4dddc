// How a connection is opened and closed: both ends are written by SDO, the server's first.
#include <algorithm>
#include <utility>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t sub_request = 1;
constexpr std::uint8_t sub_response = 2;
constexpr std::uint8_t sub_peer = 3;
constexpr std::uint32_t closed_cob_id = CobId::bit31 | CobId::bit30;
constexpr unsigned lists = 4;
constexpr unsigned list_length = 254;

constexpr std::uint16_t server_parameter(unsigned channel) {
  return static_cast<std::uint16_t>(sdo_server_parameter + channel);
}

}  // namespace

void SdoManager::open(SdoConnection& connection) {
  busy_ = true;
  current_ = &connection;
  if (!allocate(connection)) return refuse(DynamicSdoError::no_cob_id);
  if (connection.server_channel != 0) return write_connection();
  if (connection.server != node_.id()) {
    channel_ = 1;
    tries_left_ = settings_.tries;
    return try_server_channel();
  }
  connection.server_channel = free_channel_here();
  if (connection.server_channel == 0) return refuse(DynamicSdoError::no_manager_channel);
  write_connection();
}

bool SdoManager::allocate(SdoConnection& connection) {
  if (connection.request != 0) return true;
  const std::uint16_t request = free_can_id(0);
  const std::uint16_t response = free_can_id(request);
  if (request == 0 || response == 0) return false;
  connection.request = request;
  connection.response = response;
  return true;
}

/// 0 where there is none.
std::uint16_t SdoManager::free_can_id(std::uint16_t taken) const {
  const auto count = static_cast<unsigned>(node_.dictionary().number(dynamic_sdo::cob_ids, 0));
  for (unsigned sub = 1; sub <= count; ++sub) {
    const CobId id{static_cast<std::uint32_t>(
        node_.dictionary().number(dynamic_sdo::cob_ids, static_cast<std::uint8_t>(sub)))};
    const bool is_usable = id.valid() && id.is_base_frame() && !is_restricted(id.can_id());
    if (is_usable && id.can_id() != taken && !is_given(id.can_id())) {
      return static_cast<std::uint16_t>(id.can_id());
    }
  }
  return 0;
}

bool SdoManager::is_given(std::uint32_t can_id) const {
  return std::ranges::any_of(connections_, [can_id](const SdoConnection& connection) {
    return connection.request == can_id || connection.response == can_id;
  });
}

std::uint8_t SdoManager::free_channel_here() const {
  for (unsigned channel = 1; channel < sdo_channels_max; ++channel) {
    const Result<Entry> entry = node_.dictionary().find(server_parameter(channel), sub_request);
    if (entry && !CobId{load<std::uint32_t>(entry->value)}.valid()) {
      return static_cast<std::uint8_t>(channel);
    }
  }
  return 0;
}

/// The server knows best which of its channels is free.
void SdoManager::try_server_channel() {
  --tries_left_;
  buffer_ = {};
  const AbortCode refused = client_.upload(
      current_->server, server_parameter(channel_), sub_request, std::span<std::uint8_t>(buffer_),
      SdoClient::Done::to<&SdoManager::server_channel_read>(*this), settings_.time_out);
  if (refused != AbortCode::none) refuse(DynamicSdoError::server_silent);
}

void SdoManager::server_channel_read(SdoClient::Outcome outcome) {
  if (outcome.abort() == AbortCode::time_out) {
    return tries_left_ != 0 ? try_server_channel() : refuse(DynamicSdoError::server_silent);
  }
  if (!outcome) {
    const bool is_absent = outcome.abort() == AbortCode::no_object;
    return refuse(is_absent ? DynamicSdoError::no_server_channel : DynamicSdoError::server_refused);
  }
  if (!CobId{load<std::uint32_t>(buffer_.data())}.valid()) {
    current_->server_channel = channel_;
    return write_connection();
  }
  if (++channel_ == sdo_channels_max) return refuse(DynamicSdoError::no_server_channel);
  tries_left_ = settings_.tries;
  try_server_channel();
}

void SdoManager::write_connection() {
  const SdoConnection& c = *current_;
  const std::uint16_t server = server_parameter(c.server_channel);
  const auto client = static_cast<std::uint16_t>(sdo_client_parameter + c.client_channel);
  writes_.begin(SdoWriteList::Done::to<&SdoManager::opened>(*this));
  writes_.add({.node = c.server,
               .index = server,
               .sub = sub_peer,
               .value = c.client,
               .size = 1,
               .may_fail = true});  // an optional entry
  writes_.add({c.server, server, sub_response, c.response | CobId::bit30});
  writes_.add({c.server, server, sub_request, c.request | CobId::bit30});
  writes_.add({.node = c.client, .index = client, .sub = sub_peer, .value = c.server, .size = 1});
  writes_.add({c.client, client, sub_request, c.request | CobId::bit30});
  writes_.add({c.client, client, sub_response, c.response | CobId::bit30});
  using Status = DynamicSdoState::Status;
  const bool is_registration = c.server == node_.id();
  tell(c, !is_registration ? Status::connected
          : c.wants_all    ? Status::all_given
                           : Status::registered);
  writes_.run();
}

void SdoManager::tell(const SdoConnection& connection, DynamicSdoState::Status status) {
  DynamicSdoState state;
  state.client_parameter =
      static_cast<std::uint16_t>(sdo_client_parameter + connection.client_channel);
  state.status = status;
  state.error = connection.error;
  state.wants_all = connection.wants_all;
  writes_.add({connection.client, dynamic_sdo::state, 0, state.value()});
}

void SdoManager::opened(const SdoWriteList::Outcome& outcome) {
  SdoConnection& connection = *std::exchange(current_, nullptr);
  busy_ = false;
  wake();
  if (connection.state == SdoConnection::State::ending) return;
  if (outcome.abort == AbortCode::none) {
    connection.state = SdoConnection::State::given;
    return list(connection);
  }
  const bool is_silent = outcome.abort == AbortCode::time_out;
  connection.state = SdoConnection::State::ending;
  connection.tell_client = true;
  if (outcome.node == connection.server) {
    connection.error = is_silent ? DynamicSdoError::server_silent : DynamicSdoError::server_refused;
  } else {
    connection.client_is_gone = is_silent;
    connection.error = DynamicSdoError::device_refused;
  }
}

/// Nothing was written yet: the device is told, and that is all.
void SdoManager::refuse(DynamicSdoError error) {
  SdoConnection& connection = *std::exchange(current_, nullptr);
  busy_ = false;
  wake();
  if (connection.state == SdoConnection::State::ending) return;
  connection.state = SdoConnection::State::ending;
  connection.tell_client = true;
  connection.error = error;
}

void SdoManager::close(SdoConnection& connection) {
  busy_ = true;
  current_ = &connection;
  const SdoConnection& c = connection;
  const std::uint16_t server = server_parameter(c.server_channel);
  const auto client = static_cast<std::uint16_t>(sdo_client_parameter + c.client_channel);
  const bool was_written = c.server_channel != 0;
  writes_.begin(SdoWriteList::Done::to<&SdoManager::closed>(*this));
  const auto invalidate = [this](NodeId node, std::uint16_t index) {
    for (const std::uint8_t sub : {sub_request, sub_response}) {
      writes_.add(
          {.node = node, .index = index, .sub = sub, .value = closed_cob_id, .may_fail = true});
    }
  };
  if (was_written && !c.server_is_gone) invalidate(c.server, server);
  if (was_written && !c.client_is_gone) invalidate(c.client, client);
  if (c.tell_client && !c.client_is_gone) tell(c, DynamicSdoState::Status::failed);
  writes_.run();
}

void SdoManager::closed(const SdoWriteList::Outcome&) {
  busy_ = false;
  wake();
  if (current_ == nullptr) return;
  SdoConnection& connection = *std::exchange(current_, nullptr);
  if (!may_speak()) return;  // nobody was told: it is closed when this node may speak again
  connection = {};
  list(connection);
}

/// In 1F03h to 1F06h, where the dictionary has them.
void SdoManager::list(const SdoConnection& connection) {
  const auto position = static_cast<unsigned>(&connection - connections_.data());
  if (position >= lists * list_length) return;
  const std::uint32_t value = static_cast<std::uint32_t>(connection.client) << 24 |
                              static_cast<std::uint32_t>(connection.client_channel) << 16 |
                              static_cast<std::uint32_t>(connection.server) << 8 |
                              connection.server_channel;
  node_.dictionary().set_number(
      static_cast<std::uint16_t>(dynamic_sdo::connections + position / list_length),
      static_cast<std::uint8_t>(position % list_length + 1), value);
}

}  // namespace canvoy
