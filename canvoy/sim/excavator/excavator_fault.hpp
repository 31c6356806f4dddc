// What goes wrong in an excavator, when and for how long.
//
//     ScheduledFault fault{.kind = FaultKind::stuck_axis, .axis = 4, .start = Time(20min)};
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/excavator/excavator_invariant.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::excavator {

enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  bus_off,
  cable_cut,
  babbling_node,
  corrupted_frames,
  lost_frames,
  delayed_frames,
  stuck_axis,
  broken_wire,
  vanished_armrest,
};
inline constexpr std::size_t fault_kinds =
    static_cast<std::size_t>(FaultKind::vanished_armrest) + 1;

/// A restart is over at once.
constexpr bool lasts(FaultKind kind) {
  return kind != FaultKind::restart;
}
/// The fault is one of a node.
constexpr bool has_node(FaultKind kind) {
  return kind <= FaultKind::cable_cut || kind == FaultKind::lost_frames ||
         kind == FaultKind::delayed_frames;
}
/// The fault is one of an axis of the sticks.
constexpr bool has_axis(FaultKind kind) {
  return kind == FaultKind::stuck_axis || kind == FaultKind::broken_wire;
}

/// All kinds, in the order of FaultKind; `:node=N` and `:axis=N` say where.
FaultGrammar fault_grammar();
std::string_view fault_name(FaultKind kind);

struct ScheduledFault {
  FaultKind kind = FaultKind::lost_node;
  NodeId node = 0;    ///< 0: the plan leaves it open: the host
  unsigned axis = 0;  ///< 1 to 4, as Stick has them; 0: the plan leaves it open: the last
  Time start{};
  Duration duration = for_the_rest;

  Time end() const { return end_of_fault(start, duration); }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};
ScheduledFault scheduled(const WrittenFault& fault);
WrittenFault written(const ScheduledFault& fault);

/// Which invariants cannot hold while it is present, and for a time after it.
InvariantSet affected_by(FaultKind kind);

struct FaultPlan {
  std::uint64_t seed = 1;  ///< of what is left to chance
  std::vector<ScheduledFault> faults{};
  double corrupted_share = 0.01;  ///< corrupted_frames: of all frames, 0 to 1
  double lost_share = 0.05;       ///< lost_frames: of those of a node
  Duration delay = 20ms;          ///< delayed_frames
};

}  // namespace canvoy::excavator
