#include "canvoy/worlds/excavator/valves_hardware.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "canvoy/worlds/excavator/host_objects.hpp"

namespace canvoy::excavator::valves_hardware_test {
namespace {

class ValvesHardwareTest : public testing::Test {
 protected:
  Excavator machine;
  std::vector<std::pair<Button, bool>> switched;
  ValvesHardware sut{machine,
                     [this](Button button, bool is_on) { switched.emplace_back(button, is_on); }};
  cia401::IoHardware module = sut.hardware();
};

TEST_F(ValvesHardwareTest, EachOutputThatIsAnotherThanBeforeIsTold) {
  module.drive_digital(1, bit_of(Switched::light) | bit_of(Switched::pilot_pressure));
  module.drive_digital(1, bit_of(Switched::pilot_pressure));
  EXPECT_EQ(switched, (std::vector<std::pair<Button, bool>>{
                          {Button::light, true}, {Button::lock, true}, {Button::light, false}}));
  EXPECT_TRUE(sut.is_on(Switched::pilot_pressure));
  EXPECT_TRUE(machine.has_pilot_pressure());
  module.drive_digital(2, 0xFF);
  EXPECT_EQ(sut.outputs(), bit_of(Switched::pilot_pressure)) << "nothing is wired to group 2";
}

/// Values of converters are in the upper half of 32 bits (CiA 401: 6401h has 16 of them).
TEST_F(ValvesHardwareTest, AValueOfASensorIsAdjustedToTheLeft) {
  const double degrees = machine.angle(Movement::boom);
  const auto value = module.analogue_input(static_cast<unsigned>(Sensor::boom));
  EXPECT_NEAR(value / 65'536.0, degrees * 100, 1) << "hundredths of a degree";
  EXPECT_EQ(value % 65'536, 0);
  EXPECT_EQ(module.analogue_input(sensors + 1), 0);
}

TEST_F(ValvesHardwareTest, WithoutPowerValvesCloseAndNothingIsSwitched) {
  module.drive_digital(1, bit_of(Switched::pilot_pressure));
  module.drive_analogue(1, static_cast<std::int32_t>(valve_digits) * 65'536);
  for (int i = 0; i < 100; ++i) machine.step(0.02);
  ASSERT_NE(machine.speed(Movement{0}), 0);
  sut.release();
  EXPECT_EQ(sut.outputs(), 0U);
  EXPECT_EQ(switched.back(), std::pair(Button::lock, false));
  for (int i = 0; i < 250; ++i) machine.step(0.02);
  EXPECT_EQ(machine.speed(Movement{0}), 0);
}

TEST_F(ValvesHardwareTest, ARealModulesValvesFollowWhatTheHostTellsIt) {
  Frame switches = Frame::data_frame(switches_id, {0x10, 0, 0, 0, 0, 0, 0, 0});
  sut.follow(switches);
  EXPECT_TRUE(machine.has_pilot_pressure());
  // 32,000 digits are 7D00h, low byte first: the first valve is open.
  sut.follow(Frame::data_frame(valve_id, {0x00, 0x7D, 0, 0, 0, 0, 0, 0}));
  for (int i = 0; i < 100; ++i) machine.step(0.02);
  EXPECT_GT(machine.speed(Movement{0}), 0);
  switches.length = 7;
  switches.data[0] = 0;
  sut.follow(switches);
  EXPECT_TRUE(machine.has_pilot_pressure()) << "a frame that is too short is none";
}

}  // namespace
}  // namespace canvoy::excavator::valves_hardware_test
