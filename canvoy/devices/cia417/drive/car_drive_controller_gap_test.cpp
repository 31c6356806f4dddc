// Reactions of a car drive controller to lost PDOs: the state of the drive is requested by remote
// frame, and the next command follows from the answer (CiA 402, controlword and statusword; CiA
// 417-4, 4.11). Node 2 is the drive, 4 the position unit.
#include "canvoy/devices/cia417/drive/car_drive_controller_test.hpp"

namespace canvoy::cia417::car_drive_controller_gap_test {
namespace {

class DriveControllerInAGap : public DriveControllerAtTheWire {
 protected:
  /// Its own CAN controller was alone on a piece of cable, which is mended now.
  void mend() {
    bench.sent.clear();
    device.node().bus_state(BusState::error_passive, bench.now);
    device.node().bus_state(BusState::error_warning, bench.now);
    bench.run_for(20ms);
  }
  std::size_t count(std::string_view frame) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        bench.sent, [&](const Frame& sent) { return wire_text(sent) == frame; }));
  }
};

TEST_F(DriveControllerInAGap, AsksForTheStateOfDriveAndPositionUnit) {
  begin_trip();
  mend();
  EXPECT_EQ(count("181#R6"), 1u);
  EXPECT_EQ(count("185#R6"), 1u);
  EXPECT_EQ(count("18C#R4"), 1u);
}

/// The drive has lost its controller and stopped, and that PDO was lost.
TEST_F(DriveControllerInAGap, LeadsADriveThatHasStoppedMeanwhileToItsTargetFromTheBeginning) {
  begin_trip();
  mend();
  hear("181#50 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#06 00 E0 2E 00 00")) << "not 0Fh for ever";
  hear("181#31 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("602#2F 03 64 00 01 00 00 00")) << "its mode may be another one";
  hear("582#60 03 64 00 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#07 00 E0 2E 00 00"));
  hear("181#33 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#0F 00 E0 2E 00 00"));
  hear("181#37 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("180#2F 00 E0 2E 00 00"));
  bench.run_for(5ms);
  EXPECT_TRUE(bench.has_sent("180#3F 00 E0 2E 00 00")) << "the set-point of before is gone";
}

/// Its commands in the gap were not received.
TEST_F(DriveControllerInAGap, TellsItsCommandAgainWhenTheDriveHasAnswered) {
  begin_trip();
  order([&] { controller().stop(); });
  EXPECT_TRUE(bench.has_sent("180#07 00 E0 2E 00 00"));
  mend();
  EXPECT_EQ(count("180#07 00 E0 2E 00 00"), 0u);
  hear("181#37 12 00 00 00 00");
  EXPECT_EQ(count("180#07 00 E0 2E 00 00"), 1u);
  EXPECT_EQ(count("184#07 00 00 00 00 00"), 1u);
}

/// No sign at all: a command without its effect within its time is one.
TEST_F(DriveControllerInAGap, ADriveThatDoesNotDoWhatItIsToldIsAskedAndTold) {
  begin_trip();
  order([&] { controller().stop(); });
  bench.sent.clear();
  bench.run_for(750ms);
  EXPECT_GE(count("180#07 00 E0 2E 00 00"), 1u);
  EXPECT_GE(count("181#R6"), 1u);
}

/// The last PDO of a car that slowed down was lost, and so it seems to move for ever.
TEST_F(DriveControllerInAGap, ACarThatMovesWithoutPowerIsAskedHowFastItIs) {
  begin_trip();
  order([&] { controller().stop(); });
  hear("185#37 12 40 06 00 00");
  hear("181#33 02 00 00 00 00");
  EXPECT_FALSE(controller().status().standing);
  bench.sent.clear();
  bench.run_for(250ms);
  EXPECT_GE(count("185#R6"), 1u);
  hear("185#33 02 00 00 00 00");
  EXPECT_TRUE(controller().status().standing);
}

/// Its velocity is old, and not its position: no encoder is dead. How long the gap lasts then does
/// not matter.
TEST_F(DriveControllerInAGap, ACarThatStoodIsAvailableAsSoonAsItSaysThatItStands) {
  begin_trip();
  order([&] { controller().stop(); });
  hear("185#37 12 40 06 00 00");
  hear("181#33 02 00 00 00 00");
  bench.sent.clear();
  bench.run_for(2s);
  ASSERT_FALSE(controller().status().available) << "it moves, and its position stands";
  EXPECT_GE(count("185#R6"), 1u);
  EXPECT_GE(count("18C#R4"), 1u);
  hear("185#33 02 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
}

TEST_F(DriveControllerInAGap, APositionThatStandsIsAskedForUntilItMoves) {
  begin_trip();
  hear("185#37 12 40 06 00 00");
  bench.run_for(1s);
  ASSERT_FALSE(controller().status().available);
  hear("185#17 02 40 06 00 00");
  hear("185#50 02 00 00 00 00");
  hear("181#50 02 00 00 00 00");
  EXPECT_FALSE(controller().status().available) << "it did move";
  bench.sent.clear();
  bench.run_for(1s);
  EXPECT_GE(count("18C#R4"), 3u);
  hear("18C#C0 D4 01 00");
  EXPECT_TRUE(controller().status().available);
}

TEST_F(DriveControllerInAGap, AWayHomeThatDoesNotBeginEnds) {
  order([&] { controller().home(); });
  hear("181#31 02 00 00 00 00");
  hear("582#60 03 64 00 00 00 00 00");
  hear("181#33 02 00 00 00 00");
  hear("181#37 02 00 00 00 00");
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::home);
  bench.run_for(3900ms);
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::home);
  bench.run_for(400ms);
  EXPECT_EQ(controller().aim(), CarDriveController::Aim::none);
}

// Behind the last floors are limit switches (EN 81-20, 5.12.2).

class DriveControllerBetweenFloors : public testing::Test {
 protected:
  DriveControllerBetweenFloors() {
    bench.boot(device.node());
    hear("18C#00 00 00 00");
    hear("185#50 02 00 00 00 00");
    bench.sent.clear();
    device.node().advance(bench.now);
    device.unit().controller().travel_to(12'000'000);
    bench.settle();
    for (const char* step : {"181#31 02 00 00 00 00", "582#60 03 64 00 00 00 00 00",
                             "181#33 02 00 00 00 00", "181#37 02 00 00 00 00"}) {
      hear(step);
    }
    bench.run_for(5ms);
    hear("181#37 12 00 00 00 00");
  }
  void hear(std::string_view frame) {
    bench.sent.clear();
    bench.send(frame);
  }

  DriveBench bench;
  CarDriveControllerDevice<> device{
      bench.port(), 1, {.lowest_micrometre = 0, .highest_micrometre = 12'000'000}};
};

/// From 400 mm/s it stops within 80 mm at 1 m/s2; it is detected 32 mm late, and may be wrong by
/// 30.
TEST_F(DriveControllerBetweenFloors, StopsFastWhereItWouldPassTheLastFloor) {
  hear("18C#2C D3 01 00");  // 11,959.6 mm
  hear("185#37 12 90 01 00 00");
  EXPECT_FALSE(bench.has_sent("180#02 00 E0 2E 00 00"));
  hear("18C#58 D4 01 00");  // 11,989.6 mm: 69.6 mm past it
  EXPECT_TRUE(bench.has_sent("180#02 00 E0 2E 00 00")) << "quick stop";
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_controller_gap_test
