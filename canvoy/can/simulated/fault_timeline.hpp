// The faults of a simulated bus that begin and end at a time: what is due, and when the next is.
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

/// What begins and ends at one time, each by the controller that it is about; no_controller:
/// nothing.
struct FaultsDue {
  ControllerId cut_after = no_controller;
  ControllerId mend_after = no_controller;
  ControllerId babble = no_controller;
  ControllerId stop_babbling = no_controller;

  friend bool operator==(const FaultsDue&, const FaultsDue&) = default;
};

class FaultTimeline {
 public:
  /// From the start of time, which belongs to it.
  explicit FaultTimeline(const BusFaults& faults);

  /// never_ns where nothing comes any more.
  std::int64_t next_ns() const { return next_ns_; }
  /// What is due at next_ns(), and on to what comes behind it.
  FaultsDue take_next();
  /// What a babbling node sends.
  const Frame& babble() const { return babbling_.frame; }

 private:
  std::int64_t next_after(std::int64_t ns) const;

  CableCut cable_cut_;
  Babbling babbling_;
  std::int64_t next_ns_ = never_ns;
};

}  // namespace canvoy
