// Automatic reactions of a car door: 6304h in every mode and with every timer (CiA 417-4, 4.7.3).
#include "canvoy/devices/cia417/door/car_door_modes_test.hpp"

namespace canvoy::cia417::car_door_modes_test {
namespace {

// Values.

TEST_F(CarDoorModes, ModesThatAreReservedAreRefused) {
  // The highest that each takes; profiles are those that this door has.
  constexpr unsigned highest[] = {0, 0, 3, 2, 2, 2, 2, 255, 255, 255, 2};
  for (unsigned sub = 1; sub <= 0x0B; ++sub) {
    for (unsigned value = 0; value <= 0xFF; ++value) {
      write(0x6304, sub, value);
      char refused[40];
      std::snprintf(refused, sizeof refused, "586#80 04 63 %02X 30 00 09 06", sub);
      char done[40];
      std::snprintf(done, sizeof done, "586#60 04 63 %02X 00 00 00 00", sub);
      EXPECT_EQ(cable.last(0x586), value <= highest[sub - 1] ? done : refused) << value;
    }
  }
}

TEST_F(CarDoorModes, ProfilesThatTheDoorHasReachItsDrive) {
  Cable other;
  DoorBench wide;
  CarDoorDevice<> device(other.port(0), 6, {wide.hardware()},
                         {.velocity_profiles = 3, .width_profiles = 2});
  other.connect(0, device.node());
  other.start_all();
  other.send("606#2F 04 63 01 02 00 00 00");
  other.send("606#2F 04 63 02 01 00 00 00");
  other.send("606#2F 04 63 01 03 00 00 00");
  EXPECT_EQ(other.last(0x586), "586#80 04 63 01 30 00 09 06");
  other.send("000#01 06");
  other.send("200#FF 4F FF FF FF FF FF FF");
  EXPECT_EQ(wide.driven.velocity_profile, 2);
  EXPECT_EQ(wide.driven.width_profile, 1);
}

// Light barrier.

TEST_F(CarDoorModes, LightBarrier0OnlyTells) {
  close_for_a_second();
  see(Detection::yes);
  cable.run_for(2s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorModes, LightBarrier1ReOpens) {
  set(light_barrier, 1);
  close_for_a_second();
  see(Detection::yes);
  EXPECT_EQ(cable.last(0x201), "201#00 60 58 02") << "re-opening, from 600 mm";
  cable.run_for(1s);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  see(Detection::no);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_with_torque) << "6304h:08h is 0: the timer is disabled";
}

TEST_F(CarDoorModes, LightBarrier2Stops) {
  set(light_barrier, 2);
  close_for_a_second();
  see(Detection::yes);
  EXPECT_EQ(state(), DoorState::stopped);
  EXPECT_TRUE(bench.driven.has_torque);
  see(Detection::no);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::stopped);
}

TEST_F(CarDoorModes, AClosedOrOpeningDoorDoesNotCareForTheLightBarrier) {
  for (unsigned mode = 0; mode <= 2; ++mode) {
    set(light_barrier, mode);
    see(Detection::yes);
    EXPECT_TRUE(is_closed(state()));
    see(Detection::no);
  }
  command(0x4);
  cable.run_for(1s);
  see(Detection::yes);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoorModes, TheDoorClosesAgainSoManySecondsAfterTheLightBarrierIsFree) {
  set(light_barrier, 1);
  set(barrier_reclose, 5);
  close_for_a_second();
  see(Detection::yes);
  cable.run_for(20s);
  EXPECT_EQ(state(), DoorState::opened_with_torque) << "somebody stands in it";
  see(Detection::no);
  expect_closing_after(5s);
  EXPECT_FALSE(bench.driven.is_reduced);
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorModes, TheNextPassengerBeginsTheTimeAnew) {
  let_one_pass(5);
  cable.run_for(4s);
  see(Detection::yes);
  see(Detection::no);
  expect_closing_after(5s);
}

TEST_F(CarDoorModes, ACommandEndsTheTime) {
  set(light_barrier, 1);
  set(barrier_reclose, 5);
  close_for_a_second();
  see(Detection::yes);
  see(Detection::no);
  cable.run_for(2s);
  command(0x4);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(CarDoorModes, ALightBarrierThatBreaksTurnsTheDoorAndItClosesSlowlyAfterTwiceTheSeconds) {
  set(light_barrier, 1);
  set(barrier_reclose, 1);
  set(broken_reclose, 5);
  close_for_a_second();
  see(Detection::error);
  EXPECT_EQ(state(), DoorState::re_opening);
  cable.run_for(1s);
  ASSERT_EQ(state(), DoorState::opened_with_torque);
  expect_closing_after(10s);  // 2 s a bit
  EXPECT_TRUE(bench.driven.is_reduced);
  cable.run_for(6s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorModes, WithoutThatTimeADoorWithABrokenLightBarrierStaysOpen) {
  set(light_barrier, 1);
  set(barrier_reclose, 1);
  close_for_a_second();
  see(Detection::error);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  command(0xF);
  command(0x1);
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::closed_with_torque) << "but it can be closed by command";
}

TEST_F(CarDoorModes, AtReducedSpeedTheLightBarrierTurnsNothing) {
  set(light_barrier, 1);
  open();
  see(Detection::yes);
  cable.send("200#FF 17 FF FF FF FF FF FF");
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(6s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorModes, TheLightBarrierMayBeADeviceOfItsOwn) {
  set(light_barrier, 1);
  close_for_a_second();
  cable.send("205#7F");
  EXPECT_EQ(state(), DoorState::re_opening);
  cable.run_for(1s);
  command(0x4);
  command(0x1);
  EXPECT_EQ(state(), DoorState::opened_with_torque) << "somebody still stands there";
  cable.send("205#3F");
  command(0x4);
  command(0x1);
  EXPECT_EQ(state(), DoorState::closing);
}

TEST_F(CarDoorModes, ALightBarrierOfWhichTheHeartbeatIsLostIsBroken) {
  Cable other;
  DoorBench watched;
  CarDoorDevice<> device(other.port(0), 6, {watched.hardware()}, {.light_barrier = 9});
  other.connect(0, device.node());
  other.start_all();
  other.send("606#2F 04 63 04 01 00 00 00");
  other.send("606#2F 04 63 0A 03 00 00 00");
  other.send("606#23 16 10 01 E8 03 09 00");
  other.send("000#01 06");
  other.send("205#3F");
  other.send("709#05");
  other.send("200#FF 4F FF FF FF FF FF FF");
  other.run_for(500ms);
  other.send("200#FF 1F FF FF FF FF FF FF");
  other.send("709#05");
  other.run_for(0s);
  ASSERT_EQ(device.unit().state(), DoorState::closing);
  other.send("200#FF 4F FF FF FF FF FF FF");
  other.run_for(900ms);
  other.send("200#FF 1F FF FF FF FF FF FF");
  other.run_for(100ms);
  EXPECT_EQ(device.unit().state(), DoorState::re_opening) << "nobody watches the door any more";
  other.run_for(2s);
  ASSERT_EQ(device.unit().state(), DoorState::opened_with_torque);
  other.run_for(6s);
  EXPECT_EQ(device.unit().state(), DoorState::closing);
  EXPECT_TRUE(watched.driven.is_reduced);
}

// Force limit.

TEST_F(CarDoorModes, ForceLimit0OnlyTells) {
  close_for_a_second();
  push(true);
  EXPECT_EQ(cable.last(0x201), "201#00 24 58 02");
  cable.run_for(10s);
  EXPECT_EQ(state(), DoorState::closing) << "it goes on pushing";
}

TEST_F(CarDoorModes, ForceLimit1ReOpensAndClosesAgainAfterItsTime) {
  set(force_limit, 1);
  set(force_reclose, 3);
  close_for_a_second();
  push(true);
  EXPECT_EQ(state(), DoorState::re_opening);
  push(false);
  cable.run_for(1s);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  expect_closing_after(3s);
}

TEST_F(CarDoorModes, ForceLimit1WithoutItsTimeStaysOpen) {
  set(force_limit, 1);
  set(barrier_reclose, 1);
  close_for_a_second();
  push(true);
  push(false);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(CarDoorModes, ForceLimit2Stops) {
  set(force_limit, 2);
  close_for_a_second();
  push(true);
  EXPECT_EQ(state(), DoorState::stopped);
  push(false);
  command(0x4);
  cable.run_for(100ms);
  push(true);
  EXPECT_EQ(state(), DoorState::stopped) << "while opening, too";
}

TEST_F(CarDoorModes, ForceLimit1HasNothingToReOpenWhileOpening) {
  set(force_limit, 1);
  command(0x4);
  cable.run_for(1s);
  push(true);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoorModes, WithoutLimitForceItPushesOn) {
  set(force_limit, 1);
  open();
  command(0x0);
  cable.run_for(1s);
  push(true);
  EXPECT_EQ(state(), DoorState::closing);
}

// Motion detection.

TEST_F(CarDoorModes, Motion0OnlyTells) {
  close_for_a_second();
  move(true);
  EXPECT_EQ(cable.last(0x201), "201#00 21 58 02");
}

TEST_F(CarDoorModes, Motion1ReOpensAsLongAsThereIsMotion) {
  set(motion_detection, 1);
  close_for_a_second();
  move(true);
  EXPECT_EQ(state(), DoorState::re_opening);
  cable.run_for(500ms);
  move(false);
  EXPECT_EQ(state(), DoorState::closing);
  move(true);
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
  move(false);
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorModes, Motion2Stops) {
  set(motion_detection, 2);
  close_for_a_second();
  move(true);
  EXPECT_EQ(state(), DoorState::stopped);
}

TEST_F(CarDoorModes, AMotionDetectorThatIsDisabledTurnsNothing) {
  set(motion_detection, 1);
  open();
  cable.send("200#FF 1D FF FF FF FF FF FF");
  cable.run_for(1s);
  move(true);
  EXPECT_EQ(state(), DoorState::closing);
}

// Finger protector.

TEST_F(CarDoorModes, Finger0OnlyTells) {
  command(0x4);
  cable.run_for(1s);
  pinch(true);
  EXPECT_EQ(cable.last(0x201), "201#40 50 2C 01");
}

TEST_F(CarDoorModes, Finger1ClosesAsLongAsThereIsAFinger) {
  set(finger_protector, 1);
  command(0x4);
  cable.run_for(1s);
  pinch(true);
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(500ms);
  EXPECT_EQ(bench.position_mm, 150);
  pinch(false);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_for(2500ms);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(CarDoorModes, Finger2Stops) {
  set(finger_protector, 2);
  command(0x4);
  cable.run_for(1s);
  pinch(true);
  EXPECT_EQ(state(), DoorState::stopped);
}

TEST_F(CarDoorModes, AFingerProtectorThatIsDisabledTurnsNothing) {
  set(finger_protector, 1);
  cable.send("200#7F 4F FF FF FF FF FF FF");
  cable.run_for(1s);
  pinch(true);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoorModes, WhileClosingAFingerIsOnlyTold) {
  for (unsigned mode = 0; mode <= 2; ++mode) {
    set(finger_protector, mode);
    close_for_a_second();
    pinch(true);
    EXPECT_EQ(state(), DoorState::closing);
    pinch(false);
  }
}

// The controller is lost.

// Doors 2 to 4.

TEST(CarDoorConfiguration, OfEachDoorStandsInAnObjectOfItsOwn) {
  static constexpr LiftDeviceOptions all_doors = {.doors = 0b1111, .parts = 128};
  for (unsigned number = 1; number <= 4; ++number) {
    Cable cable;
    std::array<DoorBench, 4> benches;
    CarDoorDevice<all_doors> device(cable.port(0), 6,
                                    {benches[0].hardware(), benches[1].hardware(),
                                     benches[2].hardware(), benches[3].hardware()});
    cable.connect(0, device.node());
    cable.start_all();
    char text[40];
    std::snprintf(text, sizeof text, "606#2F %02X 63 04 02 00 00 00", 0x03 + number);
    cable.send(text);
    EXPECT_EQ(cable.last(0x586).substr(0, 6), "586#60");
    cable.send("000#01 06");
    cable.send("200#FF 4F FF 4F FF 4F FF 4F");
    cable.run_for(3s);
    cable.send("200#FF 1F FF 1F FF 1F FF 1F");
    cable.run_for(1s);
    for (DoorBench& bench : benches) bench.light_barrier = Detection::yes;
    cable.run_for(100ms);
    for (unsigned door = 1; door <= 4; ++door) {
      const DoorState state = device.unit().door(door - 1).state();
      EXPECT_EQ(state, door == number ? DoorState::stopped : DoorState::closing)
          << "mode 2 of door " << number << ", seen by door " << door;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::car_door_modes_test
