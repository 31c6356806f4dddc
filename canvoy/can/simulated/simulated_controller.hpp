// A CAN controller on the simulated bus: what its node chooses, is told and may read, and what it
// does: queues, fault confinement, and the node that listens.
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

/// What a node is told by its controller, at the moment it happens. Null: not told.
struct BusListener {
  void* context = nullptr;
  /// A frame of another controller that the acceptance filter lets pass.
  void (*on_frame)(void* context, Time now, const Frame& frame) = nullptr;
  /// A frame of its own went over the bus and was acknowledged: there is room in the transmit
  /// queue.
  void (*on_sent)(void* context, Time now, const Frame& frame) = nullptr;
  void (*on_state)(void* context, Time now, BusState state) = nullptr;
  /// A frame was lost because the receive queue was full (only with `queue_received`).
  void (*on_overrun)(void* context, Time now) = nullptr;
};

struct ControllerOptions {
  BusListener listener{};
  TransmitOrder transmit_order = TransmitOrder::as_queued;
  std::uint32_t bit_rate = 0;         ///< bit/s, 1000 to 1'000'000; 0: that of the bus
  bool listen_only = false;           ///< neither sends nor acknowledges nor destroys anything;
                                      ///< its error counters stand still
  bool accept_all = true;             ///< false: the acceptance filter begins closed
  bool queue_received = false;        ///< frames wait for receive(), on_frame is not called
  bool recover_automatically = true;  ///< from bus-off; false: on recover()
  std::int32_t clock_drift_ppm = 0;   ///< of the node's clock, see SimulatedBus::clock()
  double misread_probability =
      0.0;  ///< 0 to 1: share of the others' frames that it alone sees disturbed
  /// With the listener's context: what another controller sends is no frame here, for an error flag
  /// or a foreign bit rate. Told when it ends.
  void (*on_error)(void* context, Time now) = nullptr;
};

/// Counted since attach().
struct ControllerStatistics {
  std::uint64_t received = 0;  ///< frames handed to the node or put into its receive queue
  std::uint64_t sent = 0;
  std::uint64_t overruns = 0;         ///< frames lost because the receive queue was full
  std::uint64_t transmit_errors = 0;  ///< attempts to send that failed, each is repeated
  std::uint64_t receive_errors = 0;
};

/// What it has to send and has received, its mode, and its fault confinement. What it needs to hand
/// over a frame shares a cache line.
class alignas(64) SimulatedController {
 public:
  SimulatedController() = default;
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

  ControllerId id() const { return id_; }
  /// Without on_frame, where its node fetches them.
  const BusListener& listener() const { return listener_; }
  /// With the listener's context.
  auto on_error() const { return on_error_; }
  BusState state() const { return state_; }
  bool is_powered() const { return is_powered_; }
  bool is_listen_only() const { return is_listen_only_; }
  bool recovers_automatically() const { return recovers_automatically_; }
  const ErrorCounters& counters() const { return counters_; }
  const ControllerStatistics& statistics() const { return statistics_; }
  const DriftingClock& clock() const { return clock_; }

  void set_listen_only(bool on) { is_listen_only_ = on; }
  /// As it comes from a reset: queues empty, counters at zero.
  void switch_power(bool on) {
    is_powered_ = on;
    to_send_.unlock();
    to_send_.clear();
    received_.clear();
    counters_.restart();
    state_ = BusState::error_active;
    has_overrun_ = false;
  }

  /// False: the queue is full, or it cannot send.
  bool queue(const PendingFrame& frame) {
    return is_powered_ && !is_listen_only_ && to_send_.push(frame);
  }
  /// Drops what waits, except a frame that is on the wire.
  void discard_pending() { to_send_.clear(); }
  /// Puts this frame on the wire again and again, in place of what is queued.
  void babble(const PendingFrame& frame) {
    babble_ = frame;
    is_babbling_ = true;
  }
  void stop_babbling() { is_babbling_ = false; }

  /// Whether it has something to send, and may.
  bool wants_bus() const {
    const bool may_send = is_powered_ && !is_listen_only_ && state_ != BusState::bus_off;
    return may_send && (is_babbling_ || !to_send_.empty());
  }
  /// What it puts on the wire next; only where wants_bus().
  const PendingFrame& head() const { return is_babbling_ ? babble_ : to_send_.front(); }
  /// Of what is on the wire, or was: it did not come from the queue, and its node knows nothing of
  /// it.
  bool is_sending_babble() const { return is_sending_babble_; }
  /// Its frame is on the wire, until end_sending() or break_off().
  void begin_sending() {
    is_sending_babble_ = is_babbling_;
    if (!is_babbling_) to_send_.lock();
  }
  void end_sending() {
    if (!is_sending_babble_) to_send_.pop();
    ++statistics_.sent;
  }
  /// It has to be sent again.
  void break_off() {
    if (!is_sending_babble_) to_send_.unlock();
  }

  /// A frame that its filter lets pass; false where it is lost for a full queue.
  bool take(const Frame& frame) {
    if (queues_received_ && !received_.push(frame)) [[unlikely]] {
      ++statistics_.overruns;
      has_overrun_ = true;
      return false;
    }
    ++statistics_.received;
    return true;
  }
  /// The oldest one that its node has not fetched; false where there is none.
  bool fetch(Frame& frame) { return received_.pop(frame); }
  /// Whether frames were lost since it was asked last.
  bool take_overrun() { return std::exchange(has_overrun_, false); }

  // Fault confinement. Each answers whether the state is another then.
  bool count_receive_error(bool alone) {
    ++statistics_.receive_errors;
    counters_.receive_error();
    if (alone) counters_.receive_error_alone();
    return follow_counters();
  }
  bool count_transmit_error(bool unacknowledged) {
    ++statistics_.transmit_errors;
    unacknowledged ? counters_.acknowledgement_missing() : counters_.transmit_error();
    return follow_counters();
  }
  bool count_received() {
    counters_.received();
    return follow_counters();
  }
  bool count_transmitted() {
    if (counters_.transmit() == 0) return false;
    counters_.transmitted();
    return follow_counters();
  }
  /// Back from bus-off.
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
  bool is_sending_babble_ = false;  // what is on the wire did not come from the queue
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
