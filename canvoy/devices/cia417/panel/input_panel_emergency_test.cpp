// The emergency of an input that is defective: FF04h, with the number of the input (CiA
// 417-1, 8.4).
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/panel/input_panel_test.hpp"

namespace canvoy::cia417::input_panel_emergency_test {
namespace {

constexpr auto telling_panel =
    describe(panel<PanelOptions{.inputs = 4}>(), cia301::identity({}), cia301::emergency());
constexpr auto telling_panel_layout = partial(lay_out_device<telling_panel>());

const Records first_is_defective{"04 FF 21 01 00 00 00 00"};
const Records none_is_left{"00 00 00 00 00 00 00 00"};

struct InputPanelEmergencyTest : testing::Test {
  InputPanelEmergencyTest() { bench.start(); }
  Records told() {
    Records all;
    for (const Cable::Heard& heard : bench.cable.heard) {
      if (heard.frame.id == 0x095) all.push_back(wire_text(heard.frame).substr(4));
    }
    bench.cable.clear();
    return all;
  }
  PanelBench<telling_panel_layout> bench;
};

TEST_F(InputPanelEmergencyTest, EachDefectIsToldAndItsEnd) {
  bench.report(0, CallRequest::defective);
  EXPECT_EQ(told(), first_is_defective);
  bench.report(3, CallRequest::defective);
  EXPECT_EQ(told(), (Records{"04 FF 21 04 00 00 00 00"}));
  bench.report(0, CallRequest::none);
  EXPECT_EQ(told(), (Records{"00 00 21 00 00 00 00 00"})) << "the other is there still";
  bench.report(3, CallRequest::none);
  EXPECT_EQ(told(), none_is_left);
}

TEST_F(InputPanelEmergencyTest, ADefectIsToldOnce) {
  bench.report(0, CallRequest::defective, 0x12);
  bench.report(0, CallRequest::defective, 0x13);
  EXPECT_EQ(told(), first_is_defective);
}

TEST_F(InputPanelEmergencyTest, WhatIsPressedOrNotInstalledIsNoDefect) {
  bench.press(1);
  bench.report(0, CallRequest::not_installed);
  EXPECT_EQ(told(), Records{});
  bench.report(0, CallRequest::defective);
  bench.report(0, CallRequest::not_installed);
  EXPECT_EQ(told(), (Records{first_is_defective[0], none_is_left[0]}));
}

TEST_F(InputPanelEmergencyTest, ADefectOfADisabledInputIsNone) {
  bench.write("23 20 61 01 FE FF FF FF");
  bench.report(0, CallRequest::defective);
  EXPECT_EQ(told(), Records{});
  bench.write("23 20 61 01 FF FF FF FF");
  EXPECT_EQ(told(), first_is_defective);
  bench.write("23 20 61 01 FE FF FF FF");
  EXPECT_EQ(told(), none_is_left);
}

TEST_F(InputPanelEmergencyTest, ADefectThatIsThereStillIsToldAgainAfterAReset) {
  bench.report(0, CallRequest::defective);
  told();
  for (const char* reset : {"000#81 15", "000#82 15"}) {
    bench.cable.send(reset);
    bench.cable.run_for(0ms);
    EXPECT_EQ(told(), first_is_defective) << reset;
    bench.cable.send("000#01 15");
    bench.cable.run_for(0ms);
    EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 02", "0E 0C 01 03 00 80"})) << reset;
  }
  bench.report(0, CallRequest::none);
  EXPECT_EQ(told(), none_is_left);
}

TEST_F(InputPanelEmergencyTest, APanelThatIsStartedAgainTellsItAgain) {
  bench.report(0, CallRequest::defective);
  told();
  bench.panel.node().start(bench.cable.now);
  bench.cable.run_for(0ms);
  EXPECT_EQ(told(), first_is_defective);
}

}  // namespace
}  // namespace canvoy::cia417::input_panel_emergency_test
