// A building with its lifts, as constant data in metres, kilograms and seconds. Floors, lifts and
// doors are numbered as in CiA 417: floors 1 to 254 from below (0 is the car), lifts 1 to 8, doors
// 1 to 4.
//
//     const Building building = uniform_building({.floors = 20, .lifts = 4});
//     building.height_m(3);     // of the third floor above the first: 7.0
//     building.floor_near(7.004, 0.010);  // 3
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::lift {

/// A door is not closed if its leaves are at least this far apart.
inline constexpr double open_least_m = 0.001;

using FloorNumber = std::uint8_t;  ///< 1 to 254
using LiftNumber = std::uint8_t;   ///< 1 to 8
using DoorNumber = std::uint8_t;   ///< 1 to 4

inline constexpr FloorNumber no_floor = 0;  ///< between two floors, none, or any, as the place says
inline constexpr FloorNumber floors_max = 254;  ///< highest number of a floor in CiA 417
inline constexpr LiftNumber lifts_max = 8;      ///< lifts of one building (CiA 417-1)
inline constexpr DoorNumber doors_max = 4;      ///< doors of one car

/// Direction of travel, or of a landing call.
enum class Direction : std::uint8_t { none, up, down };

/// A floor of the building; its number is its place in Building::floors, from 1.
struct Floor {
  double height_m = 0;    ///< above floor 1
  double population = 0;  ///< number of people who work or live there; 0 at an entrance
  std::string name{};     ///< name on a display
};

/// A door of a car, with the landing doors that it moves.
struct DoorDesign {
  double width_m = 0.9;       ///< width of the open doorway
  double open_time_s = 2.0;   ///< from closed to open
  double close_time_s = 2.6;  ///< from open to closed
};

/// A car and what it may carry.
struct CarDesign {
  double mass_kg = 1100;        ///< mass of the empty car
  double rated_load_kg = 1000;  ///< the basis of the load signals of 6482h
  unsigned rated_persons = 13;  ///< by EN 81-20; decides whether people board
  /// Sag of the car under a load, through its ropes.
  double rope_stretch_um_per_kg = 2;
  double overload_share = 1.1;  ///< share of the rated load: with more, a car must not leave (EN
                                ///< 81-20)
};

/// Floors, from below; a list that may be empty then stands for all.
using FloorList = std::vector<FloorNumber>;
/// True if a list names the floor; unlike the lists of a design, an empty one names none.
inline bool has_floor(const FloorList& floors, FloorNumber floor) {
  return std::find(floors.begin(), floors.end(), floor) != floors.end();
}

inline constexpr std::size_t key_locks = 4;  ///< key locks of a car panel that permit car calls

/// A lift with its car, its doors, and the floors that it serves.
struct LiftDesign {
  CarDesign car{};          ///< same at all floors
  DoorDesign door{};        ///< all its doors are alike
  unsigned doors = 0b0001;  ///< its doors: bit 0 is door 1
  std::string zone{};       ///< zone of the building that it serves; empty: none
  FloorList floors{};       ///< floors of its zone that it serves; empty: all
  /// Floors among these that have each door; empty: all.
  std::array<FloorList, doors_max> floors_of_door{};
  /// Floors to which car calls need key lock 1 to 4 turned; empty: none.
  std::array<FloorList, key_locks> locked_by_key{};
  /// Share of the rated load that the counterweight balances, beside the mass of the car.
  double balance = 0.5;
  double speed_m_s = 1.6;          ///< rated speed
  double acceleration_m_s2 = 1.0;  ///< greatest, also of braking
  double jerk_m_s3 = 1.2;          ///< greatest change of the acceleration
  double overtravel_m = 0.3;       ///< beyond the lowest and the highest floor, up to the buffers
  double door_zone_m = 0.2;        ///< to both sides of a floor, where doors may be open
  /// False: its safety chain is bridged, which is forbidden; for tests of referees.
  bool has_safety_chain = true;
  /// False: its drive does not test its brake (EN 81-20, 5.6.7.3); for tests of referees.
  bool has_brake_test = true;
};

/// Floors that a group of the lifts of a building serves.
struct Zone {
  std::string name{};  ///< by which a lift refers to it
  FloorList floors{};  ///< that a lift of the zone may serve
};

struct Building {
  std::vector<Floor> floors{};      ///< from below; at most 254
  std::vector<LiftDesign> lifts{};  ///< lift 1 first; at most 8
  std::vector<Zone> zones{};        ///< none: each lift serves all floors
  FloorNumber main_floor = 1;       ///< floor where people come in

  /// Also the number of the highest floor.
  FloorNumber floor_count() const { return static_cast<FloorNumber>(floors.size()); }
  /// Also the number of the last lift.
  LiftNumber lift_count() const { return static_cast<LiftNumber>(lifts.size()); }
  /// `number` from 1; throws std::out_of_range beyond the building.
  const Floor& floor(FloorNumber number) const { return floors.at(number - std::size_t{1}); }
  /// `number` from 1; throws std::out_of_range beyond the building.
  const LiftDesign& lift(LiftNumber number) const { return lifts.at(number - std::size_t{1}); }
  /// Height of a floor above floor 1.
  double height_m(FloorNumber number) const { return floor(number).height_m; }
  /// Doors that a lift has at a floor: bit 0 is door 1.
  unsigned doors_at(LiftNumber number, FloorNumber floor) const {
    const LiftDesign& design = lift(number);
    const bool is_served = design.floors.empty() || has_floor(design.floors, floor);
    if (!is_served || !is_in_zone(design.zone, floor)) return 0;
    unsigned doors = design.doors;
    for (std::size_t i = 0; i < design.floors_of_door.size(); ++i) {
      const FloorList& has_it = design.floors_of_door.at(i);
      if (!has_it.empty() && !has_floor(has_it, floor)) doors &= ~(1U << i);
    }
    return doors;
  }
  /// True if a lift has a door at the floor.
  bool serves(LiftNumber number, FloorNumber floor) const { return doors_at(number, floor) != 0; }
  /// True if a lift serves both floors.
  bool has_way(FloorNumber from, FloorNumber to) const {
    for (std::size_t i = 1; i <= lifts.size(); ++i) {
      const auto number = static_cast<LiftNumber>(i);
      if (serves(number, from) && serves(number, to)) return true;
    }
    return false;
  }
  /// True where the zone does not exist: a lift without a zone goes everywhere.
  bool is_in_zone(const std::string& zone, FloorNumber floor) const {
    const auto found = std::find_if(zones.begin(), zones.end(),
                                    [&](const Zone& each) { return each.name == zone; });
    return found == zones.end() || has_floor(found->floors, floor);
  }
  /// Height of the highest floor above floor 1; the building must have one.
  double top_m() const { return floors.back().height_m; }

  /// The floor within `tolerance_m`; no_floor where there is none. Linear in the number of floors.
  FloorNumber floor_near(double position_m, double tolerance_m) const {
    for (std::size_t i = 0; i < floors.size(); ++i) {
      if (std::abs(floors[i].height_m - position_m) <= tolerance_m) {
        return static_cast<FloorNumber>(i + 1);
      }
    }
    return no_floor;
  }
  /// Sum over all floors.
  double population() const {
    double all = 0;
    for (const Floor& each : floors) all += each.population;
    return all;
  }
};

/// A building with floors of one height and lifts of one kind.
struct UniformBuilding {
  FloorNumber floors = 10;           ///< 1 to 254
  double floor_height_m = 3.5;       ///< from floor to floor
  LiftNumber lifts = 1;              ///< 1 to 8, all alike
  double population_per_floor = 50;  ///< at each floor but the lowest, which is the entrance
  LiftDesign lift{};                 ///< design of all of them
};

/// A building by these options; floors are named by their numbers.
inline Building uniform_building(const UniformBuilding& options) {
  Building made;
  for (unsigned i = 0; i < options.floors; ++i) {
    made.floors.push_back({.height_m = i * options.floor_height_m,
                           .population = i == 0 ? 0 : options.population_per_floor,
                           .name = std::to_string(i + 1)});
  }
  made.lifts.assign(options.lifts, options.lift);
  return made;
}

}  // namespace canvoy::lift
