// What happens in the network of a battery and its charger, as typed events: words are made of them
// in the tools.
//
//     if (const auto* stop = std::get_if<ReasonChanged>(&event.what)) print(stop->reason);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/nmt.hpp"
#include "canvoy/canopen/time_of_day.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/sim/charging/invariant.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy {

// Seen on the bus.

struct BootedUp {
  NodeId node = 0;
};
/// A heartbeat tells another state than the one before.
struct NmtStateSeen {
  NodeId node = 0;
  NmtState state = NmtState::initialisation;
};
struct NmtCommandSeen {
  NodeId node = 0;  ///< 0: all
  NmtCommand command = NmtCommand::start;
};
struct EmergencySeen {
  NodeId node = 0;
  std::uint16_t code = 0;  ///< 0: an error is gone, or all are
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> info{};
};
/// The first TIME message since the start.
struct TimeSeen {
  TimeOfDay time;
};
struct BusStateChanged {
  NodeId node = 0;
  BusState state = BusState::error_active;
};

// Said by the charger.

struct PhaseEntered {
  cia419::ChargerPhase phase = cia419::ChargerPhase::unplugged;
  NodeId battery = 0;  ///< where it is linked
};
struct ReasonChanged {
  cia419::StopReason reason = cia419::StopReason::none;
};
struct ChargeBegan {};
struct ChargeEnded {
  double ampere_hours = 0;  ///< as the charger counted them since the start of the simulation
};

// Done by the SDO manager of the vehicle.

struct SdoConnectionChanged {
  NodeId client = 0;
  NodeId server = 0;  ///< that of the manager: the client is registered
  bool is_given = false;
};

// Done by the simulation.

struct FaultBegan {
  std::size_t fault = 0;  ///< its place in the plan
  FaultKind kind = FaultKind::heartbeat_loss;
};
struct FaultEnded {
  std::size_t fault = 0;
  FaultKind kind = FaultKind::heartbeat_loss;
};
struct InvariantBroken {
  Invariant invariant;
};

struct ChargingEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged, PhaseEntered,
               ReasonChanged, ChargeBegan, ChargeEnded, FaultBegan, FaultEnded, InvariantBroken,
               TimeSeen, SdoConnectionChanged>
      what;
};

}  // namespace canvoy
