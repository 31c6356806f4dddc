// A whole lift controller among the other nodes of its lift.
#include "canvoy/devices/cia417/controller_device/lift_controller_device_test.hpp"

namespace canvoy::cia417::lift_controller_device_test {
namespace {

TEST_F(WholeLift, IsThreeVirtualDevicesInOneNode) {
  const Dictionary& dictionary = controller.node().dictionary();
  EXPECT_EQ(dictionary.number(0x1000, 0), 0x0000'01A1u) << "several virtual devices";
  EXPECT_EQ(dictionary.number(0x6000, 0), 3u);
  EXPECT_EQ(dictionary.number(0x6000, 1), 0x0100u) << "call controller";
  EXPECT_EQ(dictionary.number(0x6000, 2), 0x0400u) << "car door controller";
  EXPECT_EQ(dictionary.number(0x6000, 3), 0x0800u) << "car drive controller";
  EXPECT_EQ(dictionary.number(0x6001, 0), 0x01u);
}

TEST_F(WholeLift, ControllerAndDriveBelongToOneLiftAtATime) {
  for (const unsigned node : {1U, 2U}) {
    const std::string id = node == 1 ? "601#" : "602#";
    cable.send(id + "2F 01 60 00 03 00 00 00");
    EXPECT_EQ(cable.last(0x580 + node).substr(4), "80 01 60 00 30 00 09 06") << node;
    cable.send(id + "2F 01 60 00 01 00 00 00");
    EXPECT_EQ(cable.last(0x580 + node).substr(4), "60 01 60 00 00 00 00 00") << node;
  }
}

TEST_F(WholeLift, TheControllerGoesToAnotherLiftFromRestAlone) {
  const auto write_lift_2 = [&] {
    cable.send("601#2F 01 60 00 02 00 00 00");
    return cable.last(0x581).substr(4);
  };
  constexpr const char* refused = "80 01 60 00 22 00 00 08";
  press_in_car(3);
  run_for(4s);
  ASSERT_EQ(controller.lift().phase(), LiftPhase::driving);
  EXPECT_EQ(write_lift_2(), refused) << "because of the present device state";
  ASSERT_TRUE(arrives_at(3));
  EXPECT_EQ(write_lift_2(), refused) << "its doors are open";
  ASSERT_TRUE(comes_to_rest());
  EXPECT_EQ(controller.lift().floor(), 3);
  EXPECT_EQ(write_lift_2(), "60 01 60 00 00 00 00 00");
  EXPECT_FALSE(controller.drive().status().available) << "what it heard was of lift 1";
  cable.clear();
  cable.send("490#05 05 02 00 11 01");
  run_for(5s);
  EXPECT_EQ(cable.count(0x180) + cable.count(0x200), 0u) << "lift 1 is not commanded";
  EXPECT_EQ(controller.lift().fault(), LiftFault::motion);
  cable.send("601#2F 01 60 00 01 00 00 00");
  cable.send("188#01");
  press_in_car(5);
  ASSERT_TRUE(arrives_at(5)) << "back, it asks drive and door";
}

TEST_F(WholeLift, AControllerThatIsNotOperationalGoesToAnotherLiftWhileItsCarStands) {
  run_for(1s);
  press_in_car(3);
  ASSERT_TRUE(arrives_at(3));
  cable.send("000#80 01");
  cable.send("601#2F 01 60 00 02 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#60 01 60 00 00 00 00 00");
}

TEST_F(WholeLift, TheControllerIsNmtMasterAndSendsItsHeartbeat) {
  EXPECT_EQ(controller.node().state(), NmtState::operational);
  EXPECT_EQ(drive.node().state(), NmtState::operational);
  EXPECT_EQ(door.node().state(), NmtState::operational);
  EXPECT_GE(count("000#01 00"), 1u);
  cable.clear();
  cable.send("717#00");  // a panel boots
  EXPECT_EQ(count("000#01 17"), 1u);
  run_for(3s);
  EXPECT_EQ(cable.count(0x701), 10u) << "each 300 ms";
}

TEST_F(WholeLift, ComesToWhoPressesAndTakesHimAlong) {
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
  cable.send("498#02 01 01 04 10 01");
  cable.run_for(0ms);
  EXPECT_EQ(cable.last(0x400).substr(0, 12), "400#42 11 01") << "and it moves up";
  EXPECT_EQ(count("400#02 01 01 04 10 81"), 1u);
  ASSERT_TRUE(arrives_at(4));
  EXPECT_EQ(count("400#02 01 01 04 10 00"), 1u);
  press_in_car(7);
  ASSERT_TRUE(arrives_at(7));
  EXPECT_EQ(count("400#05 07 01 00 F1 00"), 1u);
  ASSERT_TRUE(comes_to_rest());
  EXPECT_TRUE(door_bench.is_locked);
  EXPECT_FALSE(bench.power);
}

TEST_F(WholeLift, AnOverloadHoldsItsDoors) {
  press_in_car(3);
  ASSERT_TRUE(arrives_at(3));
  cable.send("188#08");
  press_in_car(5);
  run_for(30s);
  EXPECT_TRUE(is_open_at(3));
  EXPECT_EQ(count("400#43 03 01 00 F0 01"), 1u);
  cable.send("188#00");
  ASSERT_TRUE(arrives_at(5));
}

TEST_F(WholeLift, WithoutPositionUnitItStandsAndGoesOnWhenItIsBack) {
  press_in_car(8);
  run_for(6s);
  ASSERT_EQ(controller.lift().phase(), LiftPhase::driving);
  has_position = false;
  ASSERT_TRUE(run_until([&] { return controller.lift().phase() == LiftPhase::stopped; }, 3s));
  run_for(5s);
  EXPECT_FALSE(bench.brake_released) << "the car stands";
  EXPECT_EQ(count("081#04 FF 21 01 00 00 00 00"), 1u) << "FF04h: application error";
  has_position = true;
  ASSERT_TRUE(arrives_at(8)) << "the call is not lost";
  EXPECT_EQ(cable.last(0x081), "081#00 00 00 00 00 00 00 00");
}

TEST_F(WholeLift, WithoutDriveItStandsAndGoesOnWhenItIsBack) {
  press_in_car(8);
  run_for(6s);
  cable.cut(1);
  ASSERT_TRUE(run_until([&] { return controller.lift().phase() == LiftPhase::stopped; }, 3s));
  run_for(5s);
  EXPECT_FALSE(bench.brake_released) << "it does not hear its controller";
  cable.cut(1, false);
  ASSERT_TRUE(arrives_at(8, 90s));
}

TEST_F(WholeLift, WithoutDoorItEndsAtTheNextFloor) {
  press_in_car(8);
  run_for(6s);
  cable.cut(2);
  ASSERT_TRUE(run_until([&] { return controller.lift().phase() == LiftPhase::stopped; }, 20s));
  run_for(5s);
  EXPECT_FALSE(bench.brake_released);
  cable.cut(2, false);
  ASSERT_TRUE(arrives_at(8, 90s));
}

TEST_F(WholeLift, WithoutLoadUnitItDoesNotLeave) {
  has_load = false;
  run_for(6s);
  EXPECT_EQ(controller.lift().fault(), LiftFault::load);
  EXPECT_GT(door_bench.position_mm, 899) << "who is in the car gets out";
  has_load = true;
  cable.clear();
  run_for(20ms);
  EXPECT_EQ(count("188#R1"), 1u) << "its load may be another one now";
  EXPECT_EQ(controller.lift().fault(), LiftFault::load);
  cable.send("188#01");
  press_in_car(8);
  ASSERT_TRUE(arrives_at(8, 60s));
}

TEST_F(WholeLift, AfterAResetOfItsControllerItServesAgain) {
  press_in_car(8);
  run_for(6s);
  controller.node().command(NmtCommand::reset_node);
  cable.run_for(0ms);
  run_for(10s);
  EXPECT_FALSE(bench.brake_released) << "the car stands";
  cable.send("188#00");
  press_in_car(2);
  ASSERT_TRUE(arrives_at(2, 90s));
}

TEST(LiftControllerDevice, WatchesEachUnitThatItWorksWith) {
  LiftControllerDeviceSettings settings = lift_settings();
  settings.doors.doors = 0b1111;
  settings.doors.door_units = {6, 7, 8, 12};
  settings.doors.light_barrier_units = {9, 9, 9, 10};
  settings.load_unit = 14;
  Cable cable;
  LiftControllerDevice<> controller(cable.port(0), 1, settings);
  cable.connect(0, controller.node());
  cable.start_all();
  // Emergencies 8130h with this node-ID, among those of the lift itself.
  const auto losses_of = [&](NodeId unit) {
    return std::ranges::count_if(cable.heard, [unit](const auto& heard) {
      const Frame& frame = heard.frame;
      return frame.id == 0x081 && frame.data[0] == 0x30 && frame.data[1] == 0x81 &&
             frame.data[3] == unit;
    });
  };
  for (const NodeId unit : std::to_array<NodeId>({2, 4, 6, 7, 8, 9, 10, 12, 14})) {
    SCOPED_TRACE(unsigned{unit});
    cable.send(wire_text(Frame::data_frame(0x700U + unit, {0x05})));
    cable.run_for(1499ms);
    EXPECT_EQ(losses_of(unit), 0);
    cable.run_for(2ms);
    EXPECT_EQ(losses_of(unit), 1);
  }
}

TEST(LiftControllerDevice, LivesInTheObjectsOfItsLift) {
  static constexpr auto description = full_lift_controller<LiftControllerOptions{.lift = 2}>;
  static constexpr auto layout = lay_out_device<description>();
  Cable cable;
  LiftControllerDevice<LiftControllerOptions{.lift = 2}, layout> controller(cable.port(0), 1,
                                                                            lift_settings());
  cable.connect(0, controller.node());
  cable.start_all();
  cable.run_for(100ms);
  const Dictionary& dictionary = controller.node().dictionary();
  EXPECT_EQ(dictionary.number(0x6001, 0), 0x02u);
  EXPECT_EQ(dictionary.number(0x1914, 1), 0x190u) << "control of its drive";
  cable.clear();
  cable.send("498#02 01 02 04 10 01");
  cable.run_for(0ms);
  EXPECT_EQ(cable.last(0x400), "400#02 01 02 04 10 81");
  cable.clear();
  cable.send("498#02 01 01 04 10 01");
  EXPECT_EQ(cable.count(0x400), 0u) << "lift 1 is another one";
}

}  // namespace
}  // namespace canvoy::cia417::lift_controller_device_test
