#include "canvoy/worlds/lift/lift_faults.hpp"

namespace canvoy::lift {

LiftFaults::LiftFaults(World& world, const LiftNetworkDescription& description,
                       LiftDevices& devices, LiftPeople& people, FaultReferee& referee,
                       std::vector<LiftEvent>& events)
    : world_(&world),
      devices_(&devices),
      people_(&people),
      referee_(&referee),
      events_(&events),
      present_(description.faults.faults, devices),
      consequences_(world, description, devices, present_),
      faults_(description.faults.faults, Engine::of(*this), FaultMaking::by_world) {
  faults_.plan(world);
}

/// A fire alarm of all lifts counts as one of each; any other fault stays as it is.
template <class Act>
void LiftFaults::for_each_lift(ScheduledFault fault, const Act& act) const {
  if (fault.kind != FaultKind::fire_alarm || fault.part != 0) return act(fault);
  for (fault.part = 1; fault.part <= devices_->count(); ++fault.part) act(fault);
}

void LiftFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, devices_->place_of(it)}});
  for_each_lift(
      it, [&](const ScheduledFault& each) { referee_->began(now, fault, consequences_.of(each)); });
}

void LiftFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, devices_->place_of(it)}});
  referee_->ended(now, fault);
  present_.remove(fault);
}

void LiftFaults::set(std::size_t fault, bool present) {
  for_each_lift(faults_[fault], [&](const ScheduledFault& each) { set_one(each, present); });
  if (present) present_.add(fault);
}

void LiftFaults::set_one(const ScheduledFault& fault, bool present) {
  if (present_.has_like(fault)) return;
  const bool is_of_people = fault.kind == FaultKind::fire_brigade && fault.part != 0;
  if (is_of_people) return people_->call_brigade(fault.part, present);
  devices_->set_fault(fault, present);
}

}  // namespace canvoy::lift
