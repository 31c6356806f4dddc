// What a fault of a plan must bring about in a building, as it begins there and then: which
// emergencies are on the bus, within which time a car stands, and when people are carried again.
//
//     FaultConsequences consequences(description, devices, present);
//     referee.began(now, 0, consequences.of(fault));
#pragma once

#include "canvoy/sim/lift/fault_referee.hpp"
#include "canvoy/sim/lift/lift_devices.hpp"
#include "canvoy/sim/lift/present_faults.hpp"

namespace canvoy::lift {

/// Of the time in which people want a lift, until the first of them has got to where he wants:
/// whoever it is has boarded and left within a round with a stop at each floor, up and down.
Duration serves_most(const LiftNetworkDescription& description, LiftNumber lift);

class FaultConsequences {
 public:
  /// All must outlive this.
  FaultConsequences(const World& world, const LiftNetworkDescription& description,
                    const LiftDevices& devices, const PresentFaults& present)
      : world_(&world), description_(&description), devices_(&devices), present_(&present) {}

  /// Of a fault that begins now, and is not made yet. A fire alarm is one of a lift.
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
