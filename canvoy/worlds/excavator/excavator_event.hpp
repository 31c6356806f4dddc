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

/// The operator begins something else.
struct ActivityChanged {
  Activity activity = Activity::sits_down;  ///< what
};
/// A bucket of earth is on the heap.
struct BucketDumped {
  double cubic_metres = 0;  ///< of this bucket
  double heap = 0;          ///< m3, in all
};
/// A button goes down.
struct ButtonPressed {
  Button button = Button::horn;  ///< which
};
/// A device of the machine that can be heard or seen is switched on or off.
struct SwitchChanged {
  Button button = Button::horn;  ///< the button for it
  bool is_on = false;            ///< true: on
};
/// Other lamps are lit at the seat.
struct LampsChanged {
  Lamps lit;  ///< after the change
};

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct ExcavatorEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               ActivityChanged, BucketDumped, ButtonPressed, SwitchChanged, LampsChanged,
               FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::excavator
