// Reactions of a call controller to a panel that it receives again: the test is panel 22 (16h) of a
// lift, and its other units. A heartbeat is lost after 3 s (1016h), that of a unit after 1.5 s.
#include "canvoy/devices/cia417/call/returned_panels.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_of_four_floors_test.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"

namespace canvoy::cia417::returned_panels_test {
namespace {

constexpr const char* first_question = "616#40 00 61 00 00 00 00 00";

/// For a controller with calls() that receives a panel with one input.
template <class Device, class... Settings>
struct Bench : DeviceOnCable<Device> {
  using DeviceOnCable<Device>::cable;
  using DeviceOnCable<Device>::device;

  explicit Bench(const Settings&... settings) : DeviceOnCable<Device>(settings...) {
    this->start();
    cable.send("000#01 00");
    cable.send("716#05");
    answer("0E 0C 01 03 10 80");
    cable.run_for(1s);
    cable.clear();
  }
  bool is_on(SpecialFunction function) { return device.calls().is_on(function); }
  /// Each question, until all is read: its one input is this record.
  void answer(const std::string& record) {
    for (int i = 0; i < 6; ++i) {
      cable.run_for(5ms);
      const std::string asked = cable.last(0x616);
      cable.clear();
      if (asked == first_question) {
        cable.send("596#4F 00 61 00 01 00 00 00");
      } else if (asked == "616#40 00 61 01 00 00 00 00") {
        cable.send("596#41 00 61 01 06 00 00 00");
        cable.send("596#03 " + record + " 00");
      } else if (!asked.empty()) {
        cable.send("596#80 01 61 00 00 00 02 06");
      }
    }
  }
  /// Its cable is cut for long enough to lose it, and repaired: the same heartbeat as before.
  void cut_for(Duration time, const std::string& heartbeat = "716#05") {
    cable.run_for(time);
    cable.clear();
    cable.send(heartbeat);
  }
  std::size_t count(const std::string& frame) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        cable.heard, [&](const auto& heard) { return wire_text(heard.frame) == frame; }));
  }
};

struct OfALift : Bench<LiftControllerDevice<>, NodeId, LiftControllerDeviceSettings> {
  OfALift() : Bench(NodeId{1}, lift_of_four_floors()) {}
};

TEST(ReturnedPanels, AKeyThatWasTurnedWhileItsPanelWasNotHeardIsLearnt) {
  OfALift bench;
  bench.cut_for(4s);
  bench.answer("0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
}

TEST(ReturnedPanels, AKeyThatWasTurnedBackWhileItsPanelWasNotHeardIsLearnt) {
  OfALift bench;
  bench.cable.send("496#0E 0C 01 03 10 81");
  ASSERT_TRUE(bench.is_on(SpecialFunction::fire_service));
  bench.cut_for(4s);
  bench.answer("0E 0C 01 03 10 80");
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service));
}

TEST(ReturnedPanels, AKeyThatWasTurnedWhileTheControllerWasStoppedIsLearnt) {
  OfALift bench;
  bench.cable.send("000#02 01");
  bench.cable.send("496#0E 0C 01 03 10 81");
  bench.cable.run_for(1s);
  bench.cable.send("716#05");
  EXPECT_FALSE(bench.is_on(SpecialFunction::fire_service));
  bench.cable.send("000#01 01");
  bench.answer("0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
}

TEST(ReturnedPanels, AButtonThatWasLetGoMeanwhileIsNoLongerHeld) {
  OfALift bench;
  bench.cable.send("496#0E 09 01 00 11 01");
  ASSERT_TRUE(bench.is_on(SpecialFunction::door_open));
  bench.cut_for(4s);
  bench.answer("0E 09 01 00 11 00");
  EXPECT_FALSE(bench.is_on(SpecialFunction::door_open));
}

TEST(ReturnedPanels, APanelWhoseAnswersToGuardingComeAgainIsReadAsWell) {
  OfALift bench;
  bench.cut_for(4s, "716#85");
  bench.answer("0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
}

TEST(ReturnedPanels, WhereTheControllerItselfIsGuardedAgainAllAreRead) {
  OfALift bench;
  const Error life_guarding{.code = canvoy::emergency_code::heartbeat};
  bench.device.node().raise(life_guarding);
  bench.device.node().clear(life_guarding);
  bench.answer("0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
}

TEST(ReturnedPanels, WhoWasHeardAllTheTimeIsNotAskedAgain) {
  OfALift bench;
  for (int i = 0; i < 10; ++i) {
    bench.cable.run_for(1s);
    bench.cable.send("716#05");
  }
  EXPECT_EQ(bench.count(first_question), 0u);
}

TEST(ReturnedPanels, LampsThatWentOutMeanwhileAreToldToBeOut) {
  OfALift bench;
  bench.cable.send("496#02 01 01 03 10 01");  // up, at floor 3
  bench.cable.send("496#02 02 01 04 10 01");  // down, at floor 4
  bench.cable.run_for(100ms);
  bench.device.calls().answered(3, Direction::up);
  bench.cut_for(4s);
  EXPECT_EQ(bench.count("400#02 01 01 03 10 00"), 0u);
  bench.cable.run_for(200ms);
  EXPECT_EQ(bench.count("400#02 01 01 03 10 00"), 1u) << "out";
  EXPECT_EQ(bench.count("400#02 02 01 04 10 81"), 1u) << "and what is lit";
  EXPECT_EQ(bench.count("400#02 01 01 04 10 00"), 0u) << "what never was needs no word";
  bench.cable.run_for(2s);
  EXPECT_EQ(bench.count("400#02 01 01 03 10 00"), 1u) << "once";
}

TEST(ReturnedPanels, WhatIsSpecialNoMoreIsToldToBeOut) {
  OfALift bench;
  bench.cable.send("496#0E 0F 01 03 10 81");  // VIP service
  bench.cable.run_for(100ms);
  bench.cable.send("496#0E 0F 01 03 10 80");
  bench.cable.run_for(100ms);
  bench.cut_for(4s);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.count("400#0E 0F 01 03 10 00"), 1u) << "the lamp of the key";
}

TEST(ReturnedPanels, WhatGoesOutWhileItIsToldAgainIsToldAsItIs) {
  OfALift bench;
  CallController& calls = bench.device.calls();
  bench.cable.send("496#02 01 01 03 10 01");
  bench.cable.run_for(100ms);
  bench.cut_for(4s);
  bench.cable.run_for(199ms);
  calls.answered(3, Direction::up);
  bench.device.node().advance(bench.cable.now);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.count("400#02 01 01 03 10 81"), 0u);
  EXPECT_GE(bench.count("400#02 01 01 03 10 00"), 1u);
}

struct Alone : Bench<CallControllerDevice<>, NodeId, CallControllerSettings> {
  Alone() : Bench(NodeId{1}, CallControllerSettings{.served = {FloorSet::between(1, 4)}}) {}
  void show(const LiftDisplay& display) {
    device.calls().display() = display;
    device.calls().show();
    device.node().advance(cable.now);
    cable.run_for(100ms);
  }
};

TEST(ReturnedPanels, IndicationsAndLanternsThatAreOutAreToldSo) {
  Alone bench;
  bench.show({.lantern_floor = 3,
              .lantern_doors = 1,
              .lantern = Direction::up,
              .specials = indication_bit(SpecialIndication::overload)});
  bench.show({});
  bench.cut_for(4s);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.count("400#43 03 01 00 F0 00"), 1u) << "overload, in the car";
  EXPECT_EQ(bench.count("400#41 03 01 03 F0 00"), 1u) << "both lanterns of floor 3";
  EXPECT_EQ(bench.count("400#43 02 01 00 F0 00"), 0u) << "what never was needs no word";
}

TEST(ReturnedPanels, ALanternThatIsLitStaysSo) {
  Alone bench;
  const LiftDisplay lit{.lantern_floor = 3, .lantern_doors = 1, .lantern = Direction::up};
  bench.show(lit);
  bench.cut_for(4s);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.count("400#41 03 01 03 F0 00"), 0u);
  EXPECT_EQ(bench.count("400#41 01 01 03 10 01"), 1u);
}

TEST(ReturnedPanels, ACallControllerAloneDoesTheSame) {
  Alone bench;
  bench.cable.send("496#02 01 01 03 10 01");
  bench.cable.run_for(100ms);
  bench.device.calls().answered(3, Direction::up);
  bench.device.node().advance(bench.cable.now);
  bench.cut_for(4s);
  EXPECT_EQ(bench.device.node().state(), NmtState::operational) << "a lost panel stops nothing";
  bench.answer("0E 0C 01 03 10 81");
  EXPECT_TRUE(bench.is_on(SpecialFunction::fire_service));
  bench.cut_for(4s);
  bench.cable.run_for(200ms);
  EXPECT_EQ(bench.count("400#02 01 01 03 10 00"), 1u);
}

TEST(SpecialFunctions, AKeyThatIsTurnedBackEndsNothingThatAnotherAsksFor) {
  SpecialFunctions sut;
  VirtualInput first{.function = BasicFunction::special_function,
                     .sub_function = sub_function_of(SpecialFunction::fire_service_enable),
                     .lifts = 1,
                     .floor = 1,
                     .doors = 0x10,
                     .data = 0x81};
  VirtualInput second = first;
  second.floor = 5;
  sut.take(first);
  sut.take(second);
  first.data = second.data = 0x80;
  sut.take(first);
  EXPECT_TRUE(sut.is_on(SpecialFunction::fire_service_enable));
  EXPECT_FALSE(sut.take_reading(first)) << "known";
  EXPECT_TRUE(sut.is_on(SpecialFunction::fire_service_enable));
  EXPECT_TRUE(sut.take_reading(second));
  EXPECT_FALSE(sut.is_on(SpecialFunction::fire_service_enable));
}

TEST(SpecialFunctions, MoreInputsThanAreRememberedEndAFunctionWithTheNextEnd) {
  SpecialFunctions sut;
  VirtualInput key{.function = BasicFunction::special_function,
                   .sub_function = sub_function_of(SpecialFunction::vip_service),
                   .lifts = 1,
                   .doors = 0x10};
  for (unsigned floor = 1; floor <= SpecialFunctions::inputs_max + 1; ++floor) {
    key.floor = static_cast<std::uint8_t>(floor);
    key.data = 0x81;
    sut.take(key);
  }
  for (unsigned floor = 1; floor <= SpecialFunctions::inputs_max; ++floor) {
    key.floor = static_cast<std::uint8_t>(floor);
    key.data = 0x80;
    sut.take(key);
    EXPECT_TRUE(sut.is_on(SpecialFunction::vip_service)) << floor;
  }
  key.floor = SpecialFunctions::inputs_max + 1;
  sut.take(key);
  EXPECT_FALSE(sut.is_on(SpecialFunction::vip_service));
}

// Units of the lift: their former state is discarded.

TEST(ReturnedUnits, ALoadUnitIsAskedAndWhatItSaidBeforeCountsNoLonger) {
  OfALift bench;
  bench.cable.send("188#01");
  bench.cable.send("70D#05");
  bench.cable.run_for(1600ms);
  bench.cable.clear();
  bench.cable.send("70D#05");
  EXPECT_EQ(bench.cable.last(0x188), "188#R1");
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.count("188#R1"), 2u) << "until it answers";
  bench.cable.send("188#08");
  bench.cable.run_for(10ms);
  EXPECT_EQ(bench.count("400#43 03 01 00 F0 01"), 1u) << "overload, in the car";
}

TEST(ReturnedUnits, ALoadUnitThatBootsWithoutALossIsAskedAsWell) {
  OfALift bench;
  bench.cable.send("188#01");
  bench.cable.send("70D#05");
  bench.cable.clear();
  bench.cable.send("70D#00");
  bench.cable.send("70D#05");
  EXPECT_EQ(bench.cable.last(0x188), "188#R1");
}

TEST(ReturnedUnits, OfADoorThatBootsNothingIsKnownBeforeItIsHeard) {
  OfALift bench;
  bench.cable.send("706#05");
  bench.cable.send("201#00 30 84 03");
  ASSERT_TRUE(bench.device.doors().view(1).is_known);
  bench.cable.send("706#00");
  EXPECT_FALSE(bench.device.doors().view(1).is_known);
  bench.cable.clear();
  bench.cable.send("706#05");
  EXPECT_EQ(bench.cable.last(0x201), "201#R4");
}

TEST(ReturnedUnits, OfADriveThatBootsNothingIsKnownBeforeItIsHeard) {
  OfALift bench;
  bench.cable.send("702#05");
  bench.cable.send("704#05");
  bench.cable.send("181#50 02 00 00 00 00");
  bench.cable.send("18C#00 00 00 00");
  ASSERT_TRUE(bench.device.drive().status().available);
  bench.cable.send("702#00");
  EXPECT_FALSE(bench.device.drive().status().available);
}

}  // namespace
}  // namespace canvoy::cia417::returned_panels_test
