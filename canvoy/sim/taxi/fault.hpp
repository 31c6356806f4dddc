// What goes wrong in a taxi, when and for how long.
//
//     ScheduledFault fault{.kind = FaultKind::lost_node, .node = 2, .start = Time(20min)};
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::taxi {

enum class FaultKind : std::uint8_t {
  lost_node,
  restart,
  cable_cut,
  babbling_node,
  corrupted_frames,
  wheel_signal,
  paper_out,
  no_fix,
};
inline constexpr std::size_t fault_kinds = static_cast<std::size_t>(FaultKind::no_fix) + 1;

/// A restart is over at once.
constexpr bool lasts(FaultKind kind) {
  return kind != FaultKind::restart;
}

/// All kinds, in the order of FaultKind; `:node=N` says where.
FaultGrammar fault_grammar();
std::string_view fault_name(FaultKind kind);
/// The fault is one of a node: lost_node, restart.
constexpr bool has_node(FaultKind kind) {
  return kind == FaultKind::lost_node || kind == FaultKind::restart;
}

/// It excuses nothing: one device lacks what it works with, and has to say so, or frames are sent
/// again; all goes on.
constexpr bool is_harmless(FaultKind kind) {
  return kind == FaultKind::paper_out || kind == FaultKind::no_fix ||
         kind == FaultKind::corrupted_frames;
}

struct ScheduledFault {
  FaultKind kind = FaultKind::lost_node;
  NodeId node = 0;  ///< 0: the plan leaves it open: the taximeter
  Time start{};
  Duration duration = for_the_rest;

  Time end() const { return end_of_fault(start, duration); }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};
ScheduledFault scheduled(const WrittenFault& fault);
WrittenFault written(const ScheduledFault& fault);

struct FaultPlan {
  std::uint64_t seed = 1;  ///< of what is left to chance
  std::vector<ScheduledFault> faults{};
  double corrupted_share = 0.01;  ///< corrupted_frames: of all frames, 0 to 1
};

}  // namespace canvoy::taxi
