// Events in a network of lifts, as types; the tools turn them into words.
//
//     if (const auto* stop = std::get_if<CarStopped>(&event.what)) print(stop->floor);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/fault.hpp"
#include "canvoy/worlds/lift/invariant.hpp"
#include "canvoy/worlds/lift/referee.hpp"
#include "canvoy/worlds/lift/safety_chain.hpp"
#include "canvoy/worlds/lift/technician.hpp"

namespace canvoy::lift {

// Seen in the building.

/// The lamp of a call is lit or goes out, as people see it.
struct LampChanged {
  CallKey call{};                 ///< the call
  bool lit = false;               ///< true: lit; false: it goes out
  CallEnd end = CallEnd::served;  ///< why its lamp goes out
};
/// A car leaves a standstill.
struct CarStarted {
  LiftNumber lift = 1;           ///< from 1
  FloorNumber floor = no_floor;  ///< floor where it stood; no_floor: between two
  unsigned persons = 0;          ///< people in the car
};
/// A car has come to rest.
struct CarStopped {
  LiftNumber lift = 1;           ///< from 1
  FloorNumber floor = no_floor;  ///< where it stands; no_floor: between two
};
/// A door is no longer closed.
struct DoorsOpened {
  LiftNumber lift = 1;           ///< from 1
  FloorNumber floor = no_floor;  ///< where the car stands; no_floor: between two
};
/// The safety chain is open until a technician resets it by hand; `none`: it was reset.
struct ChainTripped {
  LiftNumber lift = 1;                               ///< from 1
  SafetyChain::Trip trip = SafetyChain::Trip::none;  ///< the part that tripped
};

/// A step of a technician, or the cause of the call.
struct TechnicianDid {
  LiftNumber lift = 1;                            ///< where the technician is
  TechnicianStep step = TechnicianStep::arrives;  ///< the step
  FloorNumber floor = no_floor;                   ///< where the technician moves the car, and lets
                                                  ///< people out
};

// Done by the simulation. The part of a place is the number of a lift; 0: the group, or all.

/// A fault of the plan begins; its part is the number of the lift.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct LiftEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, EmergencySeen, BusStateChanged, LampChanged, CarStarted,
               CarStopped, DoorsOpened, ChainTripped, TechnicianDid, HandActed, FaultBegan,
               FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::lift
