// A car door unit at its wire: controlwords in, statuswords and positions out, at exact virtual
// times. The words are typed from the tables of CiA 417-4, 4.6.1 and 4.7.1.
#include "canvoy/devices/cia417/door/car_door_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/door/car_door_unit_test.hpp"

namespace canvoy::cia417::car_door_unit_test {
namespace {

class CarDoor : public CarDoorTest {};

TEST_F(CarDoor, TellsWhereItIsWhenItBecomesOperational) {
  EXPECT_EQ(cable.last(0x201), "201#11 10 00 00")
      << "closed without torque, locked, contact closed";
}

TEST_F(CarDoor, OpensWithLimitedForceAndTellsItsWay) {
  cable.clear();
  cable.send("200#FF 4F FF FF FF FF FF FF");
  EXPECT_EQ(cable.last(0x201), "201#01 50 00 00") << "opening; no longer locked";
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(0x201), "201#00 50 1E 00") << "30 mm, contact open";
  cable.run_for(2899ms);
  EXPECT_EQ(cable.last(0x201), "201#00 50 66 03") << "29 x 30 mm";
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x201), "201#00 30 84 03") << "opened with torque, at once";
  EXPECT_EQ(cable.count(0x201), 31u);
  cable.run_for(1h);
  EXPECT_EQ(cable.count(0x201), 31u) << "nothing more to tell";
}

TEST_F(CarDoor, ClosesLocksAndClosesItsSafetyContact) {
  open();
  cable.send("200#FF 1F FF FF FF FF FF FF");
  EXPECT_EQ(cable.last(0x201), "201#00 20 84 03");
  EXPECT_TRUE(bench.driven.limits_force);
  cable.run_for(3s);
  EXPECT_EQ(cable.last(0x201), "201#11 00 00 00") << "closed with torque, locked, contact closed";
}

TEST_F(CarDoor, MovesWithFullForceWhereTheCommandSaysSo) {
  command(0x3);
  EXPECT_EQ(state(), DoorState::opening);
  EXPECT_FALSE(bench.driven.limits_force);
  command(0x4);
  EXPECT_TRUE(bench.driven.limits_force);
  cable.run_for(1s);
  command(0x0);
  EXPECT_EQ(state(), DoorState::closing);
  EXPECT_FALSE(bench.driven.limits_force);
}

TEST_F(CarDoor, AtReducedSpeedItTakesTwiceAsLong) {
  cable.send("200#FF 47 FF FF FF FF FF FF");
  cable.run_for(5999ms);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(CarDoor, ItsSpeedCanChangeOnTheWay) {
  cable.send("200#FF 4F FF FF FF FF FF FF");
  cable.run_for(1s);
  cable.send("200#FF 47 FF FF FF FF FF FF");
  EXPECT_TRUE(bench.driven.is_reduced);
  cable.send("200#FF 4F FF FF FF FF FF FF");
  EXPECT_TRUE(bench.driven.is_reduced) << "do not care";
  cable.send("200#FF 4B FF FF FF FF FF FF");
  EXPECT_TRUE(bench.driven.is_reduced) << "10b is reserved";
  cable.send("200#FF 43 FF FF FF FF FF FF");
  EXPECT_FALSE(bench.driven.is_reduced);
}

/// "Take no action" leaves a door unchanged: another word is a command (4.6.1).
TEST_F(CarDoor, ADoorThatStoppedByItselfStaysWhereItIsUntilItIsCommanded) {
  command(0x4);
  cable.run_for(1s);
  bench.is_blocked = true;
  unit().hardware_changed();
  write(0x6304, 4, 2);
  bench.light_barrier = Detection::yes;
  command(0x1);
  EXPECT_EQ(state(), DoorState::stopped) << "the light barrier stops it";
  bench.light_barrier = Detection::no;
  cable.send("200#FF FF FF FF 00 00 00 00");
  EXPECT_EQ(state(), DoorState::stopped) << "the words of other doors changed";
  command(0x1);
  EXPECT_EQ(state(), DoorState::closing);
}

TEST_F(CarDoor, ACommandBySdoIsAlwaysObeyed) {
  order_by_sdo(0x7FFF);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
  order_by_sdo(0x4FFF);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_for(1s);
  write(0x6304, 4, 2);
  order_by_sdo(0x1FFF);
  bench.light_barrier = Detection::yes;
  changed();
  EXPECT_EQ(state(), DoorState::stopped);
  bench.light_barrier = Detection::no;
  order_by_sdo(0x1FFF);
  EXPECT_EQ(state(), DoorState::closing);
}

TEST_F(CarDoor, DoesNotHearTheWordsOfOtherDoors) {
  cable.send("200#FF FF FF 4F FF 4F FF 4F");
  EXPECT_EQ(state(), DoorState::closed_without_torque);
}

TEST_F(CarDoor, ALockThatIsDisabledStaysOpen) {
  cable.send("200#DF FF FF FF FF FF FF FF");
  EXPECT_FALSE(bench.is_locked);
  EXPECT_EQ(cable.last(0x201), "201#01 10 00 00");
  cable.send("200#EF FF FF FF FF FF FF FF");
  EXPECT_FALSE(bench.is_locked) << "10b is reserved";
  cable.send("200#CF FF FF FF FF FF FF FF");
  EXPECT_TRUE(bench.is_locked);
}

TEST_F(CarDoor, ADoorThatIsOpenDoesNotLock) {
  open();
  cable.send("200#CF 4F FF FF FF FF FF FF");
  EXPECT_FALSE(bench.is_locked);
}

TEST_F(CarDoor, DetectorsThatAreDisabledAreNotAvailable) {
  bench.motion = Detection::yes;
  bench.finger = Detection::yes;
  changed();
  EXPECT_EQ(cable.last(0x201), "201#51 11 00 00");
  cable.send("200#FF FD FF FF FF FF FF FF");
  EXPECT_EQ(cable.last(0x201), "201#51 13 00 00");
  cable.send("200#7F FD FF FF FF FF FF FF");
  EXPECT_EQ(cable.last(0x201), "201#D1 13 00 00");
  cable.send("200#3F FC FF FF FF FF FF FF");
  EXPECT_EQ(cable.last(0x201), "201#51 11 00 00");
}

TEST_F(CarDoor, TakesItsPowerFromTheBatteryWhereItIsTold) {
  cable.send("200#F7 FF FF FF FF FF FF FF");
  EXPECT_TRUE(bench.uses_battery);
  EXPECT_EQ(cable.last(0x201), "201#15 10 00 00");
  cable.send("200#FB FF FF FF FF FF FF FF");
  EXPECT_TRUE(bench.uses_battery) << "10b is reserved";
  cable.send("200#F3 FF FF FF FF FF FF FF");
  EXPECT_FALSE(bench.uses_battery);
}

TEST_F(CarDoor, EachReadingStandsInItsBits) {
  bench.force_limit = Detection::error;
  changed();
  EXPECT_EQ(word(), 0x1811);
  bench.force_limit = Detection::not_available;
  changed();
  EXPECT_EQ(word(), 0x1C11);
  bench.force_limit = Detection::yes;
  bench.motion = Detection::error;
  bench.finger = Detection::not_available;
  changed();
  EXPECT_EQ(word(), 0x16D1);
}

TEST_F(CarDoor, DefectsAreTold) {
  bench.finger = Detection::error;
  changed();
  EXPECT_EQ(cable.last(0x086), "086#02 FF 01 01 00 00 00 00");
  bench.motion = Detection::error;
  changed();
  EXPECT_EQ(cable.last(0x086), "086#03 FF 01 01 00 00 00 00");
  bench.finger = Detection::no;
  bench.motion = Detection::no;
  changed();
  EXPECT_EQ(cable.last(0x086), "086#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable.count(0x086), 4u);
}

TEST_F(CarDoor, ADriveThatFailsIsAnErrorUntilItIsReset) {
  command(0x4);
  cable.run_for(1s);
  bench.has_fault = true;
  changed();
  EXPECT_EQ(cable.last(0x201), "201#00 E0 2C 01");
  EXPECT_EQ(cable.last(0x086), "086#04 FF 01 01 00 00 00 00");
  EXPECT_EQ(bench.driven.motion, DoorDrive::Motion::none);
  EXPECT_FALSE(bench.driven.has_torque);
  command(0xE);
  EXPECT_EQ(state(), DoorState::error) << "the fault is there";
  bench.has_fault = false;
  command(0x4);
  EXPECT_EQ(state(), DoorState::error);
  command(0xE);
  EXPECT_EQ(state(), DoorState::stopped);
  EXPECT_EQ(cable.last(0x086), "086#00 00 00 00 00 00 00 00");
  command(0x4);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoor, ADoorThatIsDrivenAndDoesNotMoveIsStuck) {
  bench.is_blocked = true;
  command(0x4);
  cable.run_for(1999ms);
  EXPECT_EQ(state(), DoorState::opening);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::error);
  bench.is_blocked = false;
  command(0xE);
  command(0x4);
  cable.run_for(3s);
  EXPECT_EQ(state(), DoorState::opened_with_torque);
}

TEST_F(CarDoor, ADoorThatPushesAgainstSomethingIsNotStuck) {
  command(0x4);
  cable.run_for(1s);
  bench.is_blocked = true;
  bench.force_limit = Detection::yes;
  cable.run_for(1min);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoor, ALockThatDoesNotOpenIsAnError) {
  bench.lock_is_stuck = true;
  command(0x4);
  EXPECT_EQ(state(), DoorState::closed_with_torque) << "it waits for its lock";
  cable.run_for(999ms);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::error);
  EXPECT_EQ(bench.position_mm, 0);
}

TEST_F(CarDoor, ADoorThatIsPushedOpenClosesAgain) {
  command(0x1);
  bench.position_mm = 40;
  changed();
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(1s);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoor, AResetOfTheNodeStopsIt) {
  command(0x4);
  cable.run_for(1s);
  cable.send("000#81 06");
  EXPECT_EQ(bench.driven.motion, DoorDrive::Motion::none);
  cable.send("000#01 06");
  EXPECT_EQ(cable.last(0x201), "201#00 70 2C 01");
  command(0x4);
  EXPECT_EQ(state(), DoorState::opening) << "the same command as before is a new one";
}

TEST_F(CarDoor, WithoutAMeasurementThePositionIsNotAvailable) {
  Cable other;
  bool is_open = false;
  auto sense = [&is_open](Time) { return DoorReadings{.is_closed = !is_open, .is_open = is_open}; };
  DoorHardware hardware;
  hardware.sense = Callback<DoorReadings(Time)>::of(sense);
  CarDoorDevice<> device(other.port(0), 6, {hardware});
  other.connect(0, device.node());
  other.start_all();
  other.send("000#01 06");
  EXPECT_EQ(other.last(0x201), "201#FF 1F FF FF");
  other.send("200#FF 4F FF FF FF FF FF FF");
  EXPECT_EQ(other.last(0x201), "201#FF 5F FF FF");
  is_open = true;
  other.run_for(49ms);
  EXPECT_EQ(other.last(0x201), "201#FF 5F FF FF") << "it is looked at each 50 ms";
  other.run_for(1ms);
  EXPECT_EQ(other.last(0x201), "201#FF 3F FF FF");
}

TEST_F(CarDoor, DoorsOfOneDeviceOfLift3MoveApart) {
  static constexpr LiftDeviceOptions options = {.lift = 3, .doors = 0b1010, .parts = 96};
  Cable other;
  DoorBench second;
  DoorBench fourth;
  CarDoorDevice<options> device(other.port(0), 6, {second.hardware(), fourth.hardware()});
  other.connect(0, device.node());
  other.start_all();
  other.send("000#01 06");
  EXPECT_EQ(other.last(0x222), "222#11 10 00 00");
  other.send("220#FF FF FF 4F FF FF FF FF");
  other.run_for(1s);
  EXPECT_EQ(second.position_mm, 300);
  EXPECT_EQ(fourth.position_mm, 0);
  other.send("220#FF FF FF 4F FF FF FF 4F");
  other.run_for(1s);
  EXPECT_EQ(second.position_mm, 600);
  EXPECT_EQ(fourth.position_mm, 300);
  EXPECT_EQ(other.last(0x224), "224#00 50 2C 01") << "door 4, by the CAN-ID that is inferred";
  EXPECT_EQ(device.node().dictionary().number(0x7302, 4), 300u);
  EXPECT_EQ(device.node().dictionary().number(0x7301, 1), 0xFFFFu) << "another device's";
}

}  // namespace
}  // namespace canvoy::cia417::car_door_unit_test
