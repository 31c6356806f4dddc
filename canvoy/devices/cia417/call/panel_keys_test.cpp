// Keys that stay turned while their controller starts: it reads the inputs of its panels by SDO
// (CiA 417-4, 4.3.1: 6100h to 611Fh). At first the test plays a foreign panel, node 22 (16h), then
// there is one of ours.
#include "canvoy/devices/cia417/call/panel_keys.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_of_four_floors_test.hpp"
#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"
#include "canvoy/devices/cia417/panel/lift_panel_device.hpp"

namespace canvoy::cia417::panel_keys_test {
namespace {

template <LiftControllerOptions options = LiftControllerOptions{}>
struct Bench : DeviceOnCable<LiftControllerDevice<options>> {
  using Base = DeviceOnCable<LiftControllerDevice<options>>;
  using Base::cable;
  using Base::device;

  Bench() : Base(NodeId{1}, lift_of_four_floors()) { this->start(); }
  bool is_on(SpecialFunction function) { return device.calls().is_on(function); }
  /// The last request of the controller to the panel, after its pause.
  std::string asked() {
    cable.run_for(5ms);
    const std::string request = cable.last(0x616);
    cable.clear();
    return request;
  }
  /// The panel answers, and gets this request.
  std::string answer(const std::string& bytes) {
    cable.send("596#" + bytes);
    return asked();
  }
  /// A record of six bytes, in two frames; returns the request after it.
  std::string answer_record(const std::string& place, const std::string& record) {
    EXPECT_EQ(answer("41 " + place + " 06 00 00 00"), "616#60 00 00 00 00 00 00 00");
    return answer("03 " + record + " 00");
  }
};

TEST(PanelKeys, OfAPanelThatIsHeardEachInputIsReadAndATurnedKeyTaken) {
  Bench bench;
  bench.cable.send("716#05");
  EXPECT_EQ(bench.asked(), "616#40 00 61 00 00 00 00 00") << "how many inputs?";
  EXPECT_EQ(bench.answer("4F 00 61 00 02 00 00 00"), "616#40 00 61 01 00 00 00 00");
  EXPECT_EQ(bench.answer_record("00 61 01", "02 01 01 03 10 00"), "616#40 00 61 02 00 00 00 00");
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service));
  EXPECT_EQ(bench.answer_record("00 61 02", "0E 0C 01 03 10 81"), "616#40 01 61 00 00 00 00 00")
      << "the next group";
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
  EXPECT_EQ(bench.answer("80 01 61 00 00 00 02 06"), "") << "it has none";
  bench.cable.send("716#05");
  EXPECT_EQ(bench.asked(), "") << "that was it";
  bench.cable.run_for(1s);
  bench.cable.send("496#0E 0C 01 03 10 80");
  bench.cable.run_for(10ms);
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service)) << "turned back";
}

TEST(PanelKeys, WhatIsNoTurnedKeyCountsWhenItIsToldAlone) {
  Bench bench;
  bench.cable.send("716#05");
  bench.asked();
  bench.answer("4F 00 61 00 06 00 00 00");
  bench.answer_record("00 61 01", "02 01 01 03 10 01");  // a hall call button that is held
  bench.answer_record("00 61 02", "0E 01 01 00 10 01");  // a fan button without locking function
  bench.answer_record("00 61 03", "0E 0C 01 03 10 80");  // a key that is not turned
  bench.answer_record("00 61 04", "0E 0C 01 03 10 82");  // one that is broken
  bench.answer_record("00 61 05", "0E 0F 02 00 10 81");  // one of lift 2
  bench.answer_record("00 61 06", "0E 10 01 00 10 81");  // out of order
  EXPECT_TRUE(bench.device.calls().calls().empty());
  EXPECT_FALSE(bench.is_on(SpecialFunction::fan_1));
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service));
  EXPECT_FALSE(bench.is_on(SpecialFunction::vip_service));
  EXPECT_TRUE(bench.is_on(SpecialFunction::out_of_order));
}

TEST(PanelKeys, AnInputThatCannotBeReadIsLeftOut) {
  Bench bench;
  bench.cable.send("716#05");
  bench.asked();
  bench.answer("4F 00 61 00 02 00 00 00");
  EXPECT_EQ(bench.answer("80 00 61 01 24 00 00 08"), "616#40 00 61 02 00 00 00 00");
  bench.answer_record("00 61 02", "0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
}

TEST(PanelKeys, WhatHasAnotherLengthIsNeitherANumberOfInputsNorARecord) {
  Bench bench;
  bench.cable.send("716#05");
  bench.asked();
  EXPECT_EQ(bench.answer_record("00 61 00", "0E 0C 01 03 10 81"), "") << "6100h is something else";
  bench.cable.send("716#7F");
  bench.cable.send("716#05");
  EXPECT_EQ(bench.asked(), "616#40 00 61 00 00 00 00 00");
  bench.answer("42 00 61 00 01 00 00 00");  // without its size
  EXPECT_EQ(bench.answer("43 00 61 01 0E 0C 01 03"), "616#40 01 61 00 00 00 00 00");
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service));
}

TEST(PanelKeys, WhoHasNoInputsOrDoesNotAnswerIsLeftAndTheNextIsAsked) {
  Bench bench;
  bench.cable.send("716#05");
  bench.cable.send("717#05");
  bench.cable.send("718#05");
  EXPECT_EQ(bench.asked(), "616#40 00 61 00 00 00 00 00");
  bench.answer("80 00 61 00 00 00 02 06");
  EXPECT_EQ(bench.cable.last(0x617), "");
  bench.cable.run_for(999ms);
  EXPECT_EQ(bench.cable.count(0x618), 0u);
  bench.cable.run_for(7ms);
  EXPECT_EQ(bench.cable.last(0x617), "617#80 00 61 00 00 00 04 05") << "time-out";
  EXPECT_EQ(bench.cable.last(0x618), "618#40 00 61 00 00 00 00 00");
}

TEST(PanelKeys, BehindEachAnswerItLeavesTheBusToHeartbeats) {
  Bench bench;
  bench.cable.send("716#05");
  ASSERT_EQ(bench.asked(), "616#40 00 61 00 00 00 00 00");
  bench.cable.send("596#4F 00 61 00 02 00 00 00");
  bench.cable.run_for(5ms - 1us);
  EXPECT_EQ(bench.cable.count(0x616), 0u);
  bench.cable.run_for(1us);
  EXPECT_EQ(bench.cable.last(0x616), "616#40 00 61 01 00 00 00 00");
}

TEST(PanelKeys, UnitsOfTheLiftAreNotAsked) {
  Bench bench;
  for (const unsigned unit : {2U, 4U, 6U, 7U, 8U, 13U}) {
    bench.cable.send(wire_text(Frame::data_frame(0x700 + unit, {0x05})));
    bench.cable.run_for(0ms);
    for (const Cable::Heard& heard : bench.cable.heard) {
      EXPECT_NE(wire_text(heard.frame).substr(4), "40 00 61 00 00 00 00 00") << unit;
    }
  }
}

TEST(PanelKeys, APanelOfLift3HasItsInputsInTheObjectsOfThatLiftOrOfTheFirst) {
  Bench<LiftControllerOptions{.lift = 3}> bench;
  bench.cable.send("716#05");
  EXPECT_EQ(bench.asked(), "616#40 00 71 00 00 00 00 00");
  EXPECT_EQ(bench.answer("80 00 71 00 00 00 02 06"), "616#40 00 61 00 00 00 00 00");
  EXPECT_EQ(bench.answer("4F 00 61 00 01 00 00 00"), "616#40 00 61 01 00 00 00 00");
  bench.answer_record("00 61 01", "0E 0C 07 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service)) << "of lifts 1 to 3";
}

TEST(PanelKeys, AResetEndsItAndWhoIsHeardBehindItIsReadFromTheBeginning) {
  Bench bench;
  bench.cable.send("716#05");
  bench.asked();
  bench.answer("4F 00 61 00 02 00 00 00");
  bench.cable.send("000#81 01");
  bench.cable.run_for(100ms);
  bench.cable.clear();
  bench.answer("41 00 61 01 06 00 00 00");
  EXPECT_EQ(bench.asked(), "") << "too late";
  bench.cable.send("716#05");
  EXPECT_EQ(bench.asked(), "616#40 00 61 00 00 00 00 00");
}

TEST(PanelKeys, AfterARestartOfItsControllerAKeyThatStayedTurnedIsKnown) {
  Cable cable;
  LiftControllerDevice<> controller(cable.port(0), 1, lift_of_four_floors());
  LandingPanelDevice<> panel(
      cable.port(1), 22, {},
      LandingPanel{
          .lifts = 0x01, .floor = 3, .doors = 0b0001, .highest_floor = 4, .fire_key = true});
  cable.connect(0, controller.node());
  cable.connect(1, panel.node());
  cable.start_all();
  cable.run_for(2s);
  panel.inputs().set_level(2, true, cable.now);
  cable.run_for(100ms);
  ASSERT_TRUE(controller.calls().is_on(SpecialFunction::fire_service));
  controller.node().command(NmtCommand::reset_node);
  cable.run_for(10ms);
  ASSERT_FALSE(controller.calls().is_on(SpecialFunction::fire_service));
  cable.run_for(2s);
  EXPECT_TRUE(controller.calls().is_on(SpecialFunction::fire_service));
}

TEST(PanelKeys, GoOnWhereTheirNodeIsStartedAgainInTheMiddleOfAPanel) {
  Bench bench;
  bench.cable.send("716#05");
  bench.asked();
  EXPECT_EQ(bench.answer("4F 00 61 00 02 00 00 00"), "616#40 00 61 01 00 00 00 00");
  bench.cable.send("000#80 01");
  EXPECT_EQ(bench.answer_record("00 61 01", "02 01 01 03 10 00"), "") << "not now";
  bench.cable.run_for(100ms);
  bench.cable.clear();
  bench.cable.send("000#01 01");
  EXPECT_EQ(bench.asked(), "616#40 00 61 02 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia417::panel_keys_test
