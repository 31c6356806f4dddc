// A CANopen node without its services: dictionary, NMT slave, routes, timers, and the way to the
// bus (CiA 301, 7.3.2).
//
// It owns no socket, thread, clock or heap. Whoever owns it hands in frames and points in time, and
// calls again at deadline(). Services (SDO, PDO, heartbeat ...) attach themselves, and only those
// that are used are linked.
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
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/emergency/error.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/canopen/router.hpp"
#include "canvoy/canopen/service.hpp"
#include "canvoy/canopen/timer_queue.hpp"
#include "canvoy/canopen/transmitter.hpp"

namespace canvoy {

/// The same for applications, which set what they care for at run time: callbacks, all optional, as
/// ServiceCalls has them.
struct Service {
  Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  Callback<void(ResetScope)> reset = {};
  Callback<void(NmtState)> state_entered = {};
  Callback<void(BusState)> bus_state_changed = {};
  Callback<void(const Error&, bool present)> error_changed = {};
  Callback<void(std::uint32_t)> values_changed = {};
  Callback<void()> tx_ready = {};
  ServiceLink link{&calls, this};

 private:
  template <auto callback, class... Arguments>
  static void forward(void* service, Arguments... arguments) {
    (static_cast<Service*>(service)->*callback)(arguments...);
  }
  static const ServiceCalls calls;
};
inline constexpr ServiceCalls Service::calls = {
    .reset = forward<&Service::reset, ResetScope>,
    .state_entered = forward<&Service::state_entered, NmtState>,
    .bus_state_changed = forward<&Service::bus_state_changed, BusState>,
    .error_changed = forward<&Service::error_changed, const Error&, bool>,
    .values_changed = forward<&Service::values_changed, std::uint32_t>,
    .tx_ready = forward<&Service::tx_ready>,
};

/// What a node needs of memory; it must outlive the node.
struct NodeMemory {
  std::span<std::uint8_t> values;   ///< DictionaryTables::value_bytes
  std::span<ObjectState> states;    ///< one for each ObjectRow; none on a small machine
  std::span<Router::Route> routes;  ///< one for each CAN-ID that a service wants
  std::span<Frame> backlog;         ///< frames that wait for the controller
};

class Node {
 public:
  /// What the bus brought and nobody could use.
  struct Counters {
    std::uint32_t received = 0;   ///< frames of any kind
    std::uint32_t unwanted = 0;   ///< CAN-IDs that no service of this node knows
    std::uint32_t extended = 0;   ///< frames that are not 11-bit data or remote frames
    std::uint32_t malformed = 0;  ///< wrong length, unknown command: ignored by a service
    std::uint32_t bus_off = 0;    ///< times that the controller went bus-off
    std::uint32_t overruns = 0;   ///< frames that the controller lost
  };

  /// `node_id` is 1 to 127, or node_id_unconfigured: then the node stays in initialisation, without
  /// a boot-up message, until it has one (see set_pending_id()).
  /// `autostart` makes it enter operational by itself after boot-up (CiA 302-2).
  ///
  /// A node on a small machine can be constant-initialised, in memory that is zero. Its dictionary
  /// then has its defaults from start() on.
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

  /// Power-on: initialisation, boot-up message, pre-operational.
  void start(Time now);

  void receive(const Frame& frame, Time now);
  /// Does what is due. Call it at deadline(), and after application code wrote values.
  void advance(Time now);
  /// When advance() wants to be called: in the past where something waits already.
  Time deadline() const { return dictionary_.changes() != 0 ? Time::min() : timers_.deadline(); }

  /// The controller's state changed.
  void bus_state(BusState state, Time now);
  /// The controller has room for frames again, or a frame has left. Where none had to wait, nobody
  /// is told.
  void tx_ready(Time now);
  /// The controller lost received frames.
  void overrun(Time now);

  /// As if the NMT master had sent it. From outside of a callback, call advance(now) before.
  void command(NmtCommand command);

  /// The node-ID that it takes at the next NMT reset communication (CiA 305: pending node-ID): 1 to
  /// 127, or node_id_unconfigured.
  void set_pending_id(NodeId id) { pending_id_ = id; }
  /// The node-ID that it takes when it starts, and at NMT reset node (CiA 305: persistent node-ID).
  void set_power_on_id(NodeId id) { power_on_id_ = id; }
  /// Takes the pending node-ID and boots, where that is one and there was none before.
  void take_first_id();

  /// Services are told of things in the order in which they attached.
  constexpr void attach(NodeService& service) { dictionary_.attach(service); }
  constexpr void attach(ServiceLink& service) { dictionary_.attach(service); }
  void attach(Service& service) { attach(service.link); }
  void raise(const Error& error) { report(error, true); }
  void clear(const Error& error) { report(error, false); }
  /// An error came (`is_present`) or went.
  void report(const Error& error, bool is_present);
  /// A write to which a hook answered `deferred` is done, or has failed. One is under way at a
  /// time: a hook refuses another while is_deferred().
  void finish_deferred(AbortCode answer) { std::exchange(deferred_, {})(answer); }
  /// `done` is called once, with that answer.
  void await_deferred(Callback<void(AbortCode)> done) { deferred_ = done; }
  bool is_deferred() const { return static_cast<bool>(deferred_); }
  /// Called at each reset after the defaults are back and before any service is told: who keeps
  /// other power-on values puts them in their places (a device of which values depend on its
  /// node-ID; storage, CiA 301, 1010h). Answers who was called until now.
  Callback<void(ResetScope)> on_defaults_restored(Callback<void(ResetScope)> restored) {
    return std::exchange(defaults_restored_, restored);
  }

  /// Sends the error control message: the NMT state, which is the boot-up message in
  /// initialisation.
  void send_state();
  /// Sync calls it: `actuate`, and then `sample`.
  void tell_sync(ServiceEvent::Kind phase, std::uint8_t counter) {
    if constexpr (is_small_machine) {
      dictionary_.tell(phase, counter);
    } else {
      ServiceEvent event{.kind = phase, .number = counter};
      dictionary_.tell_frequent(event);
    }
  }
  /// A service ignored a frame.
  void count_malformed() { ++counters_.malformed; }

  /// The time of the call that is under way, or of the last one.
  Time now() const { return timers_.now(); }
  /// Microseconds of it since `past`, or UINT32_MAX where there are more.
  std::uint32_t elapsed_since(Time past) const;
  NodeId id() const { return node_id_; }
  NodeId pending_id() const { return pending_id_; }
  NmtState state() const { return state_; }
  BusState bus_state() const { return bus_state_; }
  constexpr Dictionary& dictionary() { return dictionary_; }
  const Dictionary& dictionary() const { return dictionary_; }
  Router& router() { return router_; }
  constexpr TimerQueue& timers() { return timers_; }
  Transmitter& transmitter() { return transmitter_; }
  const Counters& counters() const { return counters_; }

 private:
  /// Its name is another one in the library for a small machine: see machine.hpp.
  template <bool small_machine>
  void start_on(Time now);
  void begin();
  void receive_odd(const Frame& frame, Time now);
  bool dispatch(const Frame& frame, Time now);
  void receive_nmt(const Frame& frame, Time now);
  void reset(ResetScope scope);
  void enter(NmtState state);
  void announce_changes();

  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  NodeId node_id_;
  NodeId pending_id_;
  NodeId power_on_id_;
  bool autostart_;
  NmtState state_ = NmtState::initialisation;
  BusState bus_state_ = BusState::error_active;
  Counters counters_;
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
