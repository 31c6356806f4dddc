#include "canvoy/canopen/manager/sdo_connections.hpp"

namespace canvoy {

namespace {

bool belongs_to(const DynamicSdoRequest& request, const SdoConnection& connection) {
  if (connection.client != request.device) return false;
  if (request.client_parameter != 0) {
    return request.client_parameter == sdo_client_parameter + connection.client_channel;
  }
  if (request.server != 0) return connection.server == request.server;
  return true;  // the registration, and all connections
}

}  // namespace

SdoConnection* SdoConnections::add(const SdoConnection& connection) {
  SdoConnection* const place = find(SdoConnection::State::unused);
  if (place != nullptr) *place = connection;
  return place;
}

SdoConnection* SdoConnections::find(SdoConnection::State state) {
  const auto found = std::ranges::find(all_, state, &SdoConnection::state);
  return found == all_.end() ? nullptr : &*found;
}

const SdoConnection* SdoConnections::find(NodeId client, std::uint8_t client_channel) const {
  for (const SdoConnection& connection : all_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && connection.client == client && connection.client_channel == client_channel) {
      return &connection;
    }
  }
  return nullptr;
}

const SdoConnection* SdoConnections::registration(NodeId client, NodeId manager) const {
  for (const SdoConnection& connection : all_) {
    const bool is_good = connection.state == SdoConnection::State::given ||
                         connection.state == SdoConnection::State::requested;
    if (is_good && connection.client == client && connection.server == manager) {
      return &connection;
    }
  }
  return nullptr;
}

bool SdoConnections::is_lent() const {
  return std::ranges::any_of(all_, [](const SdoConnection& connection) {
    return connection.wants_all && connection.state == SdoConnection::State::given;
  });
}

bool SdoConnections::is_given(std::uint32_t can_id) const {
  return std::ranges::any_of(all_, [can_id](const SdoConnection& connection) {
    return connection.request == can_id || connection.response == can_id;
  });
}

bool SdoConnections::request_again(NodeId client, std::uint8_t client_channel) {
  for (SdoConnection& connection : all_) {
    if (connection.state == SdoConnection::State::unused) continue;
    if (connection.client != client || connection.client_channel != client_channel) continue;
    connection.state = SdoConnection::State::requested;
    return true;
  }
  return false;
}

void SdoConnections::release(const DynamicSdoRequest& request) {
  for (SdoConnection& connection : all_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && belongs_to(request, connection)) connection.state = SdoConnection::State::ending;
  }
}

void SdoConnections::end_all(NodeId client) {
  for (SdoConnection& connection : all_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && connection.client == client) connection.state = SdoConnection::State::ending;
  }
}

void SdoConnections::lose(NodeId node) {
  for (SdoConnection& connection : all_) {
    if (connection.state == SdoConnection::State::unused) continue;
    if (connection.client != node && connection.server != node) continue;
    connection.state = SdoConnection::State::ending;
    if (connection.client == node) {
      connection.client_is_gone = true;
    } else {
      connection.server_is_gone = connection.tell_client = true;
      connection.error = DynamicSdoError::connection_lost;
    }
  }
}

}  // namespace canvoy
