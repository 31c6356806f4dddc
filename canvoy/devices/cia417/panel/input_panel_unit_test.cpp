// Inputs of a panel at the wire: their stored states and sent records, at exact virtual times.
// Bytes are typed from CiA 417-4, 4.3.
#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/panel/input_panel_test.hpp"

namespace canvoy::cia417::input_panel_unit_test {
namespace {

class InputPanelUnitTest : public testing::Test {
 protected:
  PanelBench<> bench;
};

TEST_F(InputPanelUnitTest, AChangeIsStoredInItsGroupAndToldInAPdo) {
  bench.start();
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"}));
  EXPECT_EQ(bench.stored(0x6100, 1), 0x0110'0301'0102u);
  EXPECT_EQ(bench.stored(0x6010, 0), 0x0110'0301'0102u);
  bench.release(0);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 00"}));
  EXPECT_EQ(bench.stored(0x6100, 1), 0x0010'0301'0102u);
}

TEST_F(InputPanelUnitTest, TheSameLevelAgainIsNoChange) {
  bench.start();
  bench.press(1);
  bench.press(1);
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 01"}));
  bench.release(0);
  EXPECT_EQ(bench.told(), Records{});
}

TEST_F(InputPanelUnitTest, TheFunctionSaysWhereTheInputIs) {
  bench.start();
  bench.press(3);
  EXPECT_EQ(bench.told(), (Records{"05 07 01 00 01 01"})) << "a car call to floor 7, by door 1";
}

TEST_F(InputPanelUnitTest, AKeyWithALockingFunctionSaysSoInBit7) {
  bench.start();
  bench.press(2);
  EXPECT_EQ(bench.told(), (Records{"0E 0C 01 03 00 81"}));
  bench.release(2);
  EXPECT_EQ(bench.told(), (Records{"0E 0C 01 03 00 80"}));
}

TEST_F(InputPanelUnitTest, ManyChangesAtOnceAreToldOneAfterTheOtherInTheirOrder) {
  bench.start();
  for (const std::uint32_t input : {3U, 0U, 2U, 1U}) {
    bench.panel.unit().set_level(input, true, bench.cable.now);
  }
  bench.panel.unit().set_level(0, false, bench.cable.now);
  bench.cable.run_for(0ms);
  EXPECT_EQ(bench.told(), (Records{"05 07 01 00 01 01", "02 01 01 03 10 01", "0E 0C 01 03 00 81",
                                   "02 02 01 03 10 01", "02 01 01 03 10 00"}));
}

TEST_F(InputPanelUnitTest, AnInhibitTimeSpreadsThemAndLosesNone) {
  bench.start();
  bench.hold_up();
  bench.cable.run_until(Time(1s));
  for (const std::uint32_t input : {0U, 1U, 2U}) bench.press(input);
  bench.release(1);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.reported_at(),
            (Records{"1000000 02 01 01 03 10 01", "1100000 02 02 01 03 10 01",
                     "1200000 0E 0C 01 03 00 81", "1300000 02 02 01 03 10 00"}));
}

TEST_F(InputPanelUnitTest, InputsThatAreOnAreToldWhenTheNodeBecomesOperational) {
  bench.panel.unit().set_level(1, true, Time{});
  bench.cable.start_all();
  bench.cable.run_until(Time(1s));
  EXPECT_EQ(bench.told(), Records{}) << "no PDOs before";
  bench.cable.send("000#01 15");
  bench.cable.run_for(0ms);
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 01", "0E 0C 01 03 00 80"}))
      << "the key is told in either position";
}

TEST_F(InputPanelUnitTest, WithoutAnythingToTellTheFirstPdoIsStillAnInput) {
  const std::span<const VirtualInput> one(bench_inputs, 1);
  PanelBench<> quiet(one);
  quiet.cable.start_all();
  quiet.cable.send("000#01 15");
  quiet.cable.run_for(0ms);
  EXPECT_EQ(quiet.told(), (Records{"02 01 01 03 10 00"}));
}

TEST_F(InputPanelUnitTest, WhatChangesWhileTheNodeIsStoppedIsToldWhenItRunsAgain) {
  bench.start();
  bench.press(2);
  bench.press(0);
  bench.cable.send("000#02 15");
  bench.told();
  bench.release(2);
  bench.press(1);
  bench.release(1);
  EXPECT_EQ(bench.told(), Records{});
  EXPECT_EQ(bench.stored(0x6100, 3), 0x8000'0301'0C0Eu) << "stored all the same";
  bench.cable.send("000#01 15");
  bench.cable.run_for(0ms);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01", "0E 0C 01 03 00 80"}))
      << "a button that was pressed while nobody could hear it is no call";
}

TEST_F(InputPanelUnitTest, AResetTellsAllThatIsOnAgain) {
  bench.start();
  bench.press(0);
  bench.cable.send("000#81 15");
  bench.cable.send("000#01 15");
  bench.cable.run_for(0ms);
  bench.cable.clear();
  bench.release(0);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 00"}));
}

TEST_F(InputPanelUnitTest, DefectiveAndNotInstalledAreTold) {
  bench.start();
  bench.press(0);
  bench.told();
  bench.report(0, CallRequest::defective, 0x12);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 02"}));
  EXPECT_EQ(bench.stored(0x6120, 1), 0xFFFF'12FFu) << "4.3.2: the error status";
  bench.release(0);
  bench.press(0);
  EXPECT_EQ(bench.told(), Records{}) << "it does not work";
  bench.report(0, CallRequest::none);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"})) << "it works again, and is pressed";
  EXPECT_EQ(bench.stored(0x6120, 1), 0xFFFF'FFFFu);
  bench.report(1, CallRequest::not_installed);
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 03"}));
  bench.report(2, CallRequest::defective);
  EXPECT_EQ(bench.told(), (Records{"0E 0C 01 03 00 82"})) << "the locking function stays";
}

TEST_F(InputPanelUnitTest, WhatHasNoFunctionTellsNothing) {
  constexpr VirtualInput none[] = {{.lifts = lift_bit(1), .data = VirtualInput::lock_bit}};
  PanelBench<> quiet(none);
  quiet.start();
  quiet.press(0);
  quiet.press(3);
  EXPECT_EQ(quiet.told(), Records{}) << "function 00h is reserved";
}

TEST_F(InputPanelUnitTest, AnInputIsFoundByItsFunctionAndFloor) {
  bench.start();
  EXPECT_EQ(bench.panel.unit().find(BasicFunction::standard_hall_call, hall_down, 3), 1u);
  EXPECT_EQ(bench.panel.unit().find(BasicFunction::standard_car_call, 7, floor_of_car), 3u);
  EXPECT_EQ(bench.panel.unit().find(BasicFunction::standard_hall_call, hall_down, 4), io_nowhere);
}

TEST_F(InputPanelUnitTest, InputsThatAreNotThereAreIgnored) {
  bench.start();
  bench.press(4);
  bench.report(0xFFFF'FFFF, CallRequest::defective);
  EXPECT_EQ(bench.told(), Records{});
}

TEST_F(InputPanelUnitTest, WhileThePdoIsInvalidStatesAreKeptForLater) {
  bench.start();
  EXPECT_TRUE(bench.write("23 81 18 01 95 04 00 80"));
  bench.press(0);
  bench.press(1);
  bench.release(1);
  EXPECT_EQ(bench.told(), Records{});
  EXPECT_EQ(bench.stored(0x6010, 0), 0x0010'0301'0202u) << "4.2.3: mapped all the same";
  EXPECT_TRUE(bench.write("23 81 18 01 95 04 00 00"));
  bench.cable.run_for(0ms);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01", "02 02 01 03 10 01", "02 02 01 03 10 00"}));
}

constexpr auto synchronous_panel =
    describe(panel<PanelOptions{.inputs = 4}>(), cia301::identity({}), cia301::sync_consumer());
constexpr auto synchronous_layout = partial(lay_out_device<synchronous_panel>());

TEST(InputPanelUnit, ASynchronousPdoCarriesOneRecordForEachSync) {
  PanelBench<synchronous_layout> bench;
  bench.start();
  bench.write("23 81 18 01 95 04 00 80");
  EXPECT_TRUE(bench.write("2F 81 18 02 01 00 00 00"));
  EXPECT_TRUE(bench.write("23 81 18 01 95 04 00 00"));
  bench.cable.clear();
  bench.press(0);
  bench.press(1);
  EXPECT_EQ(bench.told(), Records{});
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"}));
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 01"}));
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 01"})) << "the last one again";
}

TEST(InputPanelUnit, AnAcyclicPdoCarriesOneRecordForEachSyncWhileThereIsOne) {
  PanelBench<synchronous_layout> bench;
  bench.start();
  bench.write("23 81 18 01 95 04 00 80");
  EXPECT_TRUE(bench.write("2F 81 18 02 00 00 00 00"));
  EXPECT_TRUE(bench.write("23 81 18 01 95 04 00 00"));
  bench.cable.send("080#");
  bench.cable.clear();
  bench.press(0);
  bench.release(0);
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"}));
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 00"}));
  bench.cable.send("080#");
  EXPECT_EQ(bench.told(), Records{});
}

TEST(InputPanelUnit, APdoThatIsSampledForRequestsAloneIsNotFed) {
  PanelBench<synchronous_layout> bench;
  bench.start();
  bench.write("23 81 18 01 95 04 00 80");
  EXPECT_TRUE(bench.write("2F 81 18 02 FC 00 00 00")) << "type 252";
  EXPECT_TRUE(bench.write("23 81 18 01 95 04 00 00"));
  bench.press(0);
  bench.cable.send("080#");
  bench.release(0);
  EXPECT_EQ(bench.panel.unit().waiting(), 1u) << "kept for a PDO that tells it";
}

// More at once than the queue can hold

TEST(InputPanelUnit, BeyondTheQueueEachInputIsToldWithAMissedRequestFirst) {
  PanelBench<bench_panel_layout, 2> bench;
  bench.start();
  bench.hold_up();
  for (const std::uint32_t input : {0U, 1U, 3U, 2U}) {
    bench.panel.unit().set_level(input, true, bench.cable.now);
  }
  EXPECT_EQ(bench.panel.unit().waiting(), 4u);
  bench.panel.unit().set_level(3, false, bench.cable.now);
  bench.panel.unit().set_level(0, false, bench.cable.now);
  EXPECT_EQ(bench.panel.unit().waiting(), 5u) << "0 waits in the queue, and is behind";
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01", "02 02 01 03 10 01", "0E 0C 01 03 00 81",
                                   "05 07 01 00 01 01", "05 07 01 00 01 00", "02 01 01 03 10 00"}))
      << "those that are behind have turns, from the last that was (the key, at the start)";
  EXPECT_EQ(bench.panel.unit().waiting(), 0u);
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"})) << "all is as before";
}

TEST(InputPanelUnit, WithoutAQueueAllIsToldAllTheSame) {
  PanelBench<bench_panel_layout, 0> bench;
  bench.start();
  bench.press(1);
  bench.release(1);
  EXPECT_EQ(bench.told(), (Records{"02 02 01 03 10 01", "02 02 01 03 10 00"}));
}

/// Every sequence of six presses and releases of two buttons while the bus is held up: the records
/// of each begin with its first request and end with its state; only a request is repeated.
TEST(InputPanelUnit, WhateverComesWhileTheBusIsBusyTheStateIsToldInTheEnd) {
  for (unsigned sequence = 0; sequence < 64; ++sequence) {
    PanelBench<bench_panel_layout, 2> bench;
    bench.start();
    bench.hold_up();
    bool level[2] = {false, false};
    bool pressed[2] = {false, false};
    for (unsigned step = 0; step < 6; ++step) {
      const unsigned input = sequence >> step & 1;
      level[input] = !level[input];
      pressed[input] = true;
      bench.panel.unit().set_level(input, level[input], bench.cable.now);
    }
    bench.cable.run_for(1s);
    for (unsigned input = 0; input < 2; ++input) {
      const std::string button = input == 0 ? "02 01 01 03 10 0" : "02 02 01 03 10 0";
      std::string states;
      for (const Cable::Heard& heard : bench.cable.heard) {
        const std::string record = wire_text(heard.frame).substr(4);
        if (record.starts_with(button)) states += record.back();
      }
      if (!pressed[input]) continue;
      ASSERT_FALSE(states.empty()) << sequence;
      EXPECT_EQ(states.front(), '1') << sequence;
      EXPECT_EQ(states.back(), level[input] ? '1' : '0') << sequence << " " << states;
      EXPECT_EQ(states.find("00"), std::string::npos) << states;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::input_panel_unit_test
