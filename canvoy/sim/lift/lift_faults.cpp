#include "canvoy/sim/lift/lift_faults.hpp"

namespace canvoy::lift {

/// Of one instant, what begins comes before what ends: a fault that takes over from one of its kind
/// leaves no pause, in which nobody could notice anything.
LiftFaults::LiftFaults(World& world, const LiftNetworkDescription& description,
                       LiftDevices& devices, LiftPeople& people, FaultReferee& referee,
                       std::vector<LiftEvent>& events)
    : world_(&world),
      plan_(&description.faults),
      devices_(&devices),
      people_(&people),
      referee_(&referee),
      events_(&events),
      present_(description.faults, devices),
      consequences_(world, description, devices, present_) {
  for (std::size_t i = 0; i < plan_->size(); ++i) {
    world.at((*plan_)[i].start, [this, i](Time) { begin(i); });
  }
  for (std::size_t i = 0; i < plan_->size(); ++i) {
    const Time end_at = (*plan_)[i].end();
    if (end_at != never) world.at(end_at, [this, i](Time) { end(i); });
  }
}

/// A fire alarm of all lifts is one of each; any other fault is as it is.
template <class Act>
void LiftFaults::for_each_lift(ScheduledFault fault, const Act& act) const {
  if (fault.kind != FaultKind::fire_alarm || fault.lift != 0) return act(fault);
  for (fault.lift = 1; fault.lift <= devices_->count(); ++fault.lift) act(fault);
}

void LiftFaults::begin(std::size_t fault) {
  const ScheduledFault& it = (*plan_)[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, devices_->place_of(it)}});
  for_each_lift(
      it, [&](const ScheduledFault& each) { referee_->began(now, fault, consequences_.of(each)); });
  for_each_lift(it, [&](const ScheduledFault& each) { set(each, true); });
  present_.add(fault);
}

void LiftFaults::end(std::size_t fault) {
  const ScheduledFault& it = (*plan_)[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, devices_->place_of(it)}});
  referee_->ended(now, fault);
  present_.remove(fault);
  for_each_lift(it, [&](const ScheduledFault& each) { set(each, false); });
}

void LiftFaults::set(const ScheduledFault& fault, bool present) {
  if (present_.has_like(fault)) return;
  const bool is_of_people = fault.kind == FaultKind::fire_brigade && fault.lift != 0;
  if (is_of_people) return people_->call_brigade(fault.lift, present);
  devices_->set_fault(fault, present);
}

}  // namespace canvoy::lift
