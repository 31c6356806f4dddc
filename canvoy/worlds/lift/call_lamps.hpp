// The lit lamps of calls in a building: a landing has panels of all lifts, and a call is lit as
// long as one of them shows it.
//
//     CallLamps lamps;
//     if (lamps.set(now, 1, call, true) == CallLamps::Change::lit) ...   // on the panel of lift 1
//     lamps.is_lit(call); lamps.lit_at(call); lamps.car_calls(1);
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/referee.hpp"

namespace canvoy::lift {

class CallLamps {
 public:
  /// What people see of it: the first panel that shows a call lights it, the last one darkens it.
  enum class Change : std::uint8_t { none, lit, dark };

  /// Sets a lamp on the panel of this lift, and returns the change for people, who look at all
  /// panels.
  Change set(Time now, LiftNumber lift, const CallKey& call, bool is_lit);

  /// True if a panel of any lift shows the call.
  bool is_lit(const CallKey& call) const { return lit_.contains(call); }
  /// Time at which it was last lit; never: it was not.
  Time lit_at(const CallKey& call) const;
  /// True while the panels of several lifts show one call of a landing: a lift without a group
  /// shows the calls of its own panels.
  bool are_shared() const;
  /// Floors with a lit button in the car, lowest first.
  std::vector<FloorNumber> car_calls(LiftNumber lift) const;

 private:
  std::map<CallKey, unsigned> lit_;  ///< lifts with a lit lamp on their panel; bit 0 is lift 1
  std::map<CallKey, Time> lit_at_;
};

}  // namespace canvoy::lift
