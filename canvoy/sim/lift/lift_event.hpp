// What happens in a network of lifts, as typed events: words are made of them in the tools.
//
//     if (const auto* stop = std::get_if<CarStopped>(&event.what)) print(stop->floor);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/fault.hpp"
#include "canvoy/sim/lift/invariant.hpp"
#include "canvoy/sim/lift/referee.hpp"
#include "canvoy/sim/lift/safety_chain.hpp"

namespace canvoy::lift {

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
/// The safety chain is open until somebody comes; `none`: he has, and has reset it by hand.
struct ChainTripped {
  LiftNumber lift = 1;
  SafetyChain::Trip trip = SafetyChain::Trip::none;
};

// Done by the simulation. The part of a place is the number of a lift; 0: the group, or all.

using FaultBegan = canvoy::FaultBegan<FaultKind>;
using FaultEnded = canvoy::FaultEnded<FaultKind>;
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct LiftEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, EmergencySeen, BusStateChanged, LampChanged, CarStarted,
               CarStopped, DoorsOpened, ChainTripped, FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::lift
