// A car drive controller: at the wire against a drive that the test plays, and on a cable with a
// drive and a position unit of which the car is real numbers.
#include "canvoy/devices/cia417/drive/car_drive_controller_test.hpp"

#include <cmath>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"

namespace canvoy::cia417::car_drive_controller_test {
namespace {

// At the wire.

TEST_F(DriveControllerAtTheWire, LeadsTheDriveToOperationAndToItsTargetByTheHandshake) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  EXPECT_TRUE(bench.has_sent("180#0F 00 00 00 00 00"));
  hear("181#37 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#2F 00 E0 2E 00 00")) << "12000 mm";
  EXPECT_FALSE(bench.has_sent("184#3F 00 00 00 00 00")) << "which brings no target";
  bench.run_for(5ms);
  EXPECT_TRUE(bench.has_sent("180#3F 00 E0 2E 00 00")) << "new set-point, at once";
  hear("181#37 12 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#2F 00 E0 2E 00 00"));
  hear("181#37 02 40 06 00 00");
  EXPECT_FALSE(controller().status().standing);
  hear("18C#C0 D4 01 00");
  hear("181#37 06 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#07 00 E0 2E 00 00")) << "reached: the brake holds it";
  EXPECT_FALSE(controller().status().arrived);
  hear("181#33 06 00 00 00 00");
  EXPECT_TRUE(controller().status().arrived);
  EXPECT_TRUE(controller().status().standing);
  EXPECT_EQ(controller().status().position_micrometre, 12'000'000);
}

/// No PDO has come meanwhile, and a standing unit does not repeat its position.
TEST_F(DriveControllerAtTheWire, AsksAnewWhereTheCarIsWhenItIsStartedAgain) {
  ASSERT_TRUE(controller().status().available);
  bench.send("000#02 01");
  bench.sent.clear();
  bench.send("000#01 01");
  EXPECT_TRUE(bench.has_sent("18C#R4"));
  EXPECT_TRUE(bench.has_sent("181#R6"));
  EXPECT_FALSE(controller().status().available);
  hear("181#50 02 00 00 00 00");
  hear("185#50 02 00 00 00 00");
  hear("18C#C0 D4 01 00");
  EXPECT_TRUE(controller().status().available);
  EXPECT_EQ(controller().status().position_micrometre, 12'000'000);
}

struct Drift {
  const char* position;  ///< where the position unit sees the car: 12,000 mm, less ...
  const char* target;    ///< then that of the next trip, to 9 m
};
class DriveControllerWithDrift : public DriveControllerAtTheWire,
                                 public testing::WithParamInterface<Drift> {};

TEST_P(DriveControllerWithDrift, AimsFartherWhereTheDriveStandsAtItsTargetAndTheCarDoesNot) {
  begin_trip();
  hear(GetParam().position);
  hear("181#37 06 00 00 00 00");
  hear("181#33 06 00 00 00 00");
  EXPECT_TRUE(controller().status().standing);
  order([&] { controller().travel_to(9'000'000); });
  hear("181#37 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent(GetParam().target));
}

// 1D4C0h tenths of a millimetre are 12 m; 2328h mm are 9 m.
INSTANTIATE_TEST_SUITE_P(
    Ropes, DriveControllerWithDrift,
    testing::Values(Drift{"18C#8E D4 01 00", "180#2F 00 28 23 00 00"},   // 5 mm: it jitters
                    Drift{"18C#84 D4 01 00", "180#2F 00 2E 23 00 00"},   // 6 mm
                    Drift{"18C#E4 CE 01 00", "180#2F 00 BE 23 00 00"},   // 150 mm: ropes slip
                    Drift{"18C#9C DA 01 00", "180#2F 00 92 22 00 00"}),  // 150 mm too far
    [](const auto& row) { return std::string(row.param.position).substr(4, 2); });

TEST_F(DriveControllerAtTheWire, AimsAsFarAfterAResetForRopesDoNotSlipBack) {
  begin_trip();
  hear("18C#E4 CE 01 00");  // 150 mm short of 12 m
  hear("181#37 06 00 00 00 00");
  hear("181#33 06 00 00 00 00");
  order([&] { controller().travel_to(9'000'000); });
  hear("181#37 02 00 00 00 00");
  ASSERT_TRUE(bench.has_sent("180#2F 00 BE 23 00 00"));
  hear("000#81 01");
  hear("000#01 01");
  hear("18C#E4 CE 01 00");
  hear("185#50 02 00 00 00 00");
  bench.sent.clear();
  begin_trip();
  EXPECT_TRUE(bench.has_sent("180#2F 00 76 2F 00 00")) << "12,150 mm";
}

TEST_F(DriveControllerAtTheWire, StopsACarThatTheDriveLeadsPastItsTarget) {
  begin_trip();
  hear("18C#28 6E 01 00");
  hear("185#37 12 C0 F9 FF FF");
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::trip) << "down, away from it";
  hear("18C#78 AE 01 00");  // 11,020 mm
  hear("185#37 12 40 06 00 00");
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::trip) << "1,280 mm to stop: 300 past it";
  hear("18C#82 AE 01 00");  // 11,021 mm
  EXPECT_TRUE(bench.has_sent("180#02 00 E0 2E 00 00")) << "quick stop";
  hear("18C#F8 C6 01 00");
  hear("181#50 02 00 00 00 00");
  order([&] { controller().travel_to(9'000'000); });
  EXPECT_TRUE(bench.has_sent("180#06 00 E0 2E 00 00"));
  hear("181#31 02 00 00 00 00");
  hear("181#33 02 00 00 00 00");
  hear("181#37 02 00 00 00 00");
  // On its way down, 301 mm at least let it stop short of its target: it shows the rest there.
  EXPECT_TRUE(bench.has_sent("180#2F 00 FB 21 00 00")) << "8,699 mm";
}

/// What is known of a slip is its least extent: up again, a metre more lets the car stop short.
TEST_F(DriveControllerAtTheWire, StopsShortOfATargetBehindASlipAndKnowsItThen) {
  begin_trip();
  hear("18C#82 AE 01 00");  // 11,021 mm
  hear("185#37 12 40 06 00 00");
  ASSERT_TRUE(bench.has_sent("180#02 00 E0 2E 00 00")) << "301 mm past 12 m";
  hear("18C#F8 C6 01 00");
  hear("181#50 02 00 00 00 00");
  const auto travel = [this](std::int32_t micrometre) {
    order([&] { controller().travel_to(micrometre); });
    hear("181#31 02 00 00 00 00");
    hear("181#33 02 00 00 00 00");
    hear("181#37 02 00 00 00 00");
  };
  travel(13'000'000);
  EXPECT_TRUE(bench.has_sent("180#2F 00 B3 2D 00 00")) << "11,699 mm: 301 and 1,000 less";
  // 12,100 mm by its position unit, 11,699 by its count: it has stopped short, and knows.
  bench.run_for(5ms);
  hear("181#37 12 00 00 00 00");
  hear("185#37 12 00 00 00 00");
  hear("18C#A8 D8 01 00");
  hear("181#37 06 00 00 00 00");
  hear("181#33 06 00 00 00 00");
  travel(9'000'000);
  EXPECT_TRUE(bench.has_sent("180#2F 00 97 21 00 00")) << "8,599 mm: 401 less";
}

TEST_F(DriveControllerAtTheWire, SendsTheEdgeOfBit4AgainWhereATargetIsNotAcknowledged) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  hear("181#37 02 00 00 00 00");
  bench.run_for(5ms);
  bench.sent.clear();
  bench.run_for(900ms);
  EXPECT_TRUE(bench.has_sent("180#2F 00 E0 2E 00 00"));
  EXPECT_TRUE(bench.has_sent("180#3F 00 E0 2E 00 00"));
}

TEST_F(DriveControllerAtTheWire, EndsATripThatStandsStillShortOfItsTargetAfterFourSeconds) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  hear("181#37 02 00 00 00 00");
  bench.run_for(5ms);
  hear("185#37 12 40 06 00 00");
  bench.run_for(300ms);
  hear("185#37 12 00 00 00 00");  // a limit stops it
  bench.run_for(3900ms);
  EXPECT_FALSE(controller().status().standing);
  EXPECT_FALSE(bench.has_sent("180#07 00 E0 2E 00 00"));
  bench.run_for(350ms);
  EXPECT_TRUE(bench.has_sent("180#07 00 E0 2E 00 00")) << "the brake holds it";
  hear("181#33 02 00 00 00 00");
  EXPECT_TRUE(controller().status().standing);
  EXPECT_FALSE(controller().status().arrived);
}

TEST_F(DriveControllerAtTheWire, ATripThatGoesOnSlowlyIsNone) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  hear("181#37 02 00 00 00 00");
  bench.run_for(5ms);
  hear("185#37 12 19 00 00 00");  // 25 mm/s
  for (int i = 1; i <= 40; ++i) {
    bench.run_for(250ms);
    const auto counts = static_cast<std::int32_t>(i * 62);
    Frame frame = Frame::data_frame(0x18C, {});
    frame.length = 4;
    store(frame.data.data(), counts);
    hear(wire_text(frame));
  }
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::trip);
}

TEST_F(DriveControllerAtTheWire, RunsInProfileVelocityModeWhichItWritesBySdo) {
  order([&] { controller().run(300'000); });
  hear("181#31 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("602#2F 03 64 00 03 00 00 00"));
  hear("582#60 03 64 00 00 00 00 00");
  hear("185#33 02 00 00 00 00");
  hear("185#37 12 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("184#0F 00 2C 01 00 00")) << "300 mm/s";
  order([&] { controller().stop(); });
  EXPECT_TRUE(bench.has_sent("184#07 00 00 00 00 00"));
}

TEST_F(DriveControllerAtTheWire, StopsFastByQuickStopAndGoesOnWithANewOrder) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  hear("181#37 02 00 00 00 00");
  order([&] { controller().fast_stop(); });
  EXPECT_TRUE(bench.has_sent("180#02 00 E0 2E 00 00"));
  hear("181#17 02 00 00 00 00");
  EXPECT_FALSE(controller().status().standing);
  hear("181#50 02 00 00 00 00");
  EXPECT_TRUE(controller().status().standing);
  EXPECT_FALSE(controller().status().arrived);
  order([&] { controller().travel_to(1'000'000); });
  EXPECT_TRUE(bench.has_sent("180#06 00 E0 2E 00 00"));
}

TEST_F(DriveControllerAtTheWire, ResetsAFaultEachTwoSecondsAndIsNotAvailableUntilItIsGone) {
  EXPECT_TRUE(controller().status().available);
  order([&] { controller().travel_to(12'000'000); });
  hear("181#18 02 00 00 00 00");
  EXPECT_FALSE(controller().status().available);
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::none);
  order([&] { controller().travel_to(1'000'000); });
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::none) << "nothing is driven in fault";
  EXPECT_TRUE(controller().has_fault());
  bench.sent.clear();
  bench.run_for(2250ms);
  EXPECT_TRUE(bench.has_sent("180#80 00 00 00 00 00"));
  bench.sent.clear();
  bench.run_for(2500ms);
  EXPECT_TRUE(bench.has_sent("180#00 00 00 00 00 00"));
  EXPECT_TRUE(bench.has_sent("180#80 00 00 00 00 00"));
  hear("181#50 02 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
}

TEST_F(DriveControllerAtTheWire, TellsADriveAgainThatDoesNothing) {
  order([&] { controller().travel_to(12'000'000); });
  bench.sent.clear();
  bench.run_for(800ms);
  EXPECT_TRUE(bench.has_sent("180#06 00 00 00 00 00"));
}

TEST_F(DriveControllerAtTheWire, IsNotAvailableWithoutDriveOrPositionUnit) {
  for (const char* heartbeat : {"702#05", "704#05"}) hear(heartbeat);
  bench.run_for(1400ms);
  EXPECT_TRUE(controller().status().available);
  hear("702#05");
  bench.run_for(200ms);
  EXPECT_FALSE(controller().status().available) << "the position unit is lost";
  hear("704#05");
  hear("18C#00 00 00 00");
  EXPECT_TRUE(controller().status().available);
  bench.run_for(1490ms);
  EXPECT_FALSE(controller().status().available) << "the drive is lost";
  EXPECT_FALSE(controller().status().standing) << "who knows?";
}

TEST_F(DriveControllerAtTheWire, StopsFastWhereTheDriveMovesAndThePositionDoesNot) {
  order([&] { controller().travel_to(12'000'000); });
  switch_on_for_a_trip();
  hear("181#37 02 00 00 00 00");
  hear("181#37 12 00 00 00 00");
  hear("185#37 02 40 06 00 00");
  bench.sent.clear();
  bench.run_for(1s);
  EXPECT_TRUE(bench.has_sent("180#02 00 E0 2E 00 00"));
  EXPECT_FALSE(controller().status().available);
  hear("18C#C0 D4 01 00");
  EXPECT_TRUE(controller().status().available) << "it is alive again";
}

/// The parameter: the command to go comes this many ms after the last check of the controller.
class DriveControllerAtAStart : public DriveControllerAtTheWire,
                                public testing::WithParamInterface<int> {};

TEST_P(DriveControllerAtAStart, GivesTheCarItsTimeToMove) {
  bench.run_for(1s + GetParam() * 1ms);
  begin_trip();
  for (unsigned step = 1; step <= 40; ++step) {
    bench.run_for(20ms);
    // 1.2 m/s3: 600 mm/s by the square of the time, 2000 tenths of a millimetre by its cube.
    const double seconds = 0.02 * step;
    const auto velocity = static_cast<unsigned>(600 * seconds * seconds);
    const auto position = static_cast<unsigned>(2000 * seconds * seconds * seconds);
    char frame[48];
    std::snprintf(frame, sizeof frame, "185#37 02 %02X %02X 00 00", velocity & 0xFF, velocity >> 8);
    hear(frame);
    std::snprintf(frame, sizeof frame, "18C#%02X %02X 00 00", position & 0xFF, position >> 8);
    hear(frame);
    ASSERT_TRUE(controller().status().available) << seconds;
  }
}
INSTANTIATE_TEST_SUITE_P(BetweenItsLooks, DriveControllerAtAStart, testing::Range(0, 250, 2));

TEST_F(DriveControllerAtTheWire, TellsWhereTheCarCouldStopNext) {
  EXPECT_EQ(controller().status().stopping_position_micrometre, 0);
  hear("185#37 02 40 06 00 00");
  // From 1.6 m/s at 1 m/s2 with bends of 0.833 s.
  EXPECT_NEAR(controller().status().stopping_position_micrometre, 800'000 * (1.6 + 0.8333), 100);
  hear("185#37 02 C0 F9 FF FF");
  EXPECT_NEAR(controller().status().stopping_position_micrometre, -800'000 * (1.6 + 0.8333), 100);
}

// On a cable, with a drive and a car that follows it.

class DriveControllerOnACable : public testing::Test {
 protected:
  DriveControllerOnACable() {
    cable.connect(0, controller_device.node());
    cable.connect(1, drive_device.node());
    bench.connect(drive_device.node());
    cable.start_all();
    cable.send("000#01 00");
    report_position();
    cable.run_for(200ms);
  }
  CarDriveController& controller() { return controller_device.unit().controller(); }
  /// The test is the position unit: one frame every 50 ms.
  void report_position() {
    bench.now = cable.now;
    Frame frame = Frame::data_frame(0x18C, {});
    frame.length = 4;
    store(frame.data.data(), static_cast<std::int32_t>(std::lround(bench.sense().position)));
    cable.send(wire_text(frame));
    cable.send("704#05");
  }
  void run_for(Duration time) {
    for (Duration past{}; past < time; past += 20ms) {
      cable.run_for(20ms);
      report_position();
    }
  }
  void order(const std::function<void()>& command) {
    controller_device.node().advance(cable.now);
    command();
    cable.run_for(1us);
  }

  Cable cable;
  DriveBench bench;
  CarDriveControllerDevice<> controller_device{cable.port(0), 1};
  CarDriveDevice<> drive_device{cable.port(1), 2, bench.hardware()};
};

TEST_F(DriveControllerOnACable, TakesTheCarFromFloorToFloor) {
  for (const std::int32_t floor : {12'000'000, 3'000'000, 6'000'000, 0}) {
    order([&] { controller().travel_to(floor); });
    run_for(1s);
    EXPECT_FALSE(controller().status().standing);
    run_for(14s);
    EXPECT_TRUE(controller().status().arrived) << floor;
    EXPECT_EQ(controller().status().position_micrometre, floor);
    EXPECT_FALSE(bench.brake_released);
    EXPECT_FALSE(bench.power);
  }
}

TEST_F(DriveControllerOnACable, StopsOnItsWayWhereItWasToldInTime) {
  order([&] { controller().travel_to(12'000'000); });
  run_for(4s);
  const std::int32_t stopping = controller().status().stopping_position_micrometre;
  order([&] { controller().travel_to(stopping + 100'000); });
  run_for(12s);
  EXPECT_TRUE(controller().status().arrived);
  EXPECT_NEAR(controller().status().position_micrometre, stopping + 100'000, 600);
}

TEST_F(DriveControllerOnACable, ComesBackToATargetThatWasTooNear) {
  order([&] { controller().travel_to(12'000'000); });
  run_for(4s);
  order([&] { controller().travel_to(4'000'000); });
  run_for(25s);
  EXPECT_TRUE(controller().status().arrived);
  EXPECT_EQ(controller().status().position_micrometre, 4'000'000);
}

TEST_F(DriveControllerOnACable, RunsAndStopsAndTravelsAgain) {
  order([&] { controller().run(300'000); });
  run_for(5s);
  EXPECT_EQ(controller().status().velocity_micrometre_per_second, 300'000);
  order([&] { controller().stop(); });
  run_for(3s);
  EXPECT_TRUE(controller().status().standing);
  EXPECT_FALSE(controller().status().arrived);
  order([&] { controller().travel_to(3'000'000); });
  run_for(10s);
  EXPECT_TRUE(controller().status().arrived);
}

TEST_F(DriveControllerOnACable, HomesTheDrive) {
  bench.home_switch = -1'000;
  order([&] { controller().home(); });
  run_for(8s);
  EXPECT_TRUE(controller().has_homed());
  EXPECT_TRUE(controller().status().standing);
}

TEST_F(DriveControllerOnACable, GoesOnWhenAFaultOfTheDriveIsGone) {
  order([&] { controller().travel_to(12'000'000); });
  run_for(4s);
  bench.readings.fault = 0x4210;
  run_for(5s);
  EXPECT_FALSE(controller().status().available);
  EXPECT_EQ(drive_device.unit().state(), DriveState::fault);
  bench.readings.fault = 0;
  run_for(3s);
  EXPECT_TRUE(controller().status().available);
  order([&] { controller().travel_to(12'000'000); });
  run_for(14s);
  EXPECT_TRUE(controller().status().arrived);
}

TEST_F(DriveControllerOnACable, TheDriveStopsFastWhenTheControllerIsGoneAndObeysItAfterwards) {
  order([&] { controller().travel_to(30'000'000); });
  run_for(4s);
  cable.cut(0);
  run_for(5s);
  EXPECT_EQ(drive_device.unit().state(), DriveState::switch_on_disabled);
  EXPECT_FALSE(bench.brake_released);
  cable.cut(0, false);
  run_for(2s);
  order([&] { controller().travel_to(30'000'000); });
  run_for(25s);
  EXPECT_TRUE(controller().status().arrived);
}

TEST(DriveControllerInVelocityMode, GivesTheEndVelocityAtTheFloorSwitchAndThen0) {
  Cable cable;
  DriveBench bench;
  CarDriveControllerDevice<> controller(cable.port(0), 1,
                                        {.trip_mode = cia402::DriveMode::profile_velocity});
  CarDriveDevice<> drive(cable.port(1), 2, bench.hardware());
  cable.connect(0, controller.node());
  cable.connect(1, drive.node());
  bench.connect(drive.node());
  cable.start_all();
  cable.send("000#01 00");
  const auto run_for = [&](Duration time) {
    for (Duration past{}; past < time; past += 10ms) {
      cable.run_for(10ms);
      bench.now = cable.now;
      Frame frame = Frame::data_frame(0x18C, {});
      frame.length = 4;
      store(frame.data.data(), static_cast<std::int32_t>(std::lround(bench.sense().position)));
      cable.send(wire_text(frame));
    }
  };
  run_for(200ms);
  for (const std::int32_t floor : {12'000'000, 9'000'000}) {
    controller.node().advance(cable.now);
    controller.unit().controller().travel_to(floor);
    run_for(25s);
    EXPECT_TRUE(controller.unit().controller().status().arrived);
    EXPECT_NEAR(controller.unit().controller().status().position_micrometre, floor, 10'000)
        << "10 mm";
  }
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_controller_test
