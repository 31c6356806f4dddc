#include "canvoy/worlds/bus_line/journey_forecast.hpp"

#include <algorithm>

namespace canvoy::bus_line {

namespace {

using Seconds = std::chrono::seconds;

Seconds whole(Duration time) {
  return std::chrono::floor<Seconds>(time);
}

/// Departure after an arrival at that time.
Seconds departure_after(const Passing& passing, Seconds arrival) {
  const Seconds planned = whole(passing.departure);
  if (passing.is_timing_point) return std::max(arrival, planned);
  return arrival + std::max(Seconds(0), planned - whole(passing.arrival));
}

/// Arrival at `place`, which the bus has not reached yet.
Seconds arrival_after(const Journey& journey, std::size_t place, Seconds left_before) {
  const Seconds way =
      whole(journey.passings[place].arrival) - whole(journey.passings[place - 1].departure);
  return left_before + std::max(Seconds(1), way);
}

Seconds first_arrival(const Journey& journey, const JourneyProgress& progress, Seconds now) {
  if (progress.arrived) return *progress.arrived;
  if (!progress.left_before) return std::max(now, whole(journey.passings[progress.place].arrival));
  return std::max(now, arrival_after(journey, progress.place, *progress.left_before));
}

}  // namespace

std::vector<StopForecast> forecast(const Journey& journey, const JourneyProgress& progress,
                                   Seconds now) {
  std::vector<StopForecast> all;
  Seconds left{};
  for (std::size_t place = progress.place; place < journey.passings.size(); ++place) {
    const Passing& passing = journey.passings[place];
    StopForecast stop{.place = place};
    Seconds departure = std::max(now, whole(passing.departure));
    if (place != 0) {
      stop.arrival =
          all.empty() ? first_arrival(journey, progress, now) : arrival_after(journey, place, left);
      departure = std::max(now, departure_after(passing, *stop.arrival));
    }
    if (place + 1 != journey.passings.size()) stop.departure = departure;
    left = departure;
    all.push_back(stop);
  }
  return all;
}

}  // namespace canvoy::bus_line
