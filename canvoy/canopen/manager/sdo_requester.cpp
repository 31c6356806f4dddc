#include "canvoy/canopen/manager/sdo_requester.hpp"

#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

// Sub-indices of 1280h and above:
constexpr std::uint8_t cob_id_request_sub = 1;
constexpr std::uint8_t cob_id_response_sub = 2;
constexpr std::uint8_t server_sub = 3;  // node-ID of the SDO server

constexpr std::uint16_t parameter_of(std::uint8_t client) {
  return static_cast<std::uint16_t>(sdo_client_parameter + client);
}

}  // namespace

constexpr AccessHandlers SdoRequester::hook_calls = {
    .first = dynamic_sdo::state,
    .last = dynamic_sdo::state,
    .after_write = method<&SdoRequester::after_write>};
constexpr ServiceHandlers SdoRequester::service_calls = {
    .state_entered = method<&SdoRequester::state_entered>, .hooks = {&hook_calls, 1}};

SdoRequester::SdoRequester(Node& node, const Settings& settings)
    : node_(node),
      settings_(settings),
      client_(node, settings.manager_client),
      timer_(callback<&SdoRequester::expired>(*this)) {
  node_.attach(service_);
}

bool SdoRequester::available() const {
  return is_node_id(node_.id()) && node_.dictionary().find(dynamic_sdo::state, 0) &&
         node_.dictionary().find(manager_parameter(), server_sub);
}

NodeId SdoRequester::manager() const {
  return static_cast<NodeId>(node_.dictionary().number(manager_parameter(), server_sub));
}

bool SdoRequester::registered() const {
  return is_node_id(manager()) && sdo_channel(node_.dictionary(), manager_parameter()).valid();
}

AbortCode SdoRequester::connect(NodeId server, std::uint8_t client, Done done) {
  const bool is_possible = is_node_id(server) && server != node_.id() &&
                           client != settings_.manager_client &&
                           node_.dictionary().find(parameter_of(client), server_sub);
  if (!is_possible) return AbortCode::no_sdo_connection;
  wanted_ = {.client_parameter = parameter_of(client), .device = node_.id(), .server = server};
  return begin(false, done);
}

AbortCode SdoRequester::connect_all(Done done) {
  return begin(true, done);
}

bool SdoRequester::may_speak() const {
  return node_.state() == NmtState::pre_operational || node_.state() == NmtState::operational;
}

AbortCode SdoRequester::begin(bool wants_all, Done done) {
  if (!available()) return AbortCode::no_sdo_connection;
  if (busy() || !may_speak()) return AbortCode::device_state;
  done_ = done;
  wants_all_ = wants_all;
  error_ = DynamicSdoError::none;
  is_kept_ = !wants_all && registered();
  if (is_kept_) return request();
  register_anew();
  return AbortCode::none;
}

void SdoRequester::register_anew() {
  is_kept_ = false;
  client_.cancel();
  close_manager_channel();
  ask_to_register();
  state_ = State::calling;
  calls_left_ = settings_.calls_max;
  call();
}

/// A valid channel would refuse other COB-IDs.
void SdoRequester::close_manager_channel() {
  if (!registered()) return;
  std::array<std::uint8_t, 4> closed{};
  store(closed.data(), CobId::bit31);
  for (const std::uint8_t sub : {cob_id_request_sub, cob_id_response_sub}) {
    const Result<Entry> entry = node_.dictionary().find(manager_parameter(), sub);
    if (entry) node_.dictionary().write(*entry, closed, Source::application);
  }
}

void SdoRequester::ask_to_register() {
  DynamicSdoState state;
  state.client_parameter = manager_parameter();
  state.wants_all = wants_all_;
  node_.dictionary().set_number(dynamic_sdo::state, 0, state.value());
}

/// The call has no node-ID: the SDO manager looks for a 1F10h with a request.
void SdoRequester::call() {
  --calls_left_;
  node_.timers().arm(timer_, node_.now() + settings_.time_out);
  node_.transmitter().send(Frame::data_frame(can_id::dynamic_sdo_request, {}));
}

AbortCode SdoRequester::request() {
  state_ = State::requesting;
  node_.timers().arm(timer_, node_.now() + settings_.time_out);
  if (send(dynamic_sdo::request, wanted_)) return AbortCode::none;
  state_ = State::idle;
  node_.timers().disarm(timer_);
  return AbortCode::no_sdo_connection;
}

bool SdoRequester::send(std::uint16_t index, const DynamicSdoRequest& request) {
  store(buffer_.data(), request.value());
  return client_.download(manager(), index, 0, std::span<const std::uint8_t>(buffer_),
                          SdoClient::Done::to<&SdoRequester::sent>(*this),
                          settings_.time_out) == AbortCode::none;
}

/// The answer to a request is 1F10h: the manager has work to do first.
void SdoRequester::sent(SdoClient::Outcome outcome) {
  if (state_ == State::releasing) state_ = State::idle;
  if (state_ != State::requesting || outcome) return;
  const bool is_stale =
      outcome.is_silence() || outcome == SdoEnd::by_server(AbortCode::device_state);
  if (is_kept_ && is_stale && may_speak()) return register_anew();
  finish(outcome);
}

void SdoRequester::after_write(const Entry& entry, Source source) {
  if (source != Source::sdo || !busy()) return;
  answered_by_manager(DynamicSdoState(load<std::uint32_t>(entry.value)));
}

void SdoRequester::answered_by_manager(const DynamicSdoState& answer) {
  using Status = DynamicSdoState::Status;
  const std::uint16_t expected =
      state_ == State::calling ? manager_parameter() : wanted_.client_parameter;
  if (answer.client_parameter != expected) {
    // Another message of the manager has replaced the request that it must find.
    if (state_ == State::calling) ask_to_register();
    return;
  }
  if (answer.status == Status::failed && answer.error != DynamicSdoError::none) {
    error_ = answer.error;
    return finish(SdoEnd::by_server(AbortCode::no_sdo_connection));
  }
  if (state_ == State::calling && answer.status == Status::registered && !wants_all_) {
    const AbortCode refused = registered() ? request() : AbortCode::no_sdo_connection;
    if (refused != AbortCode::none) finish(refused);
    return;
  }
  const bool all_given =
      state_ == State::calling && answer.status == Status::all_given && wants_all_;
  const bool connected = state_ == State::requesting && answer.status == Status::connected;
  if (all_given || connected) finish({});
}

bool SdoRequester::release(std::uint8_t client) {
  if (busy() || !registered()) return false;
  const auto server =
      static_cast<NodeId>(node_.dictionary().number(parameter_of(client), server_sub));
  if (!is_node_id(server)) return false;
  state_ = State::releasing;
  if (send(dynamic_sdo::release, {parameter_of(client), node_.id(), server})) return true;
  state_ = State::idle;
  return false;
}

bool SdoRequester::leave() {
  if (busy() || !registered()) return false;
  state_ = State::releasing;
  if (send(dynamic_sdo::release, {0, node_.id(), 0})) return true;
  state_ = State::idle;
  return false;
}

/// A connection that comes too late is returned, since it is not needed.
void SdoRequester::expired(Time) {
  if (state_ == State::calling && calls_left_ != 0) return call();
  if (state_ == State::requesting && is_kept_) return register_anew();
  const bool may_come = state_ == State::requesting;
  const DynamicSdoRequest late = wanted_;
  finish(SdoEnd::no_answer());
  if (!may_come || busy()) return;
  state_ = State::releasing;
  if (!send(dynamic_sdo::release, late)) state_ = State::idle;
}

void SdoRequester::state_entered(NmtState state) {
  if (state == NmtState::pre_operational || state == NmtState::operational || !busy()) return;
  finish(SdoEnd::cancelled(AbortCode::device_state));
}

/// Nothing is used after the callback, which may have started the next request.
void SdoRequester::finish(SdoEnd end) {
  const State was = std::exchange(state_, State::idle);
  node_.timers().disarm(timer_);
  if (was == State::releasing) return;
  if (!end) client_.cancel();
  const Done done = done_;
  done(end);
}

}  // namespace canvoy
