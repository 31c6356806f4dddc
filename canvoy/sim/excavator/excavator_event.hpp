// What happens in an excavator, as typed events: words are made of them in the tools.
//
//     if (const auto* change = std::get_if<ActivityChanged>(&event.what)) print(change->activity);
#pragma once

#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/excavator/excavator_fault.hpp"
#include "canvoy/sim/excavator/excavator_operator.hpp"

namespace canvoy::excavator {

struct ActivityChanged {
  Activity activity = Activity::sits_down;
};
/// A bucket of earth is on the heap.
struct BucketDumped {
  double cubic_metres = 0;
  double heap = 0;  ///< m3, all of it
};
struct ButtonPressed {
  Button button = Button::horn;
};
/// What is heard or seen of the machine.
struct SwitchChanged {
  Button button = Button::horn;  ///< what it belongs to
  bool is_on = false;
};
/// Which lamps are lit at the seat.
struct LampsChanged {
  Lamps lit;
};

using FaultBegan = canvoy::FaultBegan<FaultKind>;
using FaultEnded = canvoy::FaultEnded<FaultKind>;
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct ExcavatorEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged,
               ActivityChanged, BucketDumped, ButtonPressed, SwitchChanged, LampsChanged,
               FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::excavator
