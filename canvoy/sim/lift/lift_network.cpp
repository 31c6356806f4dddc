#include "canvoy/sim/lift/lift_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/sim/lift/lift_network_state.hpp"
#include "canvoy/sim/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

LiftSummary::Times times_of(const DurationSample& sample) {
  return {
      .mean = sample.mean(), .percentile_90 = sample.percentile(90), .longest = sample.longest()};
}

Traffic traffic_of(const LiftNetworkDescription& description) {
  if (!description.arrivals.empty()) return Traffic(description.arrivals);
  return {description.building, description.traffic};
}

}  // namespace

LiftNetwork::State::State(LiftNetworkDescription wanted)
    : description(std::move(wanted)),
      referee(description.building),
      cars(description.building.lifts.size()),
      opened_at(description.building.lifts.size(),
                std::vector<Time>(description.building.floors.size(), never)) {
  add_buses();
  add_shafts();
  add_group();
  add_configurations();
  add_crowd();
  add_brigades();
  world.add_plant(Callback<void(Time)>::to<&State::look>(*this), look_period);
  plan_faults();
  for (const auto& each : shafts) each->start();
  if (group) group->start();
}

void LiftNetwork::State::add_buses() {
  for (std::size_t i = 0; i < description.buses.size(); ++i) {
    buses.push_back(
        world.add_bus({.bit_rate = description.buses[i].bit_rate, .seed = description.seed + i}));
    watches.push_back(std::make_unique<BusWatch>(
        i, [this](Time now, const BusEvent& event) { heard(now, event); }));
    world.bus(buses.back()).observe(watches.back()->tap());
  }
}

void LiftNetwork::State::add_shafts() {
  const ShaftHooks hooks{.changed = [this](LiftNumber lift) { shaft_changed(lift); },
                         .lamp = [this](LiftNumber lift, const CallKey& call,
                                        bool is_lit) { lamp_changed(lift, call, is_lit); },
                         .assigned = [this](LiftNumber panel, const DestinationButton& button,
                                            LiftNumber lift) { assigned(panel, button, lift); }};
  for (std::size_t i = 1; i <= description.building.lifts.size(); ++i) {
    shafts.push_back(
        std::make_unique<LiftShaft>(world, description, static_cast<LiftNumber>(i), hooks));
  }
  for (const NodeDescription& node : description.nodes) {
    if (node.lift == 0) continue;
    const std::optional<SlotIndex> slot = shaft(node.lift).slot(node.id);
    if (slot) watches[node.bus]->name(world.controller(*slot), node.id);
  }
}

void LiftNetwork::State::add_group() {
  for (const NodeDescription& node : description.nodes) {
    if (node.kind != DeviceKind::group_controller) continue;
    if (node.played) {
      group = std::make_unique<LiftGroup>(world, buses[node.bus], node.id, description);
    }
    for (const auto& each : shafts) each->join_group(buses[node.bus], node.id);
    return;
  }
}

Node* LiftNetwork::State::node_of(const NodeDescription& node) {
  if (node.kind != DeviceKind::group_controller) return shaft(node.lift).node(node.id);
  return group ? &group->node() : nullptr;
}

std::vector<NodeSnapshot> LiftNetwork::State::look_at_nodes() {
  std::vector<NodeSnapshot> seen;
  for (const NodeDescription& each : description.nodes) {
    Node* const node = node_of(each);
    if (node == nullptr) continue;
    const std::optional<SlotIndex> slot =
        each.lift == 0 ? group->slot() : shaft(each.lift).slot(each.id);
    if (!slot) continue;
    NodeSnapshot look = played_snapshot(world, buses[each.bus], *slot, *node);
    look.bus = each.bus;
    look.id = each.id;
    seen.push_back(look);
  }
  return seen;
}

void LiftNetwork::State::add_configurations() {
  for (const NodeDescription& each : description.nodes) {
    Node* const node = each.values.empty() ? nullptr : node_of(each);
    if (node == nullptr) continue;
    configurations.push_back({&each, std::make_unique<NodeConfiguration>(*node, each.values)});
  }
}

void LiftNetwork::State::add_crowd() {
  crowd = std::make_unique<Crowd>(description.building, traffic_of(description), hands(),
                                  description.people);
  crowd_plant = world.add_sleeping_plant(Callback<void(Time)>::to<&State::run_crowd>(*this));
  wake_crowd();
}

void LiftNetwork::State::add_brigades() {
  for (const auto& each : shafts) {
    LiftShaft& lift = *each;
    const auto number = static_cast<LiftNumber>(brigades.size() + 1);
    brigades.push_back(std::make_unique<FireBrigade>(
        FireBrigadeHands{.alarm_key = [&lift](bool on) { lift.turn_fire_key(on); },
                         .car_key = [&lift](bool on) { lift.turn_brigade_key(on); },
                         .call =
                             [&lift, number](FloorNumber floor, bool pressed) {
                               lift.press({.lift = number, .floor = floor}, pressed);
                             },
                         .door_open = [&lift](bool pressed) { lift.press_door_open(pressed); },
                         .door_close = [&lift](bool pressed) { lift.press_door_close(pressed); }},
        FireBrigadeOptions{.fire_floor = description.service.fire_floor,
                           .floors = description.building.floor_count(),
                           .seed = description.seed + number}));
  }
}

void LiftNetwork::State::run_crowd(Time now) {
  crowd->advance(now);
  wake_crowd();
}

void LiftNetwork::State::wake_crowd() {
  world.wake(crowd_plant, crowd->deadline());
}

LiftNetwork::LiftNetwork(const LiftNetworkDescription& description)
    : state_(std::make_unique<State>(description)) {}

LiftNetwork::~LiftNetwork() = default;

void LiftNetwork::run_until(Time until) {
  state_->world.run_until(until);
}
Time LiftNetwork::now() const {
  return state_->world.now();
}
bool LiftNetwork::visit(FloorNumber from, FloorNumber to) {
  const Building& building = state_->description.building;
  const auto is_floor = [&](FloorNumber floor) {
    return floor >= 1 && floor <= building.floor_count();
  };
  if (!is_floor(from) || !is_floor(to) || from == to || !building.has_way(from, to)) return false;
  state_->crowd->come(now(), {.at = now(), .from = from, .to = to});
  state_->wake_crowd();
  return true;
}
bool LiftNetwork::observe(std::size_t bus, const BusTap& tap) {
  return state_->world.bus(state_->buses.at(bus)).observe(tap);
}
std::optional<RefusedValue> LiftNetwork::refused() const {
  for (const State::Configuration& each : state_->configurations) {
    const std::optional<NodeConfiguration::Refusal>& refusal = each.values->refusal();
    if (refusal) return RefusedValue{*each.node, *refusal};
  }
  return std::nullopt;
}
std::span<const LiftEvent> LiftNetwork::events() const {
  return state_->events;
}
const LiftNetworkDescription& LiftNetwork::description() const {
  return state_->description;
}
World& LiftNetwork::world() {
  return state_->world;
}

std::vector<Invariant> LiftNetwork::invariants() const {
  std::vector<Invariant> all = state_->referee.invariants();
  const std::vector<Invariant> of_faults = state_->fault_referee.invariants(now());
  all.insert(all.end(), of_faults.begin(), of_faults.end());
  return all;
}

bool LiftNetwork::all_hold() const {
  const std::vector<Invariant> all = invariants();
  return std::all_of(all.begin(), all.end(),
                     [](const Invariant& invariant) { return invariant.held; });
}

namespace {

LandingSnapshot landing_of(const Crowd& crowd, FloorNumber floor,
                           const std::map<CallKey, unsigned>& lit) {
  LandingSnapshot view;
  for (const PassengerId who : crowd.waiting(floor)) {
    ++(crowd.passengers()[who].wish.to > floor ? view.waiting_up : view.waiting_down);
  }
  view.lamp_up = lit.contains({.floor = floor, .direction = Direction::up});
  view.lamp_down = lit.contains({.floor = floor, .direction = Direction::down});
  return view;
}

}  // namespace

LiftNetworkSnapshot LiftNetwork::snapshot() const {
  const State& state = *state_;
  LiftNetworkSnapshot view{.at = now()};
  for (std::size_t i = 0; i < state.shafts.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i + 1);
    view.lifts.push_back(state.shafts[i]->snapshot(now()));
    view.lifts.back().persons = static_cast<unsigned>(state.crowd->riding(lift).size());
    view.lifts.back().starts = state.cars[i].starts;
    for (const auto& [call, on_lifts] : state.lit) {
      if (call.lift == lift) view.lifts.back().car_calls.push_back(call.floor);
    }
  }
  for (std::size_t i = 1; i <= state.description.building.floors.size(); ++i) {
    view.landings.push_back(landing_of(*state.crowd, static_cast<FloorNumber>(i), state.lit));
  }
  for (const BusIndex bus : state.buses) {
    const SimulatedBus& wire = state.world.bus(bus);
    view.buses.push_back({.load = wire.load(),
                          .frames = wire.statistics().frames,
                          .error_frames = wire.statistics().error_frames});
  }
  view.nodes = state_->look_at_nodes();
  view.waiting = state.crowd->waiting_count();
  view.riding = state.crowd->riding_count();
  view.served = state.crowd->statistics().served_count();
  return view;
}

double LiftNetwork::State::formula_interval_s(double persons) const {
  const Building& building = description.building;
  const bool is_up_peak = description.arrivals.empty() &&
                          description.traffic.pattern == TrafficPattern::up_peak &&
                          !description.people.destination_control;
  const LiftDesign& first = building.lifts.front();
  const bool are_alike =
      std::all_of(building.lifts.begin(), building.lifts.end(), [&](const LiftDesign& lift) {
        return lift.speed_m_s == first.speed_m_s && lift.jerk_m_s3 == first.jerk_m_s3 &&
               lift.acceleration_m_s2 == first.acceleration_m_s2 &&
               lift.door.open_time_s == first.door.open_time_s &&
               lift.door.close_time_s == first.door.close_time_s;
      });
  const bool is_plain = building.main_floor == 1 && building.floor_count() > 1 && are_alike;
  if (!is_up_peak || !is_plain || persons <= 0) return 0;
  return round_trip_time(round_trip_options(building, persons)).interval_s;
}

LiftSummary LiftNetwork::summary() const {
  const State& state = *state_;
  const PassengerStatistics& people = state.crowd->statistics();
  LiftSummary account{.run = now() - Time{},
                      .arrived = state.crowd->passengers().size(),
                      .served = people.served_count(),
                      .gave_up = people.gave_up_count(),
                      .waiting = times_of(people.waiting()),
                      .to_destination = times_of(people.to_destination()),
                      .most_in_5_minutes = people.most_in_5_minutes(),
                      .interval_s = state.crowd->departures().interval_s(),
                      .persons_of_car = state.crowd->departures().persons_mean(),
                      .is_saturated = state.is_saturated};
  account.formula_interval_s = state.formula_interval_s(account.persons_of_car);
  const LiftNetworkSnapshot view = snapshot();
  for (const LiftSnapshot& lift : view.lifts) {
    const LiftStatistics each{lift.starts, lift.distance_m, lift.energy_wh};
    account.lifts.push_back({.starts = each.starts,
                             .starts_an_hour = each.starts_an_hour(account.run),
                             .distance_m = each.distance_m,
                             .energy_wh = each.energy_wh});
  }
  for (const BusIndex bus : state.buses) {
    account.bus_loads.push_back(state.world.bus(bus).load_total());
  }
  return account;
}

}  // namespace canvoy::lift
