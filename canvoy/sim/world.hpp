// A simulated world: buses, the nodes on them, plants, and planned actions, all in one virtual
// time.
//
//     World world;
//     const BusIndex bus = world.add_bus({.bit_rate = 125'000});
//     const SlotIndex slot = world.add_slot(bus);
//     Node charger(tables, memory, world.port(slot), 5);
//     world.occupy(slot, charger);
//     world.start(slot);
//     world.at(Time(20min), [&](Time) { world.stop(slot); });
//     world.run_until(Time(8h));
//
// The world is deterministic. What is due at one time happens in this order: the buses, actions in
// the order in which they were given, then plants and nodes in the order in which they were added.
// Memory is allocated while the world is put together and by at(), not while it runs.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <queue>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/simulated/drifting_clock.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/deadline_tree.hpp"

namespace canvoy {

/// Participant of a bus: a Node, or a tool or tester with the same six functions. Its times are
/// those of its own clock.
template <class T>
concept WorldNode = requires(T node, const T& idle, const Frame& frame, Time now, BusState state) {
  node.start(now);
  node.receive(frame, now);
  node.advance(now);
  { idle.deadline() } -> std::convertible_to<Time>;
  node.bus_state(state, now);
  node.tx_ready(now);
  node.overrun(now);
};

/// Number of a bus, from 0 in the order of add_bus().
using BusIndex = std::size_t;
/// Number of a slot, from 0 in the order of add_slot(), on whichever bus.
using SlotIndex = std::size_t;
/// Number of a plant, from 0 in the order in which they were added.
using PlantIndex = std::size_t;

/// Connection of a node.
struct SlotOptions {
  std::int32_t clock_drift_ppm = 0;  ///< drift of the node's clock against the world's
  std::uint32_t bit_rate = 0;        ///< bit/s, like ControllerOptions; 0: that of the bus
  TransmitOrder transmit_order = TransmitOrder::as_queued;  ///< order of its transmit queue
  bool listen_only = false;                                 ///< see ControllerOptions
  bool accept_all = false;  ///< false: only the identifiers that the node requests by Port::accept
};

class World {
 public:
  /// Called with the time of the world.
  using Action = std::function<void(Time)>;

  World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Adds a bus; valid as long as the world.
  BusIndex add_bus(const SimulatedBusOptions& options = {});
  /// A bus; `index` must exist.
  SimulatedBus& bus(BusIndex index = 0) { return *buses_[index]; }
  /// A bus; `index` must exist.
  const SimulatedBus& bus(BusIndex index = 0) const { return *buses_[index]; }

  /// Adds a connection for a node at the end of a cable of a bus. The bus must have a controller
  /// left.
  SlotIndex add_slot(BusIndex bus, const SlotOptions& options = {});
  /// Port through which the node of this slot sends; valid as long as the world.
  Port port(SlotIndex slot);
  /// The node must outlive the world's last run. It is silent until start().
  template <WorldNode T>
  void occupy(SlotIndex slot, T& node) {
    slots_[slot].node = &node;
    slots_[slot].calls = &calls_of<T>;
  }
  /// Controller of a slot, on its bus.
  ControllerId controller(SlotIndex slot) const { return slots_[slot].controller; }

  /// Switches power on, or off and on again: the node boots.
  void start(SlotIndex slot);
  /// Switches power off: the node hears, acknowledges and sends nothing.
  void stop(SlotIndex slot);
  /// True while the node of a slot has power.
  bool is_running(SlotIndex slot) const { return slots_[slot].runs; }
  /// Call it after a node was changed from outside of the world (a tool that writes a value between
  /// two runs): its deadline is read again.
  void touched(SlotIndex slot) { update_deadline(slots_[slot]); }
  /// Makes the clock of a node gain or lose from this time on; the clock does not jump.
  void set_clock_drift(SlotIndex slot, std::int32_t drift_ppm);

  /// Calls `step` each `period` from now + period on. `period` is above zero.
  PlantIndex add_plant(Callback<void(Time)> step, Duration period);
  /// Calls `step` once for each wake(): for a plant that often has nothing to do.
  PlantIndex add_sleeping_plant(Callback<void(Time)> step);
  /// Sets the next step of the plant to `when`, or at once where that has passed; never: it sleeps.
  void wake(PlantIndex plant, Time when);
  /// Like wake(), but a step that is due before stays at its time.
  void wake_before(PlantIndex plant, Time when);

  /// Calls `action` at `when`, or at once in the next run where that has passed.
  void at(Time when, Action action);

  /// Time up to which the world has run; within a call of an action or a node, its time.
  Time now() const { return now_; }
  /// Runs up to and including `until`.
  void run_until(Time until);
  /// Runs for `duration` from now() on.
  void run_for(Duration duration) { run_until(now_ + duration); }

  /// Number of times that a node was due again after calls_max calls at one instant. Such a node
  /// has a fault; it is called again a microsecond later, and the world goes on.
  std::uint64_t livelocks() const { return livelocks_; }
  static constexpr int calls_max = 1000;  ///< of a node at one instant
  /// Sum of Node::mapping_reads() of all nodes that count them.
  std::uint64_t mapping_reads() const;

 private:
  /// A node's functions, without its type.
  struct NodeCalls {
    void (*start)(void* node, Time now);
    void (*receive)(void* node, const Frame& frame, Time now);
    void (*advance)(void* node, Time now);
    Time (*deadline)(const void* node);
    void (*bus_state)(void* node, BusState state, Time now);
    void (*tx_ready)(void* node, Time now);
    void (*overrun)(void* node, Time now);
    std::uint64_t (*mapping_reads)(const void* node);  ///< 0: the node does not count them
  };
  template <WorldNode T>
  static constexpr NodeCalls calls_of = {
      [](void* node, Time now) { static_cast<T*>(node)->start(now); },
      [](void* node, const Frame& frame, Time now) { static_cast<T*>(node)->receive(frame, now); },
      [](void* node, Time now) { static_cast<T*>(node)->advance(now); },
      [](const void* node) -> Time { return static_cast<const T*>(node)->deadline(); },
      [](void* node, BusState state, Time now) { static_cast<T*>(node)->bus_state(state, now); },
      [](void* node, Time now) { static_cast<T*>(node)->tx_ready(now); },
      [](void* node, Time now) { static_cast<T*>(node)->overrun(now); },
      [](const void* node) -> std::uint64_t {
        if constexpr (requires(const T& it) { it.mapping_reads(); }) {
          return static_cast<const T*>(node)->mapping_reads();
        } else {
          return 0;
        }
      },
  };

  struct Slot {
    World* world = nullptr;
    void* node = nullptr;
    const NodeCalls* calls = nullptr;
    std::size_t actor = 0;
    BusIndex bus = 0;
    ControllerId controller = no_controller;
    bool runs = false;
    DriftingClock clock{};
    Time clock_zero_world{};  ///< time at which `clock` starts, by the world's clock
    Time clock_zero_node{};   ///< by the node's clock

    Time node_time(Time at) const {
      return clock_zero_node + (clock.node_time(Time(at - clock_zero_world)) - Time{});
    }
    Time world_time(Time at) const {
      return clock_zero_world + (clock.world_time(Time(at - clock_zero_node)) - Time{});
    }
  };
  struct Plant {
    Callback<void(Time)> step;
    Duration period{};  ///< 0: a plant that is woken
    Time next{};
    std::size_t actor = 0;
  };
  struct Planned {
    Time when{};
    std::uint64_t order = 0;
    Action action;
    /// std::priority_queue has the greatest on top.
    bool operator<(const Planned& other) const {
      return when != other.when ? when > other.when : order > other.order;
    }
  };
  /// Kind of an actor in the tree.
  struct Actor {
    enum class Kind : std::uint8_t { plan, plant, node } kind = Kind::plan;
    std::size_t index = 0;
  };

  template <class Call>
  static void tell(void* context, Time now, const Call& call);
  static BusListener listener_of(Slot& slot);
  PlantIndex add(const Plant& plant);
  void advance_buses(Time limit);
  void call_due();
  void call(const Actor& actor);
  void call_plant(Plant& plant);
  void call_node(Slot& slot);
  void do_planned();
  void update_deadline(const Slot& slot);
  void set_deadline(std::size_t actor, Time deadline);

  std::vector<std::unique_ptr<SimulatedBus>> buses_;
  std::deque<Slot> slots_;  // the buses keep addresses of slots
  std::vector<Plant> plants_;
  std::vector<Actor> actors_;
  DeadlineTree deadlines_;
  std::priority_queue<Planned> plan_;
  std::uint64_t plan_order_ = 0;
  std::uint64_t livelocks_ = 0;
  Time now_{};
  Time limit_{};  ///< time up to which the buses run without a look at the deadlines
};

}  // namespace canvoy
