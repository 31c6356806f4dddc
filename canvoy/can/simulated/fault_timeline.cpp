#include "canvoy/can/simulated/fault_timeline.hpp"

#include <algorithm>

namespace canvoy {

FaultTimeline::FaultTimeline(const BusFaults& faults)
    : cable_cut_(faults.cable_cut), babbling_(faults.babbling), next_ns_(next_after(-1)) {}

FaultsDue FaultTimeline::take_next() {
  const auto due = [this](Time time, ControllerId id) {
    return to_ns(time) == next_ns_ ? id : no_controller;
  };
  const FaultsDue faults{.cut_after = due(cable_cut_.from, cable_cut_.after),
                         .mend_after = due(cable_cut_.until, cable_cut_.after),
                         .babble = due(babbling_.from, babbling_.controller),
                         .stop_babbling = due(babbling_.until, babbling_.controller)};
  next_ns_ = next_after(next_ns_);
  return faults;
}

std::int64_t FaultTimeline::next_after(std::int64_t ns) const {
  std::int64_t next_ns = never_ns;
  for (const Time time : {cable_cut_.from, cable_cut_.until, babbling_.from, babbling_.until}) {
    if (to_ns(time) > ns) next_ns = std::min(next_ns, to_ns(time));
  }
  return next_ns;
}

}  // namespace canvoy
