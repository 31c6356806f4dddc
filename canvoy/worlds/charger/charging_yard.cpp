#include "canvoy/worlds/charger/charging_yard.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::charger {

namespace {

constexpr double of_whole = 100;
constexpr double joule_per_watt_hour = 3600;
/// Of the maker of a flooded battery, after each full charge.
constexpr Duration equalising_time = 1h;
constexpr double equalising_ampere = 2;  ///< a smaller current stirs no acid

double hours(Duration time) {
  return std::chrono::duration<double, std::ratio<3600>>(time).count();
}

}  // namespace

YardReferee::YardReferee(const YardOptions& yard, const YardVehicles::Bays& bays,
                         const YardVehicles& vehicles)
    : yard_(&yard),
      bays_(&bays),
      vehicles_(&vehicles),
      of_bays_(bays.size()),
      results_(vehicles.size()) {}

void YardReferee::change_faults(Time now, std::size_t bay, int by) {
  of_bays_[bay].faults += by;
  of_bays_[bay].excused_until = now + recovery;
}

void YardReferee::step(Time now) {
  ++steps_;
  measure_mains();
  for (std::size_t vehicle = 0; vehicle < results_.size(); ++vehicle) {
    watch(now, vehicle);
    judge_goal(now, vehicle);
  }
  is_past_goal_ = yard_->goal && now >= yard_->goal->at;
}

void YardReferee::measure_mains() {
  double joule = 0;
  for (std::size_t bay = 0; bay < of_bays_.size(); ++bay) {
    const double total = (*bays_)[bay]->devices().plant().stage.mains_energy_joule();
    joule += total - std::exchange(of_bays_[bay].mains_joule, total);
  }
  const double seconds = std::chrono::duration<double>(ChargingPlant::step_time).count();
  mains_watt_max_ = std::max(mains_watt_max_, joule / seconds);
}

void YardReferee::watch(Time now, std::size_t vehicle) {
  Result& result = results_[vehicle];
  if (vehicles_->place(vehicle) != VehiclePlace::plugged) return;
  const std::size_t bay = vehicles_->bay(vehicle) - 1;
  const Bay& of_bay = of_bays_[bay];
  if (of_bay.faults > 0 || now < of_bay.excused_until) {
    result.excused += ChargingPlant::step_time;
  } else if (vehicles_->cells(vehicle).is_full()) {
    result.full += ChargingPlant::step_time;
    const bool flows = (*bays_)[bay]->devices().plant().ampere() >= equalising_ampere;
    if (flows) result.equalised += ChargingPlant::step_time;
  }
}

/// At the time of the goal, or when it has left before that.
void YardReferee::judge_goal(Time now, std::size_t vehicle) {
  Result& result = results_[vehicle];
  if (!yard_->goal || is_past_goal_ || result.charge) return;
  const bool is_here = vehicles_->place(vehicle) != VehiclePlace::away;
  const bool has_left = !is_here && result.was_here;
  result.was_here = result.was_here || is_here;
  const bool is_due = is_here && now >= yard_->goal->at;
  if (is_due || (has_left && now < yard_->goal->at)) {
    result.charge = vehicles_->cells(vehicle).state_of_charge();
  }
}

double YardReferee::missing_percent(std::size_t vehicle) const {
  const double wanted = yard_->goal->state_of_charge;
  return std::max(0.0, wanted - *results_[vehicle].charge) * of_whole;
}

/// What the faults at its cable can have cost at most.
double YardReferee::allowed_percent(std::size_t vehicle) const {
  const BatteryDesign& design = vehicles_->cells(vehicle).design();
  return std::min(yard_->goal->state_of_charge, design.charge_current_ampere *
                                                    hours(results_[vehicle].excused) /
                                                    design.capacity_ampere_hour) *
         of_whole;
}

YardInvariant YardReferee::goal_of(std::size_t vehicle) const {
  YardInvariant goal{.kind = YardInvariantKind::battery_goal,
                     .part = static_cast<std::uint8_t>(vehicle + 1)};
  if (!results_[vehicle].charge || !is_seen(vehicle)) return goal;
  goal.worst = missing_percent(vehicle);
  goal.allowed = allowed_percent(vehicle);
  goal.held = goal.worst <= goal.allowed;
  goal.judged = 1;
  return goal;
}

/// The current of a real charger and the cells of a real battery are not seen here.
bool YardReferee::is_seen(std::size_t vehicle) const {
  return yard_->plays(vehicles_->bay(vehicle));
}

/// That of the battery that is furthest beyond what is allowed of it.
YardInvariant YardReferee::goal_of_bay(unsigned bay) const {
  YardInvariant worst{.kind = YardInvariantKind::charger_goal,
                      .part = static_cast<std::uint8_t>(bay)};
  for (std::size_t vehicle = 0; vehicle < results_.size(); ++vehicle) {
    const YardInvariant goal = goal_of(vehicle);
    if (vehicles_->bay(vehicle) != bay || !goal.is_decided()) continue;
    const bool is_worse = goal.worst - goal.allowed > worst.worst - worst.allowed;
    if (worst.judged == 0 || is_worse) {
      worst.worst = goal.worst;
      worst.allowed = goal.allowed;
      worst.held = goal.held;
    }
    ++worst.judged;
  }
  return worst;
}

/// Judged once the battery has been full at its cable for long enough.
YardInvariant YardReferee::equalising_of(std::size_t vehicle) const {
  const Result& result = results_[vehicle];
  YardInvariant invariant{.kind = YardInvariantKind::equalised,
                          .part = static_cast<std::uint8_t>(vehicle + 1),
                          .allowed = equalising_missing_max_percent};
  // The last minutes of the phase before count as full already.
  if (result.full < equalising_time || !is_seen(vehicle)) return invariant;
  invariant.worst = std::max(0.0, 1 - hours(result.equalised) / hours(equalising_time)) * of_whole;
  invariant.held = invariant.worst <= invariant.allowed;
  invariant.judged = 1;
  return invariant;
}

/// What a real charger takes from the mains comes on top of what is measured here.
YardInvariant YardReferee::supply() const {
  constexpr double kilo = 1000;
  const bool is_held = mains_watt_max_ <= yard_->supply_watt;
  const bool is_decided = mains_watt_max_ > 0 && (yard_->real_chargers.empty() || !is_held);
  return {.kind = YardInvariantKind::supply,
          .worst = mains_watt_max_ / kilo,
          .allowed = yard_->supply_watt / kilo,
          .held = is_held,
          .judged = is_decided ? steps_ : 0};
}

std::vector<YardInvariant> YardReferee::invariants() const {
  std::vector<YardInvariant> all;
  if (yard_->goal) {
    for (unsigned bay = 1; bay <= of_bays_.size(); ++bay) all.push_back(goal_of_bay(bay));
    for (std::size_t i = 0; i < results_.size(); ++i) all.push_back(goal_of(i));
  }
  for (std::size_t i = 0; i < results_.size(); ++i) {
    if (!vehicles_->cells(i).design().asks) all.push_back(equalising_of(i));
  }
  if (yard_->supply_watt > 0) all.push_back(supply());
  return all;
}

double YardReferee::mains_watt_hours(std::size_t bay) const {
  return (*bays_)[bay]->devices().plant().stage.mains_energy_joule() / joule_per_watt_hour;
}

double YardReferee::mains_watt_hours() const {
  double sum = 0;
  for (std::size_t bay = 0; bay < of_bays_.size(); ++bay) sum += mains_watt_hours(bay);
  return sum;
}

namespace {

/// It keeps all nodes of its bus from sending.
bool is_of_bus(FaultKind kind) {
  return kind == FaultKind::cable_cut || kind == FaultKind::corrupted_frames ||
         kind == FaultKind::babbling_node || kind == FaultKind::wrong_bit_rate;
}

}  // namespace

YardVehicles::Bays ChargingYard::make_bays(World& world, const YardOptions& options) {
  YardVehicles::Bays bays;
  for (unsigned bay = 1; bay <= options.chargers; ++bay) {
    const ChargerOptions of_bay = bay_options(options, bay);
    const BusIndex bus =
        options.one_bus && bay > 1
            ? 0
            : world.add_bus({.bit_rate = of_bay.bit_rate, .seed = of_bay.faults.seed});
    bays.push_back(std::make_unique<ChargingBay>(world, of_bay, bus));
  }
  return bays;
}

ChargingYard::Watch::Watch(ChargingYard& of_yard, BusIndex at)
    : yard(&of_yard),
      bus(at),
      of_nodes(at, [this](Time now, const BusEvent& event) { yard->heard(bus, now, event); }) {}

ChargingYard::ChargingYard(YardOptions options)
    : options_(std::move(options)),
      bays_(make_bays(world_, options_)),
      collected_(bays_.size()),
      vehicles_(options_, bays_,
                [this](Time now, const VehicleMoved& moved) {
                  events_.push_back({now, moved.bay, moved});
                }),
      referee_(options_, bays_, vehicles_),
      stepping_(world_.add_plant(callback<&ChargingYard::step>(*this), ChargingPlant::step_time)) {
  for (unsigned bay = 1; bay <= bays_.size(); ++bay) {
    faults_.push_back(faults_of_bay(options_, bay));
  }
  observe();
  for (const auto& bay : bays_) bay->start();
}

void ChargingYard::observe() {
  const std::size_t buses = options_.one_bus ? 1 : bays_.size();
  for (BusIndex bus = 0; bus < buses; ++bus) {
    watches_.push_back(std::make_unique<Watch>(*this, bus));
    Watch& watch = *watches_.back();
    world_.bus(bus).observe({.context = &watch,
                             .on_frame =
                                 [](void* self, Time now, ControllerId, const Frame& frame) {
                                   const Watch& heard = *static_cast<Watch*>(self);
                                   heard.yard->hear(heard.bus, now, frame);
                                 },
                             .on_state = nullptr});
    for (const auto& bay : bays_) {
      if (bay->devices().bus() != bus) continue;
      watch.of_nodes.name(bay->devices().charger_controller(), bay->options().charger_id);
      watch.of_nodes.name(bay->devices().battery_controller(), bay->options().battery_id);
    }
    world_.bus(bus).observe(watch.of_nodes.tap());
  }
}

void ChargingYard::hear(BusIndex bus, Time now, const Frame& frame) {
  for (const auto& bay : bays_) {
    if (bay->devices().bus() == bus) bay->hear(now, frame);
  }
}

const ChargingBay* ChargingYard::bay_of(BusIndex bus, NodeId node) const {
  for (const auto& bay : bays_) {
    const ChargerOptions& options = bay->options();
    const bool is_its_node = node == options.charger_id || node == options.battery_id;
    if (bay->devices().bus() == bus && is_its_node) return bay.get();
  }
  return nullptr;
}

/// A command to all nodes of a shared bus is told by its first bay.
void ChargingYard::heard(BusIndex bus, Time now, const BusEvent& event) {
  const NodeId node = std::visit([](const auto& seen) { return seen.node; }, event);
  for (const auto& bay : bays_) {
    const bool is_for_it = node == 0 ? bay->devices().bus() == bus : bay_of(bus, node) == bay.get();
    if (is_for_it) return bay->heard(now, event);
  }
}

void ChargingYard::run_until(Time until) {
  world_.run_until(until);
  collect();
}

void ChargingYard::step(Time now) {
  collect();
  vehicles_.step(now);
  referee_.step(now);
  report_broken(now);
}

/// The new events of all bays, in the order of their times.
void ChargingYard::collect() {
  const auto first = static_cast<std::ptrdiff_t>(events_.size());
  for (std::size_t bay = 0; bay < bays_.size(); ++bay) {
    const std::span<const ChargerEvent> all = bays_[bay]->events();
    while (collected_[bay] < all.size()) take(bay, all[collected_[bay]++]);
  }
  std::stable_sort(events_.begin() + first, events_.end(),
                   [](const YardEvent& one, const YardEvent& other) { return one.at < other.at; });
}

void ChargingYard::take(std::size_t bay, ChargerEvent event) {
  const auto part = static_cast<std::uint8_t>(bay + 1);
  if (auto* began = std::get_if<FaultBegan>(&event.what)) {
    excuse(event.at, bay, began->kind, true);
    began->fault = faults_[bay][began->fault];
    began->place.part = part;
  } else if (auto* ended = std::get_if<FaultEnded>(&event.what)) {
    excuse(event.at, bay, ended->kind, false);
    ended->fault = faults_[bay][ended->fault];
    ended->place.part = part;
  } else if (auto* broken = std::get_if<InvariantBroken>(&event.what)) {
    Invariant& invariant = broken->invariant;
    invariant.part = part;
    if (invariant.fault != no_fault) invariant.fault = faults_[bay][invariant.fault];
  }
  events_.push_back({event.at, part, std::move(event)});
}

/// The other bays of the bus are kept waiting as well.
void ChargingYard::excuse(Time now, std::size_t bay, FaultKind kind, bool begins) {
  for (std::size_t other = 0; other < bays_.size(); ++other) {
    const bool is_hit = other == bay || (options_.one_bus && is_of_bus(kind));
    if (!is_hit) continue;
    begins ? referee_.fault_began(now, other) : referee_.fault_ended(now, other);
    if (other != bay) bays_[other]->referees().excuse(now, kind, begins);
  }
}

void ChargingYard::report_broken(Time now) {
  if ((now - Time{}) % 1s != Duration::zero()) return;
  const std::vector<YardInvariant> all = goals();
  told_.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].held || told_[i]) continue;
    told_[i] = true;
    events_.push_back({now, 0, canvoy::InvariantBroken<YardInvariantKind>{all[i]}});
  }
}

std::vector<Invariant> ChargingYard::invariants() const {
  std::vector<Invariant> all;
  for (std::size_t bay = 0; bay < bays_.size(); ++bay) {
    for (Invariant invariant : bays_[bay]->referees().invariants()) {
      invariant.part = static_cast<std::uint8_t>(bay + 1);
      if (invariant.fault != no_fault) invariant.fault = faults_[bay][invariant.fault];
      all.push_back(invariant);
    }
  }
  return all;
}

bool ChargingYard::all_hold() const {
  const std::vector<YardInvariant> goals = this->goals();
  const std::vector<Invariant> of_bays = invariants();
  return std::ranges::all_of(goals, &YardInvariant::held) &&
         std::ranges::all_of(of_bays, &Invariant::held);
}

YardSnapshot ChargingYard::snapshot() {
  YardSnapshot look{.at = now(),
                    .buses = {},
                    .bays = {},
                    .vehicles = {},
                    .mains_watt_hours = referee_.mains_watt_hours(),
                    .mains_watt_max = referee_.mains_watt_max()};
  for (const auto& bay : bays_) look.bays.push_back(bay->snapshot());
  for (const auto& watch : watches_) {
    const auto of_bus = std::ranges::find_if(
        bays_, [&](const auto& bay) { return bay->devices().bus() == watch->bus; });
    look.buses.push_back(look.bays[static_cast<std::size_t>(of_bus - bays_.begin())].bus);
  }
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const BatteryPlant& cells = vehicles_.cells(i);
    look.vehicles.push_back({.bay = vehicles_.bay(i),
                             .place = vehicles_.place(i),
                             .state_of_charge = cells.state_of_charge(),
                             .celsius = cells.celsius(),
                             .is_full = cells.is_full(),
                             .at_goal = referee_.at_goal(i)});
  }
  return look;
}

}  // namespace canvoy::charger
