// The faults of a plan as they come and go in a world: each is told when it begins and ends, and is
// made and mended. Several of one kind may overlap: what they are about is mended when the last one
// is over; but for those of a node, each of which is made and mended for itself.
//
//     PlannedFaults<ScheduledFault, fault_kinds> faults(plan, {.began = ..., .set = ...});
//     faults.plan(world);
//     if (faults.is_present(FaultKind::no_paper)) ...
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

/// `Fault` has `kind`, `start` and `end()`, and has_node(kind) says which kinds are about a node.
template <class Fault, std::size_t kinds>
class PlannedFaults {
 public:
  using Kind = decltype(Fault::kind);
  /// Who is told, by the place of the fault in the plan, and who makes and mends it, in this order.
  struct Hands {
    Callback<void(std::size_t fault)> began;
    Callback<void(std::size_t fault)> ended;
    Callback<void(const Fault& fault, bool is_present)> set;
  };

  /// The faults must outlive this.
  PlannedFaults(std::span<const Fault> faults, const Hands& hands)
      : faults_(faults), hands_(hands) {}
  PlannedFaults(const PlannedFaults&) = delete;
  PlannedFaults& operator=(const PlannedFaults&) = delete;

  /// This must outlive the world's last run.
  void plan(World& world) {
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      world.at(faults_[i].start, [this, i](Time) { begin(i); });
      if (faults_[i].end() != never) world.at(faults_[i].end(), [this, i](Time) { end(i); });
    }
  }

  bool is_present(Kind kind) const { return present_[static_cast<std::size_t>(kind)] != 0; }
  bool has_any(Kind kind) const {
    return std::ranges::any_of(faults_, [&](const Fault& fault) { return fault.kind == kind; });
  }

 private:
  unsigned& count_of(Kind kind) { return present_.at(static_cast<std::size_t>(kind)); }
  void begin(std::size_t fault) {
    const Fault& it = faults_[fault];
    hands_.began(fault);
    if (++count_of(it.kind) == 1 || has_node(it.kind)) hands_.set(it, true);
  }
  void end(std::size_t fault) {
    const Fault& it = faults_[fault];
    hands_.ended(fault);
    if (--count_of(it.kind) == 0 || has_node(it.kind)) hands_.set(it, false);
  }

  std::span<const Fault> faults_;
  Hands hands_;
  std::array<unsigned, kinds> present_{};  ///< how many of each kind
};

}  // namespace canvoy
