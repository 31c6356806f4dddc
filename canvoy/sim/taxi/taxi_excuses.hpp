// What a fault of a taxi excuses: that, and only that, which it can cause, for as long as it can.
//
//     can_cause({.kind = FaultKind::restart, .node = alarm_id}, InvariantKind::fare)    // false
//
//     TaxiExcuses excuses;
//     excuses.begins(fault, now);
//     excuses.ends(fault, now);
//     if (excuses.is_excused(InvariantKind::receipts, now)) ...
//     if (excuses.may_be_missing(printer_id, now)) ...
#pragma once

#include <algorithm>
#include <array>

#include "canvoy/sim/taxi/fault.hpp"
#include "canvoy/sim/taxi/invariant.hpp"
#include "canvoy/sim/taxi/taxi_options.hpp"

namespace canvoy::taxi {

/// Whether a fault of this kind, at its place, can make what the invariant is about wrong.
bool can_cause(const ScheduledFault& fault, InvariantKind kind);
/// Whether it can keep a device of this node-ID from its work.
bool can_cost(const ScheduledFault& fault, NodeId device);
/// How long after its end it still can: until all that it has touched is back.
Duration lasts_after(InvariantKind kind);

/// Those of all faults that are, or just were.
class TaxiExcuses {
 public:
  /// A device that has lost its power, or its bus, is named, booted and started in this time.
  static constexpr Duration return_bound = 20s;

  /// A fault has just begun.
  void begins(const ScheduledFault& fault, Time now) { change(fault, now, lasts(fault.kind), 1); }
  /// A fault is just over.
  void ends(const ScheduledFault& fault, Time now) { change(fault, now, lasts(fault.kind), -1); }

  /// What the invariant is about may be wrong now.
  bool is_excused(InvariantKind kind, Time now) const {
    return kinds_[static_cast<std::size_t>(kind)].holds(now);
  }
  /// The device may be away now.
  bool may_be_missing(NodeId device, Time now) const { return devices_.at(device).holds(now); }

 private:
  struct Excuse {
    int faults = 0;  ///< that last
    Time until{};
    bool was_there = false;
    bool holds(Time now) const { return faults != 0 || (was_there && now <= until); }
  };

  void change(const ScheduledFault& fault, Time now, bool does_last, int more);
  static void change(Excuse& excuse, Time until, int more);

  std::array<Excuse, invariant_kinds> kinds_{};
  std::array<Excuse, device_names.size() + 1> devices_{};
};

}  // namespace canvoy::taxi
