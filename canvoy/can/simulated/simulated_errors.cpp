// Errors on the simulated bus: what goes wrong with a frame, error frames, fault confinement,
// bus-off and the way back.
//
// An error is decided at the start of a frame, as the bit at the end of which somebody detects it.
// From there: an error flag of six bits (dominant of an error-active controller, recessive of an
// error-passive one), six more bits of those who see an error only in that flag, eight recessive
// bits of delimiter, three of intermission.
#include <algorithm>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"

namespace canvoy {
namespace {

constexpr unsigned error_flag_bits = 6;
constexpr unsigned error_delimiter_bits = 8;
constexpr unsigned stuff_error_bits = 6;  // so many equal bits are an error
constexpr std::uint32_t recovery_sequences = 128;
constexpr unsigned recovery_sequence_bits = 11;

}  // namespace

void SimulatedBus::plan_errors(Wire& wire) {
  if (has_mixed_rates_) plan_foreign_rates(wire);
  if (!misreading_.empty()) plan_misreading(wire);
  if ((wire.receivers & acknowledging_).empty()) plan_missing_acknowledgement(wire);
  if (has_disturbances_) plan_disturbance(wire);
}

/// The error flag of an error-passive transmitter is recessive, as the end of a frame is: who only
/// listens has the frame, before the failure is over.
void SimulatedBus::plan_missing_acknowledgement(Wire& wire) {
  const bool unseen = !wire.receivers.empty() && (wire.transmitters & flagging_).empty();
  wire.plan_failure(unseen ? wire.bit_end_ns(wire.current.bits) : wire.acknowledgement_ns(),
                    BusErrorKind::acknowledgement, no_controller);
}

/// A controller on another bit rate cannot read the frame. It is taken to see six equal bits in the
/// first six bit times, its own or those of the sender, whichever are longer; at the latest it
/// destroys the acknowledgement.
void SimulatedBus::plan_foreign_rates(Wire& wire) {
  (wire.members & hearing_).for_each([&](ControllerId id) {
    Controller& controller = controllers_[id];
    if (controller.bit_ns == wire.bit_ns) return;
    wire.receivers.erase(id);
    if (!acknowledging_.contains(id)) return;
    const std::int64_t seen_ns =
        wire.begin_ns + stuff_error_bits * std::max(controller.bit_ns, wire.bit_ns);
    const bool is_sending = wire.transmitters.contains(id);
    if (is_sending || flagging_.contains(id)) {
      wire.plan_failure(std::min(seen_ns, wire.acknowledgement_ns()),
                        is_sending ? BusErrorKind::bit : BusErrorKind::stuff, id);
    } else {
      count_receive_error(controller, false);
    }
  });
}

/// A controller that misreads a frame destroys it for all, unless it is error-passive or only
/// listens: then it alone does not have it.
void SimulatedBus::plan_misreading(Wire& wire) {
  (wire.receivers & misreading_).for_each([&](ControllerId id) {
    Controller& controller = controllers_[id];
    if (!random_.happens(controller.misreads)) return;
    const unsigned bit = 1 + random_.below(wire.current.bits - 1);
    if (flagging_.contains(id)) {
      wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::stuff, id);
      return;
    }
    wire.receivers.erase(id);
    if (acknowledging_.contains(id)) count_receive_error(controller, false);
  });
}

void SimulatedBus::plan_disturbance(Wire& wire) {
  const unsigned bits = wire.current.bits;
  if (disturbances_left_ > 0) {
    --disturbances_left_;
    wire.plan_failure(wire.bit_end_ns(std::min(disturbed_bit_, bits)), BusErrorKind::bit,
                      no_controller);
  }
  if (random_.happens(frame_error_)) {
    const unsigned bit = 1 + random_.below(bits);
    wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::bit, no_controller);
  }
  if (bit_error_by_.empty()) return;
  const std::uint64_t drawn = random_.next();
  if (drawn >= bit_error_by_[bits]) return;
  const auto hit = std::upper_bound(bit_error_by_.begin(), bit_error_by_.end(), drawn);
  const unsigned bit = static_cast<unsigned>(hit - bit_error_by_.begin());
  wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::bit, no_controller);
}

void SimulatedBus::disturb(std::uint32_t frames, unsigned bit) {
  disturbances_left_ = frames;
  disturbed_bit_ = std::max(bit, 1U);
  has_disturbances_ = true;
}

void SimulatedBus::set_frame_error_probability(double probability) {
  frame_error_ = Probability(probability);
  has_disturbances_ = true;
}

void SimulatedBus::fail(Wire& wire) {
  const bool receivers_have_it = wire.phase == Wire::Phase::last_bit;
  const ControllerSet transmitters = wire.transmitters;
  // Those that have dropped out of the frame are no receivers of it.
  const ControllerSet others = (acknowledging_ & wire.members) - transmitters - wire.suspended;
  const ControllerSet first = wire.detectors.empty() ? transmitters : wire.detectors;
  std::int64_t flag_bit_ns = wire.bit_ns;
  first.for_each(
      [&](ControllerId id) { flag_bit_ns = std::max(flag_bit_ns, controllers_[id].bit_ns); });
  const bool is_echoed = !((flagging_ & wire.members) - first).empty();

  const bool unseen = wire.failure_kind == BusErrorKind::acknowledgement && !is_echoed;
  const std::int64_t detected_ns = unseen ? wire.acknowledgement_ns() : now_ns_;
  wire.phase = Wire::Phase::idle;
  wire.recessive_since_ns = detected_ns + error_flag_bits * flag_bit_ns;
  if (is_echoed) wire.recessive_since_ns += error_flag_bits * wire.bit_ns;
  wire.free_ns = wire.recessive_since_ns + (error_delimiter_bits + intermission_bits) * wire.bit_ns;
  wire.load.add(wire.begin_ns, wire.free_ns);
  ++statistics_.error_frames;
  tell_error(wire);

  transmitters.for_each([&](ControllerId id) { count_transmit_error(controllers_[id], unseen); });
  if (!receivers_have_it) {
    others.for_each([&](ControllerId id) {
      count_receive_error(controllers_[id], is_echoed && first.contains(id));
    });
    tell_listeners_of_error((hearing_ & wire.members) - transmitters);
  }
  schedule(wire);
}

void SimulatedBus::tell_listeners_of_error(const ControllerSet& who) {
  who.for_each([this](ControllerId id) {
    const Controller& controller = controllers_[id];
    if (controller.on_error == nullptr) return;
    has_told_ = true;
    controller.on_error(controller.listener.context, to_time(now_ns_));
  });
}

void SimulatedBus::tell_error(const Wire& wire) {
  const std::int64_t bits_sent = (now_ns_ - wire.begin_ns) / wire.bit_ns;
  const BusError error{.kind = wire.failure_kind,
                       .sender = wire.transmitters.first(),
                       .detector = wire.detectors.first(),
                       .bit = static_cast<unsigned>(bits_sent),
                       .frame = wire.current.frame};
  for (std::size_t i = 0; i < tap_count_; ++i) {
    if (taps_[i].on_error != nullptr) taps_[i].on_error(taps_[i].context, to_time(now_ns_), error);
  }
}

void SimulatedBus::count_receive_error(Controller& controller, bool alone) {
  ++controller.statistics.receive_errors;
  controller.counters.receive_error();
  if (alone) controller.counters.receive_error_alone();
  with_receive_errors_.insert(controller.id);
  update_state(controller);
}

void SimulatedBus::count_transmit_error(Controller& controller, bool unacknowledged) {
  ++controller.statistics.transmit_errors;
  if (unacknowledged) {
    controller.counters.acknowledgement_missing();
  } else {
    controller.counters.transmit_error();
  }
  if (!controller.is_sending_babble) controller.to_send.unlock();
  offer(controller);
  update_state(controller);
  if (controller.state == BusState::error_passive) {
    wires_[controller.wire].suspended.insert(controller.id);
  }
}

void SimulatedBus::update_state(Controller& controller) {
  const BusState state = controller.counters.state();
  if (state == controller.state) return;
  controller.state = state;
  if (state == BusState::bus_off && controller.recovers_automatically) begin_recovery(controller);
  refresh(controller);
  const Time now = to_time(now_ns_);
  for (std::size_t i = 0; i < tap_count_; ++i) {
    const BusTap& tap = taps_[i];
    if (tap.on_state != nullptr) tap.on_state(tap.context, now, controller.id, state);
  }
  const BusListener& listener = controller.listener;
  if (listener.on_state == nullptr) return;
  has_told_ = true;
  listener.on_state(listener.context, now, state);
}

void SimulatedBus::recover(ControllerId id) {
  Controller& controller = at(id);
  if (controller.state != BusState::bus_off || recovering_.contains(id)) return;
  begin_recovery(controller);
  schedule(wires_[controller.wire]);
}

void SimulatedBus::begin_recovery(Controller& controller) {
  recovering_.insert(controller.id);
  controller.recovery_sequences_left = recovery_sequences;
  controller.recovery_counted_to_ns = now_ns_;
}

std::int64_t SimulatedBus::next_recovery_ns(const Wire& wire) const {
  std::int64_t next_ns = never_ns;
  (recovering_ & wire.members).for_each([&](ControllerId id) {
    next_ns = std::min(next_ns, controllers_[id].recovery_end_ns(wire.recessive_since_ns));
  });
  return next_ns;
}

/// A frame begins: what is left of eleven recessive bits does not count.
void SimulatedBus::count_recessive_bits(const Wire& wire) {
  (recovering_ & wire.members).for_each([&](ControllerId id) {
    Controller& controller = controllers_[id];
    const std::int64_t from_ns =
        std::max(wire.recessive_since_ns, controller.recovery_counted_to_ns);
    const std::int64_t seen = (now_ns_ - from_ns) / (recovery_sequence_bits * controller.bit_ns);
    controller.recovery_sequences_left -= static_cast<std::uint32_t>(seen);
    controller.recovery_counted_to_ns = now_ns_;
  });
}

void SimulatedBus::complete_recoveries(const Wire& wire) {
  (recovering_ & wire.members).for_each([&](ControllerId id) {
    Controller& controller = controllers_[id];
    if (controller.recovery_end_ns(wire.recessive_since_ns) > now_ns_) return;
    recovering_.erase(id);
    controller.counters.restart();
    update_state(controller);
  });
}

}  // namespace canvoy
