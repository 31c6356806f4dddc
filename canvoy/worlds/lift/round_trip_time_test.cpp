#include "canvoy/worlds/lift/round_trip_time.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::round_trip_time_test {
namespace {

// Numbers calculated by hand from the formulas of the source.

TEST(FlightTimeTest, AWayWithoutEndTakesItsLengthBySpeedAndTwoHalfRamps) {
  // 2 m/s, 1 m/s2, 1 m/s3: a ramp takes 2 + 1 s.
  EXPECT_DOUBLE_EQ(flight_time_s({2, 1, 1}, 20), 10 + 3);
}

TEST(FlightTimeTest, AShortWayReachesTheAccelerationAndNotTheSpeed) {
  // 3.75 m: 1 + sqrt(15 + 1) s.
  EXPECT_DOUBLE_EQ(flight_time_s({10, 1, 1}, 3.75), 1 + 4);
}

TEST(FlightTimeTest, AVeryShortWayReachesNeither) {
  // Cube root of 32 times 0.25 m by 1 m/s3.
  EXPECT_DOUBLE_EQ(flight_time_s({10, 10, 1}, 0.25), 2);
}

TEST(FlightTimeTest, TheThreeCasesMeetWhereOneEnds) {
  const Flight limits{2, 1, 1};
  EXPECT_NEAR(flight_time_s(limits, 2.0 - 1e-9), flight_time_s(limits, 2.0 + 1e-9), 1e-6);
  EXPECT_NEAR(flight_time_s(limits, 6.0 - 1e-9), flight_time_s(limits, 6.0 + 1e-9), 1e-6);
}

TEST(FlightTimeTest, ASlowCarWithMuchAccelerationIsLimitedByItsJerk) {
  // 1 m/s is reached after 1 s at 2 m/s2, which is less than 5: a ramp takes 2 sqrt(1 / 1) s.
  EXPECT_DOUBLE_EQ(flight_time_s({1, 5, 1}, 10), 10 + 2);
}

TEST(FlightTimeTest, NoWayTakesNoTime) {
  EXPECT_EQ(flight_time_s({2, 1, 1}, 0), 0);
}

TEST(RoundTripTimeTest, ReversalFloorAndStopsAreThoseOfTheTables) {
  // The handbook's table for 10 floors and 8 passengers: H = 9.3, S = 5.7.
  const RoundTrip trip = round_trip_time({.floors_above = 10, .persons = 8});
  EXPECT_NEAR(trip.reversal_floor, 9.32, 0.005);
  EXPECT_NEAR(trip.stops, 5.70, 0.005);
}

TEST(RoundTripTimeTest, OnePassengerStopsOnceInTheMiddle) {
  const RoundTrip trip = round_trip_time({.floors_above = 9, .persons = 1});
  EXPECT_NEAR(trip.reversal_floor, 5, 1e-12);
  EXPECT_NEAR(trip.stops, 1, 1e-12);
}

TEST(RoundTripTimeTest, IntervalAndCapacityFollowFromTheRoundTrip) {
  // One floor above: H = S = 1, so 2 tv + 2 (T - tv) + 2 P tp = 2 T + 2 P tp.
  // T = flight of 4 m at 2 m/s, 1 m/s2, 1 m/s3 (1 + sqrt(17) s) + 2 + 3 + 1 + 0.5 s.
  const RoundTrip trip = round_trip_time({.floors_above = 1,
                                          .floor_height_m = 4,
                                          .lifts = 2,
                                          .persons = 10,
                                          .flight = {2, 1, 1},
                                          .door_open_s = 2,
                                          .door_close_s = 3,
                                          .transfer_s = 1,
                                          .dwell_s = 1,
                                          .start_delay_s = 0.5});
  EXPECT_NEAR(trip.round_trip_s, 2 * (1 + 4.1231056 + 6.5) + 20, 1e-6);
  EXPECT_NEAR(trip.interval_s, trip.round_trip_s / 2, 1e-12);
  EXPECT_NEAR(trip.persons_in_5_minutes, 300 * 10 / trip.interval_s, 1e-9);
}

TEST(RoundTripTimeTest, OptionsOfABuildingAreItsOwn) {
  const Building building = uniform_building({.floors = 11, .floor_height_m = 4, .lifts = 3});
  const RoundTripOptions options = round_trip_options(building, 10);
  EXPECT_EQ(options.floors_above, 10U);
  EXPECT_DOUBLE_EQ(options.floor_height_m, 4);
  EXPECT_EQ(options.lifts, 3U);
  EXPECT_EQ(options.flight.speed_m_s, building.lift(1).speed_m_s);
}

}  // namespace
}  // namespace canvoy::lift::round_trip_time_test
