// A car drive unit in profile velocity mode, and its ramps. Its defaults: 1.6 m/s,
// 1 m/s2, 1.2 m/s3, the brake takes 200 ms; ten increments are a millimetre.
#include <gtest/gtest.h>

#include <cmath>

#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"

namespace canvoy::cia417::car_drive_modes_test {
namespace {

class CarDriveModes : public testing::Test {
 protected:
  CarDriveModes() { bench.boot(device.node()); }

  std::uint16_t status() { return Values(device.node().dictionary())[statusword].raw(); }
  /// 184h, as a drive controller sends it.
  void control(std::uint16_t word, std::int32_t velocity) {
    Frame frame = Frame::data_frame(0x184, {});
    frame.length = 6;
    store(frame.data.data(), word);
    store(frame.data.data() + 2, velocity);
    bench.send(wire_text(frame));
  }
  void choose(DriveMode mode) {
    const std::string number = std::to_string(static_cast<int>(mode));
    EXPECT_EQ(bench.ask("2F 03 64 00 0" + number + " 00 00 00"), 0U);
  }
  void enable(std::int32_t velocity = 0) {
    control(0x0006, velocity);
    control(0x0007, velocity);
    control(0x000F, velocity);
    bench.sent.clear();
  }
  double position_mm() { return bench.sense().position / 10; }
  double velocity_mm() { return bench.sense().velocity / 10; }

  DriveBench bench;
  CarDriveDevice<> device{bench.port(), 2, bench.hardware()};
};

using DriveVelocity = CarDriveModes;

TEST_F(DriveVelocity, ShowsTheModeThatItIsIn) {
  EXPECT_EQ(bench.ask("40 04 64 00 00 00 00 00"), 1U);
  choose(DriveMode::profile_velocity);
  EXPECT_EQ(bench.ask("40 04 64 00 00 00 00 00"), 3U);
}

TEST_F(DriveVelocity, MovesUpwardByAPositiveAndDownwardByANegativeTarget) {
  choose(DriveMode::profile_velocity);
  enable();
  EXPECT_EQ(status() & 0x1000, 0x1000) << "speed 0";
  control(0x000F, 800);
  bench.run_for(4s);
  EXPECT_NEAR(velocity_mm(), 800, 0.01);
  EXPECT_EQ(status() & 0x1400, 0x0400) << "target reached, and not speed 0";
  control(0x000F, -800);
  bench.run_for(6s);
  EXPECT_NEAR(velocity_mm(), -800, 0.01);
  EXPECT_TRUE(bench.has_sent("185#37 06 E0 FC FF FF")) << "-800 mm/s";
}

TEST_F(DriveVelocity, ATargetOf0EndsTheTravelBehindTheBrake) {
  choose(DriveMode::profile_velocity);
  enable();
  control(0x000F, 800);
  bench.run_for(4s);
  control(0x000F, 100);
  bench.run_for(3s);
  EXPECT_NEAR(velocity_mm(), 100, 0.01);
  control(0x000F, 0);
  bench.run_for(3s);
  EXPECT_EQ(status() & 0x1400, 0x1400);
  EXPECT_FALSE(bench.brake_released);
  EXPECT_TRUE(bench.power) << "operation is enabled, still";
}

TEST_F(DriveVelocity, StartsWhenOperationIsEnabledWithATargetOtherThan0) {
  choose(DriveMode::profile_velocity);
  enable(500);
  EXPECT_TRUE(bench.brake_released);
  bench.run_for(4s);
  EXPECT_NEAR(velocity_mm(), 500, 0.01);
}

TEST_F(DriveVelocity, HaltsAndGoesOn) {
  choose(DriveMode::profile_velocity);
  enable(500);
  bench.run_for(4s);
  control(0x010F, 500);
  bench.run_for(3s);
  EXPECT_EQ(velocity_mm(), 0);
  EXPECT_EQ(status() & 0x0400, 0x0400);
  control(0x000F, 500);
  bench.run_for(3s);
  EXPECT_NEAR(velocity_mm(), 500, 0.01);
}

TEST_F(DriveVelocity, HaltsByTheRampOfItsOptionCode) {
  choose(DriveMode::profile_velocity);
  EXPECT_EQ(bench.ask("2B 02 64 04 03 00 00 00"), 0U) << "on the current limit: 2.5 m/s2";
  enable(1'000);
  bench.run_for(5s);
  const double from = position_mm();
  control(0x010F, 1'000);
  bench.run_for(3s);
  EXPECT_NEAR(position_mm() - from, 200, 0.1);
}

TEST_F(DriveVelocity, StopsWithinItsSoftwareLimitsAndTellsSo) {
  choose(DriveMode::profile_velocity);
  EXPECT_EQ(bench.ask("23 22 64 02 B8 0B 00 00"), 0U) << "3 m";
  enable(1'600);
  bench.run_for(10s);
  EXPECT_NEAR(position_mm(), 3'000, 0.01);
  EXPECT_EQ(status() & 0x0800, 0x0800);
  EXPECT_FALSE(bench.brake_released);
  control(0x000F, 1'500);
  bench.run_for(2s);
  EXPECT_NEAR(position_mm(), 3'000, 0.01) << "not further";
  control(0x000F, -1'500);
  bench.run_for(2s);
  EXPECT_LT(position_mm(), 2'500) << "but back";
  EXPECT_EQ(status() & 0x0800, 0);
}

TEST_F(DriveVelocity, TellsWhenItSlipsMoreThanAllowed) {
  choose(DriveMode::profile_velocity);
  enable(1'000);
  bench.run_for(4s);
  bench.detached = true;
  bench.readings.velocity = 8'100;
  bench.run_for(20ms);
  EXPECT_EQ(status() & 0x2000, 0) << "190 mm/s";
  bench.readings.velocity = 7'900;
  bench.run_for(20ms);
  EXPECT_EQ(status() & 0x2000, 0x2000) << "210 mm/s, where 200 are allowed";
}

TEST_F(DriveVelocity, ReachesItsTargetAfterTheTimeOfTheWindow) {
  EXPECT_EQ(bench.ask("23 35 64 02 2C 01 00 00"), 0U) << "300 ms";
  choose(DriveMode::profile_velocity);
  enable();
  control(0x000F, 1'000);
  // The ramp ends 1000/1000 + 1000/1200 s after the brake has opened.
  bench.run_for(200ms + 1834ms);
  EXPECT_EQ(status() & 0x0400, 0);
  bench.run_for(300ms);
  EXPECT_EQ(status() & 0x0400, 0x0400);
}

TEST_F(DriveVelocity, TakesAModeWhenTheCarStands) {
  choose(DriveMode::profile_velocity);
  enable(500);
  bench.run_for(3s);
  choose(DriveMode::profile_position);
  EXPECT_EQ(bench.ask("40 04 64 00 00 00 00 00"), 3U);
  control(0x000F, 0);
  bench.run_for(3s);
  EXPECT_EQ(bench.ask("40 04 64 00 00 00 00 00"), 1U);
}

// Profile types and jerks.

struct Ramp {
  const char* name;
  const char* type;
  double seconds;  ///< to 1 m/s
};
class DriveRamp : public CarDriveModes, public testing::WithParamInterface<Ramp> {};

TEST_P(DriveRamp, LastsAsLongAsItsProfileTypeAndJerkSay) {
  choose(DriveMode::profile_velocity);
  EXPECT_EQ(bench.ask(GetParam().type), 0U);
  enable(1'000);
  EXPECT_NEAR(bench.profile.duration(), GetParam().seconds, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(
    Types, DriveRamp,
    testing::Values(Ramp{"Linear", "2B 05 64 00 00 00 00 00", 1.0},
                    Ramp{"SineSquared", "2B 05 64 00 01 00 00 00",
                         2.0278893},  // pi x sqrt(1/2.4), by the jerk
                    Ramp{"JerkFree", "2B 05 64 00 02 00 00 00", 2.1934566},  // sqrt(5.7735/1.2)
                    Ramp{"JerkLimited", "2B 05 64 00 03 00 00 00", 1 + 1 / 1.2},
                    Ramp{"WithoutJerk", "2F 0C 64 00 00 00 00 00", 1.0}),
    [](const auto& test) { return test.param.name; });

TEST_F(CarDriveModes, UsesAJerkForEachBendWhereSixAreUsed) {
  choose(DriveMode::profile_velocity);
  EXPECT_EQ(bench.ask("2F 0C 64 00 06 00 00 00"), 0U);
  const char* jerks[] = {"23 0D 64 01 E8 03 00 00", "23 0D 64 02 D0 07 00 00",   // A 1, C 2
                         "23 0D 64 03 A0 0F 00 00", "23 0D 64 04 F4 01 00 00",   // B 4, D 0.5
                         "23 0D 64 05 40 1F 00 00", "23 0D 64 06 40 1F 00 00"};  // E, F 8 m/s3
  for (const char* jerk : jerks) EXPECT_EQ(bench.ask(jerk), 0U);
  EXPECT_EQ(bench.ask("23 24 64 00 64 00 00 00"), 0U) << "end velocity 100 mm/s";
  enable(1'600);
  // 1 s for A, 0.25 s for B, and what is left of 1.6 m/s at 1 m/s2.
  EXPECT_NEAR(bench.profile.duration(), 1 + 0.25 + (1.6 - 0.5 - 0.125), 1e-6);
  bench.run_for(5s);
  control(0x000F, 100);
  // 1 m/s2 is not reached: C and D make 1.5 m/s with sqrt(2 x 1.5 / (1/2 + 1/0.5)) m/s2 at most.
  EXPECT_NEAR(bench.profile.duration(), 0.5 + 2 + (1.5 - 1.25), 1e-6);
  bench.run_for(5s);
  control(0x000F, 0);
  EXPECT_NEAR(bench.profile.duration(), 2 * std::sqrt(0.1 / 8), 1e-6) << "E and F";
}

// Lifts 2 to 8.

constexpr auto lift_3_layout = layout_of<CarDriveKind<3>>;

TEST(CarDriveOfLift3, HasItsObjectsTwoBlocksAboveAndItsPdosTwentyHexAbove) {
  DriveBench bench;
  CarDriveDevice<lift_3_layout> device(bench.port(), 2, bench.hardware(), {.lift = 3});
  bench.boot(device.node());
  bench.send("1A0#06 00 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("1A1#31 02 00 00 00 00"));
  EXPECT_EQ(bench.ask("40 01 74 00 00 00 00 00"), 0x0231U);
  EXPECT_EQ(bench.ask("23 23 74 00 00 00 00 00"), 0x0609'0032U);
  EXPECT_EQ(bench.ask("40 01 64 00 00 00 00 00"), 0x0602'0000U);
}

// As it leaves for its building.

TEST(CarDriveTuning, IsThereAfterPowerOnAndAfterAReset) {
  DriveBench bench;
  CarDriveDevice<> device(
      bench.port(), 2, bench.hardware(),
      {.tuning = {.velocity = 2500, .acceleration = 2400, .jerk = 3000}, .stops_for = {4}});
  bench.boot(device.node());
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(bench.ask("40 08 64 01 00 00 00 00"), 2500U);
    EXPECT_EQ(bench.ask("40 23 64 00 00 00 00 00"), 2500U);
    EXPECT_EQ(bench.ask("40 0B 64 01 00 00 00 00"), 2400U);
    EXPECT_EQ(bench.ask("40 09 64 01 00 00 00 00"), 2400U) << "no lower than that";
    EXPECT_EQ(bench.ask("40 0D 64 01 00 00 00 00"), 3000U);
    bench.send("000#81 02");
  }
  bench.send("000#01 02");
  bench.run_for(200ms);
  bench.send("184#06 00 00 00 00 00");
  bench.send("184#0F 00 00 00 00 00");
  EXPECT_EQ(device.unit().state(), DriveState::operation_enabled);
  bench.send("084#05 FF 01 00 00 00 00 00");
  EXPECT_EQ(device.unit().state(), DriveState::switch_on_disabled) << "for node 4";
  EXPECT_TRUE(device.unit().is_held());
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_modes_test
