// A car that follows a drive by its messages on the bus.
#include "canvoy/worlds/lift/car_follower.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"

namespace canvoy::lift::car_follower_test {
namespace {

class FollowedCar : public testing::Test {
 protected:
  Time read_clock() { return now; }
  void hear(std::string_view frame) { car.hear(wire_frame(frame)); }
  Time now{};
  CarFollower car{1, callback<&FollowedCar::read_clock>(*this)};
};

TEST_F(FollowedCar, MovesAsFastAsTheDriveSays) {
  hear("185#37 02 E8 03 00 00");
  now += 1500ms;
  EXPECT_DOUBLE_EQ(car.position_mm(), 1500);
  hear("185#37 02 18 FC FF FF");
  now += 500ms;
  EXPECT_DOUBLE_EQ(car.position_mm(), 1000);
  EXPECT_EQ(car.velocity_mm_s(), -1000);
}

TEST_F(FollowedCar, TakesTheStraightLineBetweenVelocitiesThatFollowClosely) {
  for (int i = 1; i <= 5; ++i) {
    now += 20ms;
    Frame frame = wire_frame("185#37 02 00 00 00 00");
    frame.data[2] = static_cast<std::uint8_t>(20 * i);
    car.hear(frame);
  }
  // 1 m/s2 for 0.1 s.
  EXPECT_NEAR(car.position_mm(), 5, 1e-9);
}

TEST_F(FollowedCar, StandsAtTheTargetWhenTheDriveSaysSo) {
  hear("180#1F 00 E8 03 00 00");
  hear("185#37 12 E8 03 00 00");
  now += 990ms;
  hear("185#37 02 02 00 00 00");
  EXPECT_NEAR(car.position_mm(), 990, 1e-9);
  hear("185#37 02 00 00 00 00");
  EXPECT_EQ(car.position_mm(), 1000);
}

TEST_F(FollowedCar, StandsAtTheTargetAsSoonAsItCountsAsStanding) {
  hear("180#1F 00 E8 03 00 00");
  hear("185#37 12 E8 03 00 00");
  now += 950ms;
  hear("185#37 02 01 00 00 00");
  EXPECT_EQ(car.position_mm(), 1000) << "at 1 mm/s it is told to have stopped: not between floors";
}

TEST_F(FollowedCar, StandsWhereItIsBeforeItLeavesForATargetThatIsNear) {
  hear("180#1F 00 32 00 00 00");
  hear("185#37 12 00 00 00 00");
  EXPECT_EQ(car.position_mm(), 0);
  hear("181#37 06 00 00 00 00");
  EXPECT_EQ(car.position_mm(), 50) << "it says that it is there";
}

TEST_F(FollowedCar, StandsWhereAQuickStopHasStoppedIt) {
  hear("180#1F 00 E8 03 00 00");
  hear("185#37 12 E8 03 00 00");
  now += 950ms;
  hear("185#17 02 00 00 00 00");
  EXPECT_NEAR(car.position_mm(), 950, 1e-9);
}

TEST_F(FollowedCar, DoesNotJumpToATargetThatIsFarAway) {
  hear("180#1F 00 E8 03 00 00");
  hear("181#37 06 00 00 00 00");
  EXPECT_EQ(car.position_mm(), 0) << "halted, say";
}

TEST_F(FollowedCar, StandsWhereTheDriveWasHeardLast) {
  hear("185#37 02 E8 03 00 00");
  now += 1s;
  hear("702#05");
  now += 10s;
  EXPECT_EQ(car.velocity_mm_s(), 0);
  EXPECT_DOUBLE_EQ(car.position_mm(), 1000);
}

TEST_F(FollowedCar, LivesThroughFramesOfAnyKind) {
  for (const char* frame : {"185#", "185#37", "185#R", "00000185#37 02 E8 03 00 00", "181#FF FF",
                            "180#FF FF FF FF FF FF", "7FF#00", "000#01 00"}) {
    hear(frame);
  }
  EXPECT_EQ(car.position_mm(), 0);
}

TEST(FollowedCarOnABus, BringsTheCarToEachFloorForAPositionUnitOfItsOwn) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = 250'000});
  const std::array<SlotIndex, 3> slots{world.add_slot(bus), world.add_slot(bus),
                                       world.add_slot(bus)};
  const auto clock = Callback<Time()>::to<&World::now>(world);
  CarPlant plant({}, clock);
  CarFollower follower(1, clock);
  cia417::CarDriveControllerDevice<> controller(world.port(slots[0]), 1);
  cia417::CarDriveDevice<> drive(world.port(slots[1]), 2, plant.drive_hardware());
  cia417::CarPositionDevice<layout_of<cia417::CarPositionKind<>>, 4> position(
      world.port(slots[2]), 4, follower.position_hardware());
  auto heard = [&](const Frame& frame, Time) { follower.hear(frame); };
  constexpr std::array<std::uint16_t, 4> of_drive = {0x180, 0x181, 0x185, 0x702};
  for (const std::uint16_t id : of_drive) {
    position.node().router().add(id, Router::Receiver::of(heard));
  }
  Node* nodes[] = {&controller.node(), &drive.node(), &position.node()};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    world.occupy(slots[i], *nodes[i]);
    world.start(slots[i]);
  }
  world.run_for(100ms);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    nodes[i]->command(NmtCommand::start);
    world.touched(slots[i]);
  }
  world.run_for(500ms);
  for (const std::int32_t floor : {10'500'000, 3'500'000, 28'000'000, 0}) {
    controller.node().advance(world.now());
    controller.unit().controller().travel_to(floor);
    world.touched(slots[0]);
    world.run_for(5s);
    EXPECT_NEAR(follower.position_mm(), plant.truth().position_m * 1000, 20);
    world.run_for(20s);
    EXPECT_TRUE(controller.unit().controller().status().arrived);
    EXPECT_EQ(controller.unit().controller().status().position_micrometre, floor);
  }
}

}  // namespace
}  // namespace canvoy::lift::car_follower_test
