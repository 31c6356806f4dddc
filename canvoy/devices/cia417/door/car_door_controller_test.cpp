// The car door controller at its wire: statuswords in, controlwords out, and with doors of ours at
// the other end of a cable.
#include "canvoy/devices/cia417/door/car_door_controller.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"

namespace canvoy::cia417::car_door_controller_test {
namespace {

class DoorController : public testing::Test {
 protected:
  DoorController() {
    cable.connect(0, device.node());
    doors.on_change(Callback<void()>::of(count));
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(1s);
    cable.clear();
  }
  void settle() {
    device.node().advance(cable.now);
    cable.run_for(0s);
  }
  void open(DoorMask mask) {
    doors.open(mask);
    settle();
  }
  void close(DoorMask mask, DoorClosing closing = DoorClosing::normal) {
    doors.close(mask, closing);
    settle();
  }
  DoorsStatus status() const { return doors.status(); }
  /// A door's heartbeat.
  void alive(unsigned node) { cable.send(node == 6 ? "706#05" : "707#05"); }

  Cable cable;
  CarDoorControllerDevice<> device{cable.port(0), 1, {.doors = 0b0011}};
  CarDoorController& doors = device.unit();
  int changes = 0;
  struct Count {
    int& changes;
    void operator()() const { ++changes; }
  };
  Count count{changes};
};

TEST_F(DoorController, BeginsWithoutAnOrder) {
  Cable other;
  CarDoorControllerDevice<> fresh(other.port(0), 1, {});
  other.connect(0, fresh.node());
  other.start_all();
  other.send("000#01 01");
  EXPECT_EQ(other.last(0x200), "200#FF FF FF FF FF FF FF FF");
}

TEST_F(DoorController, OrdersAreWordsOfOnePdo) {
  open(0b01);
  EXPECT_EQ(cable.last(0x200), "200#FF 43 FF FF FF FF FF FF") << "open, limited, standard speed";
  open(0b10);
  EXPECT_EQ(cable.last(0x200), "200#FF 43 FF 43 FF FF FF FF");
  close(0b01);
  EXPECT_EQ(cable.last(0x200), "200#FF 10 FF 43 FF FF FF FF") << "with motion detector";
  close(0b10, DoorClosing::nudging);
  EXPECT_EQ(cable.last(0x200), "200#FF 10 FF 15 FF FF FF FF") << "reduced, without it";
  doors.stop(0b11);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#FF 80 FF 85 FF FF FF FF");
  doors.reset(0b01);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#FF E0 FF 85 FF FF FF FF");
}

TEST_F(DoorController, OrdersWithFullForceAreOthers) {
  doors.open(0b01, CarDoorController::Force::unlimited);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#FF 33 FF FF FF FF FF FF");
  doors.close(0b01, DoorClosing::normal, CarDoorController::Force::unlimited);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#FF 00 FF FF FF FF FF FF");
  doors.stop(0b01, CarDoorController::Force::unlimited);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#FF 70 FF FF FF FF FF FF");
}

TEST_F(DoorController, FieldsBesideTheCommandAreOrderedAlone) {
  doors.lock(0b01);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#CF FF FF FF FF FF FF FF");
  doors.lock(0b01, false);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#DF FF FF FF FF FF FF FF");
  doors.enable_finger_protector(0b01, false);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#5F FF FF FF FF FF FF FF");
  doors.enable_motion_detector(0b01, false);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#5F FD FF FF FF FF FF FF");
  doors.enable_battery(0b01);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#57 FD FF FF FF FF FF FF");
  doors.enable_battery(0b01, false);
  settle();
  EXPECT_EQ(cable.last(0x200), "200#53 FD FF FF FF FF FF FF");
}

TEST_F(DoorController, ADoorThatTheCarDoesNotHaveGetsNoOrder) {
  open(0b1100);
  EXPECT_EQ(cable.count(0x200), 0u);
}

TEST_F(DoorController, WhatADoorSaysIsSeen) {
  EXPECT_EQ(status().faulty, 0b11) << "not heard yet";
  cable.send("201#11 00 00 00");
  cable.send("202#00 50 2C 01");
  EXPECT_EQ(status(), (DoorsStatus{.locked = 0b01, .moving = 0b10}));
  EXPECT_TRUE(doors.view(2).is_known);
  EXPECT_EQ(doors.view(2).report.state, DoorState::opening);
  EXPECT_EQ(doors.view(2).position_mm, 300);
  EXPECT_EQ(changes, 2);
  cable.send("202#00 30 84 03");
  EXPECT_EQ(status(), (DoorsStatus{.locked = 0b01, .open = 0b10}));
  cable.send("202#00 30 84 03");
  EXPECT_EQ(changes, 3) << "nothing new";
}

TEST_F(DoorController, OnlyALockedDoorWithAClosedContactIsLocked) {
  cable.send("202#11 00 00 00");
  cable.send("201#01 00 00 00");
  EXPECT_EQ(status().locked, 0b10) << "not locked";
  cable.send("201#10 00 00 00");
  EXPECT_EQ(status().locked, 0b10) << "the contact is open";
  cable.send("201#13 00 00 00");
  EXPECT_EQ(status().locked, 0b10) << "nobody knows of the contact";
  cable.send("201#21 00 00 00");
  EXPECT_EQ(status().locked, 0b10) << "an error of the lock";
  cable.send("201#11 20 00 00");
  EXPECT_EQ(status().locked, 0b10) << "still closing";
  cable.send("201#31 00 00 00");
  EXPECT_EQ(status().locked, 0b11) << "no lock is installed";
}

TEST_F(DoorController, WhateverIsInTheWayIsAnObstruction) {
  cable.send("202#11 00 00 00");
  cable.send("201#00 30 84 03");
  EXPECT_EQ(status().obstructed, 0);
  for (const char* frame : {"201#00 34 84 03", "201#00 31 84 03", "201#40 30 84 03"}) {
    cable.send(frame);
    EXPECT_EQ(status().obstructed, 0b01) << frame;
  }
  cable.send("201#00 30 84 03");
  cable.send("205#7F");
  EXPECT_EQ(status().obstructed, 0b01) << "the light barrier";
  EXPECT_EQ(status().faulty, 0);
  cable.send("205#BF");
  EXPECT_EQ(status(), (DoorsStatus{.locked = 0b10, .open = 0b01, .unprotected = 0b01}));
  cable.send("205#3F");
  EXPECT_EQ(status().unprotected, 0);
}

TEST_F(DoorController, ADoorThatClosesOnSomebodyIsOpened) {
  cable.send("201#00 30 84 03");
  close(0b01);
  cable.send("201#00 20 20 03");
  cable.send("205#7F");
  EXPECT_EQ(cable.last(0x200), "200#FF 40 FF FF FF FF FF FF");
}

TEST_F(DoorController, ADoorThatNudgesIsNotOpened) {
  cable.send("201#00 30 84 03");
  close(0b01, DoorClosing::nudging);
  cable.send("201#00 20 20 03");
  cable.send("205#7F");
  EXPECT_EQ(cable.last(0x200), "200#FF 15 FF FF FF FF FF FF");
}

TEST_F(DoorController, ADoorThatHasNudgedGetsItsMotionDetectorBack) {
  cable.send("201#00 30 84 03");
  close(0b01, DoorClosing::nudging);
  cable.send("201#00 20 20 03");
  EXPECT_EQ(cable.last(0x200), "200#FF 15 FF FF FF FF FF FF");
  cable.send("201#11 10 00 00");
  EXPECT_EQ(cable.last(0x200), "200#FF 14 FF FF FF FF FF FF") << "closed";
  cable.clear();
  cable.send("201#11 10 00 01");
  EXPECT_EQ(cable.count(0x200), 0u) << "once";
}

TEST_F(DoorController, AnOrderThatIsRepeatedIsNotSentAgain) {
  cable.send("201#11 10 00 00");
  open(0b01);
  cable.send("201#01 50 00 00");
  cable.clear();
  for (int i = 0; i < 20; ++i) {
    open(0b01);
    cable.run_for(100ms);
  }
  EXPECT_EQ(cable.count(0x200), 0u);
}

TEST_F(DoorController, ADoorThatDoesNotObeyIsToldAgainEachThreeSeconds) {
  cable.send("201#11 10 00 00");
  cable.send("202#11 10 00 00");
  open(0b01);
  const Time told = cable.now;
  cable.clear();
  cable.run_for(2999ms);
  EXPECT_EQ(cable.count(0x200), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x200), "200#FF F3 FF FF FF FF FF FF") << "so that it listens";
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x200), "200#FF 43 FF FF FF FF FF FF");
  EXPECT_EQ(cable.now, told + 3050ms);
  cable.run_for(2999ms);
  EXPECT_EQ(cable.count(0x200), 2u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.count(0x200), 3u);
  cable.send("201#01 50 00 00");
  cable.run_for(10min);
  EXPECT_EQ(cable.count(0x200), 4u) << "it obeys";
}

TEST_F(DoorController, ADoorWithAnErrorIsResetFirst) {
  cable.send("201#11 10 00 00");
  cable.send("202#11 10 00 00");
  open(0b01);
  cable.send("201#00 E0 2C 01");
  EXPECT_EQ(status().faulty, 0b01);
  cable.clear();
  cable.run_for(3s);
  EXPECT_EQ(cable.last(0x200), "200#FF E3 FF FF FF FF FF FF");
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x200), "200#FF 43 FF FF FF FF FF FF");
}

TEST_F(DoorController, ADoorOfWhichTheHeartbeatIsLostIsUnknown) {
  alive(6);
  cable.send("201#11 00 00 00");
  cable.send("202#11 00 00 00");
  cable.send("205#3F");
  EXPECT_EQ(status().locked, 0b11);
  cable.run_for(1500ms);
  EXPECT_EQ(status(), (DoorsStatus{.locked = 0b10, .faulty = 0b01}));
  EXPECT_FALSE(doors.view(1).is_known);
  EXPECT_EQ(doors.view(1).report, DoorReport{});
  cable.clear();
  alive(6);
  EXPECT_GE(cable.count(0x201), 1u) << "it is asked by remote frame";
  EXPECT_EQ(status().faulty, 0b01) << "what it said before counts no longer";
  cable.send("201#11 00 00 00");
  EXPECT_EQ(status().locked, 0b11);
}

TEST_F(DoorController, ALightBarrierOfWhichTheHeartbeatIsLostIsBroken) {
  Cable other;
  CarDoorControllerDevice<> watcher(other.port(0), 1,
                                    {.doors = 0b0001, .light_barrier_units = {7, 0, 0, 0}});
  other.connect(0, watcher.node());
  other.start_all();
  other.send("000#01 01");
  other.send("201#11 00 00 00");
  other.send("205#3F");
  other.send("707#05");
  EXPECT_EQ(watcher.unit().status().unprotected, 0);
  other.run_for(2s);
  EXPECT_EQ(watcher.unit().status().unprotected, 0b01);
  EXPECT_EQ(watcher.unit().view(1).light_barrier, Detection::error);
  other.send("707#05");
  EXPECT_EQ(watcher.unit().status().unprotected, 0);
}

TEST_F(DoorController, EachOfFourDoorsHasPdosOfItsOwn) {
  Cable other;
  CarDoorControllerDevice<> four(other.port(0), 1, {.doors = 0b1111});
  other.connect(0, four.node());
  other.start_all();
  other.send("000#01 01");
  const CarDoorController& all = four.unit();
  for (unsigned door = 1; door <= 4; ++door) {
    char status[24];
    std::snprintf(status, sizeof status, "%03X#11 00 0%u 00", 0x200 + door, door);
    char barrier[24];
    std::snprintf(barrier, sizeof barrier, "%03X#7F", 0x204 + door);
    other.send(status);
    EXPECT_EQ(all.status().locked, (1U << door) - 1);
    EXPECT_EQ(all.view(door).position_mm, door);
    other.send(barrier);
    EXPECT_EQ(all.status().obstructed, (1U << door) - 1);
  }
}

TEST_F(DoorController, AnyStatuswordIsTaken) {
  for (unsigned word = 0; word <= 0xFFFF; ++word) {
    Frame frame = Frame::data_frame(0x201, {});
    frame.length = 4;
    store(frame.data.data(), static_cast<std::uint16_t>(word));
    device.node().receive(frame, cable.now);
    const DoorsStatus seen = status();
    const unsigned state = word >> 12;
    EXPECT_EQ((seen.locked & 1) != 0,
              state <= 1 && (word & 3) == 1 && ((word >> 4 & 3) == 1 || (word >> 4 & 3) == 3));
    EXPECT_EQ((seen.open & 1) != 0, state == 3 || state == 4);
    EXPECT_EQ((seen.moving & 1) != 0, state == 2 || state == 5 || state == 6);
    EXPECT_EQ((seen.faulty & 1) != 0, state == 14 || state == 15);
    EXPECT_EQ(doors.view(1).report.word(), word);
  }
}

/// A controller and a door of ours.
class DoorPair : public testing::Test {
 protected:
  DoorPair() {
    cable.connect(0, controller.node());
    cable.connect(1, door.node());
    cable.start_all();
    cable.send("000#01 00");
  }
  void settle() { cable.run_for(0s); }
  void tell(void (*order)(CarDoorController&)) {
    controller.node().advance(cable.now);
    order(controller.unit());
    controller.node().advance(cable.now);
    settle();
  }

  Cable cable;
  DoorBench bench;
  CarDoorControllerDevice<> controller{cable.port(0), 1, {}};
  CarDoorDevice<> door{cable.port(1), 6, {bench.hardware()}};
};

TEST_F(DoorPair, OpensAndClosesAndLocks) {
  EXPECT_EQ(controller.unit().status().locked, 1);
  tell([](CarDoorController& doors) { doors.interface().open(1); });
  cable.run_for(3s);
  EXPECT_EQ(controller.unit().interface().status(), (DoorsStatus{.open = 1}));
  tell([](CarDoorController& doors) { doors.interface().close(1, DoorClosing::normal); });
  cable.run_for(1s);
  tell([](CarDoorController& doors) { doors.interface().stop(1); });
  EXPECT_EQ(door.unit().state(), DoorState::stopped);
  tell([](CarDoorController& doors) { doors.interface().close(1, DoorClosing::normal); });
  cable.run_for(3s);
  EXPECT_EQ(controller.unit().status(), (DoorsStatus{.locked = 1}));
}

TEST_F(DoorPair, ADoorThatStartedAgainIsToldAgain) {
  tell([](CarDoorController& doors) { doors.open(1); });
  cable.run_for(1s);
  door.node().start(cable.now);
  cable.send("000#01 06");
  EXPECT_EQ(door.unit().state(), DoorState::stopped);
  cable.run_for(6s);
  EXPECT_EQ(door.unit().state(), DoorState::opened_with_torque);
}

TEST_F(DoorPair, AControllerThatStartsLaterAsksForTheState) {
  cable.send("000#81 01");
  EXPECT_FALSE(controller.unit().view(1).is_known);
  cable.send("000#01 01");
  EXPECT_EQ(controller.unit().status().locked, 1);
}

TEST_F(DoorPair, ACutCableStopsTheDoorAndItGoesOnAfterwards) {
  tell([](CarDoorController& doors) { doors.open(1); });
  cable.run_for(1s);
  cable.cut(1);
  cable.run_for(1500ms);
  EXPECT_EQ(door.unit().state(), DoorState::stopped) << "6304h:0Bh is 00h";
  EXPECT_EQ(controller.unit().status().faulty, 1);
  cable.cut(1, false);
  cable.run_for(10s);
  EXPECT_EQ(controller.unit().status(), (DoorsStatus{.open = 1}));
}

}  // namespace
}  // namespace canvoy::cia417::car_door_controller_test
