#include "canvoy/worlds/lift/round_trip_time.hpp"

#include <cmath>

namespace canvoy::lift {

namespace {

/// Neither the speed nor the acceleration need be reached: the three cases of the same handbook,
/// chapter 5.
double short_flight_s(const Flight& limits, double distance_m) {
  const double a = limits.acceleration_m_s2;
  const double j = limits.jerk_m_s3;
  const bool reaches_acceleration = distance_m >= 2 * a * a * a / (j * j);
  if (!reaches_acceleration) return std::cbrt(32 * distance_m / j);
  return a / j + std::sqrt(4 * distance_m / a + a * a / (j * j));
}

}  // namespace

double flight_time_s(const Flight& limits, double distance_m) {
  const double v = limits.speed_m_s;
  const double a = limits.acceleration_m_s2;
  const double j = limits.jerk_m_s3;
  if (distance_m <= 0) return 0;
  const bool can_accelerate_fully = v >= a * a / j;
  // From rest to the speed, or from the speed to rest.
  const double ramp_s = can_accelerate_fully ? v / a + a / j : 2 * std::sqrt(v / j);
  if (distance_m >= v * ramp_s) return distance_m / v + ramp_s;
  return short_flight_s(limits, distance_m);
}

RoundTrip round_trip_time(const RoundTripOptions& options) {
  const double n = options.floors_above;
  const double p = options.persons;
  RoundTrip trip;
  trip.reversal_floor = n;
  for (unsigned i = 1; i < options.floors_above; ++i) trip.reversal_floor -= std::pow(i / n, p);
  trip.stops = n * (1 - std::pow(1 - 1 / n, p));
  const double tv = options.floor_height_m / options.flight.speed_m_s;
  const double performance = flight_time_s(options.flight, options.floor_height_m) +
                             options.door_open_s + options.door_close_s + options.dwell_s +
                             options.start_delay_s;
  trip.round_trip_s = 2 * trip.reversal_floor * tv + (trip.stops + 1) * (performance - tv) +
                      2 * p * options.transfer_s;
  trip.interval_s = trip.round_trip_s / options.lifts;
  trip.persons_in_5_minutes = five_minutes_s * p / trip.interval_s;
  return trip;
}

RoundTripOptions round_trip_options(const Building& building, double persons) {
  const LiftDesign& lift = building.lift(1);
  const unsigned above = building.floor_count() - 1U;
  return {.floors_above = above,
          .floor_height_m = building.top_m() / above,
          .lifts = building.lift_count(),
          .persons = persons,
          .flight = {lift.speed_m_s, lift.acceleration_m_s2, lift.jerk_m_s3},
          .door_open_s = lift.door.open_time_s,
          .door_close_s = lift.door.close_time_s};
}

}  // namespace canvoy::lift
