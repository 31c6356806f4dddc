// Lamps that the answers of a call controller switch on and off (CiA 417-4, 4.4.1): the record of
// one call must not switch off the lamp of another one. Bytes: basic function, sub-function, lift,
// floor, doors, data.
#include "canvoy/devices/cia417/call/call_controller_test.hpp"
#include "canvoy/devices/cia417/virtual_io/output_address.hpp"

namespace canvoy::cia417::call_lamps_test {
namespace {

/// A lamp in a panel: each record that addresses it switches it on or off.
struct Lamp {
  VirtualOutput assigned;
  bool is_lit = false;
};

constexpr VirtualOutput hall_lamp(std::uint8_t sub_function, std::uint8_t floor,
                                  std::uint8_t doors = 0x10) {
  return {BasicFunction::standard_hall_call, sub_function, 1, floor, doors};
}

/// Floors 1 to 20 with door 1, of which 1 to 5 have door 2, too.
class CallLampsTest : public CallControllerCable {
 protected:
  CallLampsTest() {
    cable.connect(0, device.node());
    start(1s);
  }
  /// Records sent up to this point, as the panel of the lamp receives them.
  void follow(Lamp& lamp) {
    for (const std::string& text : told()) {
      std::array<unsigned, 6> bytes{};
      std::sscanf(text.c_str(), "%2X %2X %2X %2X %2X %2X", &bytes[0], &bytes[1], &bytes[2],
                  &bytes[3], &bytes[4], &bytes[5]);
      std::uint64_t record = 0;
      for (std::size_t i = 0; i < bytes.size(); ++i) record |= std::uint64_t{bytes[i]} << 8 * i;
      const VirtualOutput output = decode_output(record);
      if (is_addressed(output, lamp.assigned)) lamp.is_lit = (output.data & 1) != 0;
    }
  }
  void press(const std::string& input, Lamp& lamp) {
    cable.send("495#" + input);
    follow(lamp);
  }

  CallControllerDevice<> device{
      cable.port(0), 1, {.lift = 1, .served = {FloorSet::between(1, 20), FloorSet::between(1, 5)}}};
  CallController& calls = device.calls();
};

TEST_F(CallLampsTest, ACallWithoutADirectionThatIsDoneLeavesTheLampsOfThoseThatStand) {
  Lamp down{hall_lamp(hall_down, 5)};
  press("02 02 01 05 10 01", down);
  press("02 03 01 05 10 01", down);
  ASSERT_TRUE(down.is_lit);
  calls.answered(5, Direction::up);
  EXPECT_TRUE(calls.calls().contains({CallKind::down, CallPriority::standard, 5, 1}));
  follow(down);
  EXPECT_TRUE(down.is_lit) << "who waits to go down is told that a car will come";
  calls.answered(5, Direction::down);
  follow(down);
  EXPECT_FALSE(down.is_lit);
}

TEST_F(CallLampsTest, OnTheWireWhatStandsFollowsWhatHasGone) {
  answer_to("02 02 01 05 10 01");
  answer_to("02 03 01 05 10 01");
  calls.answered(5, Direction::up);
  EXPECT_EQ(told(), (Texts{"02 03 01 05 10 00", "02 02 01 05 10 81"}));
}

TEST_F(CallLampsTest, ADirectedCallThatIsWithdrawnLeavesTheLampOfOneWithoutADirection) {
  Lamp any{hall_lamp(hall_undirected, 5)};
  press("02 03 01 05 10 01", any);
  press("02 01 01 05 10 01", any);
  calls.acknowledge({CallKind::up, CallPriority::standard, 5, 1}, false);
  follow(any);
  EXPECT_TRUE(any.is_lit);
}

TEST_F(CallLampsTest, OtherFloorsDoorsAndPrioritiesHaveLampsOfTheirOwn) {
  answer_to("02 02 01 04 10 01");
  answer_to("02 02 01 05 20 01");
  answer_to("03 02 01 05 10 01");
  answer_to("02 03 01 05 10 01");
  calls.acknowledge({CallKind::any, CallPriority::standard, 5, 1}, false);
  EXPECT_EQ(told(), (Texts{"02 03 01 05 10 00"})) << "and nothing is told again";
}

TEST_F(CallLampsTest, ARefusedCallWithoutADirectionLeavesTheLampsOfThoseThatStand) {
  Lamp down{hall_lamp(hall_down, 5)};
  press("02 02 01 05 10 01", down);
  calls.on_hall_call({});
  calls.accept(kinds_of(CallKind::down));
  press("02 03 01 05 10 01", down);
  EXPECT_TRUE(down.is_lit);
}

TEST_F(CallLampsTest, AHallCallWithNeitherDirectionIsNoCallAndDarkensNothing) {
  for (const char* standing : {"02 01 01 05 10 01", "02 02 01 05 10 01", "02 03 01 05 10 01"}) {
    answer_to(standing);
  }
  for (const char* reserved : {"02 00 01 05 10 01", "03 04 01 05 10 01", "04 FC 01 05 10 01"}) {
    EXPECT_EQ(answer_to(reserved), Texts{}) << reserved << ": 00h is reserved, as of other calls";
  }
}

TEST_F(CallLampsTest, WhereTheLiftHasNoDoorACallWithoutOneIsAnsweredAllTheSame) {
  EXPECT_EQ(answer_to("05 15 01 00 00 01", "490"), (Texts{"05 15 01 00 F1 00"})) << "floor 21";
  EXPECT_EQ(answer_to("07 FE 01 00 10 01", "490"), (Texts{"07 FE 01 00 F1 00"})) << "floor 254";
  EXPECT_EQ(answer_to("02 02 01 15 00 01"), (Texts{"02 02 01 15 10 00"})) << "a hall call there";
}

TEST_F(CallLampsTest, OfACallForTwoDoorsTheOneThatIsNotThereIsRefused) {
  answer_to("05 07 01 00 11 01", "490");
  EXPECT_EQ(answer_to("05 07 01 00 13 01", "490"), (Texts{"05 07 01 00 F2 00"}))
      << "door 1 goes on to be lit";
  EXPECT_TRUE(calls.calls().contains({CallKind::car, CallPriority::standard, 7, 1}));
}

TEST_F(CallLampsTest, FromTheTopNobodyGoesUpAndFromTheBottomNobodyDown) {
  EXPECT_EQ(answer_to("02 01 01 14 10 01"), (Texts{"02 01 01 14 10 00"}));
  EXPECT_EQ(answer_to("04 02 01 01 10 01"), (Texts{"04 02 01 01 10 00"}));
  EXPECT_TRUE(calls.calls().empty());
  EXPECT_EQ(answer_to("02 02 01 14 10 01"), (Texts{"02 02 01 14 10 81"}));
  EXPECT_EQ(answer_to("02 01 01 01 10 01"), (Texts{"02 01 01 01 10 81"}));
  EXPECT_EQ(answer_to("02 03 01 14 10 01"), (Texts{"02 03 01 14 10 81"})) << "no direction is said";
  EXPECT_EQ(answer_to("02 01 01 05 20 01"), (Texts{"02 01 01 05 20 81"}))
      << "the highest floor of door 2: in the car there is door 1";
}

TEST_F(CallLampsTest, WhatAGroupShowedBeyondTheReachOfThisLiftIsNotItsOwnAfterwards) {
  for (const Call& call : {Call{CallKind::down, CallPriority::standard, 25, 1},
                           Call{CallKind::up, CallPriority::standard, 20, 1},
                           Call{CallKind::down, CallPriority::standard, 4, 1}}) {
    calls.acknowledge(call, true);
  }
  told();
  calls.adopt(1);
  EXPECT_EQ(calls.calls().floors(all_calls), FloorSet::between(4, 4));
  EXPECT_EQ(told(), (Texts{"02 01 01 14 10 00", "02 02 01 19 10 00"})) << "no car will come";
}

}  // namespace
}  // namespace canvoy::cia417::call_lamps_test
