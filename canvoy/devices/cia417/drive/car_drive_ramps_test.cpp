// Objects of a car drive unit that determine its ramps (CiA 417-4, 4.11.1 and 4.11.4): velocities,
// accelerations, jerks and option codes, in the units of their objects. The defaults are 1.6 m/s, 1
// m/s2 and 1.2 m/s3.
#include <algorithm>

#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_ramps_test {
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

/// Duration of the ramp from 0 to 1 m/s, and back, without jerk.
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

// Ways to a stop from 1.6 m/s, by default.
constexpr double slow_down_way = 800 * (1.6 + 0.8333);
constexpr double quick_stop_way = 640;
constexpr double current_limit_way = 512;
constexpr double voltage_limit_way = 640;

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

constexpr std::uint16_t no_command = 0xFFFF;

/// Start of a fast stop, and its option code in 6402h.
struct FastStop {
  const char* name;
  const char* option;
  std::uint16_t word;  ///< no_command: the frame
  const char* frame;
};
class DriveFastStop : public CarDriveTest, public testing::WithParamInterface<FastStop> {
 protected:
  /// From 1.6 m/s.
  void begin() {
    if (GetParam().word != no_command) return control(GetParam().word);
    if (GetParam().frame != nullptr) return bench.send(GetParam().frame);
    bench.readings.fault = 0x4210;
    bench.run_for(20ms);
  }
};

/// Only 640Ah determines the duration: the jerk of 640Dh is for profile movement.
TEST_P(DriveFastStop, HasTheQuickStopDecelerationAtOnce) {
  struct Row {
    const char* request;
    double seconds;
  };
  constexpr Row rows[] = {{"23 0A 64 00 20 03 00 00", 2},           // 0.8 m/s2
                          {"23 0A 64 00 DC 05 00 00", 1.6 / 1.5},   // 1.5
                          {"23 0A 64 00 40 1F 00 00", 0.2},         // 8
                          {"23 0A 64 00 28 23 00 00", 1.6 / 9.0}};  // 9
  EXPECT_EQ(bench.ask("23 09 64 02 10 27 00 00"), 0U) << "10 m/s2 at most";
  EXPECT_EQ(bench.ask("23 28 10 04 84 00 00 00"), 0U) << "hears node 4";
  EXPECT_EQ(bench.ask(GetParam().option), 0U);
  for (const Row& row : rows) {
    EXPECT_EQ(bench.ask(row.request), 0U) << row.request;
    travel_for(4s);
    const double from = position_mm();
    begin();
    EXPECT_NEAR(bench.profile.duration(), row.seconds, 0.001) << row.request;
    EXPECT_NEAR(bench.profile.at(0).acceleration, -16'000 / row.seconds, 20);
    bench.run_for(4s);
    EXPECT_NEAR(position_mm() - from, 800 * row.seconds, 35);
    EXPECT_FALSE(bench.brake_released);
    bench.readings.fault = 0;
    bench.send("084#00 00 00 00 00 00 00 00");
    bench.send("000#01 02");
    control(0x0000);
    control(0x0080);
    control(0x0000);
    enable();
    control(0x001F, 0);
    bench.run_for(15s);
    control(0x0000);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Each, DriveFastStop,
    testing::Values(FastStop{"QuickStop2", "2B 02 64 03 02 00 00 00", 0x0002, nullptr},
                    FastStop{"QuickStop6", "2B 02 64 03 06 00 00 00", 0x0002, nullptr},
                    FastStop{"Halt2", "2B 02 64 04 02 00 00 00", 0x010F, nullptr},
                    FastStop{"Fault2", "2B 02 64 05 02 00 00 00", no_command, nullptr},
                    FastStop{"NotOperational", "2B 02 64 03 02 00 00 00", no_command, "000#80 02"},
                    FastStop{"OverspeedOfNode4", "2B 02 64 03 02 00 00 00", no_command,
                             "084#05 FF 01 00 00 00 00 00"},
                    FastStop{"UnintendedMovementOfNode4", "2B 02 64 03 02 00 00 00", no_command,
                             "084#06 FF 01 00 00 00 00 00"},
                    FastStop{"OverspeedOfNode4WhateverTheOption", "2B 02 64 03 01 00 00 00",
                             no_command, "084#05 FF 01 00 00 00 00 00"},
                    FastStop{"OverspeedOfNode4WhateverTheOptionThatStays",
                             "2B 02 64 03 05 00 00 00", no_command, "084#05 FF 01 00 00 00 00 00"}),
    [](const auto& test) { return test.param.name; });

TEST_F(DriveRamps, AStopOnTheSlowDownRampBecomesAFastOneByOverspeed) {
  EXPECT_EQ(bench.ask("23 28 10 04 84 00 00 00"), 0U) << "hears node 4";
  EXPECT_EQ(bench.ask("2B 02 64 03 01 00 00 00"), 0U) << "quick stop on the slow-down ramp";
  travel_for(4s);
  const double from = position_mm();
  control(0x0002);
  EXPECT_NEAR(bench.profile.duration(), 1.6 + 1 / 1.2, 0.001);
  bench.send("084#05 FF 01 00 00 00 00 00");
  EXPECT_NEAR(bench.profile.duration(), 1.6 / 2, 0.001);
  EXPECT_EQ(state(), DriveState::quick_stop_active);
  bench.run_for(4s);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_NEAR(position_mm() - from, quick_stop_way, 1);
}

TEST_F(DriveRamps, AStopForAFaultOnTheSlowDownRampBecomesAFastOneByItsOwnOverspeed) {
  EXPECT_EQ(bench.ask("2B 02 64 05 01 00 00 00"), 0U) << "fault reaction on the slow-down ramp";
  travel_for(4s);
  bench.readings.fault = 0x4210;
  bench.run_for(20ms);
  EXPECT_NEAR(bench.profile.duration(), 1.6 + 1 / 1.2, 0.001);
  bench.detached = true;
  bench.readings.velocity = 16'000 * 1.16;
  bench.run_for(20ms);
  EXPECT_NEAR(bench.profile.duration(), 1.6 / 2, 0.02);
}

TEST_F(DriveRamps, AFastStopWhileTheCarGainsSpeedTakesTheAccelerationBackAtOnce) {
  travel_for(1200ms);  // of which the brake takes 200: 0.583 m/s and 1 m/s2, after 1/1.2 s of jerk
  const double from = position_mm();
  control(0x0002);
  const double velocity = (1 / 1.2) / 2 + (1 - 1 / 1.2);
  EXPECT_NEAR(bench.profile.duration(), velocity / 2, 0.001);
  bench.run_for(3s);
  EXPECT_NEAR(position_mm() - from, velocity * velocity / 4 * 1000, 1);
}

// Option codes. The slow-down ramp is 1 m/s2 with bends of 0.833 s; the
// quick stop ramp is 2 m/s2 and the limits are 2.5 and 2 m/s2, without jerk.

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
}  // namespace canvoy::cia417::car_drive_ramps_test
