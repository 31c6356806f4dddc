// State of every simulated network at one instant: its buses and its nodes. Each world adds its
// own.
//
//     look.nodes.push_back(snapshot_of(world, *node, bus_watch, time_out));
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/can/port.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

/// State of a bus.
struct BusSnapshot {
  double load = 0;                 ///< bus load of the last second, 0 to 1
  std::uint64_t frames = 0;        ///< since the start
  std::uint64_t error_frames = 0;  ///< since the start
};

/// State of a node.
struct NodeSnapshot {
  BusIndex bus = 0;                             ///< of the world
  NodeId id = 0;                                ///< node-ID
  bool is_powered = true;                       ///< as far as it is known
  NmtState state = NmtState::initialisation;    ///< in force, or last heard
  BusState bus_state = BusState::error_active;  ///< of a node that is simulated here
  std::uint8_t error_register = 0;              ///< 1001h, of a node that is simulated here
};

/// Snapshot of a node that is simulated here, in this slot of this bus of the world.
inline NodeSnapshot played_snapshot(World& world, BusIndex bus, SlotIndex slot, const Node& node) {
  return {.bus = bus,
          .id = node.id(),
          .is_powered = world.is_running(slot),
          .state = node.state(),
          .bus_state = world.bus(bus).state(world.controller(slot)),
          .error_register =
              static_cast<std::uint8_t>(node.dictionary().number(object_index::error_register, 0))};
}

/// Snapshot of a node that runs elsewhere: only what is heard of it.
inline NodeSnapshot heard_snapshot(BusIndex bus, NodeId id, RemoteState heard) {
  const bool is_there = heard != RemoteState::unknown && heard != RemoteState::lost;
  return {.bus = bus,
          .id = id,
          .is_powered = is_there,
          .state = is_there ? static_cast<NmtState>(heard) : NmtState::initialisation};
}

// Snapshot of a node of a world; its slot says whether it is simulated here. Otherwise, its state
// is the one that the watch of its bus has heard in the last `time_out`.

/// Snapshot of a node of a world, simulated here or not.
template <class SimulatedNode>
NodeSnapshot snapshot_of(World& world, SimulatedNode& node, const BusWatch& watch,
                         Duration time_out) {
  const NodeId id = node.place().id;
  if (!node.place().is_played) {
    return heard_snapshot(node.bus(), id, watch.heard_of(id, world.now(), time_out));
  }
  NodeSnapshot look = played_snapshot(world, node.bus(), node.slot(), node.node());
  look.id = id;  // set even while the node has none
  return look;
}

/// True if the node does its work.
template <class SimulatedNode>
bool is_at_work(const World& world, SimulatedNode& node, const BusWatch& watch, Duration time_out) {
  if (node.place().is_played) return node.is_operational();
  return watch.heard_of(node.place().id, world.now(), time_out) == RemoteState::operational;
}

}  // namespace canvoy
