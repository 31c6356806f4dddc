// A CAN bus in virtual time (ISO 11898-1): arbitration, acknowledgement, errors, fault confinement
// and load of a real one, without a clock, a thread or an operating system.
//
//     SimulatedBus bus({.bit_rate = 125'000, .seed = 1});
//     ControllerId node = bus.attach({.listener = {.context = &state, .on_frame = handle}});
//     bus.send(node, Frame::data_frame(0x705, {5}));
//     while (bus.next_event() <= end) bus.advance(bus.next_event());
//
// It is deterministic: the same options and the same calls give the same frames at the same times.
// All memory is taken by the constructor. Before nodes act at a time, advance() the bus to that
// time. Calls may be made from within listeners, except attach(), advance(), step() and those that
// change the cable.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/random.hpp"
#include "canvoy/can/simulated/arbitration_contest.hpp"
#include "canvoy/can/simulated/bus_faults.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/drifting_clock.hpp"
#include "canvoy/can/simulated/simulated_controller.hpp"
#include "canvoy/can/simulated/simulated_wire.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// What an observer of the whole bus is told, at the moment it happens and before the nodes are.
/// Null: not told.
struct BusTap {
  void* context = nullptr;
  /// A frame went over the bus whole; `now` is when receivers have it.
  void (*on_frame)(void* context, Time now, ControllerId sender, const Frame& frame) = nullptr;
  /// A frame was destroyed; an error frame follows on the wire.
  void (*on_error)(void* context, Time now, const BusError& error) = nullptr;
  void (*on_state)(void* context, Time now, ControllerId controller, BusState state) = nullptr;
  void (*on_overrun)(void* context, Time now, ControllerId controller) = nullptr;
};

struct SimulatedBusOptions {
  std::uint32_t bit_rate = 125'000;   ///< bit/s, 1000 to 1'000'000, unless a controller has its own
  std::size_t controllers_max = 127;  ///< 1 to ControllerSet::capacity
  std::size_t transmit_queue_max = 32;  ///< frames, for each controller
  std::size_t receive_queue_max = 32;   ///< frames, for each controller with `queue_received`
  Duration load_window = 1s;            ///< how far back load() looks
  BusFaults faults{};
  std::uint64_t seed = 1;  ///< of everything that the faults leave to chance
};

class SimulatedBus {
 public:
  static constexpr std::size_t taps_max = 4;

  explicit SimulatedBus(const SimulatedBusOptions& options = {});
  SimulatedBus(const SimulatedBus&) = delete;
  SimulatedBus& operator=(const SimulatedBus&) = delete;

  /// A further controller at the end of the cable; no_controller where there are controllers_max
  /// already.
  ControllerId attach(const ControllerOptions& options);
  /// A further observer; false where there are taps_max already.
  bool observe(const BusTap& tap);

  /// Queues a frame. False: the queue is full, or the controller only listens or has no power, or
  /// it is no frame that can be sent (an error frame, a length above 8). In bus-off frames are
  /// queued until the controller is back.
  bool send(ControllerId id, const Frame& frame);
  /// The oldest frame of a controller with `queue_received`; false where there is none.
  bool receive(ControllerId id, Frame& frame);
  /// Drops what waits for transmission, except a frame that is on the wire.
  void discard_pending(ControllerId id);

  /// The acceptance filter, for frames with this 11-bit identifier (remote ones too), and for all
  /// 29-bit frames.
  void accept(ControllerId id, std::uint16_t can_id, bool wanted);
  void accept_extended(ControllerId id, bool wanted);
  /// What a node is given. Valid as long as the bus.
  Port port(ControllerId id);

  /// The time up to which the bus has been advanced.
  Time now() const;
  /// When something happens next, rounded up to a microsecond; never, where nothing is under way.
  Time next_event() const { return to_time(next_event_ns()); }
  /// Lets everything happen that is due up to and including `until`. Where nothing is, it costs a
  /// comparison: worlds with many buses advance all of them at each event of one.
  void advance(Time until) {
    const std::int64_t until_ns = to_ns(until);
    if (next_event_ns() <= until_ns) return run(until_ns, false);
    now_ns_ = std::max(now_ns_, until_ns);
  }
  /// As advance(), but returns as soon as a listener has been told something; the answer is the
  /// time that is reached.
  Time step(Time until);
  /// For listeners and taps: the advance() that is under way returns when this event is done.
  void interrupt() { is_interrupted_ = true; }

  /// Switches the power of a node: without, it hears, acknowledges and sends nothing, and what it
  /// had queued is lost.
  void power(ControllerId id, bool on);
  /// From now on; a frame that the controller is sending is destroyed.
  void set_bit_rate(ControllerId id, std::uint32_t bit_rate);
  void set_listen_only(ControllerId id, bool on);
  /// Asks a controller in bus-off to come back, which takes 128 times 11 recessive bits.
  void recover(ControllerId id);

  /// Cuts the cable between a controller and the next one. Each piece goes on as a bus of its own.
  void cut_cable(ControllerId after);
  /// Takes one controller off the cable: it is powered, and alone.
  void unplug(ControllerId id);
  void plug(ControllerId id);
  /// Mends all cuts. Frames that meet are destroyed.
  void mend_cable();
  /// Makes a controller send `frame` again and again, beside what is queued, until stop_babbling().
  void babble(ControllerId id, const Frame& frame);
  void stop_babbling(ControllerId id);

  /// Destroys the next `frames` frames for all, in this bit, counted from 1 at the start of frame
  /// with stuff bits; in the last bit of a frame receivers have it already, and get it twice.
  void disturb(std::uint32_t frames, unsigned bit);
  /// From now on, in place of what the options say.
  void set_frame_error_probability(double probability);

  BusState state(ControllerId id) const;
  const ErrorCounters& error_counters(ControllerId id) const;
  const ControllerStatistics& statistics(ControllerId id) const;
  /// Whether frames were lost for a full receive queue since it was asked last.
  bool take_overrun(ControllerId id);
  /// The node's own clock.
  const DriftingClock& clock(ControllerId id) const;

  /// Of the whole bus.
  const BusStatistics& statistics() const { return statistics_; }
  /// Share of the time (0 to 1) in which the wire was not idle, within the last load_window, and
  /// since the start: frames with their stuff bits, intermissions and error frames, as `id` (or the
  /// first controller) sees them; 0 where there is none.
  double load(ControllerId id = 0) const;
  double load_total(ControllerId id = 0) const;

 private:
  using Wire = SimulatedWire;
  using Controller = SimulatedController;

  // simulated_bus.cpp: time
  Controller& at(ControllerId id) {
    assert(id < controller_count_);
    return controllers_[id];
  }
  const Controller& at(ControllerId id) const {
    assert(id < controller_count_);
    return controllers_[id];
  }
  void run(std::int64_t limit_ns, bool stop_when_told);
  /// A cable that was never cut is one wire.
  Wire& earliest_wire() { return wires_used_ == 1 ? wires_.front() : earliest_of_pieces(); }
  Wire& earliest_of_pieces();
  std::int64_t next_event_ns() const {
    return wires_used_ == 1 ? std::min(wires_.front().event_ns, fault_ns_)
                            : next_event_of_pieces_ns();
  }
  std::int64_t next_event_of_pieces_ns() const;
  void handle(Wire& wire);
  void offer(const Controller& controller);
  void refresh(Controller& controller);
  void schedule(Wire& wire);

  // simulated_frame.cpp: the life of a frame
  void start_frame(Wire& wire);
  void elect(Wire& wire);
  void collide(Wire& wire);
  void deliver(Wire& wire);
  void tell_taps(const Wire& wire, Time now);
  void hand_over(Controller& controller, Time now, const Frame& frame);
  void finish(Wire& wire);
  void take_from_queue(Controller& controller);
  void complete_transmission(Controller& controller, const Frame& frame);

  // simulated_errors.cpp: errors and fault confinement
  void plan_errors(Wire& wire);
  void plan_missing_acknowledgement(Wire& wire);
  void plan_foreign_rates(Wire& wire);
  void plan_misreading(Wire& wire);
  void plan_disturbance(Wire& wire);
  void fail(Wire& wire);
  void tell_error(const Wire& wire);
  void tell_listeners_of_error(const ControllerSet& who);
  ControllerSet with_foreign_rate(const Wire& wire) const;
  void count_receive_error(Controller& controller, bool alone);
  void count_transmit_error(Controller& controller, bool unacknowledged);
  void update_state(Controller& controller);
  void begin_recovery(Controller& controller);
  std::int64_t next_recovery_ns(const Wire& wire) const;
  void count_recessive_bits(const Wire& wire);
  void complete_recoveries(const Wire& wire);

  // simulated_cable.cpp: pieces of cable, and what happens to nodes
  template <typename T>
  using PerPiece = std::array<T, ControllerSet::capacity>;
  void rewire();
  std::size_t list_pieces(std::span<ControllerSet> pieces) const;
  void fail_frames_that_meet(std::span<const ControllerSet> pieces);
  void assign_wires(std::span<const ControllerSet> pieces, PerPiece<Wire*>& wire_of);
  void clear(Wire& wire);
  ControllerSet occupy(Wire& wire, const ControllerSet& piece);
  ControllerId number_of(const Wire& wire) const {
    return static_cast<ControllerId>(&wire - wires_.data());
  }
  void expect_acknowledgement(Wire& wire);
  void leave_frame(Controller& controller);
  void apply_fault();
  std::int64_t next_fault_after(std::int64_t ns) const;

  std::vector<Controller> controllers_;
  std::vector<Wire> wires_;  // one for each piece that the cable can fall into
  std::vector<PendingFrame> transmit_storage_;
  std::vector<Frame> receive_storage_;
  std::vector<ControllerSet> accepting_;  // for each 11-bit identifier
  ArbitrationContest contest_;            // of those that have something to send, and may
  ControllerSet hearing_{};               // with power, not in bus-off
  ControllerSet acknowledging_{};         // of these, all that do not only listen
  ControllerSet flagging_{};              // of these, the error-active: their error flags are seen
  ControllerSet recovering_{};            // in bus-off, on the way back
  ControllerSet accepting_extended_{};    // 29-bit frames
  ControllerSet with_receive_errors_{};
  ControllerSet misreading_{};
  ControllerSet cut_after_{};
  ControllerSet to_tell_{};  // that they have sent the frame that ends
  std::array<BusTap, taps_max> taps_{};
  std::size_t tap_count_ = 0;
  std::size_t controller_count_ = 0;
  std::size_t wires_used_ = 1;

  SimulatedBusOptions options_;
  Random random_;
  Probability frame_error_{};
  std::vector<std::uint64_t> bit_error_by_;  // threshold of an error in one of the first n bits
  std::int64_t now_ns_ = 0;
  std::int64_t fault_ns_ = never_ns;  // the next fault that begins or ends by the options
  BusStatistics statistics_{};
  std::uint32_t disturbances_left_ = 0;  // by disturb()
  unsigned disturbed_bit_ = 0;
  bool has_disturbances_ = false;
  bool has_mixed_rates_ = false;
  bool has_told_ = false;  // a listener was called since step() began
  bool is_interrupted_ = false;
};

}  // namespace canvoy
