// Events in the network of a battery and its charger, as types; the tools turn them into words.
//
//     if (const auto* stop = std::get_if<ReasonChanged>(&event.what)) print(stop->reason);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/worlds/charger/fault.hpp"
#include "canvoy/worlds/charger/invariant.hpp"

namespace canvoy::charger {

// Seen on the bus.

/// The first TIME message since the start.
struct TimeSeen {
  TimeOfDay time;  ///< as the message has it
};
// Reported by the charger.

/// The charger enters a phase of its work.
struct PhaseEntered {
  cia419::ChargerPhase phase = cia419::ChargerPhase::unplugged;  ///< the new one
  NodeId battery = 0;                                            ///< node-ID of the linked battery
};
/// The reason why it does not deliver changes.
struct ReasonChanged {
  cia419::StopReason reason = cia419::StopReason::none;  ///< none: it delivers, or may
};
/// Current begins to flow.
struct ChargeBegan {};
/// Current has ended.
struct ChargeEnded {
  double ampere_hours = 0;  ///< counted by the charger since the start of the simulation
};

// Done by the SDO manager of the vehicle.

/// The manager has given an SDO connection, or withdrawn it.
struct SdoConnectionChanged {
  NodeId client = 0;      ///< node that requested it
  NodeId server = 0;      ///< node-ID of the manager: the client is registered
  bool is_given = false;  ///< false: withdrawn
};

// Done by the simulation.

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct ChargerEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged, PhaseEntered,
               ReasonChanged, ChargeBegan, ChargeEnded, FaultBegan, FaultEnded, InvariantBroken,
               TimeSeen, SdoConnectionChanged, HandActed>
      what;
};

}  // namespace canvoy::charger
