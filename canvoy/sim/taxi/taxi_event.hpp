// What happens in a taxi, as typed events: words are made of them in the tools.
//
//     if (const auto* trip = std::get_if<TripPaid>(&event.what)) print(trip->trip.paid);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/sim/car/network_changed.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/taxi/fare_referee.hpp"
#include "canvoy/sim/taxi/fault.hpp"
#include "canvoy/sim/taxi/invariant.hpp"
#include "canvoy/sim/taxi/shift.hpp"

namespace canvoy::taxi {

struct MeterChanged {
  cia447::Taximeter state = cia447::Taximeter::signed_off;
};
struct TariffChanged {
  std::array<std::uint8_t, 2> level{};  ///< its characters
};
struct TripPaid {
  Trip trip;
};
/// Something was done to the meter.
struct MeterRecorded {
  cia447::AuditEntry entry;  ///< of its audit log
};
struct AlarmPressed {};
struct ShiftChanged {
  bool begins = true;
};

using FaultBegan = canvoy::FaultBegan<FaultKind>;
using FaultEnded = canvoy::FaultEnded<FaultKind>;
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct TaxiEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               car::NetworkChanged, MeterChanged, TariffChanged, TripPaid, MeterRecorded,
               AlarmPressed, ShiftChanged, FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::taxi
