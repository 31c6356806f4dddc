// Emergencies of others at a device that is a car drive controller and nothing else (CiA 301, 7.2.7
// and 1028h; CiA 417-1, emergency codes). Node 2 is the drive, 4 the position unit.
#include <string>

#include "canvoy/devices/cia417/drive/car_drive_controller_test.hpp"

namespace canvoy::cia417::car_drive_controller_errors_test {
namespace {

using Aim = CarDriveController::Aim;

class DriveControllerErrors : public DriveControllerAtTheWire {
 protected:
  /// The quick stop of the trip that the drive is on.
  static constexpr const char* quick_stop = "180#02 00 E0 2E 00 00";
  /// What the drive does about it.
  void stand() {
    hear("181#17 02 00 00 00 00");
    hear("181#50 02 00 00 00 00");
  }
  bool is_commanded() const {
    return std::ranges::any_of(bench.sent, [](const Frame& frame) {
      return frame.id == 0x180 && frame.data[0] != 0 && frame.data[0] != 0x02;
    });
  }
};

class StoppingError : public DriveControllerErrors,
                      public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(OverspeedAndUnintendedMovement, StoppingError,
                         testing::Values("082#05 FF", "082#06 FF", "084#05 FF", "084#06 FF"));

TEST_P(StoppingError, StopsTheDriveFastAtOnceUntilItHasGone) {
  const std::string error = GetParam();
  begin_trip();
  hear(error + " 01 00 00 00 00 00");
  EXPECT_TRUE(bench.has_sent(quick_stop));
  EXPECT_FALSE(controller().status().available);
  stand();
  hear(error.substr(0, 4) + "00 00 00 00 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
  order([&] { controller().travel_to(1'000'000); });
  EXPECT_TRUE(bench.has_sent("180#06 00 E0 2E 00 00")) << "it obeys again";
}

TEST_F(DriveControllerErrors, ACarThatStandsDoesNotStartBeforeTheErrorHasGone) {
  hear("084#05 FF 01 00 00 00 00 00");
  order([&] { controller().travel_to(12'000'000); });
  EXPECT_EQ(controller().aim(), Aim::none);
  bench.run_for(60s);
  EXPECT_FALSE(is_commanded());
  hear("084#00 00 01 00 00 00 00 00");
  EXPECT_FALSE(controller().status().available)
      << "another one has gone: its register is not empty";
  hear("084#00 00 00 00 00 00 00 00");
  bench.run_for(60s);
  EXPECT_FALSE(is_commanded()) << "who released it commands anew";
  order([&] { controller().travel_to(12'000'000); });
  EXPECT_TRUE(bench.has_sent("180#06 00 00 00 00 00"));
}

TEST_F(DriveControllerErrors, OneOfTwoErrorsHoldsItAsWell) {
  hear("082#06 FF 01 00 00 00 00 00");
  hear("084#05 FF 01 00 00 00 00 00");
  hear("082#00 00 00 00 00 00 00 00");
  EXPECT_FALSE(controller().status().available);
  hear("084#00 00 00 00 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
}

TEST_F(DriveControllerErrors, WhatSaysNothingOfTheCarStopsNoTrip) {
  begin_trip();
  for (const char* error : {"084#10 00 11 00 00 00 00 00", "084#11 31 05 00 00 00 00 00",
                            "082#30 81 11 00 00 00 00 00", "085#05 FF 01 00 00 00 00 00"}) {
    hear(error);
    EXPECT_FALSE(bench.has_sent(quick_stop)) << error;
  }
  EXPECT_EQ(controller().aim(), Aim::trip);
}

TEST_F(DriveControllerErrors, ItHearsWhoIsWrittenInto1028h) {
  hear("601#40 28 10 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#43 28 10 02 82 00 00 00"));
  hear("601#40 28 10 04 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#43 28 10 04 84 00 00 00"));
  hear("601#40 28 10 05 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#43 28 10 05 00 00 00 80")) << "nobody";
  hear("601#23 28 10 05 85 00 00 00");
  begin_trip();
  hear("085#05 FF 01 00 00 00 00 00");
  EXPECT_TRUE(bench.has_sent(quick_stop)) << "a second position unit";
  stand();
  hear("601#23 28 10 04 00 00 00 80");
  hear("085#00 00 00 00 00 00 00 00");
  hear("084#05 FF 01 00 00 00 00 00");
  EXPECT_TRUE(controller().status().available) << "node 4 is not heard any more";
}

TEST_F(DriveControllerErrors, AUnitThatBootsOrIsLostHoldsItNoLonger) {
  hear("704#05");
  hear("084#05 FF 01 00 00 00 00 00");
  hear("704#00");
  EXPECT_FALSE(controller().status().available) << "where the car is, it has not said since";
  hear("18C#00 00 00 00");
  EXPECT_TRUE(controller().status().available);
  hear("084#05 FF 01 00 00 00 00 00");
  bench.run_for(1500ms);
  EXPECT_FALSE(controller().status().available) << "now it is lost";
  hear("704#05");
  hear("18C#00 00 00 00");
  EXPECT_TRUE(controller().status().available);
}

TEST_F(DriveControllerErrors, WhatItsPositionUnitHadBeforeItIsAskedFor) {
  hear("000#81 01");
  hear("000#01 01");
  EXPECT_TRUE(bench.has_sent("604#40 01 10 00 00 00 00 00")) << "its error register";
  hear("18C#00 00 00 00");
  hear("185#50 02 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
  hear("584#4F 01 10 00 01 00 00 00");
  EXPECT_FALSE(controller().status().available);
}

TEST_F(DriveControllerErrors, ItGoesToAnotherLiftWhileTheCarStandsAlone) {
  begin_trip();
  hear("601#2F 01 60 00 02 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#80 01 60 00 22 00 00 08")) << "of the present device state";
  order([&] { controller().fast_stop(); });
  hear("601#2F 01 60 00 02 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#80 01 60 00 22 00 00 08")) << "it is still stopping";
  stand();
  hear("601#2F 01 60 00 02 00 00 00");
  EXPECT_TRUE(bench.has_sent("581#60 01 60 00 00 00 00 00"));
  EXPECT_FALSE(controller().status().available) << "nothing is known of the drive of lift 2";
  hear("19C#00 00 00 00");
  hear("195#50 02 00 00 00 00");
  EXPECT_TRUE(controller().status().available);
}

TEST(DriveControllerOfOthers, HearsAndWatchesTheNodesOfItsSettings) {
  DriveBench bench;
  CarDriveControllerDevice<> device(bench.port(), 1, {.drive = 30, .position_unit = 31});
  bench.boot(device.node());
  for (const unsigned sub : {30U, 31U}) {
    EXPECT_EQ(device.node().dictionary().number(0x1028, static_cast<std::uint8_t>(sub)),
              0x80U + sub);
  }
  EXPECT_EQ(device.node().dictionary().number(0x1016, 1), 0x001E'05DCU) << "1500 ms";
  EXPECT_EQ(device.node().dictionary().number(0x1016, 2), 0x001F'05DCU);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_controller_errors_test
