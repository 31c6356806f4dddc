// The output groups of a call controller: the last records for panels, read by SDO. Records: basic
// function, sub-function, lifts, floor, doors, data.
#include "canvoy/devices/cia417/call/call_outputs.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_of_four_floors_test.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"

namespace canvoy::cia417::call_outputs_test {
namespace {

constexpr VirtualOutput outputs[] = {
    {BasicFunction::standard_hall_call, hall_up, 1, 3, 0x10},
    {BasicFunction::standard_hall_call, hall_down, 1, 3, 0x10},
    {BasicFunction::standard_car_call, 9, 1, 0, 0x11},
    {BasicFunction::position_indicator, 0, 1, 0, 0x10},
    {BasicFunction::position_indicator, 0, 1, 7, 0x10},
    {BasicFunction::special_indication, sub_function_of(SpecialIndication::fire), 1, 7, 0x10}};

class CallOutputsTest : public testing::Test, protected DeviceOnCable<CallControllerDevice<>> {
 protected:
  CallOutputsTest() : DeviceOnCable(NodeId{1}, settings(), std::span(outputs)) { start(); }
  static CallControllerSettings settings() {
    return {.lift = 1, .served = {FloorSet::between(1, 20)}};
  }
  std::uint64_t at(std::uint8_t sub) {
    cable.run_for(10ms);
    return device.node().dictionary().number(0x6200, sub);
  }
};

TEST_F(CallOutputsTest, AGroupHas254OutputsThatAreReadBySdo) {
  EXPECT_EQ(ask("40 00 62 00 00 00 00 00"), "4F 00 62 00 FE 00 00 00");
  EXPECT_EQ(ask("40 00 62 01 00 00 00 00"), "41 00 62 01 06 00 00 00") << "48 bits";
  EXPECT_EQ(ask("60 00 00 00 00 00 00 00"), "03 02 01 01 03 10 00 00") << "assigned, and not lit";
}

TEST_F(CallOutputsTest, TheControllerProvidesThemAndNobodyElseWritesThem) {
  EXPECT_EQ(ask("21 00 62 01 06 00 00 00"), "80 00 62 01 02 00 01 06");
}

TEST_F(CallOutputsTest, AnAcknowledgementIsThatOfItsOutput) {
  cable.send("495#02 01 01 03 10 01");
  EXPECT_EQ(at(1), 0x8110'0301'0102u);
  EXPECT_EQ(at(2), 0x0010'0301'0202u) << "the button down is another one";
  cable.send("490#05 09 01 00 11 01");
  EXPECT_EQ(at(3), 0x8111'0001'0905u);
  device.calls().answered(3, Direction::up);
  EXPECT_EQ(at(1), 0x0010'0301'0102u);
}

TEST_F(CallOutputsTest, AnIndicationToAllFloorsIsThatOfEach) {
  device.calls().display().floor = 12;
  device.calls().show();
  EXPECT_EQ(at(4), 0x0110'0001'0C40u);
  EXPECT_EQ(at(5), 0x0110'0701'0C40u);
}

TEST_F(CallOutputsTest, AnIndicationIsThatOfTheOutputThatHasIt) {
  device.calls().display().specials = indication_bit(SpecialIndication::full_load);
  device.calls().show();
  EXPECT_EQ(at(6), 0x0010'0701'0443u);
  device.calls().display().specials = indication_bit(SpecialIndication::fire);
  device.calls().show();
  EXPECT_EQ(at(6), 0x0110'0701'0443u);
}

TEST_F(CallOutputsTest, AResetOfTheNodeForgetsThem) {
  cable.send("495#02 01 01 03 10 01");
  ASSERT_EQ(at(1), 0x8110'0301'0102u);
  cable.send("000#81 01");
  EXPECT_EQ(at(1), 0x0010'0301'0102u);
}

// The output groups of a whole lift controller, here of lift 2. An output without a lift belongs to
// its lift.
constexpr VirtualOutput lamps[] = {{BasicFunction::standard_hall_call, hall_up, 0, 3, 0x10},
                                   {BasicFunction::standard_hall_call, hall_up, 2, 4, 0x10}};
using LiftOfOutputs = LiftControllerDevice<LiftControllerOptions{.lift = 2, .outputs = 300}>;

class OutputsOfALift : public testing::Test, protected DeviceOnCable<LiftOfOutputs> {
 protected:
  OutputsOfALift() : DeviceOnCable(NodeId{1}, lift_of_four_floors(lamps)) { start(); }
  /// Six bytes in two segments.
  std::string read(const std::string& object) {
    cable.run_for(10ms);
    ask("40 " + object + " 00 00 00 00");
    return ask("60 00 00 00 00 00 00 00");
  }
};

TEST_F(OutputsOfALift, TheyAreInItsObjectsAndInAsManyGroupsAsThereAreOutputs) {
  EXPECT_EQ(ask("40 00 6A 00 00 00 00 00"), "4F 00 6A 00 FE 00 00 00");
  EXPECT_EQ(ask("40 01 6A 00 00 00 00 00"), "4F 01 6A 00 2E 00 00 00") << "300 are 254 and 46";
  EXPECT_EQ(ask("40 00 62 01 00 00 00 00"), "80 00 62 01 00 00 02 06") << "that is lift 1";
  EXPECT_EQ(read("00 6A 01"), "03 02 01 02 03 10 00 00");
}

TEST_F(OutputsOfALift, AnAcknowledgementIsThatOfItsOutput) {
  cable.send("495#02 01 02 03 10 01");
  EXPECT_EQ(read("00 6A 01"), "03 02 01 02 03 10 81 00");
  EXPECT_EQ(read("00 6A 02"), "03 02 01 02 04 10 00 00");
}

TEST_F(OutputsOfALift, InAnotherLiftThoseOfNoLiftAreThatLifts) {
  ASSERT_EQ(ask("2F 01 60 00 01 00 00 00"), "60 01 60 00 00 00 00 00");
  cable.send("495#02 01 01 03 10 01");
  EXPECT_EQ(read("00 62 01"), "03 02 01 01 03 10 81 00");
}

}  // namespace
}  // namespace canvoy::cia417::call_outputs_test
