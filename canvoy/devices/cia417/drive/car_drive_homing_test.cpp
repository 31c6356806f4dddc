// A car drive unit in homing mode, by each of its methods. Ten increments are a millimetre; it
// searches at 100 mm/s.
#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_homing_test {
namespace {

/// A shaft with switches, and an encoder with an index pulse every 3 m from 0.5 m on, in
/// increments.
class HomingBench : public DriveBench {
 public:
  static constexpr double lower_limit = -20'000;
  static constexpr double upper_limit = 40'000;
  static constexpr double home = 10'000;
  static constexpr double home_end = 13'000;
  static constexpr double index_first = 5'000;
  static constexpr double index_pitch = 30'000;

  HomingBench() { sense(); }
  CarDriveHardware shaft() {
    CarDriveHardware made = hardware();
    made.sense = callback<&HomingBench::sense_shaft>(*this);
    return made;
  }
  DriveReadings sense_shaft() {
    DriveReadings shown = sense();
    const double now_at = shown.position;
    const auto pass = [&](std::optional<double>& latch, double place) {
      const bool is_passed = (last_ - place) * (now_at - place) <= 0 && last_ != now_at;
      if (is_passed) latch = place;
    };
    if (has_limits) pass(latches_.lower_limit_position, lower_limit);
    if (has_limits) pass(latches_.upper_limit_position, upper_limit);
    pass(latches_.home_position, home);
    if (tells_switch) pass(latches_.home_position, home_end);
    const bool is_at_home = now_at >= home && now_at <= home_end;
    if (tells_switch) shown.home_switch = is_at_home && !home_is_broken;
    for (int i = -3; i <= 3 && has_index; ++i) {
      pass(latches_.index_position, index_first + i * index_pitch);
    }
    last_ = now_at;
    shown.home_position = latches_.home_position;
    shown.lower_limit_position = latches_.lower_limit_position;
    shown.upper_limit_position = latches_.upper_limit_position;
    shown.index_position = latches_.index_position;
    return shown;
  }

  bool tells_switch = false;  ///< whether the home switch is on
  bool has_limits = true;
  bool has_index = true;
  bool home_is_broken = false;  ///< it never is

 private:
  double last_ = 0;
  DriveReadings latches_;
};

class Homing {
 public:
  explicit Homing(HomingMethod method) : Homing(CarDriveSettings{.homing = method}) {}
  explicit Homing(const CarDriveSettings& settings)
      : device(bench.port(), 2, bench.shaft(), settings) {
    bench.boot(device.node());
    EXPECT_EQ(bench.ask("2F 03 64 00 06 00 00 00"), 0U);
  }
  std::uint16_t status() { return Values(device.node().dictionary())[statusword].raw(); }
  void control(std::uint16_t word) {
    char text[32];
    std::snprintf(text, sizeof text, "184#%02X %02X 00 00 00 00", word & 0xFFU, word >> 8U);
    bench.send(text);
  }
  void begin() {
    control(0x0006);
    control(0x0007);
    control(0x000F);
    control(0x001F);
  }
  /// Travels to position 0 and returns its location in increments.
  double zero() {
    control(0x0007);
    EXPECT_EQ(bench.ask("2F 03 64 00 01 00 00 00"), 0U);
    bench.send("180#0F 00 00 00 00 00");
    bench.send("180#1F 00 00 00 00 00");
    bench.run_for(20s);
    return bench.sense().position;
  }

  HomingBench bench;
  CarDriveDevice<> device;
};

struct Method {
  const char* name;
  HomingMethod method;
  double home;      ///< in increments
  double furthest;  ///< it goes there at least
  bool has_limits = true;
};
class DriveHomingMethod : public testing::TestWithParam<Method> {};

TEST_P(DriveHomingMethod, FindsItsHomePositionAndCountsFromThere) {
  Homing homing(GetParam().method);
  homing.bench.has_limits = GetParam().has_limits;
  EXPECT_EQ(homing.bench.ask("23 28 64 00 64 00 00 00"), 0U) << "home offset 100 mm";
  homing.begin();
  double furthest = 0;
  for (int i = 0; i < 1200; ++i) {
    homing.bench.run_for(100ms);
    const double position = homing.bench.sense().position;
    if (std::abs(position) > std::abs(furthest)) furthest = position;
  }
  EXPECT_EQ(homing.status() & 0x3400, 0x1400) << "homing attained, target reached";
  EXPECT_FALSE(homing.bench.brake_released);
  EXPECT_NEAR(furthest, GetParam().furthest, 350) << "and no further than it takes to stop";
  EXPECT_NEAR(homing.zero(), GetParam().home + 1'000, 0.01);
}
INSTANTIATE_TEST_SUITE_P(
    Methods, DriveHomingMethod,
    testing::Values(Method{"HomeSwitchAbove", HomingMethod::home_switch_above, 10'000, 10'000},
                    Method{"LowerLimitSwitch17", HomingMethod::lower_limit_switch, -20'000,
                           -20'000},
                    Method{"UpperLimitSwitch18", HomingMethod::upper_limit_switch, 40'000, 40'000},
                    Method{"LowerLimitSwitchAndIndex1", HomingMethod::lower_limit_switch_and_index,
                           5'000, -20'000},
                    Method{"UpperLimitSwitchAndIndex2", HomingMethod::upper_limit_switch_and_index,
                           35'000, 40'000},
                    Method{"IndexBelow33", HomingMethod::index_below, -25'000, -25'000, false},
                    Method{"IndexAbove34", HomingMethod::index_above, 5'000, 5'000},
                    Method{"PresentPosition35And37", HomingMethod::present_position, 0, 0}),
    [](const auto& test) { return test.param.name; });

TEST(DriveHoming, TurnsAtTheLimitSwitchAndSeeksTheIndexPulse) {
  Homing homing(HomingMethod::lower_limit_switch_and_index);
  homing.begin();
  homing.bench.run_for(19s);
  EXPECT_EQ(homing.status() & 0x3400, 0) << "still down to the switch";
  EXPECT_LT(homing.bench.sense().velocity, 0);
  homing.bench.run_for(5s);
  EXPECT_GT(homing.bench.sense().velocity, 0) << "and up again";
  EXPECT_EQ(homing.status() & 0x3400, 0);
}

TEST(DriveHoming, PassesTheEdgeOfTheHomeSwitchInTheDirectionOfItsMethod) {
  Homing homing(HomingMethod::home_switch_23);
  homing.bench.tells_switch = true;
  homing.begin();
  double furthest = 0;
  for (int i = 0; i < 300; ++i) {
    homing.bench.run_for(100ms);
    furthest = std::max(furthest, homing.bench.sense().position);
  }
  EXPECT_NEAR(furthest, HomingBench::home, 350) << "up to it";
  EXPECT_EQ(homing.status() & 0x3400, 0x1400);
  EXPECT_LT(homing.bench.sense().position, HomingBench::home) << "and down past its edge";
  EXPECT_NEAR(homing.zero(), HomingBench::home, 0.01);
}

TEST(DriveHoming, FailsAtOnceWhereNobodyTellsTheHomeSwitchThatItsMethodWants) {
  Homing homing(HomingMethod::home_switch_and_index_7);
  homing.begin();
  homing.bench.run_for(2s);
  EXPECT_EQ(homing.status() & 0x3400, 0x2000) << "homing error";
  EXPECT_FALSE(homing.bench.brake_released);
}

/// It searches at 100 mm/s, and takes one second to reach that and one to stop.
void expect_failure_between(Homing& homing, Duration earliest, Duration latest) {
  homing.begin();
  homing.bench.run_for(earliest);
  EXPECT_EQ(homing.status() & 0x3400, 0) << "it searches still";
  EXPECT_NEAR(std::abs(homing.bench.sense().velocity), 1'000, 1);
  homing.bench.run_for(latest - earliest);
  EXPECT_EQ(homing.status() & 0x3400, 0x2000) << "homing error";
  EXPECT_EQ(homing.bench.sense().velocity, 0);
  EXPECT_FALSE(homing.bench.brake_released);
}

TEST(DriveHoming, FailsAtTheLimitSwitchWhereItsHomeSwitchLiesBehindIt) {
  Homing homing(HomingMethod::home_switch_below);
  expect_failure_between(homing, 19s, 23s);
  EXPECT_NEAR(homing.bench.sense().position, HomingBench::lower_limit, 350);
}

TEST(DriveHoming, FailsAtTheLimitSwitchWhereNoIndexPulseComesBefore) {
  Homing homing(HomingMethod::upper_limit_switch_and_index);
  homing.bench.has_index = false;
  // 4 m up, and 6 m down.
  expect_failure_between(homing, 95s, 106s);
  EXPECT_NEAR(homing.bench.sense().position, HomingBench::lower_limit, 350);
}

TEST(DriveHoming, FailsAtTheSecondLimitSwitchWhereTheHomeSwitchNeverSwitches) {
  Homing homing(HomingMethod::home_switch_and_index_7);
  homing.bench.tells_switch = homing.bench.home_is_broken = true;
  expect_failure_between(homing, 95s, 106s);
  EXPECT_NEAR(homing.bench.sense().position, HomingBench::lower_limit, 350);
}

TEST(DriveHoming, FailsWhenItHasSearchedATenthFartherThanItsTravel) {
  Homing homing(CarDriveSettings{.homing = HomingMethod::home_switch_below, .travel = 1'000});
  expect_failure_between(homing, 11s, 14s);
  EXPECT_NEAR(homing.bench.sense().position, -11'000, 350);
}

TEST(DriveHoming, GoesAsFarAsItsTravelInEachDirection) {
  Homing homing(
      CarDriveSettings{.homing = HomingMethod::lower_limit_switch_and_index, .travel = 2'500});
  homing.begin();
  homing.bench.run_for(60s);
  EXPECT_EQ(homing.status() & 0x3400, 0x1400) << "2 m down and 2.5 m up";
}

TEST(DriveHoming, SearchesTheOtherWayWhereThePolarityIsReversed) {
  Homing homing(HomingMethod::lower_limit_switch);
  EXPECT_EQ(homing.bench.ask("2F 1E 64 00 C0 00 00 00"), 0U);
  homing.begin();
  homing.bench.run_for(5s);
  EXPECT_GT(homing.bench.sense().velocity, 0) << "down is where increments grow";
}

TEST(DriveHoming, HaltsAndBeginsAgain) {
  Homing homing(HomingMethod::lower_limit_switch);
  homing.begin();
  homing.bench.run_for(5s);
  homing.control(0x011F);
  homing.bench.run_for(3s);
  EXPECT_EQ(homing.bench.sense().velocity, 0);
  EXPECT_EQ(homing.status() & 0x3400, 0x0400) << "it stands";
  homing.control(0x001F);
  homing.bench.run_for(60s);
  EXPECT_EQ(homing.status() & 0x3400, 0x1400);
}

TEST(DriveHoming, SoftwareLimitsCountFromTheHomePositionAndTargetsFromTheOffset) {
  Homing homing(HomingMethod::present_position);
  EXPECT_EQ(homing.bench.ask("23 22 64 02 E8 03 00 00"), 0U) << "1000 mm above home";
  EXPECT_EQ(homing.bench.ask("23 28 64 00 64 00 00 00"), 0U) << "position 0 is 100 mm above home";
  homing.begin();
  homing.bench.run_for(1s);
  EXPECT_EQ(homing.status() & 0x3400, 0x1400);
  EXPECT_EQ(homing.bench.ask("23 20 64 00 84 03 00 00"), 0U) << "900 mm";
  EXPECT_EQ(homing.bench.ask("23 20 64 00 85 03 00 00"), 0x0609'0031U);
}

TEST(DriveHoming, AResetForgetsTheHomePosition) {
  Homing homing(HomingMethod::lower_limit_switch);
  homing.begin();
  homing.bench.run_for(60s);
  homing.bench.send("000#81 02");
  homing.bench.send("000#01 02");
  homing.bench.run_for(200ms);
  EXPECT_EQ(homing.status() & 0x3000, 0);
  homing.control(0x0006);
  EXPECT_NEAR(homing.zero(), 0, 0.01) << "increments count from the encoder's zero";
}

// With a home switch below, the default.

class DriveHomingBelow : public CarDriveTest {
 protected:
  DriveHomingBelow() { EXPECT_EQ(bench.ask("2F 03 64 00 06 00 00 00"), 0U); }
  double velocity_mm() { return bench.sense().velocity / 10; }
};

TEST_F(DriveHomingBelow, GoesDownToTheHomeSwitchAndCountsFromThere) {
  bench.home_switch = -5'000;
  EXPECT_EQ(bench.ask("23 28 64 00 18 FC FF FF"), 0U) << "position 0 is 1 m below the switch";
  enable();
  control(0x001F, 0);
  bench.run_for(4s);
  EXPECT_NEAR(velocity_mm(), -100, 0.01);
  EXPECT_EQ(status() & 0x3400, 0);
  bench.run_for(6s);
  EXPECT_EQ(status() & 0x3400, 0x1400) << "homing attained, target reached";
  EXPECT_FALSE(bench.brake_released);
  control(0x0007, 0);
  EXPECT_EQ(bench.ask("2F 03 64 00 01 00 00 00"), 0U);
  control(0x000F, 0);
  control(0x001F, 0);
  bench.run_for(10s);
  EXPECT_NEAR(position_mm(), -500 - 1'000, 0.01);
}

TEST_F(DriveHomingBelow, FailsWhereThereIsNoHomeSwitchWithinTheSoftwareLimits) {
  EXPECT_EQ(bench.ask("23 22 64 01 0C FE FF FF"), 0U) << "500 mm below home";
  EXPECT_EQ(bench.ask("23 22 64 02 F4 01 00 00"), 0U) << "and above it";
  enable();
  control(0x001F, 0);
  bench.run_for(11s);
  EXPECT_EQ(status() & 0x3400, 0);
  bench.run_for(3s);
  EXPECT_EQ(status() & 0x3400, 0x2000);
  EXPECT_NEAR(position_mm(), -1'100, 35);
}

TEST_F(DriveHomingBelow, FailsAfterFiveMinutesWhereNobodyKnowsItsTravel) {
  enable();
  control(0x001F, 0);
  bench.run_for(299s);
  EXPECT_EQ(status() & 0x3400, 0);
  bench.run_for(6s);
  EXPECT_EQ(status() & 0x3400, 0x2000);
  EXPECT_EQ(velocity_mm(), 0);
}

TEST_F(DriveHomingBelow, IsGivenUpWhenBit4Falls) {
  enable();
  control(0x001F, 0);
  bench.run_for(3s);
  control(0x000F, 0);
  bench.run_for(3s);
  EXPECT_EQ(velocity_mm(), 0);
  EXPECT_EQ(status() & 0x3000, 0);
  EXPECT_FALSE(bench.brake_released);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_homing_test
