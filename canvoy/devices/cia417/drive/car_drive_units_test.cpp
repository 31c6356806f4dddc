// Conversion of the numbers in the objects of a car drive unit: the factor group with its
// dimensions (CiA 417-4, 4.11.3), and the reported velocity (4.11.6). Ten increments are a
// millimetre by default.
#include <cmath>
#include <string>

#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_units_test {
namespace {

/// In profile velocity mode, by 184h.
class DriveUnitsTest : public CarDriveTest {
 protected:
  DriveUnitsTest() { EXPECT_EQ(bench.ask("2F 03 64 00 03 00 00 00"), 0U); }

  void run_at(std::int32_t velocity, std::uint16_t word = 0x000F) {
    Frame frame = Frame::data_frame(0x184, {});
    frame.length = 6;
    store(frame.data.data(), word);
    store(frame.data.data() + 2, velocity);
    bench.send(wire_text(frame));
  }
  void enable() {
    run_at(0, 0x0006);
    run_at(0, 0x0007);
    run_at(0, 0x000F);
  }
  void disable() {
    run_at(0, 0x0000);
    bench.run_for(200ms);
  }
  std::int32_t velocity(const char* index) {
    return static_cast<std::int32_t>(bench.ask("40 " + std::string(index) + " 64 00 00 00 00 00"));
  }
};

// Units.

/// A unit in increments, as a multiple of its default.
struct Factor {
  const char* name;
  const char* request;
  double position;
  double velocity;
  double acceleration;
  double jerk;
  double sensor;  ///< of 6431h for the same increments a second
};
class DriveFactor : public DriveUnitsTest, public testing::WithParamInterface<Factor> {};

TEST_P(DriveFactor, SaysWhatAUnitIsInIncrements) {
  const Factor& factor = GetParam();
  ASSERT_EQ(bench.ask(factor.request), 0U);

  // 50 mm/s with 1200 mm/s3, which does not take the 1000 mm/s2: 2 x sqrt(v / j) s.
  enable();
  run_at(50);
  const double reached = bench.profile.end().velocity;
  EXPECT_NEAR(reached, 500 * factor.velocity, 1e-6);
  const double seconds = bench.profile.duration();
  EXPECT_NEAR(4 * std::abs(reached) / (seconds * seconds), 12'000 * factor.jerk, 1e-3);
  disable();

  EXPECT_EQ(bench.ask("2F 0C 64 00 00 00 00 00"), 0U) << "without jerk: v / a s";
  enable();
  run_at(50);
  EXPECT_NEAR(std::abs(reached) / bench.profile.duration(), 10'000 * factor.acceleration, 1e-3);
  disable();

  EXPECT_EQ(bench.ask("2F 03 64 00 01 00 00 00"), 0U);
  CarDriveTest::enable();
  control(0x001F, 300);
  EXPECT_NEAR(bench.profile.end().position, 3'000 * factor.position, 1e-6);
  control(0x0000);

  bench.readings.sensor_velocity = 600;
  bench.run_for(200ms);
  EXPECT_EQ(velocity("31"), std::lround(600 * factor.sensor));
}
INSTANTIATE_TEST_SUITE_P(
    Of4113, DriveFactor,
    testing::Values(Factor{"PositionInCentimetres", "2F 10 64 01 FE 00 00 00", 1, 0.1, 0.1, 0.1, 1},
                    Factor{"VelocityInCentimetres", "2F 11 64 01 FE 00 00 00", 1, 10, 1, 1, 1},
                    Factor{"AccelerationInCentimetres", "2F 12 64 01 FE 00 00 00", 1, 1, 10, 1, 1},
                    Factor{"JerkInCentimetres", "2F 13 64 01 FE 00 00 00", 1, 1, 1, 10, 1},
                    Factor{"EncoderIncrements", "23 14 64 01 20 4E 00 00", 2, 2, 2, 2, 0.5},
                    Factor{"MotorRevolutions", "23 14 64 02 02 00 00 00", 0.5, 0.5, 0.5, 0.5, 2},
                    Factor{"VelocityEncoderIncrements", "23 15 64 01 20 4E 00 00", 1, 1, 1, 1, 2},
                    Factor{"VelocityMotorRevolutions", "23 15 64 02 02 00 00 00", 1, 1, 1, 1, 0.5},
                    Factor{"GearMotorRevolutions", "23 16 64 01 03 00 00 00", 3, 3, 3, 3, 1},
                    Factor{"GearShaftRevolutions", "23 16 64 02 02 00 00 00", 0.5, 0.5, 0.5, 0.5,
                           1},
                    Factor{"Feed", "23 17 64 01 F4 01 00 00", 2, 2, 2, 2, 1},
                    Factor{"FeedShaftRevolutions", "23 17 64 02 03 00 00 00", 3, 3, 3, 3, 1},
                    Factor{"PositionNumerator", "23 18 64 01 03 00 00 00", 3, 3, 3, 3, 1},
                    Factor{"PositionDivisor", "23 18 64 02 02 00 00 00", 0.5, 0.5, 0.5, 0.5, 1},
                    Factor{"VelocityEncoderNumerator", "23 19 64 01 03 00 00 00", 1, 1, 1, 1, 3},
                    Factor{"VelocityEncoderDivisor", "23 19 64 02 02 00 00 00", 1, 1, 1, 1, 0.5},
                    Factor{"Velocity1Numerator", "23 1A 64 01 03 00 00 00", 1, 3, 1, 1, 1},
                    Factor{"Velocity1Divisor", "23 1A 64 02 02 00 00 00", 1, 0.5, 1, 1, 1},
                    Factor{"Velocity2Numerator", "23 1B 64 01 03 00 00 00", 1, 3, 1, 1, 1},
                    Factor{"Velocity2Divisor", "23 1B 64 02 02 00 00 00", 1, 0.5, 1, 1, 1},
                    Factor{"AccelerationNumerator", "23 1C 64 01 03 00 00 00", 1, 1, 3, 1, 1},
                    Factor{"AccelerationDivisor", "23 1C 64 02 02 00 00 00", 1, 1, 0.5, 1, 1},
                    Factor{"JerkNumerator", "23 1D 64 01 03 00 00 00", 1, 1, 1, 3, 1},
                    Factor{"JerkDivisor", "23 1D 64 02 02 00 00 00", 1, 1, 1, 0.5, 1},
                    Factor{"PositionReversed", "2F 1E 64 00 80 00 00 00", -1, 1, 1, 1, 1},
                    Factor{"VelocityReversed", "2F 1E 64 00 40 00 00 00", 1, -1, 1, 1, 1}),
    [](const auto& test) { return test.param.name; });

TEST_F(DriveUnitsTest, DimensionIndicesAreKept) {
  for (const char* object : {"10", "11", "12", "13"}) {
    const std::string entry = std::string(object) + " 64 02 ";
    EXPECT_EQ(bench.ask("2F " + entry + "A5 00 00 00"), 0U);
    EXPECT_EQ(bench.ask("40 " + entry + "00 00 00 00") & 0xFF, 0xA5U);
  }
}

TEST_F(DriveUnitsTest, NotationsAndFactorsOutOfTheirRangeAreRefused) {
  for (unsigned object = 0x10; object <= 0x13; ++object) {
    for (unsigned power = 0; power <= 0xFF; ++power) {
      char request[40];
      std::snprintf(request, sizeof request, "2F %02X 64 01 %02X 00 00 00", object, power);
      const bool is_known = power <= 9 || power >= 0xF7;
      EXPECT_EQ(bench.ask(request), is_known ? 0U : 0x0609'0030U) << request;
    }
  }
  for (unsigned object = 0x14; object <= 0x1D; ++object) {
    for (unsigned sub = 1; sub <= 2; ++sub) {
      char request[40];
      std::snprintf(request, sizeof request, "23 %02X 64 %02X 00 00 00 00", object, sub);
      EXPECT_EQ(bench.ask(request), 0x0609'0032U) << request;
    }
  }
}

// Velocities.

TEST_F(DriveUnitsTest, TellsItsVelocityAsDemandedMeasuredAndSensed) {
  enable();
  run_at(-800);
  bench.run_for(4s);
  EXPECT_EQ(velocity("32"), -800) << "demand, mm/s";
  EXPECT_EQ(velocity("33"), -800) << "actual";
  EXPECT_EQ(velocity("31"), -8'000) << "of the sensor, increments per second";
  EXPECT_EQ(velocity("06"), -800) << "control effort";
  bench.detached = true;
  bench.readings.velocity = -7'900;
  bench.run_for(20ms);
  EXPECT_EQ(velocity("32"), -800);
  EXPECT_EQ(velocity("33"), -790);
}

TEST_F(DriveUnitsTest, TheSensorIsSelectedThatTheActualVelocityComesFrom) {
  bench.readings.velocity = 40;
  bench.readings.sensor_velocity = 80;
  bench.run_for(200ms);
  EXPECT_EQ(velocity("33"), 4) << "of the position encoder";
  EXPECT_EQ(bench.ask("2B 34 64 00 01 00 00 00"), 0U);
  bench.run_for(200ms);
  EXPECT_EQ(velocity("33"), 8) << "of the velocity encoder";
}

// What the hardware reports.

TEST_F(DriveUnitsTest, ItsStatuswordShowsVoltageWarningAndRemote) {
  EXPECT_EQ(status() & 0x0290, 0x0210) << "voltage enabled, no warning, remote";
  bench.readings.warning = true;
  bench.run_for(200ms);
  EXPECT_EQ(status() & 0x0290, 0x0290);
  bench.readings.voltage = false;
  bench.run_for(200ms);
  EXPECT_EQ(status() & 0x0290, 0x0280);
  bench.send("000#80 02");
  EXPECT_EQ(status() & 0x0290, 0x0080) << "not operational: local";
}

TEST_F(DriveUnitsTest, TellsTheFaultsOfVoltagesThatItsHardwareHas) {
  for (const char* code : {"11 31", "21 31", "11 32", "21 32"}) {
    bench.sent.clear();
    bench.readings.fault = static_cast<std::uint16_t>(std::stoul(code, nullptr, 16) |
                                                      std::stoul(code + 3, nullptr, 16) << 8);
    bench.run_for(200ms);
    EXPECT_EQ(state(), DriveState::fault);
    EXPECT_TRUE(bench.has_sent("082#" + std::string(code) + " 01 00 00 00 00 00")) << code;
    bench.readings.fault = 0;
    bench.run_for(200ms);
    run_at(0, 0x0000);
    run_at(0, 0x0080);
    EXPECT_EQ(state(), DriveState::switch_on_disabled);
  }
}

// Windows and thresholds.

TEST_F(DriveUnitsTest, ATargetIsReachedWithinTheVelocityWindow) {
  EXPECT_EQ(bench.ask("2F 0C 64 00 00 00 00 00"), 0U) << "1 m/s2 without jerk";
  EXPECT_EQ(bench.ask("23 35 64 01 2C 01 00 00"), 0U) << "300 mm/s";
  enable();
  run_at(1'000);
  bench.run_for(200ms + 700ms);
  EXPECT_EQ(status() & 0x0400, 0) << "within it, and not for 50 ms";
  bench.run_for(100ms);
  EXPECT_EQ(status() & 0x0400, 0x0400) << "at 800 mm/s";
}

TEST_F(DriveUnitsTest, BelowTheVelocityThresholdItIsSpeed0) {
  for (const bool is_below : {false, true}) {
    EXPECT_EQ(bench.ask(is_below ? "23 36 64 01 97 00 00 00" : "23 36 64 01 95 00 00 00"), 0U);
    enable();
    run_at(150);
    bench.run_for(3s);
    EXPECT_EQ(status() & 0x1000, is_below ? 0x1000 : 0) << "151 or 149 mm/s";
    run_at(0);
    bench.run_for(3s);
    disable();
  }
}

TEST_F(DriveUnitsTest, ItIsSpeed0AfterTheTimeOfTheThreshold) {
  EXPECT_EQ(bench.ask("2F 0C 64 00 00 00 00 00"), 0U) << "1 m/s2 without jerk";
  EXPECT_EQ(bench.ask("23 36 64 02 E8 03 00 00"), 0U) << "1000 ms";
  bench.run_for(2s);
  enable();
  run_at(800);
  bench.run_for(4s);
  run_at(0);
  bench.run_for(790ms + 980ms);
  EXPECT_EQ(bench.sense().velocity, 0);
  EXPECT_EQ(status() & 0x1000, 0);
  bench.run_for(60ms);
  EXPECT_EQ(status() & 0x1000, 0x1000);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_units_test
