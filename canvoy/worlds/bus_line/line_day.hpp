// A day of all vehicles of a line together, without devices: it knows when each has left each stop.
// Where they follow each other at short times, people come at random and take the next vehicle: one
// that is late has more of them, and becomes later, and the one behind it has fewer. So vehicles
// bunch.
//
//     const auto day = std::make_shared<const LineDay>(line, options_of_each_block);
//     day->ahead(block, journey.number, stop)->left;
//     day->headways().variation();
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/headways.hpp"

namespace canvoy::bus_line {

class LineDay {
 public:
  /// Longest headway at which people do not look at the timetable.
  static constexpr Duration random_headway_max = 12min;

  /// Plays the day: a millisecond for each journey. `vehicles` has the options of each block; their
  /// `ahead` has no meaning. What is later than `until`, as time of the day of service, is unknown.
  LineDay(const BusLine& line, std::vector<BusOptions> vehicles, Duration until = 48h);
  LineDay(const LineDay&) = delete;
  LineDay& operator=(const LineDay&) = delete;

  /// True if vehicles of the line follow each other at such headways.
  static bool is_frequent(const BusLine& line);
  /// Vehicle ahead of a block at a stop of a journey; it drives the same route. Nothing where it is
  /// farther ahead than `random_headway_max`, or there is none.
  std::optional<VehicleAhead> ahead(std::size_t block, std::uint32_t journey,
                                    std::size_t stop) const;
  /// Headways at stops where people come at random.
  const Headways& headways() const { return headways_; }
  /// Mean of the most people aboard on a journey, of journeys that left their first stop at a
  /// longer headway than planned, or at a shorter one; 0 without any.
  double greatest_load(bool is_late) const;

 private:
  /// A journey with its departures, as times of the day of service.
  struct Run {
    const Run* ahead = nullptr;       ///< the run before on the same route
    std::vector<Duration> planned{};  ///< for each stop
    std::vector<std::optional<Duration>> left{};
    unsigned aboard_max = 0;
  };
  using Runs = std::map<std::pair<std::size_t, std::uint32_t>, Run>;

  static Runs runs_of(const BusLine& line);
  static std::optional<VehicleAhead> ahead_of(const Run& run, std::size_t stop);
  void play(const BusLine& line, std::vector<BusOptions> vehicles, Duration until);

  Runs runs_;  ///< by index of the block and number of the journey
  Headways headways_;
};

}  // namespace canvoy::bus_line
