// What happens in a network of lifts, as typed events: words are made of them in the tools.
//
//     if (const auto* stop = std::get_if<CarStopped>(&event.what)) print(stop->floor);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/nmt.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/fault.hpp"
#include "canvoy/sim/lift/invariant.hpp"
#include "canvoy/sim/lift/referee.hpp"

namespace canvoy::lift {

// Seen on a bus.

struct BootedUp {
  std::size_t bus = 0;
  NodeId node = 0;
};
/// A heartbeat tells another state than the one before.
struct NmtStateSeen {
  std::size_t bus = 0;
  NodeId node = 0;
  NmtState state = NmtState::initialisation;
};
struct EmergencySeen {
  std::size_t bus = 0;
  NodeId node = 0;
  std::uint16_t code = 0;  ///< 0: an error is gone, or all are
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> info{};
};
struct BusStateChanged {
  std::size_t bus = 0;
  NodeId node = 0;
  BusState state = BusState::error_active;
};

// Seen in the building.

struct LampChanged {
  CallKey call{};
  bool lit = false;
  CallEnd end = CallEnd::served;  ///< why it goes out
};
struct CarStarted {
  LiftNumber lift = 1;
  FloorNumber floor = no_floor;  ///< where it stood; no_floor: between two
  unsigned persons = 0;
};
struct CarStopped {
  LiftNumber lift = 1;
  FloorNumber floor = no_floor;
};
struct DoorsOpened {
  LiftNumber lift = 1;
  FloorNumber floor = no_floor;
};

// Done by the simulation.

struct FaultPlace {
  LiftNumber lift = 0;  ///< 0: the group; of a fire alarm all
  std::size_t bus = 0;
  NodeId node = 0;  ///< also where the plan left it open; 0: at no node
};
struct FaultBegan {
  std::size_t fault = 0;  ///< its place in the plan
  FaultKind kind = FaultKind::lost_node;
  FaultPlace place{};
};
struct FaultEnded {
  std::size_t fault = 0;
  FaultKind kind = FaultKind::lost_node;
  FaultPlace place{};
};
struct InvariantBroken {
  Invariant invariant{};
};

struct LiftEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, EmergencySeen, BusStateChanged, LampChanged, CarStarted,
               CarStopped, DoorsOpened, FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::lift
