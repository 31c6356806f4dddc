// The present faults of a plan, and their effects on each other: what is broken already does not
// break again, and is mended when the last of these faults is over.
//
//     PresentFaults present(plan, devices);
//     if (!present.has_like(plan[0])) devices.set_fault(plan[0], true);
//     present.add(0);
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/worlds/lift/lift_devices.hpp"

namespace canvoy::lift {

class PresentFaults {
 public:
  /// Both must outlive this object.
  PresentFaults(const std::vector<ScheduledFault>& plan, const LiftDevices& devices)
      : plan_(&plan), devices_(&devices) {}

  /// Adds a fault by its index in the plan.
  void add(std::size_t fault) { present_.push_back(fault); }
  /// The fault is over; nothing happens if it was not present.
  void remove(std::size_t fault) { std::erase(present_, fault); }

  /// True if a present fault breaks the same. A cable has one cut at a time, at any place.
  bool has_like(const ScheduledFault& fault) const;
  /// True if the loss of heartbeats by this fault cannot be detected: none has come yet (CiA 301,
  /// 7.2.8.3.2.2), or another fault has stopped them already, for all nodes, for the nodes behind a
  /// cut, or for the node that would report it.
  bool silences(const ScheduledFault& fault) const;

 private:
  NodeId node_of(const ScheduledFault& fault) const { return devices_->place_of(fault).node; }

  const std::vector<ScheduledFault>* plan_;
  const LiftDevices* devices_;
  std::vector<std::size_t> present_;
};

}  // namespace canvoy::lift
