// A CAN bus in virtual time: arbitration, acknowledgement, errors, fault confinement and load of a
// real one, without a clock, a thread or an operating system (ISO 11898-1).
//
//     SimulatedBus bus({.bit_rate = 125'000, .seed = 1});
//     ControllerId node = bus.attach({.listener = {.context = &state, .on_frame = handle}});
//     bus.send(node, Frame::data_frame(0x705, {5}));
//     while (bus.next_event() <= end) bus.advance(bus.next_event());
//
// It is deterministic: the same options and the same calls give the same frames at the same times.
// All memory is allocated by the constructor. Before nodes act at a time, advance() the bus to that
// time. Calls are allowed within listeners, except attach(), advance(), step() and those that
// change the cable.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/acceptance_filters.hpp"
#include "canvoy/can/simulated/arbitration_contest.hpp"
#include "canvoy/can/simulated/bit_times.hpp"
#include "canvoy/can/simulated/bus_faults.hpp"
#include "canvoy/can/simulated/bus_observers.hpp"
#include "canvoy/can/simulated/bus_off_recovery.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/drifting_clock.hpp"
#include "canvoy/can/simulated/fault_timeline.hpp"
#include "canvoy/can/simulated/frame_errors.hpp"
#include "canvoy/can/simulated/participants.hpp"
#include "canvoy/can/simulated/simulated_cable.hpp"
#include "canvoy/can/simulated/simulated_controller.hpp"
#include "canvoy/can/simulated/simulated_wire.hpp"
#include "canvoy/can/simulated/wire_time.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Options of a bus; the defaults are a healthy bus of 125 kbit/s.
struct SimulatedBusOptions {
  /// Bit/s, 1000 to 1'000'000, for controllers without their own.
  std::uint32_t bit_rate = 125'000;
  std::size_t controllers_max = 127;    ///< 1 to ControllerSet::capacity
  std::size_t transmit_queue_max = 32;  ///< frames, for each controller
  std::size_t receive_queue_max = 32;   ///< frames, for each controller with `queue_received`
  Duration load_window = 1s;            ///< time span of load()
  BusFaults faults{};                   ///< present from the start, or at their times
  std::uint64_t seed = 1;               ///< of all random effects of the faults
};

/// The bus: controls transmissions and notifications, and the parts at each event: the cable with
/// its wires, the controllers on it, faults, and observers.
class SimulatedBus {
 public:
  static constexpr std::size_t taps_max = BusObservers::taps_max;  ///< of observe()

  /// Makes a bus without controllers, at Time zero. Numbers out of range are limited.
  explicit SimulatedBus(const SimulatedBusOptions& options = {});
  SimulatedBus(const SimulatedBus&) = delete;
  SimulatedBus& operator=(const SimulatedBus&) = delete;

  /// Adds a controller at the end of the cable; no_controller if there are controllers_max already.
  ControllerId attach(const ControllerOptions& options);
  /// Adds an observer; false if there are taps_max already.
  bool observe(const BusTap& tap) { return observers_.add(tap); }

  /// Queues a frame. False: the queue is full, the controller only listens or has no power, or the
  /// frame cannot be sent (an error frame, a length above 8). In bus-off, frames are queued until
  /// the controller is back.
  bool send(ControllerId id, const Frame& frame);
  /// Takes the oldest frame of a controller with `queue_received`; false if there is none.
  bool receive(ControllerId id, Frame& frame) { return at(id).fetch(frame); }
  /// Drops frames that wait for transmission, except a frame that is on the wire.
  void discard_pending(ControllerId id);

  /// Sets the acceptance filter for frames with this 11-bit identifier (also remote ones), and for
  /// all 29-bit frames.
  void accept(ControllerId id, std::uint16_t can_id, bool wanted) {
    filters_.accept(id, can_id, wanted);
  }
  /// Opens or closes the filter of a controller for all 29-bit frames.
  void accept_extended(ControllerId id, bool wanted) { filters_.accept_extended(id, wanted); }
  /// Port for a node. Valid as long as the bus.
  Port port(ControllerId id);

  /// Time up to which the bus has been advanced.
  Time now() const { return to_time(now_ns_); }
  /// Time of the next event, rounded up to a microsecond; never if nothing is in progress.
  Time next_event() const { return to_time(next_event_ns()); }
  /// Like next_event(), but exact, in nanoseconds since the start: see to_time().
  std::int64_t next_event_ns() const {
    return std::min(cable_.next_event_ns(), timeline_.next_ns());
  }
  /// Carries out all events up to and including `until`. Without events, it costs a comparison:
  /// worlds with many buses advance all of them at each event of one.
  void advance(Time until) {
    const std::int64_t until_ns = to_ns(until);
    if (next_event_ns() <= until_ns) return run(until_ns, false);
    now_ns_ = std::max(now_ns_, until_ns);
  }
  /// Advances to `until`, or to the first event before it, which it leaves to advance(): what
  /// another bus causes here until then begins no earlier.
  void wait(Time until) { now_ns_ = std::max(now_ns_, std::min(to_ns(until), next_event_ns())); }
  /// Like advance(), but returns as soon as a listener was called; returns the time that is
  /// reached.
  Time step(Time until);
  /// For listeners and taps: makes the current advance() return after this event.
  void interrupt() { is_interrupted_ = true; }

  /// Switches the power of a node: without power it receives, acknowledges and sends nothing, and
  /// its queued frames are lost.
  void power(ControllerId id, bool on);
  /// Changes the bit rate of a controller; a frame that it is sending is destroyed.
  void set_bit_rate(ControllerId id, std::uint32_t bit_rate);
  /// Switches listen-only mode: the controller neither sends nor acknowledges from then on.
  void set_listen_only(ControllerId id, bool on);
  /// Starts the recovery of a controller in bus-off, which takes 128 times 11 recessive bits.
  void recover(ControllerId id);

  /// Cuts the cable between a controller and the next one. Each piece continues as a separate bus.
  void cut_cable(ControllerId after);
  /// Takes one controller off the cable: it has power, and is alone.
  void unplug(ControllerId id);
  /// Puts an unplugged controller back into its place; frames that meet are destroyed.
  void plug(ControllerId id);
  /// Mends all cuts. Frames that meet are destroyed.
  void mend_cable();
  /// Makes a controller send `frame` again and again, beside its queued frames, until
  /// stop_babbling().
  void babble(ControllerId id, const Frame& frame);
  /// Ends the babbling of a controller; a frame that is on the wire ends first.
  void stop_babbling(ControllerId id);

  /// Destroys the next `frames` frames for all, in this bit, counted from 1 at the start of frame
  /// with stuff bits; in the last bit of a frame receivers have it already, and get it twice.
  void disturb(std::uint32_t frames, unsigned bit) { errors_.disturb(frames, bit); }
  /// Replaces the probability in the options.
  void set_frame_error_probability(double probability) {
    errors_.set_frame_error_probability(Probability(probability));
  }

  /// Fault confinement state of a controller.
  BusState state(ControllerId id) const { return at(id).state(); }
  /// Error counters of a controller.
  const ErrorCounters& error_counters(ControllerId id) const { return at(id).counters(); }
  /// Counters of a controller since attach().
  const ControllerStatistics& statistics(ControllerId id) const { return at(id).statistics(); }
  /// True if frames were lost for a full receive queue since the last call.
  bool take_overrun(ControllerId id) { return at(id).take_overrun(); }
  /// Clock of the node.
  const DriftingClock& clock(ControllerId id) const { return at(id).clock(); }

  /// Counters of the whole bus.
  const BusStatistics& statistics() const { return observers_.statistics(); }
  /// Share of the time (0 to 1) in which the wire was not idle, within the last load_window, and
  /// since the start: frames with their stuff bits, intermissions and error frames, as `id` (or the
  /// first controller) sees them; 0 if there is none.
  double load(ControllerId id = 0) const;
  /// The same since the start.
  double load_total(ControllerId id = 0) const;

 private:
  using Wire = SimulatedWire;
  using Controller = SimulatedController;

  /// Target of a port.
  struct Plug {
    SimulatedBus* bus = nullptr;
    ControllerId id = no_controller;
  };

  Controller& at(ControllerId id) {
    assert(id < controller_count_);
    return controllers_[id];
  }
  const Controller& at(ControllerId id) const {
    assert(id < controller_count_);
    return controllers_[id];
  }
  bool is_attached(ControllerId id) const { return id < controller_count_; }

  // Time: what is due, and the participants of the next event.
  void run(std::int64_t limit_ns, bool stop_when_told);
  void apply_faults();
  void handle(Wire& wire);
  void offer(const Controller& controller);
  void refresh(const Controller& controller);
  void schedule(Wire& wire);

  // The life of a frame.
  void start_frame(Wire& wire);
  ControllerSet elect(Wire& wire);
  void collide(Wire& wire);
  void deliver(Wire& wire);
  void hand_over(Controller& controller, Time now, const Frame& frame);
  void finish(Wire& wire);
  void complete_transmission(Controller& controller, const Frame& frame);
  void fail(Wire& wire);
  void leave_frame(Controller& controller);

  // Fault confinement.
  void count_receive_error(Controller& controller, bool alone);
  void count_transmit_error(Controller& controller, bool unacknowledged);
  void complete_recoveries(const Wire& wire);
  void tell_state(Controller& controller);
  void tell_error(const ControllerSet& who);
  /// Calls a callback of a node, if it is set.
  template <typename... Told, typename... What>
  void tell(void (*told)(void* context, Time now, Told...), void* context, Time now,
            const What&... what) {
    if (told == nullptr) return;
    has_told_ = true;
    told(context, now, what...);
  }

  void rewire();

  SimulatedBusOptions options_;
  std::vector<Controller> controllers_;
  std::vector<Plug> plugs_;
  std::vector<PendingFrame> transmit_storage_;
  std::vector<Frame> receive_storage_;
  std::size_t controller_count_ = 0;

  SimulatedCable cable_;
  AcceptanceFilters filters_{};
  ArbitrationContest contest_;  // of controllers that have a frame to send, and may
  Participants participants_{};
  BitTimes bit_times_;
  BusOffRecovery recovery_{};
  FrameErrors errors_;
  FaultTimeline timeline_;
  BusObservers observers_{};

  std::int64_t now_ns_ = 0;
  ControllerSet to_tell_{};  // of the end of their frame
  bool has_told_ = false;    // a listener was called since step() began
  bool is_interrupted_ = false;
};

}  // namespace canvoy
