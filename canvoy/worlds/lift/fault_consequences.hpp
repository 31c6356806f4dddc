// Required consequences of a fault of a plan in a building, at its place and time: which
// emergencies are on the bus, within which time a car stands, and when people are carried again.
//
//     FaultConsequences consequences(description, devices, present);
//     referee.began(now, 0, consequences.of(fault));
#pragma once

#include "canvoy/worlds/lift/fault_referee.hpp"
#include "canvoy/worlds/lift/lift_devices.hpp"
#include "canvoy/worlds/lift/present_faults.hpp"

namespace canvoy::lift {

/// Longest time, while people want a lift, until the first of them has reached a destination: any
/// passenger boards and gets out within a round with a stop at each floor, up and down.
Duration serves_most(const LiftNetworkDescription& description, LiftNumber lift);

class FaultConsequences {
 public:
  /// All must outlive this object.
  FaultConsequences(const World& world, const LiftNetworkDescription& description,
                    const LiftDevices& devices, const PresentFaults& present)
      : world_(&world), description_(&description), devices_(&devices), present_(&present) {}

  /// Consequences of a fault that begins at present, before it is made. A fire alarm counts as one
  /// of a lift.
  FaultExpectation of(const ScheduledFault& fault) const;

 private:
  enum class Loss : std::uint8_t { none, bearable, needed };

  FaultExpectation alone(const ScheduledFault& fault) const;
  FaultExpectation of_group(const ScheduledFault& fault) const;
  void expect_of_motion(FaultExpectation& expected, const ScheduledFault& fault) const;
  Loss loss_of(const ScheduledFault& fault) const;
  bool has_no_current(const ScheduledFault& fault) const;

  const World* world_;
  const LiftNetworkDescription* description_;
  const LiftDevices* devices_;
  const PresentFaults* present_;
};

}  // namespace canvoy::lift
