#include "canvoy/canopen/manager/sdo_manager.hpp"

#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

constexpr unsigned lists = 4;
constexpr unsigned list_length = 254;

constexpr std::uint8_t client_channel(std::uint16_t client_parameter) {
  return static_cast<std::uint8_t>(client_parameter - sdo_client_parameter);
}

}  // namespace

constexpr AccessHandlers SdoManager::hook_calls = {
    .first = dynamic_sdo::request,
    .last = dynamic_sdo::cob_ids,
    .before_write = method<&SdoManager::before_write>,
    .after_write = method<&SdoManager::after_write>};
constexpr ServiceHandlers SdoManager::service_calls = {
    .reset = method<&SdoManager::reset>,
    .state_entered = method<&SdoManager::state_entered>,
    .hooks = {&hook_calls, 1}};

SdoManager::SdoManager(Node& node, std::span<SdoConnection> connections, const Settings& settings)
    : node_(node),
      settings_(settings),
      client_(node),
      connections_(connections),
      cob_ids_(node.dictionary(), connections_),
      connector_(node, client_, cob_ids_, {.time_out = settings.time_out, .tries = settings.tries},
                 SdoConnector::Ended::to<&SdoManager::ended>(*this)),
      timer_(callback<&SdoManager::work>(*this)) {
  node_.attach(service_);
  node_.router().add(can_id::dynamic_sdo_request, Router::Receiver::to<&SdoManager::called>(*this));
}

void SdoManager::reset(ResetScope) {
  client_.cancel();
  node_.timers().disarm(timer_);
  connections_.clear();
  connector_.reset();
  search_.reset();
  asked_ = 0;
}

void SdoManager::state_entered(NmtState) {
  if (connector_.may_speak()) wake();
}

void SdoManager::called(const Frame& frame, Time) {
  if (frame.length != 0) return node_.count_malformed();
  if (!connector_.may_speak()) return;
  search_.call();
  wake();
}

AbortCode SdoManager::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const std::uint64_t number = load_unsigned(value);
  switch (entry.index) {
    case dynamic_sdo::request:
      return check_request(DynamicSdoRequest::from(number));
    case dynamic_sdo::release:
      return check_release(DynamicSdoRequest::from(number));
    default:
      return entry.sub == 0 ? AbortCode::none
                            : cob_ids_.check(entry, static_cast<std::uint32_t>(number));
  }
}

void SdoManager::after_write(const Entry& entry, Source) {
  const auto asked = DynamicSdoRequest::from(load_unsigned(entry.bytes()));
  if (entry.index == dynamic_sdo::request) request(asked);
  if (entry.index == dynamic_sdo::release) release(asked);
}

AbortCode SdoManager::check_request(const DynamicSdoRequest& request) const {
  const bool is_sound = is_node_id(request.device) && is_node_id(request.server) &&
                        request.device != request.server && request.server != node_.id() &&
                        dynamic_sdo::is_client_parameter(request.client_parameter);
  if (!is_sound) return AbortCode::value_range;
  if (!is_registered(request.device)) return AbortCode::device_state;
  const SdoConnection* present =
      connections_.find(request.device, client_channel(request.client_parameter));
  if (present == nullptr) {
    const bool has_room = connections_.has(SdoConnection::State::unused);
    return has_room ? AbortCode::none : AbortCode::no_sdo_connection;
  }
  const bool is_same =
      present->server == request.server && present->state != SdoConnection::State::ending;
  return is_same ? AbortCode::none : AbortCode::device_state;
}

AbortCode SdoManager::check_release(const DynamicSdoRequest& request) const {
  const bool is_sound =
      is_node_id(request.device) && request.server <= node_id_max &&
      (request.client_parameter == 0 || dynamic_sdo::is_client_parameter(request.client_parameter));
  if (!is_sound) return AbortCode::value_range;
  return is_registered(request.device) ? AbortCode::none : AbortCode::device_state;
}

/// A connection that is requested again is written again: its answer may have been lost.
void SdoManager::request(const DynamicSdoRequest& request) {
  const std::uint8_t channel = client_channel(request.client_parameter);
  if (!connections_.request_again(request.device, channel)) {
    connections_.add({.state = SdoConnection::State::requested,
                      .client = request.device,
                      .client_channel = channel,
                      .server = request.server});
  }
  wake();
}

void SdoManager::release(const DynamicSdoRequest& request) {
  connections_.release(request);
  wake();
}

void SdoManager::remote_changed(NodeId node, RemoteState state) {
  if (!is_node_id(node)) return;
  search_.hear(node, state != RemoteState::lost);
  if (state != RemoteState::lost && state != RemoteState::boot_up) return;
  connections_.lose(node);
  wake();
}

/// Connections to close come first, since that frees COB-IDs and channels.
void SdoManager::work(Time now) {
  using State = SdoConnection::State;
  changed_(now);
  if (busy() || !connector_.may_speak() || connections_.is_lent()) return;
  if (SdoConnection* const ending = connections_.find(State::ending)) {
    return connector_.close(*ending);
  }
  if (SdoConnection* const wanted = connections_.find(State::requested)) {
    return connector_.open(*wanted);
  }
  if (search_.is_called()) search_.begin();
  while (const NodeId node = search_.next(node_.id())) {
    if (ask(node)) return;
  }
}

void SdoManager::ended(const SdoConnection* connection) {
  wake();
  if (connection != nullptr) list(*connection);
}

bool SdoManager::ask(NodeId node) {
  asked_ = node;  // before the answer, which may come at once
  buffer_ = {};
  const AbortCode refused =
      client_.upload(node, dynamic_sdo::state, 0, std::span<std::uint8_t>(buffer_),
                     SdoClient::Done::to<&SdoManager::answered>(*this),
                     search_.was_heard(node) ? settings_.time_out : settings_.scan_time_out);
  if (refused != AbortCode::none) asked_ = 0;
  return refused == AbortCode::none;
}

void SdoManager::answered(SdoClient::Outcome outcome) {
  const NodeId node = std::exchange(asked_, NodeId{0});
  wake();
  if (!outcome || *outcome != buffer_.size()) return;
  const DynamicSdoState state(load<std::uint32_t>(buffer_.data()));
  if (state.is_request()) found(node, state);
}

/// A device that registers again has lost its connections, or ends them.
void SdoManager::found(NodeId node, const DynamicSdoState& state) {
  search_.find(node);
  connections_.end_all(node);
  SdoConnection wanted{.state = SdoConnection::State::requested,
                       .client = node,
                       .client_channel = client_channel(state.client_parameter),
                       .server = node_.id(),
                       .wants_all = state.wants_all};
  if (connections_.add(wanted) != nullptr) return;
  // A place will become free, perhaps one of its own: it is asked again then.
  if (connections_.has(SdoConnection::State::ending)) return search_.call();
  wanted.error = DynamicSdoError::no_manager_channel;
  connector_.refuse(wanted);
}

/// Lists a connection in 1F03h to 1F06h, if the dictionary has them.
void SdoManager::list(const SdoConnection& connection) {
  if (connection.state == SdoConnection::State::ending) return;
  const auto position = static_cast<unsigned>(&connection - connections_.all().data());
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
