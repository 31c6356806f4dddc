// A CAN controller on the simulated bus: options, callbacks and counters for its node, and its
// operation: queues, fault confinement, and the listening node.
//
//     ControllerOptions options{.listener = {.context = &node, .on_frame = handle}, .listen_only =
//     true};
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/drifting_clock.hpp"
#include "canvoy/can/simulated/fault_confinement.hpp"
#include "canvoy/can/simulated/receive_queue.hpp"
#include "canvoy/can/simulated/transmit_queue.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Callbacks of a node, called at the moment of an event. Null: not called.
struct BusListener {
  void* context = nullptr;  ///< first argument of each call
  /// Receives a frame of another controller that passes the acceptance filter.
  void (*on_frame)(void* context, Time now, const Frame& frame) = nullptr;
  /// A frame of this controller was sent and acknowledged: there is room in the transmit queue.
  void (*on_sent)(void* context, Time now, const Frame& frame) = nullptr;
  /// The fault confinement state of this controller has changed.
  void (*on_state)(void* context, Time now, BusState state) = nullptr;
  /// A frame was lost because the receive queue was full (only with `queue_received`).
  void (*on_overrun)(void* context, Time now) = nullptr;
};

/// Options of a controller and of the quartz of its node.
struct ControllerOptions {
  BusListener listener{};                                   ///< callbacks of the node
  TransmitOrder transmit_order = TransmitOrder::as_queued;  ///< order of its transmit queue
  std::uint32_t bit_rate = 0;  ///< bit/s, 1000 to 1'000'000; 0: that of the bus
  /// Neither sends nor acknowledges nor destroys anything; its error counters do not change.
  bool listen_only = false;
  bool accept_all = true;             ///< false: the acceptance filter begins closed
  bool queue_received = false;        ///< frames wait for receive(), without a call of on_frame
  bool recover_automatically = true;  ///< from bus-off; false: by recover()
  std::int32_t clock_drift_ppm = 0;   ///< of the node's clock, see SimulatedBus::clock()
  /// 0 to 1: share of the others' frames that it alone sees disturbed.
  double misread_probability = 0.0;
  /// With the listener's context: called at the end of a transmission that is not a frame for this
  /// controller, for an error flag or a different bit rate.
  void (*on_error)(void* context, Time now) = nullptr;
};

/// Counters since attach().
struct ControllerStatistics {
  std::uint64_t received = 0;         ///< frames passed to the node or put into its receive queue
  std::uint64_t sent = 0;             ///< frames that were acknowledged
  std::uint64_t overruns = 0;         ///< frames lost because the receive queue was full
  std::uint64_t transmit_errors = 0;  ///< failed attempts to send; each is repeated
  std::uint64_t receive_errors = 0;   ///< errors detected as a receiver
};

/// Frames to send and received, mode, and fault confinement. The data needed to pass on a frame
/// shares a cache line.
class alignas(64) SimulatedController {
 public:
  SimulatedController() = default;
  /// Makes a controller that is switched on; the spans are the memory of its queues.
  SimulatedController(ControllerId id, const ControllerOptions& options,
                      std::span<PendingFrame> to_send, std::span<Frame> received)
      : listener_(options.listener),
        id_(id),
        queues_received_(options.queue_received),
        is_listen_only_(options.listen_only),
        on_error_(options.on_error),
        recovers_automatically_(options.recover_automatically),
        to_send_(to_send, options.transmit_order),
        received_(received),
        clock_(options.clock_drift_ppm) {
    if (queues_received_) listener_.on_frame = nullptr;
  }

  /// Number on the bus.
  ControllerId id() const { return id_; }
  /// Listener; without on_frame if the node fetches frames.
  const BusListener& listener() const { return listener_; }
  /// Callback with the listener's context.
  auto on_error() const { return on_error_; }
  /// Fault confinement state.
  BusState state() const { return state_; }
  /// False: takes no part in anything.
  bool is_powered() const { return is_powered_; }
  /// True: receives only.
  bool is_listen_only() const { return is_listen_only_; }
  /// True if it recovers from bus-off by itself.
  bool recovers_automatically() const { return recovers_automatically_; }
  /// Error counters.
  const ErrorCounters& counters() const { return counters_; }
  /// Counters since attach().
  const ControllerStatistics& statistics() const { return statistics_; }
  /// Clock of the node.
  const DriftingClock& clock() const { return clock_; }

  /// Switches listen-only mode. Queued frames wait until it is over.
  void set_listen_only(bool on) { is_listen_only_ = on; }
  /// Switches power, with the state after a reset: queues empty, counters at zero.
  void switch_power(bool on) {
    is_powered_ = on;
    to_send_.unlock();
    to_send_.clear();
    received_.clear();
    counters_.restart();
    state_ = BusState::error_active;
    has_overrun_ = false;
  }

  /// Queues a frame. False: the queue is full, or the controller cannot send.
  bool queue(const PendingFrame& frame) {
    return is_powered_ && !is_listen_only_ && to_send_.push(frame);
  }
  /// Drops waiting frames, except a frame that is on the wire.
  void discard_pending() { to_send_.clear(); }
  /// Sends this frame again and again, in place of queued ones.
  void babble(const PendingFrame& frame) {
    babble_ = frame;
    is_babbling_ = true;
  }
  /// Ends the babbling; queued frames follow.
  void stop_babbling() { is_babbling_ = false; }

  /// True if it has a frame to send, and may.
  bool wants_bus() const {
    const bool may_send = is_powered_ && !is_listen_only_ && state_ != BusState::bus_off;
    return may_send && (is_babbling_ || !to_send_.empty());
  }
  /// Next frame on the wire; only if wants_bus().
  const PendingFrame& head() const { return is_babbling_ ? babble_ : to_send_.front(); }
  /// True if the present or last frame on the wire did not come from the queue, so that the node
  /// must not be notified.
  bool is_sending_babble() const { return is_sending_babble_; }
  /// Begins a frame on the wire, until end_sending() or break_off().
  void begin_sending() {
    is_sending_babble_ = is_babbling_;
    if (!is_babbling_) to_send_.lock();
  }
  /// Ends a frame that was acknowledged, and removes it from the queue.
  void end_sending() {
    if (!is_sending_babble_) to_send_.pop();
    ++statistics_.sent;
  }
  /// Ends a frame that must be sent again.
  void break_off() {
    if (!is_sending_babble_) to_send_.unlock();
  }

  /// Takes a frame that passes its filter; false if it is lost for a full queue.
  bool take(const Frame& frame) {
    if (queues_received_ && !received_.push(frame)) [[unlikely]] {
      ++statistics_.overruns;
      has_overrun_ = true;
      return false;
    }
    ++statistics_.received;
    return true;
  }
  /// Takes the oldest frame that the node has not fetched; false if there is none.
  bool fetch(Frame& frame) { return received_.pop(frame); }
  /// True if frames were lost since the last call.
  bool take_overrun() { return std::exchange(has_overrun_, false); }

  // Fault confinement. Each function returns whether the state has changed.
  /// Rules a and b: a receive error, and whether no other controller had detected it before.
  bool count_receive_error(bool alone) {
    ++statistics_.receive_errors;
    counters_.receive_error();
    if (alone) counters_.receive_error_alone();
    return follow_counters();
  }
  /// Rule c: a transmit error, and whether it is a missing acknowledgement only.
  bool count_transmit_error(bool unacknowledged) {
    ++statistics_.transmit_errors;
    unacknowledged ? counters_.acknowledgement_missing() : counters_.transmit_error();
    return follow_counters();
  }
  /// Rule h: a frame was received.
  bool count_received() {
    counters_.received();
    return follow_counters();
  }
  /// Rule g: a frame was sent.
  bool count_transmitted() {
    if (counters_.transmit() == 0) return false;
    counters_.transmitted();
    return follow_counters();
  }
  /// Resets the counters after bus-off.
  bool restart_counters() {
    counters_.restart();
    return follow_counters();
  }

 private:
  bool follow_counters() {
    const BusState state = counters_.state();
    return std::exchange(state_, state) != state;
  }

  BusListener listener_{};
  ControllerId id_ = no_controller;
  BusState state_ = BusState::error_active;
  bool queues_received_ = false;
  bool is_powered_ = true;
  bool is_listen_only_ = false;
  bool is_babbling_ = false;
  bool is_sending_babble_ = false;  // the frame on the wire did not come from the queue
  ErrorCounters counters_{};
  ControllerStatistics statistics_{};

  void (*on_error_)(void* context, Time now) = nullptr;
  bool recovers_automatically_ = true;
  bool has_overrun_ = false;
  TransmitQueue to_send_{};
  ReceiveQueue received_{};
  PendingFrame babble_{};
  DriftingClock clock_{};
};

}  // namespace canvoy
