#include "canvoy/worlds/lift/car_watch.hpp"

#include <algorithm>

namespace canvoy::lift {

namespace {

bool is_open(const LiftFacts& facts) {
  return std::any_of(facts.doors.begin(), facts.doors.end(),
                     [](const DoorFacts& door) { return door.open_m >= open_least_m; });
}

}  // namespace

CarWatch::CarWatch(const Building& building, std::vector<LiftEvent>& events)
    : building_(&building), events_(&events), cars_(building.lifts.size()) {
  for (Car& car : cars_) car.opened_at.assign(building.floors.size(), never);
}

CarWatch::Seen CarWatch::look(Time now, LiftNumber lift, const LiftFacts& facts, unsigned persons) {
  Car& car = cars_[lift - std::size_t{1}];
  const Seen seen{.starts = !stands(facts) && !car.moves, .stands = stands(facts)};
  const FloorNumber floor = floor_at(*building_, facts.position_m);
  if (seen.starts) {
    ++car.starts;
    events_->push_back({now, CarStarted{lift, floor_at(*building_, car.position_m), persons}});
  }
  if (seen.stands && car.moves) {
    car.stands_since = now;
    events_->push_back({now, CarStopped{lift, floor}});
  }
  const bool open = is_open(facts);
  if (open && !car.is_open) {
    events_->push_back({now, DoorsOpened{lift, floor}});
    if (floor != no_floor) car.opened_at[floor - std::size_t{1}] = now;
  }
  car.moves = !seen.stands;
  car.is_open = open;
  car.position_m = facts.position_m;
  return seen;
}

bool CarWatch::has_opened_since(Time since, LiftNumber lift, FloorNumber floor) const {
  const Time opened = cars_[lift - std::size_t{1}].opened_at[floor - std::size_t{1}];
  return opened != never && opened >= since;
}

}  // namespace canvoy::lift
