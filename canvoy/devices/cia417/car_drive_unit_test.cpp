// A car drive unit at the wire, in profile position mode and by its state machine. Its defaults:
// millimetres, 1.6 m/s, 1 m/s2, 1.2 m/s3, the brake takes 200 ms; ten increments are a millimetre.
#include "canvoy/devices/cia417/car_drive_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/devices/cia417/car_drive_test.hpp"

namespace canvoy::cia417 {
namespace {

class CarDrive : public testing::Test {
 protected:
  CarDrive() { bench.boot(device.node()); }

  std::uint16_t status() { return Values(device.node().dictionary())[statusword].raw(); }
  DriveState state() const { return device.drive().state(); }
  /// 180h with a target of 0.
  void control(std::uint16_t word) { control(word, target); }
  /// 180h, as a drive controller sends it.
  void control(std::uint16_t word, std::int32_t position) {
    target = position;
    Frame frame = Frame::data_frame(0x180, {});
    frame.length = 6;
    store(frame.data.data(), word);
    store(frame.data.data() + 2, position);
    bench.send(wire_text(frame));
  }
  void enable() {
    control(0x0006);
    control(0x0007);
    control(0x000F);
    bench.sent.clear();
  }
  double position_mm() { return bench.sense().position / 10; }

  DriveBench bench;
  CarDriveDevice<> device{bench.port(), 2, bench.hardware()};
  std::int32_t target = 0;
};

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
  // 1.6 m/s, 1.2 m/s3, at most 2 m/s2: two bends of 1.155 s.
  EXPECT_NEAR(position_mm() - from, 1600 * 1.1547, 5);
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
/// Slow-down ramp: 1 m/s2 with bends of 0.833 s; the limits: 2.5 and 2 m/s2 without jerk.
INSTANTIATE_TEST_SUITE_P(
    Options, CarDriveQuickStop,
    testing::Values(QuickStop{0, 0, DriveState::switch_on_disabled},
                    QuickStop{1, 800 * (1.6 + 0.8333), DriveState::switch_on_disabled},
                    QuickStop{2, 1600 * 1.1547, DriveState::switch_on_disabled},
                    QuickStop{3, 512, DriveState::switch_on_disabled},
                    QuickStop{4, 640, DriveState::switch_on_disabled},
                    QuickStop{5, 800 * (1.6 + 0.8333), DriveState::quick_stop_active},
                    QuickStop{6, 1600 * 1.1547, DriveState::quick_stop_active},
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

// Limits.

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
                    Refusal{"23 0D 64 01 00 00 00 00", 0x0609'0032},
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

// What stops the drive.

TEST_F(CarDrive, StopsFastWhenTheHeartbeatOfItsControllerIsLost) {
  EXPECT_EQ(bench.ask("23 16 10 01 F4 01 01 00"), 0U) << "node 1, 500 ms";
  bench.send("701#05");
  enable();
  control(0x001F, 12'000);
  bench.run_for(450ms);
  EXPECT_EQ(state(), DriveState::operation_enabled);
  bench.run_for(100ms);
  EXPECT_EQ(state(), DriveState::quick_stop_active);
  EXPECT_TRUE(bench.has_sent("082#30 81 11 01 00 00 00 00"));
}

TEST_F(CarDrive, StopsFastWhenItIsNoLongerOperational) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  bench.send("000#80 02");
  EXPECT_EQ(state(), DriveState::quick_stop_active);
}

TEST_F(CarDrive, StopsFastByOverspeedAndUnintendedMovementThatOtherNodesTellOf) {
  EXPECT_EQ(bench.ask("23 28 10 04 84 00 00 00"), 0U) << "hears node 4";
  for (const char* emergency : {"084#05 FF 01 00 00 00 00 00", "084#06 FF 01 00 00 00 00 00"}) {
    enable();
    control(0x001F, 30'000);
    control(0x000F, 30'000);
    bench.run_for(4s);
    bench.send("085#05 FF 01 00 00 00 00 00");
    bench.send("084#04 FF 01 00 00 00 00 00");
    EXPECT_EQ(state(), DriveState::operation_enabled) << "of node 5, and another error";
    bench.send(emergency);
    EXPECT_EQ(state(), DriveState::quick_stop_active);
    bench.run_for(4s);
    enable();
    EXPECT_EQ(state(), DriveState::switch_on_disabled) << "as long as the error is there";
    bench.send("084#00 00 01 00 00 00 00 00");
    enable();
    EXPECT_EQ(state(), DriveState::switch_on_disabled) << "another one still is";
    bench.send("084#00 00 00 00 00 00 00 00");
  }
  enable();
  EXPECT_EQ(state(), DriveState::operation_enabled);
}

TEST_F(CarDrive, IsHeldNoLongerByANodeThatBoots) {
  EXPECT_EQ(bench.ask("23 28 10 04 84 00 00 00"), 0U) << "hears node 4";
  EXPECT_EQ(bench.ask("23 28 10 05 85 00 00 00"), 0U) << "and node 5";
  for (int i = 0; i < 3; ++i) {
    enable();
    ASSERT_EQ(state(), DriveState::operation_enabled);
    for (const char* error : {"084#05 FF 01 00 00 00 00 00", "085#06 FF 01 00 00 00 00 00",
                              "084#06 FF 01 00 00 00 00 00"}) {
      bench.send(error);
    }
    bench.run_for(1s);
    for (const char* other : {"704#05", "703#00", "704#00", "705#05", "705#7F", "705#00 00"}) {
      bench.send(other);
      enable();
      EXPECT_EQ(state(), DriveState::switch_on_disabled) << other << ": node 5 holds it, too";
    }
    bench.send("705#00");
  }
}

TEST_F(CarDrive, TellsOfOverspeedItselfAndStopsInFault) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  bench.detached = true;
  bench.readings.velocity = 16'000 * 1.16;
  bench.run_for(20ms);
  EXPECT_TRUE(bench.has_sent("082#05 FF 01 00 00 00 00 00"));
  EXPECT_EQ(bench.arrests, 1);
  EXPECT_EQ(state(), DriveState::fault_reaction_active);
  bench.run_for(4s);
  EXPECT_EQ(state(), DriveState::fault) << "the brake does it, whatever the encoder says";
  EXPECT_FALSE(bench.power);
  control(0x0080, 0);
  EXPECT_EQ(state(), DriveState::fault) << "still too fast";
  bench.readings.velocity = 0;
  bench.run_for(200ms);
  control(0x0000, 0);
  bench.sent.clear();
  control(0x0080, 0);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_TRUE(bench.has_sent("082#00 00 00 00 00 00 00 00"));
}

TEST_F(CarDrive, TellsOfUnintendedMovementWhileItShouldStand) {
  bench.readings.velocity = 2'500;
  bench.readings.position = 490;
  bench.run_for(100ms);
  EXPECT_EQ(state(), DriveState::switch_on_disabled) << "49 mm";
  bench.readings.position = 501;
  bench.run_for(100ms);
  EXPECT_TRUE(bench.has_sent("082#06 FF 01 00 00 00 00 00"));
  EXPECT_EQ(state(), DriveState::fault);
  EXPECT_EQ(bench.arrests, 1);
}

TEST_F(CarDrive, AnEncoderThatComesBackWithAnotherPositionHasNotMoved) {
  bench.readings.position = 50'000;
  bench.run_for(1s);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  enable();
  control(0x001F, 6'000);
  bench.run_for(5s);
  EXPECT_NEAR(position_mm(), 6'000, 0.01);
}

TEST_F(CarDrive, GoesIntoFaultWhereItLagsBehindItsProfile) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(3s);
  bench.detached = true;  // a dead encoder
  bench.run_for(1s);
  EXPECT_TRUE(bench.has_sent("082#11 86 01 00 00 00 00 00"));
  bench.run_for(4s);
  EXPECT_EQ(state(), DriveState::fault);
  EXPECT_EQ(status() & 0x2000, 0x2000);
  EXPECT_FALSE(bench.brake_released);
}

TEST_F(CarDrive, GoesIntoFaultByAFaultOfItsHardwareUntilThatIsGone) {
  bench.readings.fault = 0x4210;
  bench.run_for(200ms);
  EXPECT_EQ(status() & 0x4F, 0x08);
  EXPECT_TRUE(bench.has_sent("082#10 42 01 00 00 00 00 00"));
  control(0x0080);
  EXPECT_EQ(state(), DriveState::fault);
  bench.readings.fault = 0;
  control(0x0000);
  control(0x0080);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
}

TEST_F(CarDrive, StopsByItsBrakeAndWithoutPowerWhenItIsReset) {
  enable();
  control(0x001F, 12'000);
  bench.run_for(4s);
  bench.send("000#81 02");
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_FALSE(bench.power);
  EXPECT_FALSE(bench.brake_released);
}

TEST_F(CarDrive, LivesThroughEveryControlwordAndNeverMovesWithoutASetPoint) {
  for (unsigned word = 0; word <= 0xFFFF; word += 7) {
    control(static_cast<std::uint16_t>(word & ~0x0010U));
    ASSERT_FALSE(bench.brake_released) << word;
  }
  bench.run_for(1s);
  EXPECT_EQ(position_mm(), 0);
}

}  // namespace
}  // namespace canvoy::cia417
