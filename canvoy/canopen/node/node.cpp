#include "canvoy/canopen/node/node.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

/// A read before the start returns the default. On a small machine NMT needs no route.
void Node::begin() {
  dictionary_.restore_defaults(0x0000, 0xFFFF, node_id_);
  dictionary_.clear_changes();
  if constexpr (!is_small_machine) {
    router_.add(can_id::nmt, Router::Receiver::to<&Node::receive_nmt>(*this));
  }
}

template <>
void Node::start_on<is_small_machine>(Time now) {
  timers_.set_now(now);
  transmitter_.clear();
  if constexpr (is_small_machine) router_.filter(can_id::nmt, true);
  reset(ResetScope::node);
  announce_changes();
}

void Node::receive(const Frame& frame, Time now) {
  timers_.set_now(now);
  ++counters_.received;
  // Nearly all frames are plain: for them the router need not distinguish data from remote frames.
  if (!is_small_machine && frame.is_plain() && frame.id <= Frame::id_max) {
    if (!router_.dispatch(frame, now)) ++counters_.unwanted;
  } else {
    receive_odd(frame, now);
  }
  if (is_small_machine || dictionary_.changes() != 0) announce_changes();
}

inline void Node::receive_odd(const Frame& frame, Time now) {
  if (has(frame.flags, FrameFlags::extended | FrameFlags::error) || frame.id > Frame::id_max) {
    ++counters_.extended;
  } else if (!dispatch(frame, now)) {
    ++counters_.unwanted;
  }
}

std::uint32_t Node::elapsed_since(Time past) const {
  // Unsigned, since `past` may be any time.
  const auto elapsed = static_cast<std::uint64_t>(now().time_since_epoch().count()) -
                       static_cast<std::uint64_t>(past.time_since_epoch().count());
  return elapsed >> 32 == 0 ? static_cast<std::uint32_t>(elapsed) : UINT32_MAX;
}

[[gnu::always_inline]] inline bool Node::dispatch(const Frame& frame, Time now) {
  const bool is_wanted = router_.dispatch(frame, now);
  if constexpr (is_small_machine) {
    // It needs no route.
    if (frame.id == can_id::nmt && !frame.is_remote()) {
      receive_nmt(frame, now);
      return true;
    }
    return dictionary_.notify(ServiceEvent::frame_came, 0, &frame) != 0 || is_wanted;
  }
  return is_wanted;
}

void Node::advance(Time now) {
  timers_.set_now(now);
  timers_.run(now);
  if (is_small_machine || dictionary_.changes() != 0) announce_changes();
}

void Node::announce_changes() {
  ServiceEvent event{.kind = ServiceEvent::values_changed, .number = dictionary_.changes()};
  if constexpr (is_small_machine) {
    dictionary_.clear_changes();
    if (event.number != 0) dictionary_.notify(event);
    return;
  }
  if (event.number == 0) return;
  // Changes made during this notification belong to the next one.
  const ChangedPlaces places = dictionary_.changed_places();
  event.subject = &places;
  dictionary_.clear_changes();
  dictionary_.notify_frequent(event);
}

void Node::bus_state(BusState state, Time now) {
  timers_.set_now(now);
  if (state == bus_state_) return;
  const bool recovers = std::exchange(bus_state_, state) == BusState::bus_off;
  if (state == BusState::bus_off) {
    ++counters_.bus_off;
    transmitter_.clear();
  }
  dictionary_.notify(recovers ? ServiceEvent::bus_recovered : ServiceEvent::bus_state_changed,
                     static_cast<std::uint32_t>(state));
}

void Node::tx_ready(Time now) {
  timers_.set_now(now);
  transmitter_.flush();
  if (!is_small_machine && !transmitter_.is_awaited()) return;
  ServiceEvent event{.kind = ServiceEvent::tx_ready};
  for (NodeService* service = dictionary_.services(); service != nullptr && !transmitter_.full();
       service = service->next_) {
    service->notify(event);
  }
}

void Node::overrun(Time now) {
  timers_.set_now(now);
  ++counters_.overruns;
  raise({.code = emergency_code::can_overrun, .register_bits = error_register::communication});
}

void Node::report(const Error& error, bool is_present) {
  dictionary_.notify(is_present ? ServiceEvent::error_came : ServiceEvent::error_went, 0, &error);
}

inline void Node::receive_nmt(const Frame& frame, Time) {
  if (frame.length != 2) return count_malformed();
  const NodeId addressed = frame.data[1];
  if (addressed != 0 && addressed != node_id_) return;
  const auto wanted = static_cast<NmtCommand>(frame.data[0]);
  const bool resets = wanted == NmtCommand::reset_node || wanted == NmtCommand::reset_communication;
  // Frames that wait for the controller belong to the time before the reset, and would take the
  // room of the boot-up message.
  if (resets && state_ != NmtState::initialisation) transmitter_.clear();
  command(wanted);
}

void Node::command(NmtCommand command) {
  if (state_ == NmtState::initialisation) return;
  switch (command) {
    case NmtCommand::start:
      return enter(NmtState::operational);
    case NmtCommand::stop:
      return enter(NmtState::stopped);
    case NmtCommand::enter_pre_operational:
      return enter(NmtState::pre_operational);
    case NmtCommand::reset_node:
      return reset(ResetScope::node);
    case NmtCommand::reset_communication:
      return reset(ResetScope::communication);
  }
  count_malformed();
}

void Node::take_first_id() {
  if (state_ != NmtState::initialisation || !is_node_id(pending_id_)) return;
  reset(ResetScope::communication);
}

void Node::reset(ResetScope scope) {
  enter(NmtState::initialisation);
  if (scope == ResetScope::node) pending_id_ = power_on_id_;
  node_id_ = pending_id_;
  dictionary_.restore_defaults(
      scope == ResetScope::node ? 0x0000 : object_index::communication_first,
      scope == ResetScope::node ? 0xFFFF : object_index::communication_last, node_id_);
  defaults_restored_(scope);
  dictionary_.notify(ServiceEvent::reset, static_cast<std::uint32_t>(scope));
  if (!is_node_id(node_id_)) return;
  send_state();
  enter(NmtState::pre_operational);
  // Unless a service has left the state at once.
  if (autostart_ && state_ == NmtState::pre_operational) enter(NmtState::operational);
}

void Node::send_state() {
  const auto state = static_cast<std::uint8_t>(state_);
  transmitter_.send(static_cast<std::uint16_t>(can_id::error_control + node_id_), {&state, 1});
}

void Node::enter(NmtState state) {
  if (state == state_) return;
  state_ = state;
  // A small node drops its PDOs only.
  if (!is_small_machine && state == NmtState::stopped) transmitter_.drop_what_stopped_forbids();
  ServiceEvent event{.kind = ServiceEvent::state_entered,
                     .number = static_cast<std::uint32_t>(state)};
  for (NodeService* service = dictionary_.services(); service != nullptr;
       service = service->next_) {
    service->notify(event);
    // A service that commanded another state has caused its notification.
    if (state_ != state) return;
  }
}

}  // namespace canvoy
