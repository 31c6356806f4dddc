// Refused values and end positions of a car drive unit: limits, ranges and units of its objects.
#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_limits_test {
namespace {

using CarDrive = CarDriveTest;

TEST_F(CarDrive, RefusesATargetBeyondItsSoftwareLimits) {
  EXPECT_EQ(bench.ask("23 22 64 02 10 27 00 00"), 0U) << "at most 10 m";
  EXPECT_EQ(bench.ask("23 22 64 01 00 00 00 00"), 0U);
  EXPECT_EQ(bench.ask("23 20 64 00 10 27 00 00"), 0U);
  EXPECT_EQ(bench.ask("23 20 64 00 11 27 00 00"), 0x0609'0031U);
  EXPECT_EQ(bench.ask("23 20 64 00 FF FF FF FF"), 0x0609'0032U);
  EXPECT_EQ(bench.ask("23 22 64 01 11 27 00 00"), 0x0609'0036U) << "minimum above maximum";
}

TEST_F(CarDrive, ClampsARelativeTargetToItsSoftwareLimitsAndTellsSo) {
  EXPECT_EQ(bench.ask("23 22 64 02 10 27 00 00"), 0U);
  enable();
  control(0x004F, 20'000);
  control(0x005F, 20'000);
  EXPECT_EQ(status() & 0x1800, 0x1800);
  bench.run_for(15s);
  EXPECT_NEAR(position_mm(), 10'000, 0.01);
}

TEST_F(CarDrive, StopsFastWhereAControlPdoIsRefused) {
  EXPECT_EQ(bench.ask("23 22 64 02 E0 2E 00 00"), 0U) << "at most 12 m";
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  control(0x001F, 12'001);
  EXPECT_EQ(state(), DriveState::quick_stop_active);
}

struct Refusal {
  const char* request;
  std::uint32_t abort;
};
class CarDriveRefusal : public CarDrive, public testing::WithParamInterface<Refusal> {};

TEST_P(CarDriveRefusal, AnswersAValueOutOfItsLimitsWithTheRightAbortCode) {
  EXPECT_EQ(bench.ask(GetParam().request), GetParam().abort);
}
INSTANTIATE_TEST_SUITE_P(
    Values, CarDriveRefusal,
    testing::Values(Refusal{"2F 03 64 00 02 00 00 00", 0x0609'0030},  // velocity mode
                    Refusal{"2F 03 64 00 08 00 00 00", 0x0609'0030},  // cyclic
                    Refusal{"2F 03 64 00 06 00 00 00", 0},
                    Refusal{"2B 02 64 01 02 00 00 00", 0x0609'0030},  // shutdown option
                    Refusal{"2B 02 64 03 09 00 00 00", 0x0609'0030},  // quick stop option
                    Refusal{"2B 02 64 05 FF FF 00 00", 0x0609'0030},  // a manufacturer's
                    Refusal{"2B 05 64 00 04 00 00 00", 0x0609'0030},  // profile type
                    Refusal{"23 23 64 00 41 06 00 00", 0x0609'0031},  // above 1600 mm/s
                    Refusal{"23 23 64 00 00 00 00 00", 0x0609'0032},
                    Refusal{"23 24 64 00 41 06 00 00", 0x0609'0031},
                    Refusal{"23 30 64 00 41 06 00 00", 0x0609'0031},
                    Refusal{"23 30 64 00 BF F9 FF FF", 0x0609'0032},  // -1601 mm/s
                    Refusal{"23 0A 64 00 D1 07 00 00", 0x0609'0031},  // above 2000 mm/s2
                    Refusal{"23 0B 64 01 D1 07 00 00", 0x0609'0031},
                    Refusal{"23 0B 64 02 00 00 00 00", 0x0609'0032},
                    Refusal{"2F 0C 64 00 03 00 00 00", 0x0609'0030},
                    Refusal{"2F 0C 64 00 07 00 00 00", 0x0609'0031},
                    Refusal{"23 0D 64 01 00 00 00 00", 0},            // no jerk: no limit of it
                    Refusal{"23 16 64 02 00 00 00 00", 0x0609'0032},  // divided by 0
                    Refusal{"2F 10 64 01 0A 00 00 00", 0x0609'0030},  // 10^10 m
                    Refusal{"2F 1E 64 00 01 00 00 00", 0x0609'0030},  // reserved bits
                    Refusal{"2B 34 64 00 02 00 00 00", 0x0609'0030},
                    Refusal{"23 37 64 00 FF FF FF FF", 0x0609'0032},
                    Refusal{"2B 01 64 00 00 00 00 00", 0x0601'0002},   // the statusword
                    Refusal{"23 08 64 02 10 00 00 00", 0x0601'0002},   // max motor speed, B6
                    Refusal{"23 03 64 00 01 00 00 00", 0x0607'0012}),  // too long
    [](const auto& test) { return "Request" + std::to_string(test.index); });

TEST_F(CarDrive, MayNotBeConfiguredWhileOperationIsEnabled) {
  enable();
  for (const char* request :
       {"23 23 64 00 E8 03 00 00", "2B 02 64 03 01 00 00 00", "23 0B 64 01 E8 03 00 00",
        "2F 0C 64 00 02 00 00 00", "2F 1E 64 00 80 00 00 00", "23 22 64 02 E8 03 00 00"}) {
    EXPECT_EQ(bench.ask(request), 0x0800'0022U) << request;
  }
  EXPECT_EQ(bench.ask("23 20 64 00 E8 03 00 00"), 0U) << "a target is no configuration";
  control(0x0000);
  EXPECT_EQ(bench.ask("23 23 64 00 E8 03 00 00"), 0U);
}

TEST_F(CarDrive, CountsInTheUnitsOfItsFactorGroup) {
  EXPECT_EQ(bench.ask("2F 10 64 01 FE 00 00 00"), 0U) << "centimetres";
  EXPECT_EQ(bench.ask("2F 1E 64 00 80 00 00 00"), 0U) << "positions reversed";
  EXPECT_EQ(bench.ask("23 16 64 01 02 00 00 00"), 0U) << "two turns of the motor for one";
  enable();
  control(0x001F, 300);
  bench.run_for(15s);
  // 10000 increments a turn, two turns for 1000 cm.
  EXPECT_NEAR(bench.sense().position, -300 * 20, 0.01);
}

// The range of positions (6421h) wraps.

using DriveRange = CarDriveTest;

TEST_F(DriveRange, ATargetOutOfTheRangeIsTheOneInItThatFollowsBehindTheOtherEnd) {
  EXPECT_EQ(bench.ask("23 21 64 01 00 00 00 00"), 0U);
  EXPECT_EQ(bench.ask("23 21 64 02 0F 27 00 00"), 0U) << "0 to 9999 mm";
  enable();
  struct {
    std::int32_t target;
    double position_mm;
  } const travels[] = {{9'999, 9'999}, {10'000, 0}, {12'000, 2'000}, {-1, 9'999}, {-25'000, 5'000}};
  for (const auto& travel : travels) {
    control(0x001F, travel.target);
    EXPECT_EQ(status() & 0x1800, 0x1000) << "acknowledged, and not limited";
    bench.run_for(15s);
    EXPECT_NEAR(position_mm(), travel.position_mm, 0.01);
    control(0x000F, travel.target);
  }
}

TEST_F(DriveRange, ARelativeTargetIsAWayAndPositionsCountOnBehindTheOtherEnd) {
  bench.ask("23 21 64 01 00 00 00 00");
  bench.ask("23 21 64 02 0F 27 00 00");
  enable();
  control(0x001F, 9'000);
  bench.run_for(15s);
  control(0x004F, 2'000);
  control(0x005F, 2'000);
  bench.run_for(15s);
  EXPECT_NEAR(position_mm(), 11'000, 0.01) << "which is position 1000 now";
  control(0x000F, 2'000);
  control(0x001F, 500);
  bench.run_for(15s);
  EXPECT_NEAR(position_mm(), 10'500, 0.01);
  control(0x000F, 500);
  control(0x001F, -1);
  bench.run_for(15s);
  EXPECT_NEAR(position_mm(), 19'999, 0.01);
}

TEST_F(DriveRange, SoftwareLimitsKeepATargetFromBeingWrapped) {
  bench.ask("23 21 64 01 00 00 00 00");
  bench.ask("23 21 64 02 0F 27 00 00");
  EXPECT_EQ(bench.ask("23 22 64 02 28 23 00 00"), 0U) << "9000 mm";
  EXPECT_EQ(bench.ask("23 20 64 00 10 27 00 00"), 0x0609'0031U) << "10000 mm";
}

TEST_F(DriveRange, TheLowerEndIsNotAboveTheUpperOne) {
  EXPECT_EQ(bench.ask("23 21 64 01 64 00 00 00"), 0U);
  EXPECT_EQ(bench.ask("23 21 64 02 63 00 00 00"), 0x0609'0036U);
}

// The speed of the motor (6408h:02h).

constexpr auto slow_motor =
    detail::with_initial(CarDriveKind<>::description, 1, max_velocity_object, 2, 30);
constexpr auto slow_motor_layout = lay_out_device<slow_motor>();

TEST(DriveMotorSpeed, LimitsTheVelocityInTurnsAMinute) {
  DriveBench bench;
  CarDriveDevice<slow_motor_layout> device(bench.port(), 2, bench.hardware());
  bench.boot(device.node());
  EXPECT_EQ(bench.ask("40 08 64 02 00 00 00 00"), 30U);
  EXPECT_EQ(bench.ask("2F 03 64 00 03 00 00 00"), 0U);
  for (const char* word : {"184#06 00 00 00 00 00", "184#0F 00 00 00 00 00"}) bench.send(word);
  bench.send("184#0F 00 E8 03 00 00");
  bench.run_for(5s);
  // 10000 increments a turn: 30 turns a minute are 5000 a second.
  EXPECT_NEAR(bench.sense().velocity, 5'000, 0.01);
  EXPECT_EQ(Values(device.node().dictionary())[statusword].raw() & 0x0800, 0x0800) << "limited";
}

// The velocity controller (6438h).

struct ControlLoop {
  std::uint16_t gain = 0xFFFF;
  std::uint16_t integration_time = 0xFFFF;
  void set(std::uint16_t new_gain, std::uint16_t new_time) {
    gain = new_gain;
    integration_time = new_time;
  }
};

TEST(DriveControlLoop, GetsItsGainAndItsIntegrationTime) {
  DriveBench bench;
  ControlLoop loop;
  CarDriveHardware hardware = bench.hardware();
  hardware.control = callback<&ControlLoop::set>(loop);
  CarDriveDevice<> device(bench.port(), 2, hardware);
  bench.boot(device.node());
  EXPECT_EQ(loop.gain, 0);
  EXPECT_EQ(bench.ask("2B 38 64 01 2C 01 00 00"), 0U);
  EXPECT_EQ(bench.ask("2B 38 64 02 0A 00 00 00"), 0U);
  EXPECT_EQ(loop.gain, 300);
  EXPECT_EQ(loop.integration_time, 10);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_limits_test
