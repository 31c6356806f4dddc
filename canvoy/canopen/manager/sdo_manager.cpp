#include "canvoy/canopen/manager/sdo_manager.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/little_endian.hpp"

namespace canvoy {

namespace {

bool belongs_to(const DynamicSdoRequest& request, const SdoConnection& connection) {
  if (connection.client != request.device) return false;
  if (request.client_parameter != 0) {
    return request.client_parameter == sdo_client_parameter + connection.client_channel;
  }
  if (request.server != 0) return connection.server == request.server;
  return true;  // the registration, and all with it
}

}  // namespace

constexpr HookCalls SdoManager::hook_calls = {.first = dynamic_sdo::request,
                                              .last = dynamic_sdo::cob_ids,
                                              .before_write = method<&SdoManager::before_write>,
                                              .after_write = method<&SdoManager::after_write>};
constexpr ServiceCalls SdoManager::service_calls = {
    .reset = method<&SdoManager::reset>,
    .state_entered = method<&SdoManager::state_entered>,
    .hooks = {&hook_calls, 1}};

SdoManager::SdoManager(Node& node, std::span<SdoConnection> connections, const Settings& settings)
    : node_(node),
      connections_(connections),
      settings_(settings),
      client_(node),
      writes_(node, client_, settings.time_out, settings.tries),
      timer_(Callback<void(Time)>::to<&SdoManager::work>(*this)) {
  node_.attach(service_);
  node_.router().add(can_id::dynamic_sdo_request, Router::Receiver::to<&SdoManager::called>(*this));
}

void SdoManager::reset(ResetScope) {
  client_.cancel();
  node_.timers().disarm(timer_);
  std::ranges::fill(connections_, SdoConnection{});
  current_ = nullptr;
  busy_ = call_waits_ = scanning_ = false;
  heard_.reset();
}

void SdoManager::state_entered(NmtState) {
  if (may_speak()) wake();
}

bool SdoManager::may_speak() const {
  return node_.state() == NmtState::pre_operational || node_.state() == NmtState::operational;
}

void SdoManager::called(const Frame& frame, Time) {
  if (frame.length != 0) return node_.count_malformed();
  if (!may_speak()) return;
  call_waits_ = true;
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
                            : check_cob_id(entry, static_cast<std::uint32_t>(number));
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
  if (registration(request.device) == nullptr) return AbortCode::device_state;
  const auto channel = static_cast<std::uint8_t>(request.client_parameter - sdo_client_parameter);
  const SdoConnection* present = find(request.device, channel);
  if (present == nullptr) {
    return std::ranges::any_of(connections_,
                               [](const SdoConnection& connection) {
                                 return connection.state == SdoConnection::State::unused;
                               })
               ? AbortCode::none
               : AbortCode::no_sdo_connection;
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
  return registration(request.device) == nullptr ? AbortCode::device_state : AbortCode::none;
}

/// A COB-ID that is given stays as it is until it comes back.
AbortCode SdoManager::check_cob_id(const Entry& entry, std::uint32_t value) const {
  const CobId present{load<std::uint32_t>(entry.value)};
  if (present.raw == value) return AbortCode::none;
  if (present.valid() && is_given(present.can_id())) return AbortCode::device_state;
  const CobId wanted{value};
  if (!wanted.valid()) return AbortCode::none;
  if (!wanted.is_base_frame() || is_restricted(wanted.can_id())) return AbortCode::value_range;
  const auto count = static_cast<unsigned>(node_.dictionary().number(dynamic_sdo::cob_ids, 0));
  for (unsigned sub = 1; sub <= count; ++sub) {
    const CobId other{static_cast<std::uint32_t>(
        node_.dictionary().number(dynamic_sdo::cob_ids, static_cast<std::uint8_t>(sub)))};
    if (sub != entry.sub && other.valid() && other.can_id() == wanted.can_id()) {
      return AbortCode::parameter_incompatible;
    }
  }
  return AbortCode::none;
}

/// Asked for again, a connection is written again: its answer may have been lost.
void SdoManager::request(const DynamicSdoRequest& request) {
  const auto channel = static_cast<std::uint8_t>(request.client_parameter - sdo_client_parameter);
  for (SdoConnection& connection : connections_) {
    if (connection.state == SdoConnection::State::unused) continue;
    if (connection.client != request.device || connection.client_channel != channel) continue;
    connection.state = SdoConnection::State::requested;
    return wake();
  }
  add({.state = SdoConnection::State::requested,
       .client = request.device,
       .client_channel = channel,
       .server = request.server});
  wake();
}

void SdoManager::release(const DynamicSdoRequest& request) {
  for (SdoConnection& connection : connections_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && belongs_to(request, connection)) {
      connection.state = SdoConnection::State::ending;
    }
  }
  wake();
}

void SdoManager::remote_changed(NodeId node, RemoteState state) {
  if (!is_node_id(node)) return;
  heard_[node] = state != RemoteState::lost;
  if (state != RemoteState::lost && state != RemoteState::boot_up) return;
  for (SdoConnection& connection : connections_) {
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
  wake();
}

SdoConnection* SdoManager::find(SdoConnection::State state) {
  const auto found = std::ranges::find(connections_, state, &SdoConnection::state);
  return found == connections_.end() ? nullptr : &*found;
}

const SdoConnection* SdoManager::find(NodeId client, std::uint8_t client_channel) const {
  for (const SdoConnection& connection : connections_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && connection.client == client && connection.client_channel == client_channel) {
      return &connection;
    }
  }
  return nullptr;
}

/// One that is under way counts: a device that reads of it in its 1F10h may be faster with its
/// first request than with its confirmation.
const SdoConnection* SdoManager::registration(NodeId client) const {
  for (const SdoConnection& connection : connections_) {
    const bool is_good = connection.state == SdoConnection::State::given ||
                         connection.state == SdoConnection::State::requested;
    if (is_good && connection.client == client && connection.server == node_.id()) {
      return &connection;
    }
  }
  return nullptr;
}

bool SdoManager::is_lent() const {
  return std::ranges::any_of(connections_, [](const SdoConnection& connection) {
    return connection.wants_all && connection.state == SdoConnection::State::given;
  });
}

SdoConnection* SdoManager::add(const SdoConnection& connection) {
  SdoConnection* const place = find(SdoConnection::State::unused);
  if (place != nullptr) *place = connection;
  return place;
}

/// What is to be closed comes first, since it brings COB-IDs and channels back.
void SdoManager::work(Time now) {
  changed_(now);
  if (busy_ || !may_speak() || is_lent()) return;
  if (SdoConnection* const ending = find(SdoConnection::State::ending)) return close(*ending);
  if (SdoConnection* const wanted = find(SdoConnection::State::requested)) return open(*wanted);
  if (call_waits_) begin_scan();
  if (scanning_) scan();
}

}  // namespace canvoy
