// Doors and their controller where PDOs were lost, and where a door has stopped by itself (CiA
// 417-4, 4.6.1, 4.7.1 and 4.7.3).
#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_unit_test.hpp"

namespace canvoy::cia417::car_door_gap_test {
namespace {

// The unit.

class ADoorThatStopped : public CarDoorTest {
 protected:
  /// By its light barrier (6304h:04h = 2), half closed.
  void stop_by_barrier() {
    write(0x6304, 4, 2);
    open();
    command(0x1);
    cable.run_for(1s);
    bench.light_barrier = Detection::yes;
    changed();
    ASSERT_EQ(state(), DoorState::stopped);
  }
};

/// 6300h is a command: repeating it executes it again.
TEST_F(ADoorThatStopped, ClosesByTheSameCommandAsBeforeWhenTheWayIsFree) {
  stop_by_barrier();
  bench.light_barrier = Detection::no;
  changed();
  EXPECT_EQ(state(), DoorState::stopped) << "not by itself";
  command(0x1);
  EXPECT_EQ(state(), DoorState::closing);
}

TEST_F(ADoorThatStopped, StaysWhereItIsByTheSameCommandWhileSomethingIsInTheWay) {
  stop_by_barrier();
  const auto orders = bench.orders.size();
  command(0x1);
  command(0x1);
  EXPECT_EQ(state(), DoorState::stopped);
  for (std::size_t i = orders; i < bench.orders.size(); ++i) {
    EXPECT_EQ(bench.orders[i].motion, DoorDrive::Motion::none);
  }
}

/// A real door is not at rest when it gets the command to stop.
TEST_F(ADoorThatStopped, TellsWhereItStandsWhenItHasComeToRest) {
  open();
  command(0x1);
  cable.run_for(500ms);
  command(0x8);
  ASSERT_EQ(state(), DoorState::stopped);
  bench.position_mm = 700;
  cable.run_for(CarDoorSettings{}.position_period);
  bench.position_mm = 677;
  cable.run_for(CarDoorSettings{}.position_period);
  EXPECT_EQ(cable.last(0x201).substr(10), "A5 02") << "677 mm";
  cable.run_for(1s);
  cable.clear();
  cable.run_for(10s);
  EXPECT_EQ(cable.count(0x201), 0u);
}

// The controller: the test is door 1, node 6.

class DoorControllerInAGap : public testing::Test {
 protected:
  DoorControllerInAGap() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 01");
    cable.send("706#05");
    cable.send("201#00 10 00 00");  // closed with torque
    cable.run_for(1s);
    cable.clear();
  }
  void order(DoorMask door) {
    device.unit().open(door);
    device.node().advance(cable.now);
    cable.run_for(0s);
  }

  Cable cable;
  CarDoorControllerDevice<> device{cable.port(0), 1};
};

TEST_F(DoorControllerInAGap, AsksADoorForItsState) {
  device.node().bus_state(BusState::bus_off, cable.now);
  device.node().bus_state(BusState::error_active, cable.now);
  cable.run_for(20ms);
  EXPECT_EQ(cable.last(0x201), "201#R4");
}

TEST_F(DoorControllerInAGap, ADoorThatDoesNotDoWhatItIsToldIsAsked) {
  order(0b1);
  cable.clear();
  cable.run_for(2800ms);
  EXPECT_EQ(cable.count(0x201), 0u);
  cable.run_for(300ms);
  EXPECT_EQ(cable.last(0x201), "201#R4");
}

}  // namespace
}  // namespace canvoy::cia417::car_door_gap_test
