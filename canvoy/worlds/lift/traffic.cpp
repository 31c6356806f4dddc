#include "canvoy/worlds/lift/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

constexpr double mass_kg_least = 35;
constexpr int draws_max = 100;

}  // namespace

TrafficShares shares_of(TrafficPattern pattern) {
  switch (pattern) {
    case TrafficPattern::up_peak:
      return {.incoming = 1};
    case TrafficPattern::down_peak:
      return {.outgoing = 1};
    case TrafficPattern::lunch:
      return {.incoming = 0.45, .outgoing = 0.45, .interfloor = 0.1};
    case TrafficPattern::interfloor:
      break;
  }
  return {.interfloor = 1};
}

Traffic::Traffic(const Building& building, const TrafficOptions& options)
    : building_(&building),
      options_(options),
      random_(options.seed),
      at_(options.from),
      people_per_second_(building.population() * options.percent_in_5_minutes / 100 /
                         five_minutes_s) {
  if (building.floor_count() < 2) people_per_second_ = 0;
}

Traffic::Traffic(std::vector<Arrival> list) : random_(0), list_(std::move(list)) {
  std::sort(list_.begin(), list_.end(), [](const Arrival& a, const Arrival& b) {
    return std::tie(a.at, a.from, a.to, a.mass_kg) < std::tie(b.at, b.from, b.to, b.mass_kg);
  });
}

std::optional<Arrival> Traffic::next() {
  if (building_ == nullptr) {
    if (next_of_list_ == list_.size()) return std::nullopt;
    return list_[next_of_list_++];
  }
  if (people_per_second_ <= 0) return std::nullopt;
  // The time between two events of a Poisson process is exponentially distributed.
  const double gap_s = -std::log1p(-uniform()) / people_per_second_;
  if (gap_s >= in_seconds(options_.until - at_)) return std::nullopt;
  at_ += Duration(std::llround(gap_s * 1e6));
  if (at_ >= options_.until) return std::nullopt;
  Arrival arrival = draw_way();
  // Destinations that no lift reaches are drawn again.
  for (int i = 0; i < draws_max && !building_->has_way(arrival.from, arrival.to); ++i) {
    arrival = draw_way();
  }
  arrival.at = at_;
  arrival.mass_kg = draw_mass_kg();
  return arrival;
}

Arrival Traffic::draw_way() {
  const TrafficShares shares = shares_of(options_.pattern);
  const double chance = uniform();
  Arrival arrival;
  if (chance < shares.incoming) {
    arrival.from = building_->main_floor;
    arrival.to = draw_floor(arrival.from);
  } else if (chance < shares.incoming + shares.outgoing) {
    arrival.to = building_->main_floor;
    arrival.from = draw_floor(arrival.to);
  } else {
    arrival.from = draw_floor(building_->main_floor);
    arrival.to = draw_floor(arrival.from);
  }
  return arrival;
}

/// By population. Where no people live on any other floor, the next one is drawn.
FloorNumber Traffic::draw_floor(FloorNumber other_than) {
  const double all = building_->population() - building_->floor(other_than).population;
  double left = uniform() * all;
  FloorNumber last = no_floor;
  for (unsigned i = 1; i <= building_->floor_count(); ++i) {
    const auto floor = static_cast<FloorNumber>(i);
    if (floor == other_than || building_->floor(floor).population <= 0) continue;
    last = floor;
    left -= building_->floor(floor).population;
    if (left < 0) break;
  }
  if (last != no_floor) return last;
  return static_cast<FloorNumber>(other_than == 1 ? 2 : other_than - 1);
}

/// The sum of two uniform distributions: a triangle, with its half width divided by the root of six
/// as deviation.
double Traffic::draw_mass_kg() {
  const double half_width = options_.mass_kg_deviation * std::sqrt(6.0);
  const double mass = options_.mass_kg_mean + (uniform() + uniform() - 1) * half_width;
  return std::max(mass, mass_kg_least);
}

double Traffic::uniform() {
  return static_cast<double>(random_.next() >> 11) * 0x1p-53;
}

}  // namespace canvoy::lift
