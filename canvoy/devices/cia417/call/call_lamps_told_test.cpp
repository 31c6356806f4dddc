// Acknowledgements that panels receive. Records: basic function, sub-function, lifts, floor, doors,
// data (CiA 417-4, 4.4.1).
#include "canvoy/devices/cia417/call/call_lamps.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::cia417::call_lamps_told_test {
namespace {

constexpr std::uint8_t lift_2 = lift_bit(2);
constexpr Call up{.kind = CallKind::up, .floor = 3};
constexpr Call down{.kind = CallKind::down, .floor = 3};
constexpr Call any{.kind = CallKind::any, .floor = 3};

std::vector<VirtualOutput> tell(CallLamps& lamps) {
  std::vector<VirtualOutput> told;
  while (lamps.waits() && told.size() < 100) told.push_back(lamps.next(lift_2));
  return told;
}
VirtualOutput hall_lamp(std::uint8_t sub_function, bool on) {
  return {BasicFunction::standard_hall_call,         sub_function, 0x02, 3, 0x10,
          output_data(on, Property::standard, 0, on)};
}

TEST(CallLamps, ALampIsToldOnceAndAgainWhenItGoesOut) {
  CallLamps lamps;
  lamps.set(up, true);
  EXPECT_EQ(tell(lamps), std::vector{hall_lamp(0x01, true)});
  EXPECT_TRUE(tell(lamps).empty());
  lamps.end_at(3, calls_up);
  EXPECT_EQ(tell(lamps), std::vector{hall_lamp(0x01, false)});
}

TEST(CallLamps, WhoPressesAgainGetsAnotherAnswer) {
  CallLamps lamps;
  lamps.set(up, true);
  tell(lamps);
  lamps.set(up, true);
  EXPECT_EQ(tell(lamps), std::vector{hall_lamp(0x01, true)});
}

TEST(CallLamps, WhatChangesTwiceBeforeItIsToldIsNotTold) {
  CallLamps lamps;
  lamps.set(up, true);
  lamps.end(up);
  EXPECT_TRUE(tell(lamps).empty());
}

TEST(CallLamps, ACallWithoutDirectionThatGoesOutPutsOutBothLampsSoThatOneOfACallIsLitAgain) {
  CallLamps lamps;
  lamps.set(any, true);
  lamps.set(up, true);
  tell(lamps);
  lamps.end(any);
  EXPECT_EQ(tell(lamps), (std::vector{hall_lamp(0x03, false), hall_lamp(0x01, true)}));
}

TEST(CallLamps, PanelsThatComeAreToldWhatIsLitAndWhatWasOnce) {
  CallLamps lamps;
  lamps.set(up, true);
  lamps.set(down, true);
  tell(lamps);
  lamps.end(down);
  tell(lamps);
  lamps.report_again();
  EXPECT_EQ(tell(lamps), (std::vector{hall_lamp(0x01, true), hall_lamp(0x02, false)}));
  EXPECT_TRUE(tell(lamps).empty());
}

TEST(CallLamps, OtherPanelsAreToldWhatIsLitOnly) {
  CallLamps lamps;
  lamps.set(up, true);
  lamps.set(down, true);
  lamps.end(down);
  tell(lamps);
  lamps.forget();
  EXPECT_EQ(tell(lamps), std::vector{hall_lamp(0x01, true)});
}

}  // namespace
}  // namespace canvoy::cia417::call_lamps_told_test
