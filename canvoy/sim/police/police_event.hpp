// What happens in a police car, as typed events: words are made of them in the tools.
//
//     if (const auto* call = std::get_if<CallMade>(&event.what)) print(call->destination);
#pragma once

#include <optional>
#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/car/network_changed.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/police/client.hpp"
#include "canvoy/sim/police/crew.hpp"
#include "canvoy/sim/police/fault.hpp"
#include "canvoy/sim/police/invariant.hpp"

namespace canvoy::police {

/// The control room calls for help.
struct CallMade {
  unsigned destination = 0;
  double metres = 0;  ///< to there
};
struct ActivityChanged {
  Activity activity = Activity::off_duty;
};
/// What is seen and heard of the car.
struct SignalsChanged {
  bool is_blue = false;
  bool has_siren = false;

  bool operator==(const SignalsChanged&) const = default;
};
/// Who is read on display 1; nothing: the car itself.
struct TerminalTaken {
  std::optional<Client> client{};
};
/// The control room has got a status message.
struct StatusSent {
  int status = 0;
};
struct PowerSwitched {
  bool is_radio = true;  ///< else periphery
  bool is_on = false;
};

using FaultBegan = canvoy::FaultBegan<FaultKind>;
using FaultEnded = canvoy::FaultEnded<FaultKind>;
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct PoliceEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               car::NetworkChanged, CallMade, ActivityChanged, SignalsChanged, TerminalTaken,
               StatusSent, PowerSwitched, FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::police
