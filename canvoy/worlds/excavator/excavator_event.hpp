// Events in an excavator, as types; the tools turn them into words.
//
//     if (const auto* change = std::get_if<ActivityChanged>(&event.what)) print(change->activity);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/worlds/excavator/excavator_fault.hpp"
#include "canvoy/worlds/excavator/excavator_operator.hpp"

namespace canvoy::excavator {

struct ActivityChanged {
  Activity activity = Activity::sits_down;
};
/// A bucket of earth is on the heap.
struct BucketDumped {
  double cubic_metres = 0;
  double heap = 0;  ///< m3, in all
};
struct ButtonPressed {
  Button button = Button::horn;
};
/// A device of the machine that can be heard or seen is switched on or off.
struct SwitchChanged {
  Button button = Button::horn;  ///< the button for it
  bool is_on = false;
};
/// Other lamps are lit at the seat.
struct LampsChanged {
  Lamps lit;
};

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct ExcavatorEvent {
  Time at{};  ///< since the start of the run
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               ActivityChanged, BucketDumped, ButtonPressed, SwitchChanged, LampsChanged,
               FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::excavator
