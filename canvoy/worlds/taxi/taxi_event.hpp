// Events in a taxi, as types; the tools turn them into words.
//
//     if (const auto* trip = std::get_if<TripPaid>(&event.what)) print(trip->trip.paid);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/worlds/car/network_changed.hpp"
#include "canvoy/worlds/taxi/fare_referee.hpp"
#include "canvoy/worlds/taxi/fault.hpp"
#include "canvoy/worlds/taxi/invariant.hpp"
#include "canvoy/worlds/taxi/shift.hpp"

namespace canvoy::taxi {

/// The taximeter enters another state.
struct MeterChanged {
  cia447::Taximeter state = cia447::Taximeter::signed_off;  ///< 60D0h:01h
};
/// The tariff display shows another level.
struct TariffChanged {
  std::array<std::uint8_t, 2> level{};  ///< its characters
};
/// A trip is over.
struct TripPaid {
  Trip trip;  ///< as driven, metered and paid
};
/// The meter has recorded an event.
struct MeterRecorded {
  cia447::AuditEntry entry;  ///< of its audit log
};
/// Visible action of passengers.
struct PassengersSeen {
  /// The action.
  enum class Doing : std::uint8_t {
    get_in,                 ///< the trip begins
    stay_away,              ///< the people who have called do not come
    get_out,                ///< they have paid
    walk_away               ///< the meter did not start
  } doing = Doing::get_in;  ///< at this time
};
/// A key of a real meter must be pressed: the driver waits until it reports this state.
struct MeterWaitedFor {
  cia447::Taximeter state = cia447::Taximeter::for_hire;  ///< of 60D0h:01h
};
/// The driver presses the alarm key.
struct AlarmPressed {};
/// The control room has heard the call after an alarm.
struct CallHeard {};
/// The driver signs on or off.
struct ShiftChanged {
  bool begins = true;  ///< true: on
};

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct TaxiEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               car::NetworkChanged, HandActed, MeterChanged, TariffChanged, TripPaid, MeterRecorded,
               PassengersSeen, MeterWaitedFor, AlarmPressed, CallHeard, ShiftChanged, FaultBegan,
               FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::taxi
