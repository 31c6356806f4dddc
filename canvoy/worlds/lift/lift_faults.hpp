// The faults of a plan in a building: it makes them in the devices and by fire brigades, mends
// them, and reports them as events and to the referee, with their required consequences.
//
//     LiftFaults faults(world, description, devices, people, referee, events);   // plans them all
#pragma once

#include <vector>

#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/worlds/lift/fault_consequences.hpp"
#include "canvoy/worlds/lift/lift_event.hpp"
#include "canvoy/worlds/lift/lift_people.hpp"
#include "canvoy/worlds/lift/present_faults.hpp"

namespace canvoy::lift {

class LiftFaults {
 public:
  /// All must outlive the last run of `world`; faults are noted in `events`.
  LiftFaults(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
             LiftPeople& people, FaultReferee& referee, std::vector<LiftEvent>& events);
  LiftFaults(const LiftFaults&) = delete;
  LiftFaults& operator=(const LiftFaults&) = delete;

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool present);
  void set_one(const ScheduledFault& fault, bool present);
  template <class Act>
  void for_each_lift(ScheduledFault fault, const Act& act) const;

  World* world_;
  LiftDevices* devices_;
  LiftPeople* people_;
  FaultReferee* referee_;
  std::vector<LiftEvent>* events_;
  PresentFaults present_;
  FaultConsequences consequences_;
  Engine faults_;
};

}  // namespace canvoy::lift
