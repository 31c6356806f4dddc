// A CANopen node without its services: dictionary, NMT slave, routes, timers, and the way to the
// bus (CiA 301, 7.3.2).
//
// It owns no socket, thread, clock or heap. Its owner hands in frames and points in time, and calls
// again at deadline(). Services (SDO, PDO, heartbeat ...) attach themselves, and only those that
// are used are linked.
//
//     node.start(now);
//     node.receive(frame, now);
//     while (node.deadline() <= now) node.advance(now);
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/canopen/service/router.hpp"
#include "canvoy/canopen/service/service.hpp"
#include "canvoy/canopen/service/timer_queue.hpp"
#include "canvoy/canopen/service/transmitter.hpp"

namespace canvoy {

/// Like ServiceHandlers, but for applications, which set the callbacks at run time; all are
/// optional.
struct Service {
  Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  /// At an NMT reset, and at start, when parameters have their power-on values again.
  Callback<void(ResetScope)> reset = {};
  /// After the NMT state has changed. It may command another state, which ends this notification.
  Callback<void(NmtState)> state_entered = {};
  /// After the state of the CAN controller has changed.
  Callback<void(BusState)> bus_state_changed = {};
  /// An error appeared (`present`) or disappeared.
  Callback<void(const Error&, bool present)> error_changed = {};
  /// Values that TPDOs map have changed: bit n for TPDO numbers that are n modulo 32.
  Callback<void(std::uint32_t)> values_changed = {};
  /// Waiting frames have gone to the controller, which has room for more.
  Callback<void()> tx_ready = {};
  HandlerBinding link{&calls, this};  ///< place among the services of the node

 private:
  template <auto callback, class... Arguments>
  static void forward(void* service, Arguments... arguments) {
    (static_cast<Service*>(service)->*callback)(arguments...);
  }
  static const ServiceHandlers calls;
};
inline constexpr ServiceHandlers Service::calls = {
    .reset = forward<&Service::reset, ResetScope>,
    .state_entered = forward<&Service::state_entered, NmtState>,
    .bus_state_changed = forward<&Service::bus_state_changed, BusState>,
    .error_changed = forward<&Service::error_changed, const Error&, bool>,
    .values_changed = forward<&Service::values_changed, std::uint32_t>,
    .tx_ready = forward<&Service::tx_ready>,
};

/// Memory of a node, which must outlive it.
struct NodeMemory {
  std::span<std::uint8_t> values;   ///< DictionaryTables::value_bytes
  std::span<ObjectState> states;    ///< one for each ObjectRow; none on a small machine
  std::span<Router::Route> routes;  ///< one for each CAN-ID that a service needs
  std::span<Frame> backlog;         ///< frames that wait for the controller
};

/// The core of a device: NMT slave, dictionary and the way of frames. Compiled once for all
/// devices.
class Node {
 public:
  /// Counts frames that no service could use, and trouble on the bus.
  struct Counters {
    std::uint32_t received = 0;   ///< frames of any kind
    std::uint32_t unwanted = 0;   ///< CAN-IDs without a service on this node
    std::uint32_t extended = 0;   ///< frames that are not 11-bit data or remote frames
    std::uint32_t malformed = 0;  ///< wrong length or unknown command: ignored by a service
    std::uint32_t bus_off = 0;    ///< number of times that the controller went bus-off
    std::uint32_t overruns = 0;   ///< frames that the controller lost
  };

  /// Makes a node. `node_id` is 1 to 127, or node_id_unconfigured: then the node stays in
  /// initialisation, without a boot-up message, until it has one (see set_pending_id()).
  /// `autostart` makes it enter operational by itself after boot-up (CiA 302-2).
  ///
  /// A node on a small machine can be constant-initialised, in memory that is zero. Its dictionary
  /// then has its defaults after start() only.
  constexpr Node(const DictionaryTables& tables, const NodeMemory& memory, const Port& port,
                 NodeId node_id, bool autostart = false)
      : node_id_(node_id),
        pending_id_(node_id),
        power_on_id_(node_id),
        autostart_(autostart),
        port_(port),
        dictionary_(tables, memory.values, memory.states),
        router_(memory.routes, port_),
        transmitter_(port_, memory.backlog) {
    if (!std::is_constant_evaluated()) begin();
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Starts the node, as at power-on: initialisation, boot-up message, pre-operational.
  void start(Time now);

  /// Takes a frame from the bus, and calls the services that wait for it. `now` must not be before
  /// that of an earlier call. Frames that no service takes are counted only.
  void receive(const Frame& frame, Time now);
  /// Does what is due. Call it at deadline(), and after the application wrote values.
  void advance(Time now);
  /// Time of the next call of advance(): in the past if something is due already.
  Time deadline() const { return dictionary_.changes() != 0 ? Time::min() : timers_.deadline(); }

  /// Notes a new state of the controller.
  void bus_state(BusState state, Time now);
  /// Notes that the controller has room for frames again, or has sent one. Without frames that had
  /// to wait, no service is notified.
  void tx_ready(Time now);
  /// Notes that the controller lost received frames.
  void overrun(Time now);

  /// Carries out an NMT command, as if the NMT master had sent it. Outside of a callback, call
  /// advance(now) before.
  void command(NmtCommand command);

  /// Sets the node-ID that the node takes at the next NMT reset communication: 1 to 127, or
  /// node_id_unconfigured (CiA 305, pending node-ID).
  void set_pending_id(NodeId id) { pending_id_ = id; }
  /// Sets the node-ID that the node takes at start and at NMT reset node (CiA 305, persistent
  /// node-ID).
  void set_power_on_id(NodeId id) { power_on_id_ = id; }
  /// Takes the pending node-ID and boots, if the pending node-ID is valid and the node had none
  /// before.
  void take_first_id();

  /// Attaches a service. Services are notified in the order of attachment.
  constexpr void attach(NodeService& service) { dictionary_.attach(service); }
  /// Like attach(NodeService&), for a service with a table of handlers.
  constexpr void attach(HandlerBinding& service) { dictionary_.attach(service); }
  /// Like attach(NodeService&), for callbacks of an application. `service` must outlive the node.
  void attach(Service& service) { attach(service.link); }
  /// Reports an error that is present from now on. Errors with the same code and instance are one.
  void raise(const Error& error) { report(error, true); }
  /// Reports that an error is gone. One that is not present has no effect.
  void clear(const Error& error) { report(error, false); }
  /// Reports an error that appeared (`is_present`) or disappeared.
  void report(const Error& error, bool is_present);
  /// Ends a write to which a hook answered `deferred`, with success or failure. One is under way at
  /// a time: a hook refuses another while is_deferred().
  void finish_deferred(AbortCode answer) { std::exchange(deferred_, {})(answer); }
  /// Calls `done` once, with the answer of the deferred write.
  void await_deferred(Callback<void(AbortCode)> done) { deferred_ = done; }
  /// True from a hook's answer `deferred` to finish_deferred().
  bool is_deferred() const { return static_cast<bool>(deferred_); }
  /// Sets the function that is called at each reset after the defaults are restored and before any
  /// service is notified, to write other power-on values (a device with values that depend on its
  /// node-ID; storage). Returns the function set before (CiA 301, 1010h).
  Callback<void(ResetScope)> on_defaults_restored(Callback<void(ResetScope)> restored) {
    return std::exchange(defaults_restored_, restored);
  }

  /// Sends the error control message: the NMT state, which is the boot-up message in
  /// initialisation.
  void send_state();
  /// Notifies services of a SYNC; Sync calls it with `actuate`, then with `sample`.
  void notify_sync(ServiceEvent::Kind phase, std::uint8_t counter) {
    if constexpr (is_small_machine) {
      dictionary_.notify(phase, counter);
    } else {
      ServiceEvent event{.kind = phase, .number = counter};
      dictionary_.notify_frequent(event);
    }
  }
  /// Counts a frame that a service ignored.
  void count_malformed() { ++counters_.malformed; }
  /// For hosts: counts a read of an entry of a PDO mapping record, or that one is set.
  void count_mapping_read() {
    if constexpr (!is_small_machine) ++mapping_reads_.value;
  }

  /// Time of the call that is under way, or of the last one.
  Time now() const { return timers_.now(); }
  /// Microseconds from `past` to now(), limited to UINT32_MAX.
  std::uint32_t elapsed_since(Time past) const;
  /// Node-ID, 1 to 127, or node_id_unconfigured.
  NodeId id() const { return node_id_; }
  /// Node-ID from the next NMT reset communication on, 1 to 127, or node_id_unconfigured.
  NodeId pending_id() const { return pending_id_; }
  /// NMT state; initialisation before start(), and without a node-ID.
  NmtState state() const { return state_; }
  /// State of the CAN controller, as bus_state(BusState, Time) reported it last.
  BusState bus_state() const { return bus_state_; }
  /// Object dictionary, for the application and for services.
  constexpr Dictionary& dictionary() { return dictionary_; }
  /// Object dictionary.
  const Dictionary& dictionary() const { return dictionary_; }
  /// Routes of CAN-IDs, for services of an application.
  Router& router() { return router_; }
  /// Timers, for services of an application; run by advance().
  constexpr TimerQueue& timers() { return timers_; }
  /// Way out to the bus. Frames leave in the order in which they were sent.
  Transmitter& transmitter() { return transmitter_; }
  /// Counts since the node was made; they wrap at 2^32.
  const Counters& counters() const { return counters_; }
  /// For hosts: number of reads of entries of PDO mapping records since the start, and of mappings
  /// that were set. They are read when a mapping is set, never for a frame.
  std::uint32_t mapping_reads() const { return mapping_reads_.value; }

 private:
  /// Has another name in the library for a small machine: see machine.hpp.
  template <bool small_machine>
  void start_on(Time now);
  void begin();
  void receive_odd(const Frame& frame, Time now);
  bool dispatch(const Frame& frame, Time now);
  void receive_nmt(const Frame& frame, Time now);
  void reset(ResetScope scope);
  void enter(NmtState state);
  void announce_changes();

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  NodeId node_id_;
  NodeId pending_id_;
  NodeId power_on_id_;
  bool autostart_;
  NmtState state_ = NmtState::initialisation;
  BusState bus_state_ = BusState::error_active;
  Counters counters_;
  [[no_unique_address]] HostOnly<std::uint32_t> mapping_reads_;
  Port port_;
  Dictionary dictionary_;
  Router router_;
  TimerQueue timers_;
  Transmitter transmitter_;
  Callback<void(AbortCode)> deferred_;
  Callback<void(ResetScope)> defaults_restored_;
};

template <>
void Node::start_on<is_small_machine>(Time now);

inline void Node::start(Time now) {
  start_on<is_small_machine>(now);
}

}  // namespace canvoy
