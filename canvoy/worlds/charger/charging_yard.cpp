#include "canvoy/worlds/charger/charging_yard.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::charger {

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

ChargingYard::ChargingYard(const YardOptions& options)
    : options_(options),
      bays_(make_bays(world_, options_)),
      collected_(bays_.size()),
      vehicles_(options_, bays_,
                [this](Time now, const VehicleMoved& moved) {
                  events_.push_back({now, moved.bay, moved});
                }),
      referee_(options_, bays_, vehicles_),
      stepping_(world_.add_plant(Callback<void(Time)>::to<&ChargingYard::step>(*this),
                                 ChargingPlant::step_time)) {
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
  tell_broken(now);
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

void ChargingYard::tell_broken(Time now) {
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
