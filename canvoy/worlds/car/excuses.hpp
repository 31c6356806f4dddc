// What faults excuse in a car: only what each can cause, for as long as it can. A world defines it
// by three functions beside its ScheduledFault and its InvariantKind: `can_cause(fault, kind)`,
// `can_cost(fault, device)` and `lasts_after(kind)`.
//
//     car::Excuses<ScheduledFault, InvariantKind, invariant_kinds, device_names.size()> excuses;
//     excuses.begins(fault, now);
//     excuses.ends(fault, now);
//     if (excuses.is_excused(InvariantKind::receipts, now)) ...
//     if (excuses.may_be_missing(printer_id, now)) ...
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::car {

/// Time within which a device that has lost its power, or its bus, has a node-ID, has booted and is
/// started.
inline constexpr Duration return_bound = 20s;
/// A step of the simulation may pass until the next look.
inline constexpr Duration one_look = 1s;

/// A set of devices by their node-IDs: 1 to 15.
using Nodes = std::uint16_t;

/// A set of these node-IDs.
template <class... Ids>
constexpr Nodes nodes(Ids... ids) {
  return static_cast<Nodes>(((1U << ids) | ... | 0U));
}

/// The devices from 1 to `count`.
constexpr Nodes all_nodes(std::size_t count) {
  return static_cast<Nodes>((2U << count) - 2);
}

/// True if a cut behind this node separates them.
constexpr bool are_parted(Nodes which, NodeId behind) {
  const auto before = static_cast<Nodes>((2U << behind) - 1);
  return (which & before) != 0 && (which & ~before) != 0;
}

/// True if a fault of a device or of the bus keeps one of these devices from its work, or from
/// another one of them. Faults of other kinds do not.
template <class Fault>
bool hinders(const Fault& fault, Nodes which) {
  using Kind = decltype(fault.kind);
  switch (fault.kind) {
    case Kind::lost_node:
    case Kind::restart:
      return (which & nodes(node_of(fault))) != 0;
    case Kind::cable_cut:
      return are_parted(which, node_of(fault));
    case Kind::babbling_node:
      return (which & (which - 1)) != 0;  // a device that needs no other one needs no bus
    default:
      return false;
  }
}

/// Devices that must work, and hear each other, for an invariant to hold.
template <class Kind>
struct Needs {
  Kind kind;       ///< the invariant
  Nodes nodes;     ///< devices that it needs
  Duration after;  ///< time after a fault until all that it affects is back
};

template <class Fault, class Kind, std::size_t kinds, std::size_t devices>
class Excuses {
 public:
  /// Call it when a fault begins.
  void begins(const Fault& fault, Time now) { change(fault, now, lasts(fault.kind), 1); }
  /// Call it when a fault ends.
  void ends(const Fault& fault, Time now) { change(fault, now, lasts(fault.kind), -1); }

  /// True if a fault may break the invariant at present.
  bool is_excused(Kind kind, Time now) const {
    return kinds_[static_cast<std::size_t>(kind)].holds(now);
  }
  /// True if the device may be missing at present.
  bool may_be_missing(NodeId device, Time now) const { return devices_.at(device).holds(now); }

 private:
  struct Excuse {
    int faults = 0;  ///< number of present faults
    Time until{};
    bool was_there = false;

    bool holds(Time now) const { return faults != 0 || (was_there && now <= until); }
    void change(Time to, int more) {
      faults += more;
      until = std::max(until, to);
      was_there = true;
    }
  };

  void change(const Fault& fault, Time now, bool does_last, int more) {
    const int count = does_last ? more : 0;
    for (std::size_t i = 0; i < kinds; ++i) {
      const auto kind = static_cast<Kind>(i);
      if (can_cause(fault, kind)) kinds_[i].change(now + lasts_after(kind), count);
    }
    for (std::size_t id = 1; id <= devices; ++id) {
      if (!can_cost(fault, static_cast<NodeId>(id))) continue;
      devices_[id].change(now + lasts_after(Kind::device_missing), count);
    }
  }

  std::array<Excuse, kinds> kinds_{};
  std::array<Excuse, devices + 1> devices_{};
};

}  // namespace canvoy::car
