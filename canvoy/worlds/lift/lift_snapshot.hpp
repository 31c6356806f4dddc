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
  double position_m = 0;
  double speed_m_s = 0;
  FloorNumber nearest_floor = 1;
  Direction direction = Direction::none;  ///< as its lantern shows
  struct Door {
    bool is_there = false;
    double open_share = 0;  ///< 0 closed to 1 open
    bool locked = true;
    bool blocked = false;  ///< the light barrier is interrupted
  };
  std::array<Door, doors_max> doors{};
  LiftMode mode = LiftMode::starting;
  unsigned persons = 0;
  double load_kg = 0;
  bool overload = false;
  std::vector<FloorNumber> car_calls{};  ///< floors with a lit lamp
  std::uint32_t starts = 0;
  double distance_m = 0;
  double energy_wh = 0;
};

struct LandingSnapshot {
  unsigned waiting_up = 0;
  unsigned waiting_down = 0;
  bool lamp_up = false;
  bool lamp_down = false;
};

struct LiftNetworkSnapshot {
  Time at{};
  std::vector<LiftSnapshot> lifts{};
  std::vector<LandingSnapshot> landings{};  ///< floor 1 first
  std::vector<BusSnapshot> buses{};
  std::vector<NodeSnapshot> nodes{};  ///< nodes that are simulated here, as in the description
  std::size_t waiting = 0;
  std::size_t riding = 0;
  std::size_t served = 0;
};

/// Summary of a run. Times are zero where no passenger was carried.
struct LiftSummary {
  struct Times {
    Duration mean{0};
    Duration percentile_90{0};
    Duration longest{0};
  };
  Duration run{0};
  std::size_t arrived = 0;
  std::size_t served = 0;
  std::size_t gave_up = 0;
  Times waiting{};
  Times to_destination{};
  /// Passengers carried to their destination in any five minutes: the greatest number, and not what
  /// the lifts can carry continuously. The handling capacity follows from the interval and the
  /// persons in a car.
  std::size_t most_in_5_minutes = 0;
  /// For cars that left the main floor with people, as in the classical calculation.
  double interval_s = 0;
  double persons_of_car = 0;
  /// By the classical calculation, with the same number of persons in a car; 0: not a pure up-peak
  /// of identical lifts from the lowest floor.
  double formula_interval_s = 0;
  /// For five minutes without interruption more people waited than fill each car twice, without a
  /// fault: more people come than can be carried.
  bool is_saturated = false;
  struct Lift {
    std::uint32_t starts = 0;
    double starts_an_hour = 0;
    double distance_m = 0;
    double energy_wh = 0;
  };
  std::vector<Lift> lifts{};
  std::vector<BusSnapshot> buses{};  ///< with their load since the start
};

}  // namespace canvoy::lift
