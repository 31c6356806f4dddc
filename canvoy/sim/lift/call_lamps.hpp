// Which lamps of calls are lit in a building: a landing has panels of all lifts, and a call is lit
// as long as one of them shows it.
//
//     CallLamps lamps;
//     if (lamps.set(now, 1, call, true) == CallLamps::Change::lit) ...   // on the panel of lift 1
//     lamps.is_lit(call); lamps.lit_at(call); lamps.car_calls(1);
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/referee.hpp"

namespace canvoy::lift {

class CallLamps {
 public:
  enum class Change : std::uint8_t { none, lit, dark };

  /// On the panel of this lift; what that is for people, who look at all of them.
  Change set(Time now, LiftNumber lift, const CallKey& call, bool is_lit);

  bool is_lit(const CallKey& call) const { return lit_.contains(call); }
  /// The last time; never: it was not.
  Time lit_at(const CallKey& call) const;
  /// The panels of several lifts show one call of a landing: who is alone shows those of its own
  /// panels.
  bool are_shared() const;
  /// Floors whose buttons are lit in the car, lowest first.
  std::vector<FloorNumber> car_calls(LiftNumber lift) const;

 private:
  std::map<CallKey, unsigned> lit_;  ///< on which lifts' panels, bit 0 is lift 1
  std::map<CallKey, Time> lit_at_;
};

}  // namespace canvoy::lift
