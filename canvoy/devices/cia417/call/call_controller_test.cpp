// The call controller at the wire: records of 6010h in, records of 6011h out. Bytes: basic
// function, sub-function, lift, floor, doors, data.
#include "canvoy/devices/cia417/call/call_controller.hpp"

#include "canvoy/devices/cia417/call/call_controller_test.hpp"

namespace canvoy::cia417::call_controller_test {
namespace {

/// Floors 1 to 20 with door 1, and 1 with door 2, too; floor 13 is locked by key 2.
CallControllerSettings settings() {
  CallControllerSettings made{.lift = 1,
                              .served = {FloorSet::between(1, 20), FloorSet::between(1, 1)}};
  made.locked_by_key[1].insert(13);
  return made;
}

class CallControllerTest : public CallControllerCable {
 protected:
  CallControllerTest() {
    cable.connect(0, device.node());
    start(10ms);
  }

  CallControllerDevice<full_call_controller_layout, 3> device{cable.port(0), 1, settings()};
  CallController& calls = device.calls();
};

TEST_F(CallControllerTest, ItIsACallControllerOfLift1) {
  EXPECT_EQ(device.node().dictionary().number(0x1000, 0), 0x0100'01A1u);
  EXPECT_EQ(device.node().dictionary().number(0x1900, 1), 0x400u);
  EXPECT_EQ(device.node().dictionary().number(0x1481, 1), 0x8000'0480u) << "its own";
  EXPECT_EQ(device.node().dictionary().number(0x1482, 1), 0x482u);
  EXPECT_EQ(device.node().dictionary().number(0x14FF, 1), 0x4FFu);
}

TEST_F(CallControllerTest, AHallCallIsTakenAndAcknowledged) {
  EXPECT_EQ(answer_to("02 01 01 03 10 01"), (Texts{"02 01 01 03 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::standard, 3, 1}));
  EXPECT_EQ(answer_to("02 02 01 04 10 01"), (Texts{"02 02 01 04 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::down, CallPriority::standard, 4, 1}));
  EXPECT_EQ(answer_to("02 03 01 05 10 01"), (Texts{"02 03 01 05 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::any, CallPriority::standard, 5, 1}));
}

TEST_F(CallControllerTest, EachFunctionHasThreePriorities) {
  EXPECT_EQ(answer_to("03 01 01 03 10 01"), (Texts{"03 01 01 03 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::low, 3, 1}));
  EXPECT_EQ(answer_to("04 01 01 03 10 01"), (Texts{"04 01 01 03 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::high, 3, 1}));
  EXPECT_EQ(answer_to("06 09 01 00 11 01", "490"), (Texts{"06 09 01 00 F1 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::low, 9, 1}));
  EXPECT_EQ(answer_to("07 09 01 00 11 01", "490"), (Texts{"07 09 01 00 F1 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::high, 9, 1}));
}

TEST_F(CallControllerTest, ACarCallIsAcknowledgedInTheColumnOfItsDoor) {
  EXPECT_EQ(answer_to("05 07 01 00 11 01", "490"), (Texts{"05 07 01 00 F1 81"}));
  EXPECT_EQ(answer_to("05 01 01 00 12 01", "490"), (Texts{"05 01 01 00 F2 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::standard, 1, 0b10}));
  EXPECT_EQ(answer_to("05 02 01 00 00 01", "490"), (Texts{"05 02 01 00 F1 81"}))
      << "without a door: all that the floor has";
}

TEST_F(CallControllerTest, WhoPressesAgainIsAnsweredAgain) {
  answer_to("02 01 01 03 10 01");
  EXPECT_EQ(answer_to("02 01 01 03 10 01"), (Texts{"02 01 01 03 10 81"}));
}

TEST_F(CallControllerTest, ALetGoButtonAndOneThatIsDefectiveAreNoCall) {
  EXPECT_EQ(answer_to("02 01 01 03 10 00"), Texts{});
  EXPECT_EQ(calls.defective_inputs(), 0u);
  EXPECT_EQ(answer_to("02 01 01 03 10 02"), Texts{});
  EXPECT_EQ(answer_to("02 01 01 03 10 03"), Texts{});
  EXPECT_EQ(calls.defective_inputs(), 2u);
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(CallControllerTest, InputsOfOtherLiftsAreNotOurs) {
  EXPECT_EQ(answer_to("02 01 02 03 10 01"), Texts{});
  EXPECT_EQ(answer_to("02 01 00 03 10 01"), Texts{});
  EXPECT_EQ(answer_to("02 01 FF 03 10 01"), (Texts{"02 01 01 03 10 81"})) << "of the whole group";
}

TEST_F(CallControllerTest, ACallThatCannotBeServedIsNotAffirmed) {
  EXPECT_EQ(answer_to("02 01 01 15 10 01"), (Texts{"02 01 01 15 10 00"})) << "there is no floor 21";
  EXPECT_EQ(answer_to("02 01 01 03 20 01"), (Texts{"02 01 01 03 20 00"})) << "no door 2 there";
  EXPECT_EQ(answer_to("05 15 01 00 11 01"), (Texts{"05 15 01 00 F1 00"}));
  EXPECT_EQ(answer_to("05 0D 01 00 11 01"), (Texts{"05 0D 01 00 F1 00"})) << "13 is locked";
  EXPECT_TRUE(calls.calls().empty());
  answer_to("0E 06 01 00 10 81");
  EXPECT_EQ(answer_to("05 0D 01 00 11 01"), (Texts{"05 0D 01 00 F1 81"})) << "key 2 is turned";
}

TEST_F(CallControllerTest, FloorsThatDoNotExistAndUnknownFunctionsDoNothing) {
  for (const char* input :
       {"02 01 01 00 10 01", "02 01 01 FF 10 01", "05 00 01 00 11 01", "05 FF 01 00 11 01",
        "00 00 01 03 10 01", "01 00 01 03 10 01", "12 01 01 03 10 01", "80 01 01 03 10 01",
        "0E 00 01 00 10 01", "0E 17 01 00 10 01", "0E FF 01 00 10 01"}) {
    EXPECT_EQ(answer_to(input), Texts{}) << input;
  }
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(CallControllerTest, EveryRecordIsAnsweredOrIgnored) {
  for (unsigned function = 0; function < 256; ++function) {
    for (const unsigned sub : {0U, 1U, 2U, 3U, 20U, 21U, 254U, 255U}) {
      for (const unsigned floor : {0U, 1U, 20U, 254U, 255U}) {
        char text[32];
        std::snprintf(text, sizeof text, "495#%02X %02X 01 %02X F1 %02X", function, sub, floor,
                      (function + sub) & 0xFFU);
        cable.send(text);
      }
    }
  }
  cable.run_for(1s);

  EXPECT_EQ(calls.calls().floors(all_calls).next_up(21), 0) << "nothing beyond the building";
}

TEST_F(CallControllerTest, WhatTheCarAnsweredGoesOut) {
  answer_to("02 01 01 03 10 01");
  answer_to("02 02 01 03 10 01");
  answer_to("05 03 01 00 11 01");
  calls.answered(3, Direction::up);
  EXPECT_EQ(told(), (Texts{"05 03 01 00 F1 00", "02 01 01 03 10 00"}));
  calls.answered(3, Direction::down);
  EXPECT_EQ(told(), (Texts{"02 02 01 03 10 00"}));
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(CallControllerTest, ManyPanelsAtOnceAreAllAnswered) {
  for (unsigned floor = 1; floor <= 20; ++floor) {
    char text[32];
    std::snprintf(text, sizeof text, "%03X#02 03 01 %02X 10 01", 0x494 + floor, floor);
    cable.send(text);
  }
  EXPECT_EQ(told().size(), 20u);
}

TEST_F(CallControllerTest, ADestinationCallWaitsForTheCarAndBecomesACarCall) {
  EXPECT_EQ(answer_to("08 09 01 03 11 01"), (Texts{"08 09 01 03 11 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::standard, 3, 1}));
  EXPECT_EQ(answer_to("0A 02 01 03 10 01"), (Texts{"0A 02 01 03 10 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::down, CallPriority::high, 3, 1}));
  calls.answered(3, Direction::up);
  EXPECT_EQ(told(), (Texts{"05 09 01 00 F1 81", "08 09 01 03 11 00"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::standard, 9, 1}));
  EXPECT_TRUE(calls.calls().contains({CallKind::down, CallPriority::high, 3, 1}));
}

TEST_F(CallControllerTest, ACallToADestinationFloorIsAnsweredByItsOwnFunction) {
  EXPECT_EQ(answer_to("0B 09 01 03 11 01"), (Texts{"0B 09 01 03 11 81"}));
  EXPECT_EQ(answer_to("0C 09 01 04 11 01"), (Texts{"0C 09 01 04 11 81"}));
  EXPECT_EQ(answer_to("0D 09 01 05 11 01"), (Texts{"0D 09 01 05 11 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::low, 4, 1}));
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::high, 5, 1}));
}

TEST_F(CallControllerTest, InTheCarACallToADestinationFloorIsACarCallAndAffirmedByItsOwnFunction) {
  EXPECT_EQ(answer_to("0B 09 01 00 11 01", "490"),
            (Texts{"05 09 01 00 F1 81", "0B 09 01 00 11 81"}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::standard, 9, 1}));
  EXPECT_EQ(answer_to("0B 09 01 00 11 01", "490"),
            (Texts{"05 09 01 00 F1 81", "0B 09 01 00 11 81"}))
      << "who presses again is answered again";
  calls.answered(3, Direction::up);
  EXPECT_EQ(told(), Texts{});
  calls.answered(9, Direction::up);
  EXPECT_EQ(told(), (Texts{"05 09 01 00 F1 00", "0B 09 01 00 11 00"}));
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(CallControllerTest, InTheCarEachKindOfDestinationCallIsSoInItsPriority) {
  EXPECT_EQ(answer_to("08 09 01 00 11 01", "490").back(), "08 09 01 00 11 81");
  EXPECT_EQ(answer_to("09 0A 01 00 11 01", "490").back(), "09 0A 01 00 11 81");
  calls.answered(9, Direction::up);
  EXPECT_EQ(answer_to("0D 0B 01 00 11 01", "490").back(), "0D 0B 01 00 11 81");
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::low, 10, 1}));
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::high, 11, 1}));
}

TEST_F(CallControllerTest, InTheCarACallToADestinationFloorThatCannotBeServedIsNotAffirmed) {
  EXPECT_EQ(answer_to("0B 0D 01 00 11 01", "490"), (Texts{"0B 0D 01 00 11 00"})) << "locked";
  EXPECT_EQ(answer_to("0B 15 01 00 11 01", "490"), (Texts{"0B 15 01 00 11 00"})) << "no floor";
  EXPECT_EQ(answer_to("0B 09 01 00 18 01", "490"), (Texts{"0B 09 01 00 18 00"})) << "no door 4";
  EXPECT_TRUE(calls.calls().empty());
  answer_to("0E 0D 01 00 10 81");
  EXPECT_EQ(answer_to("0B 09 01 00 11 01", "490").back(), "0B 09 01 00 11 81")
      << "hall calls alone are disabled";
}

TEST_F(CallControllerTest, InTheCarACallToADestinationFloorIsTakenBackWithCarCallsAlone) {
  answer_to("0B 09 01 00 11 01", "490");
  calls.cancel(hall_calls);
  EXPECT_EQ(told(), Texts{});
  calls.adopt(0x02);
  EXPECT_EQ(told(), Texts{}) << "it was never a group's";
  calls.cancel(car_calls);
  EXPECT_EQ(told(), (Texts{"05 09 01 00 F1 00", "0B 09 01 00 11 00"}));
}

TEST_F(CallControllerTest, DestinationCallsBeyondItsMemoryAreNotAffirmed) {
  answer_to("08 09 01 03 11 01");
  answer_to("08 0A 01 03 11 01");
  EXPECT_EQ(answer_to("08 03 01 03 11 01"), (Texts{"08 03 01 03 11 00"})) << "it is there already";
  answer_to("08 0B 01 03 11 01");
  EXPECT_EQ(answer_to("08 0C 01 03 11 01"), (Texts{"08 0C 01 03 11 00"})) << "no memory";
  EXPECT_EQ(calls.destinations_without_room(), 1u);
  EXPECT_EQ(answer_to("08 03 01 03 11 01"), (Texts{"08 03 01 03 11 00"})) << "that is no floor";
  EXPECT_EQ(calls.answers_lost(), 0u);
  calls.answered(3, Direction::up);
  told();
  EXPECT_EQ(answer_to("08 0C 01 03 11 01"), (Texts{"08 0C 01 03 11 81"}));
}

TEST_F(CallControllerTest, NoDestinationCallIsLeftWithoutAnAnswerHoweverManyCome) {
  unsigned answered = 0;
  unsigned affirmed = 0;
  for (unsigned to = 2; to <= 20; ++to) {
    char text[32];
    std::snprintf(text, sizeof text, "08 %02X 01 01 11 01", to);
    for (const std::string& answer : answer_to(text)) {
      ++answered;
      affirmed += answer.ends_with("81") ? 1U : 0U;
    }
  }
  EXPECT_EQ(answered, 19u);
  EXPECT_EQ(affirmed, 3u);
  EXPECT_EQ(calls.destinations_without_room(), 15u) << "13 is locked, which is another reason";
}

TEST_F(CallControllerTest, AnswersBeyondWhatABlockedBusLeavesAreCounted) {
  for (const unsigned to : {9U, 10U, 11U}) {
    calls.take(
        {BasicFunction::standard_destination_call, static_cast<std::uint8_t>(to), 1, 3, 0x11, 1});
  }
  told();
  cable.send("000#80 01");
  for (std::uint8_t to = 2; to <= 12; ++to) {
    calls.take({BasicFunction::standard_destination_call, to, 1, 4, 0x11, 1});
  }
  EXPECT_EQ(calls.destinations_without_room(), 10u) << "4 is the floor itself";
  EXPECT_EQ(calls.answers_lost(), 3u) << "eight wait";
}

TEST_F(CallControllerTest, TheLiftThatLeavesDoesNotPutOutWhatIsShownOfAnother) {
  const VirtualInput call{BasicFunction::standard_destination_call, 9, 1, 3, 0x11, 1};
  calls.acknowledge_destination(call, true, 0b01);
  calls.acknowledge_destination(call, true, 0b10);
  EXPECT_EQ(told().back(), "08 09 02 03 11 81");
  calls.acknowledge_destination(call, false, 0b01);
  EXPECT_EQ(told(), Texts{});
  calls.acknowledge_destination(call, false, 0b10);
  EXPECT_EQ(told(), (Texts{"08 09 02 03 11 00"}));
}

TEST_F(CallControllerTest, AHallCallThatIsTakenAwayLeavesTheStopOfDestinationCalls) {
  const Call up_3{CallKind::up, CallPriority::standard, 3, 1};
  calls.add(up_3);
  calls.add_destination({BasicFunction::standard_destination_call, 9, 1, 3, 0x11, 1});
  calls.withdraw(up_3);
  EXPECT_TRUE(calls.calls().contains(up_3)) << "somebody is told that this lift comes";
  calls.withdraw_destination({BasicFunction::standard_destination_call, 9, 1, 3, 0x11, 1});
  EXPECT_TRUE(calls.calls().empty());
}

/// Its panel names no door: it waits at all doors of the floor.
TEST_F(CallControllerTest, ADestinationCallWithoutADoorKeepsItsStopWhenAHallCallIsTakenAway) {
  const Call up_3{CallKind::up, CallPriority::standard, 3, 1};
  calls.add(up_3);
  calls.add_destination({BasicFunction::standard_destination_call, 9, 1, 3, 0x01, 1});
  calls.withdraw(up_3);
  EXPECT_TRUE(calls.calls().contains(up_3));
}

TEST_F(CallControllerTest, ADestinationCallThatIsTakenAwayLeavesTheHallCallThatPanelsShow) {
  const Call up_3{CallKind::up, CallPriority::standard, 3, 1};
  calls.add(up_3);
  calls.acknowledge(up_3, true);
  calls.add_destination({BasicFunction::standard_destination_call, 9, 1, 3, 0x11, 1});
  calls.withdraw_destination({BasicFunction::standard_destination_call, 9, 1, 3, 0x11, 1});
  EXPECT_TRUE(calls.calls().contains(up_3));
}

TEST_F(CallControllerTest, SpecialFunctionsAreOnWhileTheyAreRequested) {
  for (unsigned function = 1; function <= 0x16; ++function) {
    char on[32];
    char off[32];
    std::snprintf(on, sizeof on, "0E %02X 01 00 10 81", function);
    std::snprintf(off, sizeof off, "0E %02X 01 00 10 80", function);
    EXPECT_EQ(answer_to(on), (Texts{on})) << "bit 7 of an acknowledgement is that it is affirmed";
    EXPECT_TRUE(calls.is_on(static_cast<SpecialFunction>(function)));
    char went[32];
    std::snprintf(went, sizeof went, "0E %02X 01 00 10 00", function);
    EXPECT_EQ(answer_to(off), (Texts{went}));
    EXPECT_FALSE(calls.is_on(static_cast<SpecialFunction>(function)));
  }
}

TEST_F(CallControllerTest, FansAndLoadTimesGoOnAndOffByOneButton) {
  for (const unsigned function : {1U, 2U, 3U, 4U}) {
    char press[32];
    char release[32];
    std::snprintf(press, sizeof press, "0E %02X 01 00 10 01", function);
    std::snprintf(release, sizeof release, "0E %02X 01 00 10 00", function);
    answer_to(press);
    EXPECT_EQ(answer_to(release), Texts{});
    EXPECT_TRUE(calls.is_on(static_cast<SpecialFunction>(function)));
    EXPECT_EQ(answer_to(press), (Texts{release}));
    EXPECT_FALSE(calls.is_on(static_cast<SpecialFunction>(function)));
  }
}

TEST_F(CallControllerTest, ABrokenWireNeitherEndsNorBeginsFireService) {
  answer_to("0E 0C 01 00 10 81");
  answer_to("0E 0C 01 00 10 82");
  EXPECT_TRUE(calls.is_on(SpecialFunction::fire_service));
  answer_to("0E 0D 01 00 10 81");
  answer_to("0E 0D 01 00 10 82");
  EXPECT_FALSE(calls.is_on(SpecialFunction::hall_call_disable));
}

TEST_F(CallControllerTest, WhileHallCallsAreDisabledNoneIsTaken) {
  answer_to("0E 0D 01 00 10 81");
  EXPECT_EQ(answer_to("02 01 01 03 10 01"), (Texts{"02 01 01 03 10 00"}));
  EXPECT_EQ(answer_to("08 09 01 03 11 01"), (Texts{"08 09 01 03 11 00"}));
  EXPECT_EQ(answer_to("05 07 01 00 11 01"), (Texts{"05 07 01 00 F1 81"}));
}

TEST_F(CallControllerTest, CallsThatAreTakenBackAreTold) {
  answer_to("02 01 01 03 10 01");
  answer_to("08 09 01 04 11 01");
  calls.cancel(hall_calls);
  EXPECT_EQ(told(), (Texts{"02 01 01 03 10 00", "08 09 01 04 11 00"}));
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(CallControllerTest, ALowCallBecomesAStandardOneInTime) {
  answer_to("03 01 01 03 10 01");
  cable.run_for(59s);
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::low, 3, 1}));
  cable.run_for(1s);
  EXPECT_TRUE(calls.calls().contains({CallKind::up, CallPriority::standard, 3, 1}));
  calls.answered(3, Direction::up);
  EXPECT_EQ(told(), (Texts{"03 01 01 03 10 00"})) << "the lamp is that of the button";
}

TEST_F(CallControllerTest, PanelsAreToldWhereTheCarIsAndGoes) {
  calls.display().floor = 7;
  calls.show();
  EXPECT_EQ(told(), (Texts{"40 07 01 00 F0 01", "40 07 01 FF F0 01"}))
      << "in the car, at all floors";
  calls.display().direction = Direction::up;
  calls.display().moving = true;
  calls.show();
  EXPECT_EQ(told(), (Texts{"42 11 01 00 F0 01", "42 11 01 FF F0 01"}));
  calls.display().moving = false;
  calls.display().direction = Direction::none;
  calls.show();
  EXPECT_EQ(told(), (Texts{"42 00 01 00 F0 00", "42 00 01 FF F0 00"}));
}

TEST_F(CallControllerTest, LanternsLightAndGoOutWhereTheyWereLit) {
  calls.display().lantern_floor = 3;
  calls.display().lantern_doors = 1;
  calls.display().lantern = Direction::down;
  calls.ring(3, 1, Direction::down);
  EXPECT_EQ(told(), (Texts{"41 02 01 03 10 01", "44 02 01 00 10 05", "44 02 01 03 10 05"}))
      << "the gong is an impulse";
  calls.display().lantern_floor = 9;
  calls.display().lantern = Direction::up;
  calls.show();
  EXPECT_EQ(told(), (Texts{"41 02 01 03 10 00", "41 01 01 09 10 01"}));
}

TEST_F(CallControllerTest, SpecialIndicationsOfTheCarAreShownInTheCar) {
  calls.display().specials = indication_bit(SpecialIndication::overload);
  calls.show();
  EXPECT_EQ(told(), (Texts{"43 03 01 00 F0 01"}));
  calls.display().specials = indication_bit(SpecialIndication::fire);
  calls.show();
  EXPECT_EQ(told(), (Texts{"43 03 01 00 F0 00", "43 04 01 00 F0 01", "43 04 01 FF F0 01"}));
}

TEST_F(CallControllerTest, WhatComesWhileItIsNotOperationalIsToldThen) {
  cable.send("000#80 01");
  cable.clear();
  calls.display().floor = 4;
  calls.show();
  EXPECT_EQ(told(), Texts{});
  cable.send("000#01 01");
  EXPECT_EQ(told(), (Texts{"40 04 01 00 F0 01", "40 04 01 FF F0 01"}));
}

TEST_F(CallControllerTest, AGroupIsAskedFirst) {
  struct Group {
    bool takes = true;
    VirtualInput last{};
    bool ask(const VirtualInput& input) {
      last = input;
      return takes;
    }
  } group;
  calls.on_hall_call(callback<&Group::ask>(group));
  EXPECT_EQ(answer_to("02 01 0F 03 10 01"), Texts{}) << "the group acknowledges";
  EXPECT_EQ(group.last.lifts, 0x0F);
  EXPECT_TRUE(calls.calls().empty());
  calls.acknowledge({CallKind::up, CallPriority::standard, 3, 1}, true);
  EXPECT_EQ(told(), (Texts{"02 01 01 03 10 81"}));
  calls.add({CallKind::up, CallPriority::standard, 3, 1});
  EXPECT_EQ(told(), Texts{}) << "an assignment is no news for panels";
  EXPECT_EQ(answer_to("05 07 01 00 11 01"), (Texts{"05 07 01 00 F1 81"})) << "not the group's";
  group.takes = false;
  EXPECT_EQ(answer_to("02 02 01 04 10 01"), (Texts{"02 02 01 04 10 81"})) << "alone again";
}

}  // namespace
}  // namespace canvoy::cia417::call_controller_test
