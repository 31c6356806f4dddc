// A CAN controller on the simulated bus: what its node chooses, is told and may read, and what the
// bus keeps of it.
//
//     ControllerOptions options{.listener = {.context = &node, .on_frame = handle}, .listen_only =
//     true};
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/random.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/drifting_clock.hpp"
#include "canvoy/can/simulated/fault_confinement.hpp"
#include "canvoy/can/simulated/receive_queue.hpp"
#include "canvoy/can/simulated/transmit_queue.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

class SimulatedBus;

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

/// What the bus keeps of a controller. What it needs to hand over a frame shares a cache line.
struct alignas(64) SimulatedController {
  SimulatedBus* bus = nullptr;
  BusListener listener{};
  ControllerId id = no_controller;
  std::uint8_t wire = 0;  ///< the piece of cable that it is on
  BusState state = BusState::error_active;
  bool queues_received = false;
  bool is_powered = true;
  bool is_plugged = true;
  bool is_listen_only = false;
  bool is_babbling = false;
  ControllerStatistics statistics{};

  void (*on_error)(void* context, Time now) = nullptr;
  bool is_sending_babble = false;  ///< what is on the wire did not come from the queue
  bool recovers_automatically = true;
  bool has_overrun = false;
  TransmitQueue to_send{};
  ReceiveQueue received{};
  ErrorCounters counters{};
  PendingFrame babble{};
  std::int64_t bit_ns = 0;
  Probability misreads{};
  DriftingClock clock{};

  std::uint32_t recovery_sequences_left =
      0;  ///< of 11 recessive bits, until it is back from bus-off
  std::int64_t recovery_counted_to_ns = 0;

  std::int64_t recovery_end_ns(std::int64_t recessive_since_ns) const {
    const std::int64_t from_ns = std::max(recessive_since_ns, recovery_counted_to_ns);
    return from_ns + recovery_sequences_left * 11 * bit_ns;
  }

  bool may_send() const { return is_powered && !is_listen_only && state != BusState::bus_off; }
  bool has_pending() const { return is_babbling || !to_send.empty(); }
  /// What it puts on the wire next; only where has_pending().
  const PendingFrame& head() const { return is_babbling ? babble : to_send.front(); }
};

}  // namespace canvoy
