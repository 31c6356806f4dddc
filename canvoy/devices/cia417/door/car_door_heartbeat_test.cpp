// Reaction of a car door to the loss of its controller's heartbeat: 6304h:0Bh (CiA 417-4, 4.7.3).
#include "canvoy/devices/cia417/door/car_door_modes_test.hpp"

namespace canvoy::cia417::car_door_heartbeat_test {
namespace {

class CarDoorWithoutController : public CarDoorModes {
 protected:
  void lose_controller() {
    cable.send("701#05");
    cable.run_for(999ms);
    before = state();
    cable.run_for(1ms);
    ASSERT_EQ(cable.last(0x086), "086#30 81 11 01 00 00 00 00");
  }
  DoorState before = DoorState::not_available;
};

TEST_F(CarDoorWithoutController, Mode0StopsWithoutTorque) {
  set(heartbeat_lost, 0);
  command(0x4);
  lose_controller();
  EXPECT_EQ(before, DoorState::opening);
  EXPECT_EQ(cable.last(0x201), "201#00 70 2C 01") << "stopped, within the heartbeat's second";
  EXPECT_FALSE(bench.driven.has_torque);
}

TEST_F(CarDoorWithoutController, Mode1StopsWithTorque) {
  set(heartbeat_lost, 1);
  command(0x4);
  lose_controller();
  EXPECT_EQ(state(), DoorState::stopped);
  EXPECT_TRUE(bench.driven.has_torque);
}

TEST_F(CarDoorWithoutController, Mode2ClosesWithReducedSpeed) {
  set(heartbeat_lost, 2);
  open();
  lose_controller();
  EXPECT_EQ(state(), DoorState::closing);
  EXPECT_TRUE(bench.driven.is_reduced);
  EXPECT_TRUE(bench.driven.limits_force);
  cable.run_for(5999ms);
  EXPECT_EQ(state(), DoorState::closing);
  cable.run_for(1ms);
  EXPECT_EQ(state(), DoorState::closed_with_torque);
}

TEST_F(CarDoorWithoutController, AClosedDoorLosesItsTorqueOrKeepsIt) {
  command(0x1);
  set(heartbeat_lost, 1);
  lose_controller();
  EXPECT_EQ(state(), DoorState::closed_with_torque);
  set(heartbeat_lost, 0);
  lose_controller();
  EXPECT_EQ(state(), DoorState::closed_without_torque);
  EXPECT_TRUE(bench.is_locked);
}

TEST_F(CarDoorWithoutController, WhenItIsBackTheSameCommandCountsAgain) {
  command(0x4);
  lose_controller();
  cable.send("701#05");
  EXPECT_EQ(state(), DoorState::stopped) << "it waits";
  command(0x4);
  EXPECT_EQ(state(), DoorState::opening);
}

TEST_F(CarDoorWithoutController, ItWaitsForNothingThatItHadBegun) {
  let_one_pass(5);
  lose_controller();
  cable.run_for(1h);
  EXPECT_EQ(state(), DoorState::opened_without_torque);
}

TEST_F(CarDoorWithoutController, ItStaysOperationalAndTells) {
  lose_controller();
  EXPECT_EQ(door.node().state(), NmtState::operational);
}

TEST_F(CarDoorWithoutController, TheLossOfAnotherNodeIsNotItsBusiness) {
  cable.send("606#23 16 10 01 E8 03 02 00");
  command(0x4);
  cable.send("702#05");
  cable.run_for(1500ms);
  EXPECT_EQ(state(), DoorState::opening);
}

}  // namespace
}  // namespace canvoy::cia417::car_door_heartbeat_test
