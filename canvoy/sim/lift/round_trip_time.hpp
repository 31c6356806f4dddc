// The classical calculation of a pure up-peak: how long a car needs from leaving the main floor
// until it can leave it again, and what follows from that for a group.
//
//     RTT = 2 H tv + (S + 1) ts + 2 P tp
//
// with H = N - sum over i = 1..N-1 of (i / N)^P   (highest reversal floor)
//      S = N (1 - (1 - 1 / N)^P)                  (expected number of stops)
//      tv = interfloor distance / rated speed
//      ts = T - tv, where T = tf(1) + tc + to + dwell (performance time; tf(1): flight of one
//      floor)
//
// for N floors above the main floor, equally populated and equally high, and P passengers in each
// car. Source: G. Barney and L. Al-Sharif, Elevator Traffic Handbook, 2nd edition, chapter 7; the
// same in CIBSE Guide D, chapter 3. Closing before the car starts and opening at the end count
// whole; neither advance opening nor start delay is taken unless it is given.
//
//     const RoundTrip trip = round_trip_time(round_trip_options(building, 10.4));
//     trip.interval_s; trip.persons_in_5_minutes;
#pragma once

#include "canvoy/sim/lift/building.hpp"

namespace canvoy::lift {

/// Handling capacity is counted in persons of five minutes.
inline constexpr double five_minutes_s = 300;

/// Time that a car needs for a distance from stand to stand with limited jerk, by the shortest way.
struct Flight {
  double speed_m_s = 1;
  double acceleration_m_s2 = 1;
  double jerk_m_s3 = 1;
};
double flight_time_s(const Flight& limits, double distance_m);

struct RoundTripOptions {
  unsigned floors_above = 9;  ///< N
  double floor_height_m = 3.5;
  unsigned lifts = 1;
  double persons = 8;  ///< P, in each car as it leaves the main floor
  Flight flight{};
  double door_open_s = 2;
  double door_close_s = 2.6;
  double transfer_s = 1.2;   ///< tp: a person in or out
  double dwell_s = 0;        ///< a door stays open beside transfers, at each stop
  double start_delay_s = 0;  ///< from locked to moving, and from standing to opening, together
};

struct RoundTrip {
  double reversal_floor = 0;  ///< H
  double stops = 0;           ///< S
  double round_trip_s = 0;    ///< RTT
  double interval_s = 0;      ///< between two cars that leave the main floor
  double persons_in_5_minutes = 0;
};
RoundTrip round_trip_time(const RoundTripOptions& options);

/// Of a building whose lifts are alike and whose main floor is the lowest.
RoundTripOptions round_trip_options(const Building& building, double persons);

}  // namespace canvoy::lift
