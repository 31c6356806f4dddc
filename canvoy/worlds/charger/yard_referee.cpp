#include "canvoy/worlds/charger/yard_referee.hpp"

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
  if (!results_[vehicle].charge) return goal;
  goal.worst = missing_percent(vehicle);
  goal.allowed = allowed_percent(vehicle);
  goal.held = goal.worst <= goal.allowed;
  goal.judged = 1;
  return goal;
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
  if (result.full < equalising_time) return invariant;
  invariant.worst = std::max(0.0, 1 - hours(result.equalised) / hours(equalising_time)) * of_whole;
  invariant.held = invariant.worst <= invariant.allowed;
  invariant.judged = 1;
  return invariant;
}

YardInvariant YardReferee::supply() const {
  constexpr double kilo = 1000;
  return {.kind = YardInvariantKind::supply,
          .worst = mains_watt_max_ / kilo,
          .allowed = yard_->supply_watt / kilo,
          .held = mains_watt_max_ <= yard_->supply_watt,
          .judged = mains_watt_max_ > 0 ? steps_ : 0};
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

}  // namespace canvoy::charger
