#include "canvoy/devices/cia417/drive/driven_car.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::driven_car_test {
namespace {

/// Hardware that does nothing by itself.
class DrivenCarTest : public testing::Test {
 protected:
  CarDriveHardware hardware() {
    return {.sense = callback<&DrivenCarTest::read>(*this),
            .power = callback<&DrivenCarTest::set_power>(*this),
            .release_brake = callback<&DrivenCarTest::set_brake>(*this),
            .follow = callback<&DrivenCarTest::set_delay>(*this)};
  }
  void sense_at(Time at) {
    now = at;
    car.sense(now, {.velocity_threshold = 10, .velocity_threshold_time = 50ms}, 5);
  }
  /// At rest for long, with power.
  void stand() {
    sense_at(now);
    sense_at(now + 50ms);
    car.switch_power(true);
  }

  DriveReadings readings;
  bool has_power = false;
  bool is_released = false;
  Duration delay{};
  int led = 0;
  Time now{1s};
  DrivenCar car{hardware(), 200ms, callback<&DrivenCarTest::note>(*this)};

 private:
  DriveReadings read() { return readings; }
  void set_power(bool on) { has_power = on; }
  void set_brake(bool released) { is_released = released; }
  void set_delay(const MotionProfile&, Duration wanted) { delay = wanted; }
  void note() { ++led; }
};

const MotionLimits gentle{.velocity = 1000, .acceleration = 500, .deceleration = 500};

TEST_F(DrivenCarTest, StandsOnceItHasBeenSlowForItsTime) {
  sense_at(now);
  sense_at(now + 49ms);
  EXPECT_FALSE(car.is_standing());
  sense_at(now + 1ms);
  EXPECT_TRUE(car.is_standing());
  readings.velocity = -11;
  sense_at(now + 20ms);
  EXPECT_FALSE(car.is_standing());
}

TEST_F(DrivenCarTest, AProfileBeginsWhenTheBrakeIsOpen) {
  stand();
  car.follow(MotionProfile::to_position(car.present(now), 1000, gentle), now);
  EXPECT_TRUE(is_released);
  EXPECT_EQ(delay, 200ms);
  EXPECT_EQ(led, 1);
  EXPECT_FALSE(car.is_standing());
  EXPECT_EQ(car.demand(now + 200ms).position, 0);
  EXPECT_GT(car.demand(now + 300ms).position, 0);
  car.follow(MotionProfile::to_position(car.present(now), 2000, gentle), now);
  EXPECT_EQ(delay, 200ms) << "the brake has been told to open at the same time";
}

TEST_F(DrivenCarTest, AProfileThatDoesNotMoveTheCarLeavesTheBrakeClosed) {
  stand();
  car.hold(now);
  EXPECT_FALSE(is_released);
  EXPECT_TRUE(car.is_standing());
}

TEST_F(DrivenCarTest, StraysFromWhereItCameToStandBehindItsBrake) {
  readings.position = 1000;
  stand();
  for (int i = 0; i < 11; ++i) {
    readings.position += 5;
    sense_at(now + 100ms);
    EXPECT_EQ(car.has_strayed(50), i == 10) << "at " << readings.position;
  }
}

TEST_F(DrivenCarTest, AnEncoderThatComesBackElsewhereIsNoMovement) {
  stand();
  readings.position = 12'000;
  sense_at(now + 20ms);
  EXPECT_FALSE(car.has_strayed(50));
  readings.velocity = 600;
  readings.position += 60;
  sense_at(now + 100ms);
  EXPECT_TRUE(car.has_strayed(50)) << "that is";
}

TEST_F(DrivenCarTest, LagsBehindItsProfileWhileTheBrakeIsOpenOnly) {
  stand();
  car.follow(MotionProfile::to_position(car.present(now), 1000, gentle), now);
  const Time end = now + 200ms + 10s;
  EXPECT_DOUBLE_EQ(car.lag(end), 1000);
  car.close_brake();
  EXPECT_DOUBLE_EQ(car.lag(end), 0);
}

}  // namespace
}  // namespace canvoy::cia417::driven_car_test
