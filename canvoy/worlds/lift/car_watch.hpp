// Notes what can be seen of the cars of a building: when they start and stop, and where they have
// opened a door.
//
//     CarWatch cars(building, events);
//     const CarWatch::Seen seen = cars.look(now, 1, shaft.facts(now), persons);
//     if (seen.starts) ...
//     cars.has_opened_since(lit_at, 1, 3);
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/lift_event.hpp"
#include "canvoy/worlds/lift/referee.hpp"

namespace canvoy::lift {

/// True if a car moves with less than 1 mm/s.
inline bool stands(const LiftFacts& facts) {
  constexpr double standing_m_s = 0.001;
  return std::abs(facts.speed_m_s) <= standing_m_s;
}

/// A car within this distance is at the floor, levelled or passing; no_floor: between two.
inline constexpr double level_tolerance_m = 0.012;
/// See level_tolerance_m.
inline FloorNumber floor_at(const Building& building, double position_m) {
  return building.floor_near(position_m, level_tolerance_m);
}
/// True within level_tolerance_m of the floor, also in motion.
inline bool is_car_at(const Building& building, const LiftFacts& facts, FloorNumber floor) {
  return std::abs(facts.position_m - building.height_m(floor)) <= level_tolerance_m;
}

class CarWatch {
 public:
  /// Both must outlive this object; changes are noted in `events`.
  CarWatch(const Building& building, std::vector<LiftEvent>& events);

  /// What a look at a car has found.
  struct Seen {
    bool starts = false;  ///< it stood at the last look
    bool stands = false;  ///< it has just stopped
  };
  /// `persons` is the number of people in it.
  Seen look(Time now, LiftNumber lift, const LiftFacts& facts, unsigned persons);

  /// How often a car has started, since the beginning.
  std::uint32_t starts(LiftNumber lift) const { return cars_[lift - std::size_t{1}].starts; }
  /// Since when a car stands; empty: it moves.
  std::optional<Time> stands_since(LiftNumber lift) const {
    const Car& car = cars_[lift - std::size_t{1}];
    return car.moves ? std::nullopt : std::optional(car.stands_since);
  }
  /// True if a door has opened at that floor.
  bool has_opened_since(Time since, LiftNumber lift, FloorNumber floor) const;

 private:
  /// State at the last look.
  struct Car {
    bool moves = false;
    Time stands_since{};
    bool is_open = false;
    double position_m = 0;
    std::uint32_t starts = 0;
    std::vector<Time> opened_at{};  ///< last time at each floor
  };

  const Building* building_;
  std::vector<LiftEvent>* events_;
  std::vector<Car> cars_;
};

}  // namespace canvoy::lift
