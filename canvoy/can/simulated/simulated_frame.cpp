// The life of a frame on the simulated bus: arbitration, delivery, end of frame.
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"

namespace canvoy {
namespace {

/// Of two frames with the same arbitration field: whether the first is dominant in the bit in which
/// they differ. All that follows is sent with the most significant bit first, so that is the order
/// of numbers.
bool is_dominant(const Frame& a, const Frame& b) {
  return a.length != b.length ? a.length < b.length : a.data < b.data;
}

}  // namespace

void SimulatedBus::start_frame(Wire& wire) {
  if (!recovering_.empty()) count_recessive_bits(wire);
  elect(wire);
  const Controller& leader = controllers_[wire.transmitters.first()];
  wire.phase = Wire::Phase::frame;
  wire.current = leader.head();
  wire.begin_ns = now_ns_;
  wire.bit_ns = leader.bit_ns;
  wire.failure_ns = never_ns;
  wire.detectors.clear();
  wire.receivers = (hearing_ & wire.members) - wire.transmitters;
  wire.transmitters.for_each([this](ControllerId id) {
    Controller& sender = controllers_[id];
    sender.is_sending_babble = sender.is_babbling;
    if (!sender.is_babbling) sender.to_send.lock();
  });
  if (wire.transmitters.has_several()) collide(wire);
  plan_errors(wire);
  wire.event_ns = std::min(wire.failure_ns, wire.bit_end_ns(wire.current.bits - 1));
}

/// All that are ready begin at once; who sends a recessive bit and reads a dominant one withdraws.
/// Left are those with the lowest key: one, unless identifiers are used twice.
void SimulatedBus::elect(Wire& wire) {
  const bool anybody_may = wires_used_ == 1 && wire.suspended.empty();
  if (anybody_may) {
    wire.transmitters = contest_.winners();
    return;
  }
  ControllerSet contenders = contest_.contenders() & wire.members;
  if (now_ns_ < wire.suspended_until_ns()) contenders = contenders - wire.suspended;
  wire.transmitters = contest_.winners_among(contenders);
  wire.suspended.clear();
}

/// Several controllers send the same identifier. Equal frames go on as one. Where they differ, the
/// one that sends a recessive bit sees a bit error: its error flag destroys the frame, or, if it is
/// error-passive, is not seen by anyone and it drops out. (It counts that at the start of frame,
/// not at the bit.)
void SimulatedBus::collide(Wire& wire) {
  const ControllerSet together = wire.transmitters;
  together.for_each([&](ControllerId id) {
    const PendingFrame& own = controllers_[id].head();
    if (is_dominant(own.frame, wire.current.frame)) wire.current = own;
  });
  together.for_each([&](ControllerId id) {
    Controller& sender = controllers_[id];
    const unsigned bit = first_different_bit(sender.head().frame, wire.current.frame);
    if (bit == 0) return;
    if (flagging_.contains(id)) {
      wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::bit, id);
      return;
    }
    wire.transmitters.erase(id);
    wire.suspended.insert(id);
    count_transmit_error(sender, false);
  });
}

/// Receivers have the frame when all but the last bit of the end of frame are seen.
void SimulatedBus::deliver(Wire& wire) {
  wire.phase = Wire::Phase::last_bit;
  wire.event_ns = wire.bit_end_ns(wire.current.bits);
  const Frame frame = wire.current.frame;
  const ControllerSet receivers = wire.receivers;
  const ControllerSet& accepting = frame.is_extended() ? accepting_extended_ : accepting_[frame.id];
  const Time now = to_time(now_ns_);
  const bool is_acknowledged =
      wire.failure_ns == never_ns || wire.failure_kind != BusErrorKind::acknowledgement;
  if (is_acknowledged) tell_taps(wire, now);
  (receivers & accepting).for_each([&](ControllerId id) {
    hand_over(controllers_[id], now, frame);
  });
  (receivers & with_receive_errors_).for_each([this](ControllerId id) {
    Controller& controller = controllers_[id];
    controller.counters.received();
    if (controller.counters.receive() == 0) with_receive_errors_.erase(id);
    update_state(controller);
  });
  if (has_mixed_rates_) tell_listeners_of_error(with_foreign_rate(wire));
}

void SimulatedBus::tell_taps(const Wire& wire, Time now) {
  ++statistics_.frames;
  statistics_.frame_bits += wire.current.bits;
  for (std::size_t i = 0; i < tap_count_; ++i) {
    const BusTap& tap = taps_[i];
    if (tap.on_frame == nullptr) continue;
    tap.on_frame(tap.context, now, wire.transmitters.first(), wire.current.frame);
  }
}

ControllerSet SimulatedBus::with_foreign_rate(const Wire& wire) const {
  ControllerSet foreign;
  (hearing_ & wire.members).for_each([&](ControllerId id) {
    foreign.assign(id, controllers_[id].bit_ns != wire.bit_ns);
  });
  return foreign;
}

void SimulatedBus::hand_over(Controller& controller, Time now, const Frame& frame) {
  const BusListener& listener = controller.listener;
  if (!controller.queues_received) {
    ++controller.statistics.received;
    if (listener.on_frame == nullptr) return;
    has_told_ = true;
    listener.on_frame(listener.context, now, frame);
    return;
  }
  if (controller.received.push(frame)) {
    ++controller.statistics.received;
    return;
  }
  ++controller.statistics.overruns;
  controller.has_overrun = true;
  for (std::size_t i = 0; i < tap_count_; ++i) {
    if (taps_[i].on_overrun != nullptr) taps_[i].on_overrun(taps_[i].context, now, controller.id);
  }
  if (listener.on_overrun == nullptr) return;
  has_told_ = true;
  listener.on_overrun(listener.context, now);
}

/// For the transmitter the frame is good when the end of frame is over.
void SimulatedBus::finish(Wire& wire) {
  wire.phase = Wire::Phase::ended;
  wire.free_ns = wire.bit_end_ns(wire.current.bits + intermission_bits);
  wire.recessive_since_ns = wire.acknowledgement_ns();
  wire.load.add(wire.begin_ns, wire.free_ns);
  const Frame frame = wire.current.frame;
  const ControllerSet transmitters = wire.transmitters;
  // What one node does when it is told may be about another one that sent the same frame.
  to_tell_ = transmitters;
  transmitters.for_each([this](ControllerId id) { take_from_queue(controllers_[id]); });
  transmitters.for_each([&](ControllerId id) { complete_transmission(controllers_[id], frame); });
  wire.phase = Wire::Phase::idle;
  schedule(wire);
}

void SimulatedBus::take_from_queue(Controller& controller) {
  if (!controller.is_sending_babble) controller.to_send.pop();
  ++controller.statistics.sent;
  offer(controller);
}

void SimulatedBus::complete_transmission(Controller& controller, const Frame& frame) {
  if (!to_tell_.contains(controller.id)) return;
  if (controller.counters.transmit() > 0) {
    controller.counters.transmitted();
    update_state(controller);
  }
  if (controller.state == BusState::error_passive) {
    wires_[controller.wire].suspended.insert(controller.id);
  }
  const BusListener& listener = controller.listener;
  const bool is_told = to_tell_.contains(controller.id) && !controller.is_sending_babble;
  if (!is_told || listener.on_sent == nullptr) return;
  has_told_ = true;
  listener.on_sent(listener.context, to_time(now_ns_), frame);
}

}  // namespace canvoy
