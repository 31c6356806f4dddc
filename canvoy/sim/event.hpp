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

/// A boot-up message.
struct BootedUp {
  BusIndex bus = 0;  ///< of the world
  NodeId node = 0;   ///< 1 to 127
};
/// A heartbeat carries another state than the one before.
struct NmtStateSeen {
  BusIndex bus = 0;                           ///< of the world
  NodeId node = 0;                            ///< 1 to 127
  NmtState state = NmtState::initialisation;  ///< that the heartbeat carries
};
/// An NMT command on the bus, of whichever node.
struct NmtCommandSeen {
  BusIndex bus = 0;                        ///< of the world
  NodeId node = 0;                         ///< 0: all
  NmtCommand command = NmtCommand::start;  ///< command specifier
};
/// An emergency message.
struct EmergencySeen {
  BusIndex bus = 0;                    ///< of the world
  NodeId node = 0;                     ///< 1 to 127
  std::uint16_t code = 0;              ///< 0: an error is gone, or all are
  std::uint8_t error_register = 0;     ///< 1001h
  std::array<std::uint8_t, 5> info{};  ///< manufacturer-specific field
};
/// The state of a controller has changed, with or without a frame that tells it.
struct BusStateChanged {
  BusIndex bus = 0;                         ///< of the world
  NodeId node = 0;                          ///< of the node
  BusState state = BusState::error_active;  ///< of its controller
};

/// All events that are seen on a bus.
using BusEvent =
    std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged>;

// Done by the simulation.

/// Where a fault is.
struct FaultPlace {
  std::uint8_t part = 0;  ///< part of the world: which lift; 0: all of it
  BusIndex bus = 0;       ///< of the world
  NodeId node = 0;  ///< the node of the fault, also where the plan leaves it open; 0: at no node
};
/// A fault of the plan begins.
template <class Kind>
struct FaultBegan {
  std::size_t fault = 0;  ///< index in the plan
  Kind kind{};            ///< of fault
  FaultPlace place{};     ///< of the fault
};
/// A fault of the plan ends.
template <class Kind>
struct FaultEnded {
  std::size_t fault = 0;  ///< index in the plan
  Kind kind{};            ///< of fault
  FaultPlace place{};     ///< of the fault
};
/// An invariant no longer holds; reported once.
template <class Kind>
struct InvariantBroken {
  Invariant<Kind> invariant{};  ///< with its measure at that time
};

}  // namespace canvoy
