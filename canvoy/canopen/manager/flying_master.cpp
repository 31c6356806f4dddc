#include "canvoy/canopen/manager/flying_master.hpp"

#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"

namespace canvoy {

namespace {

// Sub-indices of 1F90h, and their values if the object is absent.
constexpr std::uint8_t detection_sub = 1;
constexpr std::uint8_t waiting_sub = 2;
constexpr std::uint8_t priority_sub = 3;
constexpr std::uint8_t priority_slot_sub = 4;
constexpr std::uint8_t node_slot_sub = 5;
constexpr std::uint8_t cycle_sub = 6;
constexpr std::uint16_t detection_ms = 100;
constexpr std::uint16_t waiting_ms = 500;
constexpr std::uint16_t priority_level = 1;
constexpr std::uint16_t priority_slot_ms = 1500;
constexpr std::uint16_t node_slot_ms = 10;
constexpr std::uint16_t cycle_ms = 4000;
constexpr std::uint16_t capable_ms = 100;

}  // namespace

constexpr ServiceHandlers FlyingMaster::service_calls = {
    .reset = method<&FlyingMaster::reset>,
    .state_entered = method<&FlyingMaster::state_entered>,
    .error_changed = method<&FlyingMaster::error_changed>};

FlyingMaster::FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager)
    : FlyingMaster(node, commands, manager, Options{}) {}

FlyingMaster::FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager,
                           const Options& options)
    : node_(node),
      commands_(commands),
      manager_(manager),
      options_(options),
      timer_(callback<&FlyingMaster::expired>(*this)),
      capable_timer_(callback<&FlyingMaster::finding_over>(*this)) {
  for (const std::uint16_t can_id :
       {options_.active_master, options_.negotiation, options_.active_master_request,
        options_.capable_answer, options_.capable_request, options_.force_negotiation}) {
    node_.router().add(can_id, Router::Receiver::to<&FlyingMaster::received>(*this));
  }
  node_.attach(service_);
}

void FlyingMaster::reset(ResetScope) {
  node_.timers().disarm(timer_);
  node_.timers().disarm(capable_timer_);
  active_ = 0;
  was_reset_ = true;
  enter(State::off);
}

void FlyingMaster::state_entered(NmtState state) {
  if (state != NmtState::pre_operational || !std::exchange(was_reset_, false)) return;
  const NmtStartup startup = nmt_startup(node_.dictionary());
  if (!startup.is_master() || !startup.is_flying_master()) return;
  enter(State::waiting);
  wait(time(waiting_sub, waiting_ms) + node_slot());
}

/// The loss of the active master, by its heartbeat, or by life guarding, which has no node-ID. A
/// master that is heard again before this node's slot is not lost.
void FlyingMaster::error_changed(const Error& error, bool present) {
  if (state_ != State::slave || error.code != emergency_code::heartbeat) return;
  if (error.instance != active_ && error.instance != 0) return;
  present ? wait(node_slot()) : node_.timers().disarm(timer_);
}

void FlyingMaster::received(const Frame& frame, Time) {
  if (frame.id == options_.active_master) return active_master_told(frame);
  if (frame.length != 0) return node_.count_malformed();
  if (frame.id == options_.capable_request && nmt_startup(node_.dictionary()).is_master()) {
    return send(options_.capable_answer);
  }
  if (frame.id == options_.capable_answer && capable_timer_.armed()) return found_(true);
  if (state_ == State::off) return;
  if (frame.id == options_.negotiation) return negotiate(false);
  if (state_ != State::master) return;
  if (frame.id == options_.active_master_request) return tell_active();
  if (frame.id == options_.force_negotiation) return negotiate(true);
}

void FlyingMaster::active_master_told(const Frame& frame) {
  if (frame.length != 2 || !is_node_id(frame.data[1])) return node_.count_malformed();
  if (state_ == State::off) return;
  const NodeId other = frame.data[1];
  if (gives_way_to(frame.data[0], other)) return follow(other);
  send(options_.force_negotiation);
  negotiate(false);
}

/// Of two active masters with one priority, the lower node-ID stays.
bool FlyingMaster::gives_way_to(std::uint8_t other_priority, NodeId other) const {
  if (other_priority != priority()) return other_priority < priority();
  const bool compares = options_.node_id_forces || state_ == State::master;
  return !compares || other < node_.id();
}

void FlyingMaster::expired(Time) {
  switch (state_) {
    case State::waiting:
      return detect();
    case State::detecting:
      return nobody_found();
    case State::negotiating:
      return become_master();
    case State::slave:
      return reset_all();
    case State::master:
      send(options_.force_negotiation);
      return wait(time(cycle_sub, cycle_ms));
    default:
      return;
  }
}

void FlyingMaster::detect() {
  enter(State::detecting);
  send(options_.active_master_request);
  wait(time(detection_sub, detection_ms));
}

void FlyingMaster::nobody_found() {
  if (!options_.resets_all || has_reset_all_) return negotiate(true);
  reset_all();
}

void FlyingMaster::reset_all() {
  has_reset_all_ = true;
  commands_.add({NmtQueue::all_nodes, NmtCommand::reset_communication});
}

void FlyingMaster::negotiate(bool tells_others) {
  manager_.retire();
  active_ = 0;
  enter(State::negotiating);
  if (tells_others) send(options_.negotiation);
  wait(priority() * time(priority_slot_sub, priority_slot_ms) + node_slot());
}

void FlyingMaster::become_master() {
  active_ = node_.id();
  enter(State::master);
  tell_active();
  if (const Duration cycle = time(cycle_sub, cycle_ms); cycle != Duration::zero()) wait(cycle);
  manager_.become_master();
}

void FlyingMaster::follow(NodeId master) {
  node_.timers().disarm(timer_);
  manager_.retire();
  active_ = master;
  enter(State::slave);
}

void FlyingMaster::find_capable(Callback<void(bool)> found) {
  found_ = found;
  const auto ms = parameter(object_index::capable_master_timing, 1, capable_ms);
  node_.timers().arm(capable_timer_, node_.now() + std::chrono::milliseconds(ms));
  send(options_.capable_request);
}

void FlyingMaster::finding_over(Time) {
  found_(false);
}

void FlyingMaster::enter(State state) {
  if (state == state_) return;
  state_ = state;
  changed_(state);
}

void FlyingMaster::wait(Duration duration) {
  node_.timers().arm(timer_, node_.now() + duration);
}

void FlyingMaster::send(std::uint16_t can_id) {
  node_.transmitter().send(Frame::data_frame(can_id, {}));
}

void FlyingMaster::tell_active() {
  node_.transmitter().send(Frame::data_frame(options_.active_master, {priority(), node_.id()}));
}

std::uint16_t FlyingMaster::parameter(std::uint16_t index, std::uint8_t sub,
                                      std::uint16_t absent) const {
  return static_cast<std::uint16_t>(node_.dictionary().word(index, sub, absent));
}

Duration FlyingMaster::time(std::uint8_t sub, std::uint16_t absent) const {
  return std::chrono::milliseconds(parameter(object_index::flying_master_timing, sub, absent));
}

Duration FlyingMaster::node_slot() const {
  return node_.id() * time(node_slot_sub, node_slot_ms);
}

std::uint8_t FlyingMaster::priority() const {
  return static_cast<std::uint8_t>(
      parameter(object_index::flying_master_timing, priority_sub, priority_level));
}

}  // namespace canvoy
