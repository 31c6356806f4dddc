#include "canvoy/worlds/police/police_faults.hpp"

#include <array>
#include <optional>
#include <utility>

namespace canvoy::police {

PoliceFaults::PoliceFaults(PoliceCar& car, const FaultPlan& plan, PoliceExcuses& excuses,
                           EventLog<PoliceEvent>& events)
    : car_(car),
      excuses_(excuses),
      events_(events),
      faults_(plan.faults, Engine::of(*this)),
      trouble_(car.bus().bus()),
      cuts_(PowerCuts::Switch::to<&PoliceFaults::power>(*this)) {}

void PoliceFaults::plan() {
  if (faults_.has_any(FaultKind::babbling_node)) trouble_.attach_babbler();
  faults_.plan(car_.bus().world());
}

void PoliceFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultBegan{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.begins(it, now());
}

void PoliceFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultEnded{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.ends(it, now());
}

void PoliceFaults::set(std::size_t number, bool is_present) {
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
    case FaultKind::burnt_lamp:
      return car_.signals().burn_lamp(is_present);
    case FaultKind::overload:
      return car_.supply().overload(is_present);
    case FaultKind::dead_client:
      return let_client_die(is_present);
  }
}

void PoliceFaults::let_client_die(bool shall_die) {
  client_shall_die_ = shall_die;
  if (!shall_die && dead_client_ != 0)
    cuts_.set_power(std::exchange(dead_client_, NodeId{0}), true);
}

void PoliceFaults::step() {
  const std::optional<Client> client = car_.terminal().client();
  if (!client_shall_die_ || !client) return;
  constexpr std::array<NodeId, client_count> nodes = {radio_id, roof_sound_id, navigation_id};
  client_shall_die_ = false;
  dead_client_ = nodes.at(static_cast<std::size_t>(*client));
  cuts_.set_power(dead_client_, false);
}

}  // namespace canvoy::police
