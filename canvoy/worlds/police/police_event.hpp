// Events in a police car, as types; the tools turn them into words.
//
//     if (const auto* call = std::get_if<CallMade>(&event.what)) print(call->destination);
#pragma once

#include <optional>
#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/worlds/car/network_changed.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/fault.hpp"
#include "canvoy/worlds/police/invariant.hpp"

namespace canvoy::police {

/// The control room makes a call for help.
struct CallMade {
  unsigned destination = 0;  ///< number to type, 100 to 999
  double metres = 0;         ///< distance of the scene
};
/// The crew does something else.
struct ActivityChanged {
  Activity activity = Activity::off_duty;  ///< what
};
/// Signals of the car that can be seen and heard.
struct SignalsChanged {
  bool is_blue = false;    ///< the blue light flashes
  bool has_siren = false;  ///< the siren is heard

  bool operator==(const SignalsChanged&) const = default;
};
/// Client on display 1; empty: the car itself.
struct TerminalTaken {
  std::optional<Client> client{};  ///< empty: no client
};
/// The control room has received a status message.
struct StatusSent {
  int status = 0;  ///< 0 to 9
};
/// The power supply switches its power on or off.
struct PowerSwitched {
  bool is_radio = true;  ///< false: periphery
  bool is_on = false;    ///< true: on
};

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct PoliceEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               car::NetworkChanged, HandActed, CallMade, ActivityChanged, SignalsChanged,
               TerminalTaken, StatusSent, PowerSwitched, FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::police
