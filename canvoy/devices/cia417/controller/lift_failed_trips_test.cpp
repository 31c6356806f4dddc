// Trips of a lift that end elsewhere than at their floor, or not at all.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_failed_trips_test {
namespace {

constexpr auto driving = LiftPhase::driving;
constexpr auto open = LiftPhase::open;

class LiftFailedTrips : public LiftBenchTest {};

TEST_F(LiftFailedTrips, ACarThatDoesNotArriveIsStopped) {
  bench.press("05 07 01 00 11 01");
  bench.run_for(5s);
  bench.car.is_stuck = true;
  bench.run_for(45s);
  EXPECT_EQ(lift.fault(), LiftFault::travel_time);
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 05 00 00 00 00");
  bench.car.is_stuck = false;
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftFailedTrips, OutsideOfAFloorItDoesNotOpen) {
  bench.press("05 03 01 00 11 01");
  bench.run_for(1s);
  // A drive that is wrong by 11 mm.
  bench.car.stop();
  bench.car.motion.position_micrometre = 6'011'000;
  bench.car.motion.arrived = true;
  bench.step();
  EXPECT_EQ(lift.fault(), LiftFault::position);
  EXPECT_EQ(bench.doors.open_steps[0], 0);
  ASSERT_TRUE(bench.run_to(3, open)) << "it tries again";
}

TEST_F(LiftFailedTrips, ACarThatStopsShortIsToldAtOnceAndGoesOnAfterAWhile) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 3; }));
  bench.car.stop();  // by a limit, and not where it should
  bench.step();
  bench.step();
  EXPECT_EQ(lift.fault(), LiftFault::position);
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 06 00 00 00 00");
  EXPECT_TRUE(bench.doors.are_closed());
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftFailedTrips, ACarThatStandsAtItsTargetHasArrivedWhateverItsDriveSays) {
  bench.press("05 07 01 00 11 01");
  bench.run_for(1s);
  bench.car.stop();
  bench.car.motion.position_micrometre = 18'009'000;
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == open; }, 5s));
  EXPECT_EQ(lift.fault(), LiftFault::none);
}

TEST_F(LiftFailedTrips, ADriveThatReportsItsTargetWithoutATripIsSentAgainAfterAWhile) {
  bench.press("05 07 01 00 11 01");
  for (int i = 0; i < 3; ++i) {
    bench.run_for(100ms);
    ASSERT_EQ(lift.phase(), driving) << i;
    bench.car.stop();
    bench.car.motion.position_micrometre = 0;
    bench.car.motion.arrived = true;
    bench.step();
    EXPECT_EQ(lift.fault(), LiftFault::position) << i;
    bench.run_for(4s);
    EXPECT_NE(lift.phase(), driving) << i;
    ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving; }, 20s)) << i;
  }
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftFailedTrips, ACarThatDoesNotLeaveItsFloorOpensThere) {
  bench.press("05 07 01 00 11 01");
  bench.run_for(100ms);
  bench.car.stop();
  bench.car.motion.position_micrometre = 0;
  bench.run_for(4s);
  EXPECT_EQ(lift.fault(), LiftFault::position);
  EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps) << "who is inside gets out";
  ASSERT_TRUE(bench.run_to(7, open));
}

}  // namespace
}  // namespace canvoy::cia417::lift_failed_trips_test
