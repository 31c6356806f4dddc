#include "canvoy/worlds/lift/service_watch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "canvoy/worlds/lift/car_watch.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

/// A car at this distance has left its floor: people and levelling move it by less.
constexpr double left_floor_m = 0.5;
/// In addition to its way and its door: people of the stop before get in and out, and its door
/// closes.
constexpr Duration comes_after = 60s;

Duration time_to(const LiftDesign& design, double way_m) {
  const Flight flight{design.speed_m_s, design.acceleration_m_s2, design.jerk_m_s3};
  const double seconds = flight_time_s(flight, way_m) + design.door.open_time_s;
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

ServiceWatch::ServiceWatch(const Building& building)
    : building_(&building), lifts_(building.lifts.size()) {}

void ServiceWatch::look(Time now, LiftNumber lift, const LiftFacts& facts, bool is_hindered,
                        const Crowd& crowd) {
  Watched& it = watched(lift);
  const Duration passed = now - it.looked_at;
  it.looked_at = now;
  if (is_hindered) it.hindered_at = now;
  it.was_wanted = it.has_riders = false;
  const bool has_left = std::abs(facts.position_m - it.position_m) > left_floor_m;
  if (it.is_new || has_left || is_hindered) {
    it.was_wanted = has_left && !it.is_new && !is_hindered;
    it.position_m = facts.position_m;
    it.stands_since = now;
    it.idle = Duration{0};
    it.is_new = false;
  } else if (is_awaited_too_long(now, lift, crowd)) {
    it.idle += passed;
    it.was_wanted = true;
  }
  it.has_people = !crowd.riding(lift).empty();
  it.has_riders = it.has_people && !is_hindered;
  const bool is_shut_in = it.has_people && stands(facts) && !lets_out(lift, facts);
  it.shut_in = is_shut_in ? it.shut_in + passed : Duration{0};
  it.trapped = is_shut_in && !is_hindered ? it.trapped + passed : Duration{0};
}

bool ServiceWatch::lets_out(LiftNumber lift, const LiftFacts& facts) const {
  const double wide_m = RefereeLimits{}.walkable_share * building_->lift(lift).door.width_m;
  const bool is_open = std::ranges::any_of(
      facts.doors, [wide_m](const DoorFacts& door) { return door.open_m >= wide_m; });
  return is_open && floor_at(*building_, facts.position_m) != no_floor;
}

/// For a passenger at one of its floors, who wants to go to another one of its floors.
bool ServiceWatch::is_awaited_too_long(Time now, LiftNumber lift, const Crowd& crowd) const {
  const Watched& it = watched(lift);
  const LiftDesign& design = building_->lift(lift);
  for (FloorNumber floor = 1; floor <= building_->floor_count(); ++floor) {
    if (crowd.waiting(floor).empty() || !building_->serves(lift, floor)) continue;
    const double way_m = std::abs(building_->height_m(floor) - it.position_m);
    const Duration needed = comes_after + time_to(design, way_m);
    const bool is_late = std::ranges::any_of(crowd.waiting(floor), [&](PassengerId who) {
      const Passenger& person = crowd.passengers()[who];
      // A later fault may have lost the answer of a terminal to the passenger, who waits before the
      // next request.
      const bool was_told = person.lift != 0;
      if (was_told && watched(person.lift).hindered_at >= person.waiting_since) return false;
      const Time since = std::max(person.waiting_since, it.stands_since);
      return building_->serves(lift, person.wish.to) && now - since > needed;
    });
    if (is_late) return true;
  }
  return false;
}

}  // namespace canvoy::lift
