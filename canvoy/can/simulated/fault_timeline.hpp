// The faults of a simulated bus that begin and end at a time: those that are due, and the time of
// the next ones.
//
//     FaultTimeline timeline(options.faults);
//     if (timeline.next_ns() <= now_ns) apply(timeline.take_next());
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/bus_faults.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/wire_time.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Faults that begin and end at one time, each by its controller; no_controller: none.
struct FaultsDue {
  ControllerId cut_after = no_controller;      ///< cut behind it
  ControllerId mend_after = no_controller;     ///< the cut behind it is mended
  ControllerId babble = no_controller;         ///< begins to babble
  ControllerId stop_babbling = no_controller;  ///< ends to babble

  friend bool operator==(const FaultsDue&, const FaultsDue&) = default;
};

class FaultTimeline {
 public:
  /// Begins at the start of time, inclusive.
  explicit FaultTimeline(const BusFaults& faults);

  /// Time of the next faults; never_ns if there are no more.
  std::int64_t next_ns() const { return next_ns_; }
  /// Faults at next_ns(); continues with the next ones.
  FaultsDue take_next();
  /// Frame of a babbling node.
  const Frame& babble() const { return babbling_.frame; }

 private:
  std::int64_t next_after(std::int64_t ns) const;

  CableCut cable_cut_;
  Babbling babbling_;
  std::int64_t next_ns_ = never_ns;
};

}  // namespace canvoy
