#include "canvoy/can/simulated/simulated_bus.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/arbitration.hpp"

namespace canvoy {
namespace {

constexpr std::size_t identifiers = Frame::id_max + std::size_t{1};

SimulatedBusOptions within_limits(SimulatedBusOptions options) {
  const std::size_t most = ControllerSet::capacity;
  options.controllers_max = std::clamp<std::size_t>(options.controllers_max, 1, most);
  options.transmit_queue_max = std::max<std::size_t>(options.transmit_queue_max, 1);
  options.receive_queue_max = std::max<std::size_t>(options.receive_queue_max, 1);
  return options;
}

/// For each n the threshold of an error in one of the first n bits. In integers, so that it is the
/// same everywhere.
void fill_bit_errors(std::vector<std::uint64_t>& by_bit, Probability rate) {
  std::uint64_t unharmed = ~std::uint64_t{0};
  for (std::uint64_t& threshold : by_bit) {
    threshold = ~unharmed;
    const std::uint64_t high = (unharmed >> 32) * (rate.threshold() >> 32);
    const std::uint64_t low = ((unharmed >> 32) * (rate.threshold() & 0xFFFF'FFFF)) >> 32;
    unharmed -= std::min(unharmed, high + low);
  }
}

}  // namespace

SimulatedBus::SimulatedBus(const SimulatedBusOptions& options)
    : controllers_(within_limits(options).controllers_max),
      wires_(controllers_.size()),
      transmit_storage_(controllers_.size() * within_limits(options).transmit_queue_max),
      receive_storage_(controllers_.size() * within_limits(options).receive_queue_max),
      accepting_(identifiers),
      contest_(controllers_.size()),
      options_(within_limits(options)),
      random_(options.seed),
      frame_error_(options.faults.frame_error_probability) {
  for (Wire& wire : wires_) {
    wire.bit_ns = bit_time_ns(options_.bit_rate);
    wire.load = BusLoad(to_ns(Time(options_.load_window)));
  }
  const Probability bit_error_rate(options_.faults.bit_error_rate);
  if (!bit_error_rate.is_zero()) {
    bit_error_by_.resize(frame_bits_max + 1);
    fill_bit_errors(bit_error_by_, bit_error_rate);
  }
  has_disturbances_ = !frame_error_.is_zero() || !bit_error_by_.empty();
  fault_ns_ = next_fault_after(-1);
}

ControllerId SimulatedBus::attach(const ControllerOptions& options) {
  if (controller_count_ == controllers_.size()) return no_controller;
  const ControllerId id = static_cast<ControllerId>(controller_count_++);
  const std::span sends(transmit_storage_);
  const std::span receives(receive_storage_);
  Controller& controller = controllers_[id];
  controller.bus = this;
  controller.id = id;
  controller.listener = options.listener;
  controller.on_error = options.on_error;
  controller.to_send =
      TransmitQueue(sends.subspan(id * options_.transmit_queue_max, options_.transmit_queue_max),
                    options.transmit_order);
  controller.received =
      ReceiveQueue(receives.subspan(id * options_.receive_queue_max, options_.receive_queue_max));
  controller.is_listen_only = options.listen_only;
  controller.queues_received = options.queue_received;
  controller.recovers_automatically = options.recover_automatically;
  controller.misreads = Probability(options.misread_probability);
  controller.clock = DriftingClock(options.clock_drift_ppm);
  misreading_.assign(id, !controller.misreads.is_zero());
  if (options.accept_all) {
    for (ControllerSet& accepting : accepting_) accepting.insert(id);
    accepting_extended_.insert(id);
  }
  contest_.resize(controller_count_);
  for (std::size_t i = 0; i < controller_count_; ++i) offer(controllers_[i]);
  set_bit_rate(id, options.bit_rate);
  refresh(controller);
  rewire();
  return id;
}

bool SimulatedBus::observe(const BusTap& tap) {
  if (tap_count_ == taps_max) return false;
  taps_[tap_count_++] = tap;
  return true;
}

bool SimulatedBus::send(ControllerId id, const Frame& frame) {
  const std::uint32_t id_max = frame.is_extended() ? Frame::extended_id_max : Frame::id_max;
  if (frame.is_error() || frame.length > Frame::length_max || frame.id > id_max) return false;
  Controller& controller = at(id);
  if (!controller.is_powered || controller.is_listen_only) return false;
  if (!controller.to_send.push({frame, arbitration_key(frame), frame_bits(frame)})) return false;
  offer(controller);
  schedule(wires_[controller.wire]);
  return true;
}

bool SimulatedBus::receive(ControllerId id, Frame& frame) {
  return at(id).received.pop(frame);
}

void SimulatedBus::discard_pending(ControllerId id) {
  at(id).to_send.clear();
  refresh(at(id));
}

void SimulatedBus::accept(ControllerId id, std::uint16_t can_id, bool wanted) {
  if (can_id < identifiers) accepting_[can_id].assign(id, wanted);
}

void SimulatedBus::accept_extended(ControllerId id, bool wanted) {
  accepting_extended_.assign(id, wanted);
}

Port SimulatedBus::port(ControllerId id) {
  return {.context = &at(id),
          .send = [](void* context, const Frame& frame) -> bool {
            Controller& controller = *static_cast<Controller*>(context);
            return controller.bus->send(controller.id, frame);
          },
          .accept =
              [](void* context, std::uint16_t can_id, bool wanted) {
                Controller& controller = *static_cast<Controller*>(context);
                controller.bus->accept(controller.id, can_id, wanted);
              }};
}

Time SimulatedBus::now() const {
  return to_time(now_ns_);
}

std::int64_t SimulatedBus::next_event_of_pieces_ns() const {
  std::int64_t next_ns = fault_ns_;
  for (std::size_t i = 0; i < wires_used_; ++i) next_ns = std::min(next_ns, wires_[i].event_ns);
  return next_ns;
}

Time SimulatedBus::step(Time until) {
  run(to_ns(until), true);
  return now();
}

SimulatedBus::Wire& SimulatedBus::earliest_of_pieces() {
  Wire* earliest = &wires_[0];
  for (std::size_t i = 1; i < wires_used_; ++i) {
    if (wires_[i].event_ns < earliest->event_ns) earliest = &wires_[i];
  }
  return *earliest;
}

// All that is asked of the hot path: of the earliest event, whether it is due.
void SimulatedBus::run(std::int64_t limit_ns, bool stop_when_told) {
  has_told_ = is_interrupted_ = false;
  while (!is_interrupted_ && !(stop_when_told && has_told_)) {
    Wire& wire = earliest_wire();
    const std::int64_t event_ns = std::min(wire.event_ns, fault_ns_);
    if (event_ns > limit_ns || event_ns == never_ns) {
      if (limit_ns != never_ns) now_ns_ = std::max(now_ns_, limit_ns);
      return;
    }
    now_ns_ = std::max(now_ns_, event_ns);
    if (fault_ns_ <= event_ns) {
      apply_fault();
    } else {
      handle(wire);
    }
  }
}

void SimulatedBus::handle(Wire& wire) {
  switch (wire.phase) {
    case Wire::Phase::idle:
      if (!recovering_.empty()) complete_recoveries(wire);
      wire.start_ns <= now_ns_ ? start_frame(wire) : schedule(wire);
      break;
    case Wire::Phase::frame:
      wire.failure_ns <= now_ns_ ? fail(wire) : deliver(wire);
      break;
    case Wire::Phase::last_bit:
      wire.failure_ns <= now_ns_ ? fail(wire) : finish(wire);
      break;
    case Wire::Phase::ended:
      break;
  }
}

void SimulatedBus::schedule(Wire& wire) {
  if (wire.phase != Wire::Phase::idle) return;
  const ControllerSet ready = contest_.contenders() & wire.members;
  wire.start_ns = never_ns;
  if (!ready.empty()) {
    const bool is_suspended = (ready - wire.suspended).empty();
    const std::int64_t free_ns = is_suspended ? wire.suspended_until_ns() : wire.free_ns;
    wire.start_ns = std::max(free_ns, now_ns_);
  }
  wire.event_ns = wire.start_ns;
  if (recovering_.empty()) return;
  // A bit rate that became higher may have put the end of a recovery into the past.
  wire.event_ns = std::min(wire.event_ns, std::max(next_recovery_ns(wire), now_ns_));
}

/// What the controller has to send, if anything, takes part in the next arbitration.
void SimulatedBus::offer(const Controller& controller) {
  if (controller.may_send() && controller.has_pending()) {
    contest_.enter(controller.id, controller.head().key);
  } else {
    contest_.leave(controller.id);
  }
}

void SimulatedBus::refresh(Controller& controller) {
  const ControllerId id = controller.id;
  const bool hears = controller.is_powered && controller.state != BusState::bus_off;
  hearing_.assign(id, hears);
  acknowledging_.assign(id, hears && !controller.is_listen_only);
  flagging_.assign(id, acknowledging_.contains(id) && is_error_active(controller.state));
  with_receive_errors_.assign(id, acknowledging_.contains(id) && controller.counters.receive() > 0);
  offer(controller);
  schedule(wires_[controller.wire]);
}

BusState SimulatedBus::state(ControllerId id) const {
  return at(id).state;
}

const ErrorCounters& SimulatedBus::error_counters(ControllerId id) const {
  return at(id).counters;
}

const ControllerStatistics& SimulatedBus::statistics(ControllerId id) const {
  return at(id).statistics;
}

bool SimulatedBus::take_overrun(ControllerId id) {
  return std::exchange(at(id).has_overrun, false);
}

const DriftingClock& SimulatedBus::clock(ControllerId id) const {
  return at(id).clock;
}

double SimulatedBus::load(ControllerId id) const {
  return controller_count_ == 0 ? 0 : wires_[at(id).wire].load.recent(now_ns_);
}

double SimulatedBus::load_total(ControllerId id) const {
  return controller_count_ == 0 ? 0 : wires_[at(id).wire].load.total(now_ns_);
}

}  // namespace canvoy
