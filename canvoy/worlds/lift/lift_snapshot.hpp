// State of everything in a network of lifts at one instant, for a drawing or a line of a log, and
// the summary at the end of a run.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/passenger.hpp"
#include "canvoy/worlds/lift/referee.hpp"

namespace canvoy::lift {

/// State of the controller of a lift.
enum class LiftMode : std::uint8_t {
  starting,  ///< waits for its devices
  normal,
  fire_recall,
  fire_brigade,
  special,  ///< another service: attendant, VIP, bed passenger, service run, dogging
  out_of_order,
  fault,
};

struct LiftSnapshot {
  double position_m = 0;                  ///< above floor 1
  double speed_m_s = 0;                   ///< upward is positive
  FloorNumber nearest_floor = 1;          ///< floor of least distance
  Direction direction = Direction::none;  ///< as its lantern shows
  /// A door of the car.
  struct Door {
    bool is_there = false;  ///< the car has this door
    double open_share = 0;  ///< 0 closed to 1 open
    bool locked = true;     ///< its lock holds
    bool blocked = false;   ///< the light barrier is interrupted
  };
  std::array<Door, doors_max> doors{};   ///< door 1 first
  LiftMode mode = LiftMode::starting;    ///< state of its controller
  unsigned persons = 0;                  ///< in the car
  double load_kg = 0;                    ///< of the people in the car
  bool overload = false;                 ///< the car shows it, and stays
  std::vector<FloorNumber> car_calls{};  ///< floors with a lit lamp
  std::uint32_t starts = 0;              ///< since the start of the run
  double distance_m = 0;                 ///< up and down
  double energy_wh = 0;                  ///< taken from the mains, less what was returned
};

/// What is at a landing.
struct LandingSnapshot {
  unsigned waiting_up = 0;    ///< people who want to go up
  unsigned waiting_down = 0;  ///< people who want to go down
  bool lamp_up = false;       ///< the button "up" is lit
  bool lamp_down = false;     ///< the button "down" is lit
};

/// State of the whole network.
struct LiftNetworkSnapshot {
  Time at{};                                ///< since the start of the run
  std::vector<LiftSnapshot> lifts{};        ///< lift 1 first
  std::vector<LandingSnapshot> landings{};  ///< floor 1 first
  std::vector<BusSnapshot> buses{};         ///< in the order of the description
  std::vector<NodeSnapshot> nodes{};  ///< nodes that are simulated here, as in the description
  std::size_t waiting = 0;            ///< people at all landings
  std::size_t riding = 0;             ///< people in all cars
  std::size_t served = 0;             ///< people at their destination, since the start
};

/// Summary of a run. Times are zero where no passenger was carried.
struct LiftSummary {
  /// Statistics of a sample of durations.
  struct Times {
    Duration mean{0};           ///< arithmetic mean
    Duration percentile_90{0};  ///< 90 % are not longer (nearest rank)
    Duration longest{0};        ///< maximum
  };
  Duration run{0};          ///< duration of the run
  std::size_t arrived = 0;  ///< people who came
  std::size_t served = 0;   ///< people who reached the destination
  std::size_t gave_up = 0;  ///< people who took the stairs
  Times waiting{};          ///< until boarding, or until giving up
  Times to_destination{};   ///< from arrival at the landing to the destination
  /// Passengers carried to their destination in any five minutes: the greatest number, and not what
  /// the lifts can carry continuously. The handling capacity follows from the interval and the
  /// persons in a car.
  std::size_t most_in_5_minutes = 0;
  /// For cars that left the main floor with people, as in the classical calculation.
  double interval_s = 0;
  double persons_of_car = 0;  ///< mean number of people on board then
  /// By the classical calculation, with the same number of persons in a car; 0: not a pure up-peak
  /// of identical lifts from the lowest floor.
  double formula_interval_s = 0;
  /// For five minutes without interruption more people waited than fill each car twice, without a
  /// fault: more people come than can be carried.
  bool is_saturated = false;
  /// What a car has done.
  struct Lift {
    std::uint32_t starts = 0;   ///< from a standstill
    double starts_an_hour = 0;  ///< mean over the run
    double distance_m = 0;      ///< up and down
    double energy_wh = 0;       ///< taken from the mains, less what was returned
    Duration stands{0};         ///< until the end of the run, without a start
    bool is_hindered = false;   ///< at the end, by a fault or its effects, or a technician is there
  };
  std::vector<Lift> lifts{};         ///< lift 1 first
  std::vector<BusSnapshot> buses{};  ///< with their load since the start
};

}  // namespace canvoy::lift
