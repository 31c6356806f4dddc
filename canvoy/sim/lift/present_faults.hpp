// Which faults of a plan are there, and what they leave to another one: what is broken already does
// not break once more, and is not mended before the last of these faults is over.
//
//     PresentFaults present(plan, devices);
//     if (!present.has_like(plan[0])) devices.set_fault(plan[0], true);
//     present.add(0);
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/sim/lift/lift_devices.hpp"

namespace canvoy::lift {

class PresentFaults {
 public:
  /// Both must outlive this.
  PresentFaults(const std::vector<ScheduledFault>& plan, const LiftDevices& devices)
      : plan_(&plan), devices_(&devices) {}

  /// Places in the plan.
  void add(std::size_t fault) { present_.push_back(fault); }
  void remove(std::size_t fault) { std::erase(present_, fault); }

  /// The same is broken by another one. A cable has one cut at a time, wherever it is.
  bool has_like(const ScheduledFault& fault) const;
  /// Nobody can miss the heartbeats that this fault takes: none has come yet (CiA 301,
  /// 7.2.8.3.2.2), or another fault has taken them already, from all, from the nodes behind a cut,
  /// or from who would tell.
  bool silences(const ScheduledFault& fault) const;

 private:
  NodeId node_of(const ScheduledFault& fault) const { return devices_->place_of(fault).node; }

  const std::vector<ScheduledFault>* plan_;
  const LiftDevices* devices_;
  std::vector<std::size_t> present_;
};

}  // namespace canvoy::lift
