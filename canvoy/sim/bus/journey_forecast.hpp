// When a bus will be at the stops that are before it, by its timetable and what is known of its
// way: who is late stays late, but for the time that it would have waited at a timing point; who is
// early leaves no timing point before its time.
//
//     for (const StopForecast& stop : forecast(journey, {.place = 3}, now)) stop.departure ...
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

/// All times are of the day of service.
struct JourneyProgress {
  std::size_t place = 0;                              ///< where it stands, or the next stop
  std::optional<std::chrono::seconds> arrived{};      ///< there; nothing: it is on its way
  std::optional<std::chrono::seconds> left_before{};  ///< the stop before; nothing: not known
};

struct StopForecast {                               ///< times that are over included
  std::size_t place = 0;                            ///< in the route
  std::optional<std::chrono::seconds> arrival{};    ///< of the first stop there is none
  std::optional<std::chrono::seconds> departure{};  ///< of the last stop there is none
};

/// From `place` on, in rising times: at each stop a second later than at the one before at least.
/// What is not over is not before `now`. Empty where there is no such stop.
std::vector<StopForecast> forecast(const Journey& journey, const JourneyProgress& progress,
                                   std::chrono::seconds now);

}  // namespace canvoy::bus
