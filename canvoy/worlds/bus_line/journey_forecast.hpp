// Forecasts when a bus will be at its next stops, by its timetable and its progress: a late bus
// stays late, except for the time that it would have waited at a timing point; an early one leaves
// no timing point before its time.
//
//     for (const StopForecast& stop : forecast(journey, {.place = 3}, now)) stop.departure ...
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "canvoy/worlds/bus_line/bus_line.hpp"

namespace canvoy::bus_line {

/// All times are of the day of service.
struct JourneyProgress {
  std::size_t place = 0;                              ///< index of the stop where it stands, or of
                                                      ///< the next stop
  std::optional<std::chrono::seconds> arrived{};      ///< arrival there; empty: it is under way
  std::optional<std::chrono::seconds> left_before{};  ///< departure from the stop before; empty:
                                                      ///< unknown
};

/// Times at a stop of the journey, also those that are over.
struct StopForecast {
  std::size_t place = 0;                            ///< index in the route
  std::optional<std::chrono::seconds> arrival{};    ///< empty for the first stop
  std::optional<std::chrono::seconds> departure{};  ///< empty for the last stop
};

/// Forecasts from `place` on, in rising times: each stop at least a second after the one before. No
/// time in the future is before `now`. Empty where there is no such stop.
std::vector<StopForecast> forecast(const Journey& journey, const JourneyProgress& progress,
                                   std::chrono::seconds now);

}  // namespace canvoy::bus_line
