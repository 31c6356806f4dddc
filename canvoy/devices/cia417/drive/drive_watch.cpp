#include "canvoy/devices/cia417/drive/drive_watch.hpp"

#include <cmath>

namespace canvoy::cia417 {

bool DriveWatch::is_too_fast(const DrivenCar& car, const DriveParameters& parameters) const {
  const double highest = parameters.velocity_max() * limits_.overspeed_percent / 100;
  return highest > 0 && std::abs(car.readings().velocity) > highest;
}

bool DriveWatch::strays(const DrivenCar& car, const DriveParameters& parameters) const {
  return car.has_strayed(parameters.increments(limits_.unintended_distance));
}

bool DriveWatch::lags_behind(const DrivenCar& car, const DriveParameters& parameters, Time now) {
  behind_.watch(car.lag(now) > parameters.increments(limits_.following_window), now);
  return behind_.lasts(limits_.following_time, now);
}

}  // namespace canvoy::cia417
