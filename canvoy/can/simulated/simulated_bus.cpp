#include "canvoy/can/simulated/simulated_bus.hpp"

#include <algorithm>
#include <span>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/arbitration.hpp"

namespace canvoy {
namespace {

SimulatedBusOptions within_limits(SimulatedBusOptions options) {
  const std::size_t most = ControllerSet::capacity;
  options.controllers_max = std::clamp<std::size_t>(options.controllers_max, 1, most);
  options.transmit_queue_max = std::max<std::size_t>(options.transmit_queue_max, 1);
  options.receive_queue_max = std::max<std::size_t>(options.receive_queue_max, 1);
  return options;
}

PendingFrame pending(const Frame& frame) {
  return {frame, arbitration_key(frame), frame_bits(frame)};
}

/// For two frames with the same arbitration field: true if the first is dominant in the first
/// different bit. All that follows is sent with the most significant bit first, which is the order
/// of numbers.
bool is_dominant(const Frame& a, const Frame& b) {
  return a.length != b.length ? a.length < b.length : a.data < b.data;
}

}  // namespace

SimulatedBus::SimulatedBus(const SimulatedBusOptions& options)
    : options_(within_limits(options)),
      controllers_(options_.controllers_max),
      plugs_(options_.controllers_max),
      transmit_storage_(options_.controllers_max * options_.transmit_queue_max),
      receive_storage_(options_.controllers_max * options_.receive_queue_max),
      cable_(options_.controllers_max, bit_time_ns(options_.bit_rate),
             to_ns(Time(options_.load_window))),
      contest_(options_.controllers_max),
      bit_times_(bit_time_ns(options_.bit_rate)),
      errors_(options_.seed, options_.faults),
      timeline_(options_.faults) {}

ControllerId SimulatedBus::attach(const ControllerOptions& options) {
  if (controller_count_ == controllers_.size()) return no_controller;
  const ControllerId id = static_cast<ControllerId>(controller_count_++);
  const std::size_t sends = options_.transmit_queue_max;
  const std::size_t receives = options_.receive_queue_max;
  controllers_[id] =
      Controller(id, options, std::span(transmit_storage_).subspan(id * sends, sends),
                 std::span(receive_storage_).subspan(id * receives, receives));
  plugs_[id] = {.bus = this, .id = id};
  errors_.set_misreading(id, Probability(options.misread_probability));
  if (options.accept_all) filters_.accept_all(id);
  contest_.resize(controller_count_);
  for (std::size_t i = 0; i < controller_count_; ++i) offer(controllers_[i]);
  bit_times_.set(id, options.bit_rate);
  participants_.update(controllers_[id]);
  cable_.layout().append(id);
  rewire();
  return id;
}

bool SimulatedBus::send(ControllerId id, const Frame& frame) {
  const std::uint32_t id_max = frame.is_extended() ? Frame::extended_id_max : Frame::id_max;
  if (frame.is_error() || frame.length > Frame::length_max || frame.id > id_max) return false;
  Controller& controller = at(id);
  if (!controller.queue(pending(frame))) return false;
  offer(controller);
  schedule(cable_.wire_of(id));
  return true;
}

void SimulatedBus::discard_pending(ControllerId id) {
  at(id).discard_pending();
  refresh(at(id));
}

Port SimulatedBus::port(ControllerId id) {
  assert(is_attached(id));
  return {.context = &plugs_[id],
          .send = [](void* context, const Frame& frame) -> bool {
            const Plug& plug = *static_cast<Plug*>(context);
            return plug.bus->send(plug.id, frame);
          },
          .accept =
              [](void* context, std::uint16_t can_id, bool wanted) {
                const Plug& plug = *static_cast<Plug*>(context);
                plug.bus->accept(plug.id, can_id, wanted);
              }};
}

Time SimulatedBus::step(Time until) {
  run(to_ns(until), true);
  return now();
}

// The hot path checks only whether the earliest event is due.
void SimulatedBus::run(std::int64_t limit_ns, bool stop_when_told) {
  has_told_ = is_interrupted_ = false;
  while (!is_interrupted_ && !(stop_when_told && has_told_)) {
    Wire& wire = cable_.earliest();
    const std::int64_t event_ns = std::min(wire.event_ns(), timeline_.next_ns());
    if (event_ns > limit_ns || event_ns == never_ns) {
      if (limit_ns != never_ns) now_ns_ = std::max(now_ns_, limit_ns);
      return;
    }
    now_ns_ = std::max(now_ns_, event_ns);
    if (timeline_.next_ns() <= event_ns) {
      apply_faults();
    } else {
      handle(wire);
    }
  }
}

void SimulatedBus::apply_faults() {
  const FaultsDue due = timeline_.take_next();
  if (is_attached(due.cut_after)) cut_cable(due.cut_after);
  if (is_attached(due.mend_after)) mend_cable();
  if (is_attached(due.babble)) babble(due.babble, timeline_.babble());
  if (is_attached(due.stop_babbling)) stop_babbling(due.stop_babbling);
}

void SimulatedBus::handle(Wire& wire) {
  switch (wire.phase()) {
    case Wire::Phase::idle:
      if (!recovery_.is_empty()) complete_recoveries(wire);
      wire.may_start(now_ns_) ? start_frame(wire) : schedule(wire);
      break;
    case Wire::Phase::frame:
      wire.has_failed(now_ns_) ? fail(wire) : deliver(wire);
      break;
    case Wire::Phase::last_bit:
      wire.has_failed(now_ns_) ? fail(wire) : finish(wire);
      break;
    case Wire::Phase::ended:
      break;
  }
}

void SimulatedBus::schedule(Wire& wire) {
  if (wire.phase() != Wire::Phase::idle) return;
  wire.await_start(contest_.contenders() & wire.members(), now_ns_);
  if (recovery_.is_empty()) return;
  // A higher bit rate may have moved the end of a recovery into the past.
  wire.wake_at(
      std::max(recovery_.next_ns(wire.members(), wire.recessive_since_ns(), bit_times_), now_ns_));
}

/// Enters the controller's next frame, if any, in the next arbitration.
void SimulatedBus::offer(const Controller& controller) {
  if (controller.wants_bus()) {
    contest_.enter(controller.id(), controller.head().key);
  } else {
    contest_.leave(controller.id());
  }
}

/// Updates a controller that may have gained or lost the ability to send or to receive.
void SimulatedBus::refresh(const Controller& controller) {
  participants_.update(controller);
  offer(controller);
  schedule(cable_.wire_of(controller.id()));
}

void SimulatedBus::start_frame(Wire& wire) {
  if (!recovery_.is_empty()) {
    recovery_.interrupt(wire.members(), wire.recessive_since_ns(), now_ns_, bit_times_);
  }
  const ControllerSet transmitters = elect(wire);
  const ControllerId leader = transmitters.first();
  check_invariant(leader != no_controller);
  wire.begin(controllers_[leader].head(), bit_times_.of(leader), now_ns_, transmitters,
             participants_.hearing());
  transmitters.for_each([this](ControllerId id) { controllers_[id].begin_sending(); });
  if (transmitters.has_several()) collide(wire);
  const ControllerSet deaf = errors_.plan(wire, participants_, bit_times_);
  deaf.for_each([this](ControllerId id) { count_receive_error(controllers_[id], false); });
  wire.await_delivery();
}

/// All ready controllers begin at once; one that sends a recessive bit and reads a dominant one
/// withdraws. Those with the lowest key remain: one, unless identifiers are used twice.
ControllerSet SimulatedBus::elect(Wire& wire) {
  const bool anybody_may = cable_.is_one_wire() && wire.suspended().empty();
  if (anybody_may) return contest_.winners();
  return contest_.winners_among(wire.admit(contest_.contenders(), now_ns_));
}

/// Several controllers send the same identifier. Equal frames continue as one. If they differ, the
/// one that sends a recessive bit detects a bit error: its error flag destroys the frame, or, if it
/// is error-passive, is invisible to the others and the controller withdraws. (It counts that at
/// the start of frame, not at the bit.)
void SimulatedBus::collide(Wire& wire) {
  const ControllerSet together = wire.transmitters();
  together.for_each([&](ControllerId id) {
    const PendingFrame& own = controllers_[id].head();
    if (is_dominant(own.frame, wire.current().frame)) wire.carry(own);
  });
  together.for_each([&](ControllerId id) {
    Controller& sender = controllers_[id];
    const unsigned bit = first_different_bit(sender.head().frame, wire.current().frame);
    if (bit == 0) return;
    if (participants_.flagging().contains(id)) {
      wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::bit, id);
      return;
    }
    wire.drop_out(id);
    count_transmit_error(sender, false);
  });
}

void SimulatedBus::deliver(Wire& wire) {
  wire.await_end();
  const Frame frame = wire.current().frame;
  const ControllerSet receivers = wire.receivers();
  const Time now = to_time(now_ns_);
  if (wire.will_be_acknowledged()) {
    observers_.frame_carried(now, wire.transmitters().first(), frame, wire.current().bits);
  }
  (receivers & filters_.accepting(frame)).for_each([&](ControllerId id) {
    hand_over(controllers_[id], now, frame);
  });
  (receivers & participants_.with_receive_errors()).for_each([this](ControllerId id) {
    Controller& controller = controllers_[id];
    const bool has_changed = controller.count_received();
    participants_.update(controller);
    if (has_changed) tell_state(controller);
  });
  if (bit_times_.are_mixed()) {
    const ControllerSet hearing = participants_.hearing() & wire.members();
    tell_error(bit_times_.other_than(wire.bit_ns(), hearing));
  }
}

inline void SimulatedBus::hand_over(Controller& controller, Time now, const Frame& frame) {
  const BusListener& listener = controller.listener();
  if (controller.take(frame)) return tell(listener.on_frame, listener.context, now, frame);
  observers_.frame_lost(now, controller.id());
  tell(listener.on_overrun, listener.context, now);
}

/// For the transmitter the frame is good at the end of the end of frame.
void SimulatedBus::finish(Wire& wire) {
  wire.end();
  const Frame frame = wire.current().frame;
  const ControllerSet transmitters = wire.transmitters();
  // A callback of one node may affect another one that sent the same frame.
  to_tell_ = transmitters;
  transmitters.for_each([this](ControllerId id) {
    controllers_[id].end_sending();
    offer(controllers_[id]);
  });
  transmitters.for_each([&](ControllerId id) { complete_transmission(controllers_[id], frame); });
  wire.turn_idle();
  schedule(wire);
}

void SimulatedBus::complete_transmission(Controller& controller, const Frame& frame) {
  const ControllerId id = controller.id();
  if (!to_tell_.contains(id)) return;
  if (controller.count_transmitted()) tell_state(controller);
  if (controller.state() == BusState::error_passive) cable_.wire_of(id).suspend(id);
  if (!to_tell_.contains(id) || controller.is_sending_babble()) return;
  tell(controller.listener().on_sent, controller.listener().context, to_time(now_ns_), frame);
}

/// Error flags of the controllers that detected the error, and of those that see it only in these
/// flags.
void SimulatedBus::fail(Wire& wire) {
  const bool receivers_have_it = wire.phase() == Wire::Phase::last_bit;
  const ControllerSet transmitters = wire.transmitters();
  // Controllers that withdrew from the frame are not receivers of it.
  const ControllerSet others =
      (participants_.acknowledging() & wire.members()) - transmitters - wire.suspended();
  const ControllerSet first = wire.detectors().empty() ? transmitters : wire.detectors();
  const bool is_echoed = !((participants_.flagging() & wire.members()) - first).empty();
  const bool is_unseen = wire.failure_kind() == BusErrorKind::acknowledgement && !is_echoed;
  wire.end_in_error(is_unseen ? wire.acknowledgement_ns() : now_ns_,
                    bit_times_.longest(first, wire.bit_ns()), is_echoed);
  observers_.frame_destroyed(to_time(now_ns_), wire.error(now_ns_));

  transmitters.for_each(
      [&](ControllerId id) { count_transmit_error(controllers_[id], is_unseen); });
  if (!receivers_have_it) {
    others.for_each([&](ControllerId id) {
      count_receive_error(controllers_[id], is_echoed && first.contains(id));
    });
    tell_error((participants_.hearing() & wire.members()) - transmitters);
  }
  schedule(wire);
}

/// Ends the part of a node in the frame on the wire.
void SimulatedBus::leave_frame(Controller& controller) {
  const ControllerId id = controller.id();
  Wire& wire = cable_.wire_of(id);
  if (!wire.is_busy()) return;
  wire.leave(id);
  wire.expect_acknowledgement(participants_.acknowledging(), now_ns_);
  if (!wire.transmitters().contains(id)) return;
  controller.break_off();
  offer(controller);
  wire.abandon(id, now_ns_);
}

void SimulatedBus::count_receive_error(Controller& controller, bool alone) {
  const bool has_changed = controller.count_receive_error(alone);
  participants_.update(controller);
  if (has_changed) tell_state(controller);
}

void SimulatedBus::count_transmit_error(Controller& controller, bool unacknowledged) {
  controller.break_off();
  offer(controller);
  if (controller.count_transmit_error(unacknowledged)) tell_state(controller);
  if (controller.state() != BusState::error_passive) return;
  cable_.wire_of(controller.id()).suspend(controller.id());
}

void SimulatedBus::complete_recoveries(const Wire& wire) {
  const ControllerSet completed =
      recovery_.take_completed(wire.members(), wire.recessive_since_ns(), now_ns_, bit_times_);
  completed.for_each([this](ControllerId id) {
    if (controllers_[id].restart_counters()) tell_state(controllers_[id]);
  });
}

void SimulatedBus::tell_state(Controller& controller) {
  const BusState state = controller.state();
  if (state == BusState::bus_off && controller.recovers_automatically()) {
    recovery_.begin(controller.id(), now_ns_);
  }
  refresh(controller);
  const Time now = to_time(now_ns_);
  observers_.state_changed(now, controller.id(), state);
  tell(controller.listener().on_state, controller.listener().context, now, state);
}

void SimulatedBus::tell_error(const ControllerSet& who) {
  who.for_each([this](ControllerId id) {
    const Controller& controller = controllers_[id];
    tell(controller.on_error(), controller.listener().context, to_time(now_ns_));
  });
}

void SimulatedBus::power(ControllerId id, bool on) {
  Controller& controller = at(id);
  if (controller.is_powered() == on) return;
  leave_frame(controller);
  controller.switch_power(on);
  recovery_.cancel(id);
  to_tell_.erase(id);
  refresh(controller);
}

void SimulatedBus::set_bit_rate(ControllerId id, std::uint32_t bit_rate) {
  leave_frame(at(id));
  bit_times_.set(id, bit_rate);
}

void SimulatedBus::set_listen_only(ControllerId id, bool on) {
  Controller& controller = at(id);
  if (on) leave_frame(controller);
  controller.set_listen_only(on);
  refresh(controller);
}

void SimulatedBus::recover(ControllerId id) {
  if (at(id).state() != BusState::bus_off || recovery_.is_under_way(id)) return;
  recovery_.begin(id, now_ns_);
  schedule(cable_.wire_of(id));
}

void SimulatedBus::babble(ControllerId id, const Frame& frame) {
  at(id).babble(pending(frame));
  refresh(at(id));
}

void SimulatedBus::stop_babbling(ControllerId id) {
  at(id).stop_babbling();
  refresh(at(id));
}

void SimulatedBus::cut_cable(ControllerId after) {
  cable_.layout().cut(at(after).id());
  rewire();
}

void SimulatedBus::mend_cable() {
  cable_.layout().mend();
  rewire();
}

void SimulatedBus::unplug(ControllerId id) {
  cable_.layout().unplug(at(id).id());
  rewire();
}

void SimulatedBus::plug(ControllerId id) {
  cable_.layout().plug(at(id).id());
  rewire();
}

/// Handles a change of the cable's layout.
void SimulatedBus::rewire() {
  cable_.frames_that_meet().for_each([this](ControllerId number) {
    Wire& wire = cable_.wires()[number];
    wire.spoil();
    fail(wire);
  });
  const Rewired rewired = cable_.rewire(now_ns_);
  rewired.cut_off.for_each([this](ControllerId id) {
    controllers_[id].break_off();
    offer(controllers_[id]);
  });
  for (Wire& wire : cable_.wires()) {
    wire.expect_acknowledgement(participants_.acknowledging(), now_ns_);
    if (!(wire.members() & rewired.interrupted).empty()) wire.hold_after_cut(now_ns_);
    schedule(wire);
  }
  (rewired.interrupted & participants_.acknowledging()).for_each([this](ControllerId id) {
    count_receive_error(controllers_[id], false);
  });
}

double SimulatedBus::load(ControllerId id) const {
  return controller_count_ == 0 ? 0 : cable_.wire_of(at(id).id()).load().recent(now_ns_);
}

double SimulatedBus::load_total(ControllerId id) const {
  return controller_count_ == 0 ? 0 : cable_.wire_of(at(id).id()).load().total(now_ns_);
}

}  // namespace canvoy
