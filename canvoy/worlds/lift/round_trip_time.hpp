// The classical calculation of a pure up-peak: the time that a car needs from leaving the main
// floor until it can leave it again, and the results for a group.
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
// car. Source: G. Barney and L. Al-Sharif, Elevator Traffic Handbook, 2nd edition, chapter 7; also
// in CIBSE Guide D, chapter 3. Closing before the car starts and opening at the end count in full;
// advance opening and start delay count only where they are given.
//
//     const RoundTrip trip = round_trip_time(round_trip_options(building, 10.4));
//     trip.interval_s; trip.persons_in_5_minutes;
#pragma once

#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// Handling capacity counts persons in five minutes.
inline constexpr double five_minutes_s = 300;

/// Time that a car needs for a distance from rest to rest with limited jerk, at the shortest.
struct Flight {
  double speed_m_s = 1;          ///< rated speed
  double acceleration_m_s2 = 1;  ///< greatest, also of braking
  double jerk_m_s3 = 1;          ///< greatest change of the acceleration
};
/// Time for `distance_m` from rest to rest; 0 for no distance.
double flight_time_s(const Flight& limits, double distance_m);

/// Data of the calculation, with its symbols where it has them.
struct RoundTripOptions {
  unsigned floors_above = 9;    ///< N
  double floor_height_m = 3.5;  ///< all alike
  unsigned lifts = 1;           ///< L, in the group
  double persons = 8;           ///< P, in each car as it leaves the main floor
  Flight flight{};              ///< speed, acceleration and jerk of the cars
  double door_open_s = 2;       ///< to
  double door_close_s = 2.6;    ///< tc
  double transfer_s = 1.2;      ///< tp: for a person in or out
  double dwell_s = 0;           ///< time for which a door stays open at each stop, beside transfers
  double start_delay_s = 0;     ///< from locked to moving, plus from standing to opening
};

/// Results of the calculation, with its symbols.
struct RoundTrip {
  double reversal_floor = 0;        ///< H
  double stops = 0;                 ///< S
  double round_trip_s = 0;          ///< RTT
  double interval_s = 0;            ///< between two cars that leave the main floor
  double persons_in_5_minutes = 0;  ///< handling capacity of the group
};
/// Calculates a pure up-peak; constant time but for the powers.
RoundTrip round_trip_time(const RoundTripOptions& options);

/// Options of a building with identical lifts and the main floor at the bottom.
RoundTripOptions round_trip_options(const Building& building, double persons);

}  // namespace canvoy::lift
