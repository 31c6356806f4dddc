// Events that stop a car drive unit: lost partners, emergencies of others, its own faults.
#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_stop_test {
namespace {

using CarDrive = CarDriveTest;

TEST_F(CarDrive, StopsFastWhenTheHeartbeatOfItsControllerIsLost) {
  EXPECT_EQ(bench.ask("23 16 10 01 F4 01 01 00"), 0U) << "node 1, 500 ms";
  bench.send("701#05");
  travel_for(450ms);
  EXPECT_EQ(state(), DriveState::operation_enabled);
  bench.run_for(100ms);
  EXPECT_EQ(state(), DriveState::quick_stop_active);
  EXPECT_TRUE(bench.has_sent("082#30 81 11 01 00 00 00 00"));
}

TEST_F(CarDrive, StopsFastWhenItIsNoLongerOperational) {
  travel_for(4s);
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
  travel_for(4s);
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

/// EN 81-20, 5.6.7.3; the code is that of CiA 301 for additional modules.
TEST_F(CarDrive, TestsItsBrakeAtEachStandstillAndDoesNotStartWithOneThatSlips) {
  travel_for(30s);
  EXPECT_EQ(bench.brake_tests, 1) << "at the end of the trip";
  EXPECT_NE(state(), DriveState::fault);
  bench.brake_holds = false;
  control(0x000F, 0);
  control(0x001F, 0);
  ASSERT_TRUE([this] {
    for (int i = 0; i < 3000 && bench.brake_tests < 2; ++i) bench.run_for(10ms);
    return bench.brake_tests == 2;
  }());
  bench.run_for(3900ms);
  EXPECT_NE(state(), DriveState::fault) << "time to open doors";
  control(0x0000, 0);
  enable();
  EXPECT_NE(state(), DriveState::operation_enabled) << "but not to start";
  bench.run_for(200ms);
  EXPECT_TRUE(bench.has_sent("082#00 70 01 00 00 00 00 00"));
  EXPECT_EQ(state(), DriveState::fault);
  EXPECT_FALSE(bench.power);
  EXPECT_EQ(bench.arrests, 0) << "it holds what is there";
  bench.readings.voltage = false;  // its contact opens the safety chain
  control(0x0000, 0);
  control(0x0080, 0);
  EXPECT_EQ(state(), DriveState::fault) << "until a person closes the chain";
  bench.readings.voltage = true;
  bench.brake_holds = true;
  bench.run_for(200ms);
  bench.sent.clear();
  control(0x0000, 0);
  control(0x0080, 0);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_TRUE(bench.has_sent("082#00 00 00 00 00 00 00 00"));
}

TEST_F(CarDrive, DoesNotTestABrakeThatStopsTheCar) {
  travel_for(3s);
  control(0x0000);
  bench.run_for(1s);
  EXPECT_EQ(bench.brake_tests, 0);
}

TEST_F(CarDrive, WithoutVoltageItsBrakeClosesAndItWaitsForBoth) {
  for (const std::uint16_t word : std::array<std::uint16_t, 3>{0x000F, 0x0002, 0x010F}) {
    travel_for(3s);
    control(word);
    bench.readings.voltage = false;
    bench.run_for(20ms);
    EXPECT_EQ(state(), DriveState::switch_on_disabled) << word;
    EXPECT_EQ(status() & 0x0010, 0);
    EXPECT_FALSE(bench.brake_released);
    EXPECT_FALSE(bench.power);
    bench.run_for(1s);
    enable();
    control(0x001F, 0);
    bench.run_for(10s);
    EXPECT_EQ(state(), DriveState::switched_on) << "no operation while the safety chain is open";
    EXPECT_FALSE(bench.brake_released);
    bench.readings.voltage = true;
    bench.run_for(200ms);
    EXPECT_EQ(state(), DriveState::operation_enabled);
    control(0x000F, 0);
    control(0x001F, 0);
    bench.run_for(20s);
    EXPECT_NEAR(position_mm(), 0, 0.01);
    control(0x0000);
  }
}

/// Faults that the drive detects, and its state after their end.
struct OwnError {
  const char* name;
  double velocity;
  double position;
  const char* emergency;
};
class DriveOwnError : public CarDriveTest, public testing::WithParamInterface<OwnError> {};

TEST_P(DriveOwnError, IsResetWhenSomebodyHasClosedTheSafetyChain) {
  bench.readings = {.position = GetParam().position, .velocity = GetParam().velocity};
  bench.run_for(100ms);
  EXPECT_TRUE(bench.has_sent(GetParam().emergency));
  EXPECT_EQ(bench.arrests, 1);
  bench.readings.velocity = 0;
  bench.readings.voltage = false;  // the safety gear opens the chain
  bench.sent.clear();
  for (int i = 0; i < 3; ++i) {
    bench.run_for(2s);
    control(0x0000, 0);
    control(0x0080, 0);
    EXPECT_EQ(state(), DriveState::fault);
  }
  EXPECT_FALSE(bench.has_sent("082#00 00 00 00 00 00 00 00"));
  bench.readings.voltage = true;
  control(0x0000, 0);
  control(0x0080, 0);
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_TRUE(bench.has_sent("082#00 00 00 00 00 00 00 00"));
}
INSTANTIATE_TEST_SUITE_P(
    Each, DriveOwnError,
    testing::Values(OwnError{"Overspeed", 16'000 * 1.16, 0, "082#05 FF 01 00 00 00 00 00"},
                    OwnError{"UnintendedMovement", 6'000, 501, "082#06 FF 01 00 00 00 00 00"}),
    [](const auto& test) { return test.param.name; });

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
  travel_for(3s);
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
  travel_for(4s);
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

/// CiA 402: bit 13 of the statusword in profile position mode.
TEST_F(CarDrive, ForgetsAFollowingErrorByAReset) {
  travel_for(4s);
  bench.detached = true;
  bench.run_for(1s);
  ASSERT_EQ(state(), DriveState::fault);
  EXPECT_EQ(status() & status_bit::following_error, status_bit::following_error);
  bench.send("000#81 02");
  EXPECT_EQ(state(), DriveState::switch_on_disabled);
  EXPECT_EQ(status() & status_bit::following_error, 0);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_stop_test
