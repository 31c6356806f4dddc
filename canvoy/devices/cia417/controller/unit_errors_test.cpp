// Emergencies of the units of a lift at its controller: the resulting commands to the drive, and
// their times (CiA 301, 7.2.7; CiA 417-1, emergency codes). Node 2 is the drive, 4 the position
// unit, 6 the door unit, 13 the load measuring unit.
#include "canvoy/devices/cia417/controller/unit_errors.hpp"

#include <string>

#include "canvoy/devices/cia417/controller_device/lift_controller_device_test.hpp"

namespace canvoy::cia417::unit_errors_test {
namespace {

class UnitErrorsTest : public WholeLift {
 protected:
  /// An emergency with one error, the generic bit, and nothing else.
  void emergency(const std::string& node, const std::string& code) {
    cable.clear();
    send(node, code + " 01 00 00 00 00 00");
  }
  void no_error(const std::string& node) { send(node, "00 00 00 00 00 00 00 00"); }
  /// Drive and door are devices on the cable: what they send themselves they do not hear.
  void send(const std::string& node, const std::string& data) {
    const std::size_t place = node == "82" ? 1 : node == "86" ? 2 : Cable::nodes_max;
    cable.send_from(place, "0" + node + "#" + data);
    cable.run_for(0ms);
  }
  /// True if the drive has got a controlword that starts like this, at this moment.
  bool was_commanded_now(const std::string& controlword) const {
    return std::ranges::any_of(cable.heard, [&](const Cable::Heard& heard) {
      return heard.at == cable.now && heard.frame.id == 0x180 &&
             wire_text(heard.frame).substr(4, 5) == controlword;
    });
  }
  /// "Switch on", the start of each trip: the command before enables nothing.
  bool was_switched_on() const {
    return std::ranges::any_of(cable.heard, [](const Cable::Heard& heard) {
      return heard.frame.id == 0x180 && (heard.frame.data[0] & 0x0FU) == 0x07;
    });
  }
  void begin_trip_to_the_top() {
    press_in_car(8);
    run_for(6s);
    ASSERT_EQ(controller.lift().phase(), LiftPhase::driving);
    ASSERT_TRUE(bench.brake_released);
  }
};

TEST_F(UnitErrorsTest, AnErrorOfThePositionUnitStopsAMovingCarFastAtOnce) {
  begin_trip_to_the_top();
  emergency("84", "00 50");
  EXPECT_TRUE(was_commanded_now("02 00")) << "quick stop";
  EXPECT_EQ(cable.last(0x081), "081#04 FF 21 01 00 00 00 00") << "the controller tells of it, too";
  run_for(4s);
  EXPECT_FALSE(bench.brake_released);
  cable.clear();
  run_for(60s);
  EXPECT_FALSE(was_switched_on()) << "as long as it lasts";
}

TEST_F(UnitErrorsTest, AnErrorOfTheDriveStopsAMovingCarFastAtOnce) {
  begin_trip_to_the_top();
  emergency("82", "10 42");
  EXPECT_TRUE(was_commanded_now("02 00"));
}

TEST_F(UnitErrorsTest, OverspeedThatThePositionUnitSeesDoesSo) {
  begin_trip_to_the_top();
  emergency("84", "05 FF");
  EXPECT_TRUE(was_commanded_now("02 00"));
}

TEST_F(UnitErrorsTest, ACarThatStandsDoesNotStartBeforeTheErrorHasGone) {
  // Drive and door have no error in fact, and report that if their registers are read.
  cable.filter = [](const Frame& frame) {
    return wire_text(frame).find("#40 01 10") == std::string::npos;
  };
  for (const char* unit : {"82", "84", "86", "8D"}) {
    emergency(unit, "00 50");
    press_in_car(8);
    run_for(60s);
    EXPECT_FALSE(was_switched_on()) << unit;
    EXPECT_EQ(controller.lift().phase(), LiftPhase::stopped) << unit;
    no_error(unit);
    ASSERT_TRUE(arrives_at(8)) << unit;
    press_in_car(1);
    ASSERT_TRUE(arrives_at(1)) << unit;
    ASSERT_TRUE(comes_to_rest());
  }
}

TEST_F(UnitErrorsTest, ServiceResumesFiveSecondsAfterTheErrorHasGone) {
  emergency("84", "00 50");
  press_in_car(8);
  run_for(20s);
  cable.clear();
  no_error("84");
  run_for(4980ms);
  EXPECT_FALSE(was_switched_on());
  run_for(1s);
  EXPECT_TRUE(was_switched_on());
}

TEST_F(UnitErrorsTest, AnErrorLastsUntilTheErrorRegisterIsEmpty) {
  emergency("84", "00 50");
  cable.send("084#00 00 01 00 00 00 00 00");  // another one has gone
  cable.run_for(0ms);
  EXPECT_EQ(controller.lift().fault(), LiftFault::motion);
  no_error("84");
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

TEST_F(UnitErrorsTest, WhatSaysNothingOfTheCarStopsNoTrip) {
  begin_trip_to_the_top();
  for (const char* code : {"10 00", "11 31", "21 31", "11 32", "21 32", "10 81", "20 81", "30 81",
                           "40 81", "00 82", "10 82", "50 82", "01 FF", "02 FF", "03 FF"}) {
    for (const char* unit : {"82", "84", "86", "8D"}) {
      emergency(unit, code);
      EXPECT_FALSE(was_commanded_now("02 00")) << unit << " " << code;
    }
  }
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

TEST_F(UnitErrorsTest, EmergenciesOfOtherNodesAreNotItsOwn) {
  begin_trip_to_the_top();
  for (const char* node : {"83", "85", "90", "95"}) emergency(node, "00 50");
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

TEST_F(UnitErrorsTest, AnErrorInAMovingCarOfDoorOrLoadUnitEndsAtTheNextFloor) {
  for (const char* unit : {"86", "8D"}) {
    begin_trip_to_the_top();
    emergency(unit, "00 50");
    EXPECT_FALSE(was_commanded_now("02 00")) << unit;
    ASSERT_TRUE(run_until([&] { return !bench.brake_released; })) << unit;
    EXPECT_LT(bench.sense().position * 100, 20'000'000) << unit;
    run_for(2s);
    EXPECT_EQ(controller.lift().phase(), LiftPhase::stopped) << unit;
    no_error(unit);
    ASSERT_TRUE(arrives_at(8)) << unit;
    press_in_car(1);
    ASSERT_TRUE(arrives_at(1)) << unit;
    ASSERT_TRUE(comes_to_rest());
  }
}

TEST_F(UnitErrorsTest, AUnitThatBootsHasNoErrorsOfBefore) {
  emergency("84", "00 50");
  EXPECT_EQ(controller.lift().fault(), LiftFault::motion);
  cable.send("704#00");
  cable.run_for(0ms);
  EXPECT_EQ(controller.lift().fault(), LiftFault::motion) << "where the car is, it has to say";
  run_for(40ms);
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

// An error that was not received.

TEST_F(UnitErrorsTest, AfterALossTheErrorRegisterIsReadAndTheErrorOfBeforeForgotten) {
  emergency("84", "00 50");
  has_position = false;
  run_for(2s);  // it is lost
  has_position = true;
  cable.clear();
  run_for(40ms);  // until it has sent its position, too
  EXPECT_EQ(count("604#40 01 10 00 00 00 00 00"), 1u);
  cable.send("584#4F 01 10 00 00 00 00 00");
  cable.run_for(0ms);
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

TEST_F(UnitErrorsTest, AnErrorThatCameDuringALossCounts) {
  has_position = false;
  run_for(2s);
  has_position = true;
  run_for(40ms);
  cable.send("584#4F 01 10 00 01 00 00 00");
  cable.run_for(0ms);
  EXPECT_EQ(controller.lift().fault(), LiftFault::motion);
  no_error("84");
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
}

TEST_F(UnitErrorsTest, TheControllerThatStartsReadsTheErrorRegistersOfPositionAndLoadUnit) {
  cable.clear();
  controller.node().command(NmtCommand::reset_node);
  cable.run_for(0ms);
  EXPECT_EQ(count("604#40 01 10 00 00 00 00 00"), 1u);
  EXPECT_EQ(count("60D#40 01 10 00 00 00 00 00"), 0u) << "one after the other";
  cable.send("584#4F 01 10 00 01 00 00 00");
  cable.run_for(0ms);
  EXPECT_EQ(count("60D#40 01 10 00 00 00 00 00"), 1u);
  press_in_car(8);
  run_for(60s);
  EXPECT_FALSE(was_switched_on());
  EXPECT_EQ(count("60D#40 01 10 00 00 00 00 00"), 3u) << "which does not answer";
  no_error("84");
  cable.send("188#01");
  EXPECT_TRUE(arrives_at(8));
}

TEST_F(UnitErrorsTest, ARegisterThatTellsOfTheBusOrVoltagesHoldsNothing) {
  for (const unsigned bits : {0x00U, 0x11U, 0x05U, 0x15U, 0x01U, 0x03U, 0x09U, 0x21U, 0x81U}) {
    controller.node().command(NmtCommand::reset_node);
    cable.run_for(0ms);
    Frame answer = wire_frame("584#4F 01 10 00 00 00 00 00");
    answer.data[4] = static_cast<std::uint8_t>(bits);
    cable.send(wire_text(answer));
    cable.send("188#01");
    run_for(5s);
    const bool holds = bits == 0x01 || (bits & ~0x15U) != 0;
    EXPECT_EQ(controller.lift().fault() == LiftFault::motion, holds) << bits;
  }
}

/// Node 127 is the last of them, then comes the first again.
TEST_F(UnitErrorsTest, UnitsWithAnErrorAreAskedInTurnUpToTheHighestNodeId) {
  cable.send("601#23 28 10 7F FF 00 00 00");  // its emergencies: 0FFh
  ASSERT_EQ(cable.last(0x581), "581#60 28 10 7F 00 00 00 00");
  cable.send("0FF#00 50 01 00 00 00 00 00");
  cable.send("088#00 50 01 00 00 00 00 00");
  cable.clear();
  const auto questions = [this] {
    return std::pair(count("608#40 01 10 00 00 00 00 00"), count("67F#40 01 10 00 00 00 00 00"));
  };
  for (std::size_t round = 1; round <= 3; ++round) {
    run_for(5s);
    EXPECT_EQ(questions(), std::pair(round, round - 1));
    run_for(5s);
    EXPECT_EQ(questions(), std::pair(round, round));
  }
}

TEST_F(UnitErrorsTest, TheEmergenciesThatItHearsStandInItsDictionary) {
  const Dictionary& dictionary = controller.node().dictionary();
  for (const unsigned node : {2U, 4U, 6U, 7U, 8U, 13U}) {
    EXPECT_EQ(dictionary.number(0x1028, static_cast<std::uint8_t>(node)), 0x80 + node);
  }
  EXPECT_EQ(dictionary.number(0x1028, 16), 0x8000'0000u);
}

}  // namespace
}  // namespace canvoy::cia417::unit_errors_test
