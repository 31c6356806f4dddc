#include "canvoy/worlds/taxi/taxi_faults.hpp"

namespace canvoy::taxi {

TaxiFaults::TaxiFaults(TaxiCar& car, const FaultPlan& plan, TripBook& trips, MeterWatch& watch,
                       TaxiExcuses& excuses, TamperWatch& tampering, EventLog<TaxiEvent>& events)
    : car_(car),
      trips_(trips),
      watch_(watch),
      excuses_(excuses),
      tamper_watch_(tampering),
      events_(events),
      faults_(plan.faults, Engine::of(*this)),
      trouble_(car.bus().bus()),
      cuts_(PowerCuts::Switch::to<&TaxiFaults::power>(*this)),
      tampering_(car) {}

void TaxiFaults::plan() {
  if (faults_.has_any(FaultKind::babbling_node)) trouble_.attach_babbler();
  if (faults_.has_any(FaultKind::stranger_writes)) tampering_.attach_stranger();
  faults_.plan(car_.bus().world());
}

void TaxiFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultBegan{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.begins(it, now());
  if (is_tampering(it.kind)) tamper_watch_.begins(it.kind, now());
}

void TaxiFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultEnded{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.ends(it, now());
}

void TaxiFaults::power(NodeId id, bool is_on) {
  if (id == taximeter_id) meter_power(is_on);
  car_.power(car_.bus().node(id), is_on);
}

void TaxiFaults::meter_power(bool is_on) {
  watch_.power_changes(now(), is_on);
  if (is_on) {
    if (watch_.may_end_trip(now() - meter_lost_at_)) trips_.lose_trip();
  } else {
    trips_.lose_power();
    meter_lost_at_ = now();
  }
}

void TaxiFaults::set(std::size_t number, bool is_present) {
  const ScheduledFault& fault = faults_[number];
  switch (fault.kind) {
    case FaultKind::lost_node:
      return cuts_.set_power(node_of(fault), !is_present);
    case FaultKind::restart:
      return is_present ? cuts_.restart(node_of(fault)) : void();
    case FaultKind::cable_cut:
      return trouble_.cut_cable(car_.bus().node(node_of(fault)).controller(), is_present);
    case FaultKind::babbling_node:
      return trouble_.babble(is_present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(is_present ? corrupted_share : 0);
    case FaultKind::wheel_signal:
      return car_.lose_wheels(is_present);
    case FaultKind::paper_out:
      return car_.take_paper(is_present);
    case FaultKind::no_fix:
      return car_.lose_satellites(is_present);
    default:
      return tampering_.set(fault.kind, is_present);
  }
}

}  // namespace canvoy::taxi
