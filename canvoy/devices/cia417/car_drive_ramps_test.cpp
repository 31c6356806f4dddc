// Which object of a car drive unit makes which ramp (CiA 417-4, 4.11.1 and 4.11.4): velocities,
// accelerations, jerks and option codes, in the units of their objects. Without others it is 1.6
// m/s, 1 m/s2 and 1.2 m/s3.
#include <algorithm>

#include "canvoy/devices/cia417/car_drive_unit_test.hpp"

namespace canvoy::cia417 {
namespace {

// In profile velocity mode.

class DriveVelocityTest : public CarDriveTest {
 protected:
  /// 184h; target velocities are in mm/s.
  void accelerate(const std::string& velocity) {
    for (const char* word : {"06", "07", "0F"}) {
      bench.send("184#" + std::string(word) + " 00 00 00 00 00");
    }
    bench.send("184#0F 00 " + velocity);
  }
  void slow_down() { bench.send("184#0F 00 00 00 00 00"); }
};

/// How long the ramp from 0 to 1 m/s takes, and back, without jerk.
struct Acceleration {
  const char* name;
  const char* request;
  double seconds_up;
  double seconds_down;
};
class DriveAcceleration : public DriveVelocityTest,
                          public testing::WithParamInterface<Acceleration> {};

TEST_P(DriveAcceleration, IsThatOfItsObject) {
  for (const char* request : {"2F 03 64 00 03 00 00 00", "2F 0C 64 00 00 00 00 00"}) {
    EXPECT_EQ(bench.ask(request), 0U);
  }
  ASSERT_EQ(bench.ask(GetParam().request), 0U);
  accelerate("E8 03 00 00");
  EXPECT_NEAR(bench.profile.duration(), GetParam().seconds_up, 1e-6);
  bench.run_for(4s);
  slow_down();
  EXPECT_NEAR(bench.profile.duration(), GetParam().seconds_down, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(
    Of411, DriveAcceleration,
    testing::Values(Acceleration{"Default", "23 0B 64 01 E8 03 00 00", 1, 1},
                    Acceleration{"ProfileAcceleration", "23 0B 64 01 F4 01 00 00", 2, 1},
                    Acceleration{"ProfileDeceleration", "23 0B 64 02 F4 01 00 00", 1, 2},
                    Acceleration{"MaxAcceleration", "23 09 64 01 F4 01 00 00", 2, 1},
                    Acceleration{"MaxDeceleration", "23 09 64 02 F4 01 00 00", 1, 2}),
    [](const auto& test) { return test.param.name; });

/// 640Ch, with jerks of 1, 2, 4 and 0.5 m/s3 in sub-indices 1 to 4: from 0 to 1.6 m/s and back. A
/// ramp with bends of j and k takes a/j + a/k + (v - a2/2j - a2/2k) / a.
struct JerkUse {
  const char* used;
  double seconds_up;
  double seconds_down;
};
class DriveJerkUse : public DriveVelocityTest, public testing::WithParamInterface<JerkUse> {};

TEST_P(DriveJerkUse, AssignsSubIndicesToBendsAsItsTableSays) {
  for (const char* request :
       {"2F 03 64 00 03 00 00 00", "23 0D 64 01 E8 03 00 00", "23 0D 64 02 D0 07 00 00",
        "23 0D 64 03 A0 0F 00 00", "23 0D 64 04 F4 01 00 00"}) {
    EXPECT_EQ(bench.ask(request), 0U) << request;
  }
  EXPECT_EQ(bench.ask("2F 0C 64 00 " + std::string(GetParam().used) + " 00 00 00"), 0U);
  accelerate("40 06 00 00");
  EXPECT_NEAR(bench.profile.duration(), GetParam().seconds_up, 1e-6);
  bench.run_for(5s);
  slow_down();
  EXPECT_NEAR(bench.profile.duration(), GetParam().seconds_down, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(
    Tables1To3, DriveJerkUse,
    testing::Values(JerkUse{"00", 1.6, 1.6}, JerkUse{"01", 1 + 1 + 0.6, 1 + 1 + 0.6},  // A to D: 1
                    JerkUse{"02", 1 + 1 + 0.6, 0.5 + 0.5 + 1.1},       // A, B: 1; C, D: 2
                    JerkUse{"04", 1 + 0.25 + 0.975, 0.5 + 2 + 0.35}),  // A 1, B 3; C 2, D 4
    [](const auto& test) { return std::string("Use") + test.param.used; });

// In profile position mode.

using DriveRamps = CarDriveTest;

TEST_F(DriveRamps, TravelsAtItsProfileVelocity) {
  EXPECT_EQ(bench.ask("23 23 64 00 F4 01 00 00"), 0U) << "500 mm/s";
  enable();
  control(0x001F, 3'000);
  bench.run_for(10s);
  EXPECT_NEAR(bench.speed_max, 5'000, 0.01);
  EXPECT_NEAR(position_mm(), 3'000, 0.01);
}

TEST_F(DriveRamps, PassesATargetWithItsEndVelocityWhereAnotherOneWaits) {
  EXPECT_EQ(bench.ask("23 24 64 00 90 01 00 00"), 0U) << "400 mm/s";
  enable();
  control(0x001F, 4'000);
  control(0x000F, 4'000);
  bench.run_for(1s);
  control(0x001F, 8'000);
  double slowest = 1e9;
  while (position_mm() < 4'000) {
    bench.run_for(1ms);
    if (position_mm() > 3'000) slowest = std::min(slowest, bench.sense().velocity);
  }
  EXPECT_NEAR(slowest, 4'000, 20);
  bench.run_for(10s);
  EXPECT_NEAR(position_mm(), 8'000, 0.01);
  EXPECT_EQ(status() & 0x0400, 0x0400) << "at the last one it stands";
}

TEST_F(DriveRamps, StopsFastWithItsQuickStopDeceleration) {
  EXPECT_EQ(bench.ask("2F 0C 64 00 00 00 00 00"), 0U) << "without jerk";
  EXPECT_EQ(bench.ask("23 0A 64 00 E8 03 00 00"), 0U) << "1 m/s2";
  travel_for(4s);
  const double from = position_mm();
  control(0x0002);
  bench.run_for(3s);
  EXPECT_NEAR(position_mm() - from, 1'280, 1);
}

// Option codes. Ways are from 1.6 m/s: the slow-down ramp is 1 m/s2 with bends of 0.833 s, the
// quick stop ramp two bends of 1.155 s; the limits are 2.5 and 2 m/s2 without jerk.

constexpr double slow_down_way = 800 * (1.6 + 0.8333);
constexpr double quick_stop_way = 1600 * 1.1547;
constexpr double current_limit_way = 512;
constexpr double voltage_limit_way = 640;

constexpr std::uint16_t no_command = 0xFFFF;

struct Option {
  const char* name;
  const char* request;
  std::uint16_t word;  ///< the command that it is for; no_command: a fault of the hardware
  double way_mm;
  DriveState end;
};
class DriveOption : public CarDriveTest, public testing::WithParamInterface<Option> {};

TEST_P(DriveOption, SaysHowTheCarStops) {
  const Option& option = GetParam();
  ASSERT_EQ(bench.ask(option.request), 0U);
  travel_for(4s);
  const double from = position_mm();
  if (option.word == no_command) {
    bench.readings.fault = 0x4210;
  } else {
    control(option.word);
  }
  bench.run_for(5s);
  EXPECT_EQ(state(), option.end);
  EXPECT_NEAR(position_mm() - from, option.way_mm, 35);
  EXPECT_FALSE(bench.brake_released);
  EXPECT_EQ(bench.power, option.end == DriveState::operation_enabled);
}
INSTANTIATE_TEST_SUITE_P(
    Of6402, DriveOption,
    testing::Values(
        Option{"Shutdown0", "2B 02 64 01 00 00 00 00", 0x0006, 0, DriveState::ready_to_switch_on},
        Option{"Shutdown1", "2B 02 64 01 01 00 00 00", 0x0006, slow_down_way,
               DriveState::ready_to_switch_on},
        Option{"Disable0", "2B 02 64 02 00 00 00 00", 0x0007, 0, DriveState::switched_on},
        Option{"Disable1", "2B 02 64 02 01 00 00 00", 0x0007, slow_down_way,
               DriveState::switched_on},
        Option{"Halt1", "2B 02 64 04 01 00 00 00", 0x011F, slow_down_way,
               DriveState::operation_enabled},
        Option{"Halt2", "2B 02 64 04 02 00 00 00", 0x011F, quick_stop_way,
               DriveState::operation_enabled},
        Option{"Halt3", "2B 02 64 04 03 00 00 00", 0x011F, current_limit_way,
               DriveState::operation_enabled},
        Option{"Halt4", "2B 02 64 04 04 00 00 00", 0x011F, voltage_limit_way,
               DriveState::operation_enabled},
        Option{"Fault0", "2B 02 64 05 00 00 00 00", no_command, 0, DriveState::fault},
        Option{"Fault1", "2B 02 64 05 01 00 00 00", no_command, slow_down_way, DriveState::fault},
        Option{"Fault2", "2B 02 64 05 02 00 00 00", no_command, quick_stop_way, DriveState::fault},
        Option{"Fault3", "2B 02 64 05 03 00 00 00", no_command, current_limit_way,
               DriveState::fault},
        Option{"Fault4", "2B 02 64 05 04 00 00 00", no_command, voltage_limit_way,
               DriveState::fault}),
    [](const auto& test) { return test.param.name; });

TEST_F(DriveRamps, OptionCodesAreThoseOfCiA402AndTheirDefaultsThoseOf6402h) {
  constexpr unsigned lowest[] = {0, 0, 0, 1, 0};
  constexpr unsigned highest[] = {1, 1, 8, 4, 4};
  constexpr unsigned defaults[] = {0, 1, 2, 1, 2};
  for (unsigned sub = 1; sub <= 5; ++sub) {
    char request[40];
    std::snprintf(request, sizeof request, "40 02 64 %02X 00 00 00 00", sub);
    EXPECT_EQ(bench.ask(request), defaults[sub - 1]) << sub;
    for (unsigned code = 0; code <= 0xFFFF; code += code < 0x10 ? 1 : 0xFFEF / 3) {
      std::snprintf(request, sizeof request, "2B 02 64 %02X %02X %02X 00 00", sub, code & 0xFF,
                    code >> 8);
      const bool is_known = code >= lowest[sub - 1] && code <= highest[sub - 1];
      EXPECT_EQ(bench.ask(request), is_known ? 0U : 0x0609'0030U) << sub << " " << code;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417
