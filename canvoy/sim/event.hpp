// Events of every simulated network, as types; the tools turn them into words. Each world adds its
// own events.
//
//     using Event = std::variant<BootedUp, EmergencySeen, FaultBegan<Kind>, ..., DoorsOpened>;
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "canvoy/can/port.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/sim/invariant.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

// Seen on a bus.

struct BootedUp {
  BusIndex bus = 0;
  NodeId node = 0;
};
/// A heartbeat carries another state than the one before.
struct NmtStateSeen {
  BusIndex bus = 0;
  NodeId node = 0;
  NmtState state = NmtState::initialisation;
};
struct NmtCommandSeen {
  BusIndex bus = 0;
  NodeId node = 0;  ///< 0: all
  NmtCommand command = NmtCommand::start;
};
struct EmergencySeen {
  BusIndex bus = 0;
  NodeId node = 0;
  std::uint16_t code = 0;  ///< 0: an error is gone, or all are
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> info{};
};
struct BusStateChanged {
  BusIndex bus = 0;
  NodeId node = 0;
  BusState state = BusState::error_active;
};

/// All events that are seen on a bus.
using BusEvent =
    std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged>;

// Done by the simulation.

struct FaultPlace {
  std::uint8_t part = 0;  ///< part of the world: which lift; 0: all of it
  BusIndex bus = 0;
  NodeId node = 0;  ///< the node of the fault, also where the plan leaves it open; 0: at no node
};
template <class Kind>
struct FaultBegan {
  std::size_t fault = 0;  ///< index in the plan
  Kind kind{};
  FaultPlace place{};
};
template <class Kind>
struct FaultEnded {
  std::size_t fault = 0;
  Kind kind{};
  FaultPlace place{};
};
template <class Kind>
struct InvariantBroken {
  Invariant<Kind> invariant{};
};

}  // namespace canvoy
