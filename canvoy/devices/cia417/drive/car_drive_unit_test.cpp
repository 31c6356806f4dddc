// A car drive unit at the wire: its state machine, and travels in profile position mode.
#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"

#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_unit_test {
namespace {

using CarDrive = CarDriveTest;

TEST_F(CarDrive, IsSwitchOnDisabledAfterItsSelfTestAndTellsSo) {
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_EQ(status(), 0x0250) << "switch on disabled, voltage, remote";
  EXPECT_FALSE(bench.power);
}

TEST_F(CarDrive, GoesThroughTheStateMachineByControlPdosAndTellsEachStateByPdo181) {
  control(0x0006);
  EXPECT_TRUE(bench.has_sent("181#31 02 00 00 00 00"));
  EXPECT_FALSE(bench.power);
  control(0x0007);
  EXPECT_TRUE(bench.has_sent("181#33 02 00 00 00 00"));
  EXPECT_FALSE(bench.power);
  control(0x000F);
  EXPECT_TRUE(bench.has_sent("181#37 02 00 00 00 00"));
  EXPECT_TRUE(bench.has_sent("185#37 02 00 00 00 00")) << "with the velocity, too";
  EXPECT_TRUE(bench.power);
  EXPECT_FALSE(bench.brake_released) << "there is nothing to do yet";
}

TEST_F(CarDrive, TravelsToItsTargetAndStandsThereBehindItsBrake) {
  enable();
  control(0x001F, 12'000);
  EXPECT_EQ(status() & 0x1400, 0x1000) << "acknowledged, not reached";
  EXPECT_TRUE(bench.brake_released);
  bench.run_for(199ms);
  EXPECT_EQ(position_mm(), 0) << "the brake opens";
  control(0x000F);
  EXPECT_EQ(status() & 0x1000, 0) << "ready for another one";
  // 1/1.2 s of jerk twice and 0.767 s between to 1.6 m/s; 12 m at it, and the ramps once more.
  const double seconds = 12 / 1.6 + 1.6 / 1 + 1 / 1.2;
  bench.run_for(Duration(static_cast<long>(seconds * 1e6)));
  EXPECT_NEAR(position_mm(), 12'000, 0.01);
  bench.run_for(200ms);
  EXPECT_EQ(status(), 0x0637) << "reached, operation enabled";
  EXPECT_FALSE(bench.brake_released);
  EXPECT_NEAR(bench.speed_max, 16'000, 1);
}

TEST_F(CarDrive, TellsItsVelocityWhileItMoves) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  EXPECT_TRUE(bench.has_sent("185#37 12 40 06 00 00")) << "1600 mm/s upward";
  EXPECT_TRUE(bench.has_sent("181#37 12 40 06 00 00")) << "the control effort is that, too";
}

TEST_F(CarDrive, TakesANewTargetOnItsWayWhereItCanStopThere) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(3s);
  control(0x002F, 9'000);
  control(0x003F, 9'000);
  EXPECT_EQ(status() & 0x1000, 0x1000);
  bench.run_for(12s);
  EXPECT_NEAR(position_mm(), 9'000, 0.01);
  EXPECT_EQ(status() & 0x0400, 0x0400);
}

TEST_F(CarDrive, GoesOnToThePreviousTargetWhereItCannotStopAtTheNewOne) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);  // about 3.7 m, 1.6 m/s: the way to a stop is about 2 m
  control(0x002F, 5'000);
  control(0x003F, 5'000);
  EXPECT_EQ(status() & 0x1000, 0) << "not acknowledged";
  bench.run_for(12s);
  EXPECT_NEAR(position_mm(), 12'000, 0.01);
}

TEST_F(CarDrive, TravelsToOneTargetAfterTheOtherWhereItIsNotToChangeAtOnce) {
  enable();
  control(0x001F, 3'000);
  control(0x000F, 3'000);
  control(0x001F, 1'000);
  EXPECT_EQ(status() & 0x1000, 0x1000);
  control(0x000F, 1'000);
  control(0x001F, 2'000);
  EXPECT_EQ(status() & 0x1000, 0) << "one waits already";
  bench.run_for(5s);
  EXPECT_GT(bench.sense().position, 25'000);
  bench.run_for(10s);
  EXPECT_NEAR(position_mm(), 1'000, 0.01);
  EXPECT_EQ(status() & 0x0400, 0x0400);
}

TEST_F(CarDrive, CountsARelativeTargetFromTheLastOne) {
  enable();
  control(0x001F, 3'000);
  bench.run_for(10s);
  control(0x004F, -1'000);
  control(0x005F, -1'000);
  bench.run_for(10s);
  EXPECT_NEAR(position_mm(), 2'000, 0.01);
}

TEST_F(CarDrive, HaltsOnItsRampAndGoesOnBehindIt) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(3s);
  control(0x011F, 12'000);
  bench.run_for(4s);
  EXPECT_EQ(status() & 0x0427, 0x0427) << "halted: reached says that it stands";
  EXPECT_FALSE(bench.brake_released);
  const double halted = position_mm();
  EXPECT_LT(halted, 8'000);
  control(0x001F, 12'000);
  bench.run_for(12s);
  EXPECT_NEAR(position_mm(), 12'000, 0.01);
}

TEST_F(CarDrive, StopsFastAndDisablesItselfByQuickStop) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  const double from = position_mm();
  control(0x0002, 12'000);
  EXPECT_EQ(state(), DriveState::quick_stop_active);
  EXPECT_EQ(status() & 0x006F, 0x0007);
  bench.run_for(3s);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_FALSE(bench.power);
  EXPECT_FALSE(bench.brake_released);
  EXPECT_NEAR(position_mm() - from, 640, 1) << "1.6 m/s, 2 m/s2";
}

struct QuickStop {
  unsigned option;
  double way_mm;  ///< from 1600 mm/s
  DriveState end;
};
class CarDriveQuickStop : public CarDrive, public testing::WithParamInterface<QuickStop> {};

TEST_P(CarDriveQuickStop, StopsAsItsOptionCodeSays) {
  const QuickStop& wanted = GetParam();
  const std::string option = std::to_string(wanted.option);
  EXPECT_EQ(bench.ask("2B 02 64 03 0" + option + " 00 00 00"), 0U);
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  const double from = position_mm();
  control(0x000B, 12'000);
  bench.run_for(5s);
  EXPECT_EQ(state(), wanted.end);
  EXPECT_NEAR(position_mm() - from, wanted.way_mm, 25);
  EXPECT_FALSE(bench.brake_released);
  EXPECT_EQ(bench.power, wanted.end == DriveState::quick_stop_active);
  control(0x000F, 12'000);
  const bool resumes = wanted.end == DriveState::quick_stop_active;
  EXPECT_EQ(state(), resumes ? DriveState::operation_enabled : wanted.end) << "transition 16";
}
/// Slow-down ramp: 1 m/s2 with bends of 0.833 s; quick stop 2 m/s2 and limits 2.5 and 2 m/s2,
/// without jerk.
INSTANTIATE_TEST_SUITE_P(
    Options, CarDriveQuickStop,
    testing::Values(QuickStop{0, 0, DriveState::switch_on_disabled},
                    QuickStop{1, 800 * (1.6 + 0.8333), DriveState::switch_on_disabled},
                    QuickStop{2, 640, DriveState::switch_on_disabled},
                    QuickStop{3, 512, DriveState::switch_on_disabled},
                    QuickStop{4, 640, DriveState::switch_on_disabled},
                    QuickStop{5, 800 * (1.6 + 0.8333), DriveState::quick_stop_active},
                    QuickStop{6, 640, DriveState::quick_stop_active},
                    QuickStop{7, 512, DriveState::quick_stop_active},
                    QuickStop{8, 640, DriveState::quick_stop_active}),
    [](const auto& test) { return "Option" + std::to_string(test.param.option); });

TEST_F(CarDrive, SlowsDownBeforeItDisablesOperationAndDoesWhatIsCommandedThen) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  control(0x0007, 12'000);
  EXPECT_EQ(state(), DriveState::operation_enabled) << "until it stands";
  control(0x0006, 12'000);
  bench.run_for(4s);
  EXPECT_EQ(state(), DriveState::ready_to_switch_on);
  EXPECT_FALSE(bench.power);
}

TEST_F(CarDrive, ShutsDownAtOnceByItsDefaultOption) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  control(0x0006, 12'000);
  EXPECT_EQ(state(), DriveState::ready_to_switch_on);
  EXPECT_FALSE(bench.power);
  EXPECT_FALSE(bench.brake_released);
}

TEST_F(CarDrive, StaysOffWhileTheBrakeStillStopsTheCar) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  bench.detached = true;
  bench.readings.velocity = 9'000;
  control(0x0000, 12'000);
  EXPECT_FALSE(bench.power);
  bench.run_for(40ms);
  enable();
  EXPECT_EQ(state(), DriveState::switched_on);
  bench.readings.velocity = 0;
  bench.run_for(200ms);
  EXPECT_EQ(state(), DriveState::operation_enabled);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_unit_test
