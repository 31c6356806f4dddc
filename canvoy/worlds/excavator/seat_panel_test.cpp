#include "canvoy/worlds/excavator/seat_panel.hpp"

#include <gtest/gtest.h>

namespace canvoy::excavator::seat_panel_test {
namespace {

class SeatPanelModule : public testing::Test {
 protected:
  unsigned contacts(unsigned joystick) { return module.joystick_buttons(joystick); }

  SeatPanel panel;
  cia852::OperatorHardware module = panel.hardware();
};

// Buttons 5 to 8 of a joystick: x-, x+, y-, y+.
TEST_F(SeatPanelModule, EachDirectionOfAStickHasItsContact) {
  struct Way {
    Stick stick;
    unsigned joystick;
    unsigned less;
    unsigned more;
  };
  for (const Way& way : {Way{Stick::left_x, 1, 0x10, 0x20}, Way{Stick::left_y, 1, 0x40, 0x80},
                         Way{Stick::right_x, 2, 0x10, 0x20}, Way{Stick::right_y, 2, 0x40, 0x80}}) {
    panel.move_stick(way.stick, -0.05);
    EXPECT_EQ(contacts(way.joystick), way.less);
    EXPECT_EQ(contacts(3 - way.joystick), 0u) << "the other stick rests";
    panel.move_stick(way.stick, 0.05);
    EXPECT_EQ(contacts(way.joystick), way.more);
    panel.move_stick(way.stick, 0.03);
    EXPECT_EQ(contacts(way.joystick), 0u);
    panel.move_stick(way.stick, 0);
  }
  panel.move_stick(Stick::left_x, 1);
  panel.move_stick(Stick::left_y, -1);
  EXPECT_EQ(contacts(1), 0x60u);
}

TEST_F(SeatPanelModule, AnAxisIsSensedFromEndToEnd) {
  panel.move_stick(Stick::left_x, -1);
  panel.move_stick(Stick::left_y, 0.5);
  panel.move_stick(Stick::right_y, 1);
  EXPECT_EQ(module.joystick_axis(1, 1), -32'000);
  EXPECT_EQ(module.joystick_axis(1, 2), 16'000);
  EXPECT_EQ(module.joystick_axis(1, 3), 0) << "there is no third";
  EXPECT_EQ(module.joystick_axis(2, 1), 0);
  EXPECT_EQ(module.joystick_axis(2, 2), 32'000);
}

TEST_F(SeatPanelModule, AJamKeepsWhereItBeganAndABrokenWireReadsAsNoPosition) {
  panel.move_stick(Stick::right_x, 0.25);
  panel.jam(Stick::right_x, true);
  panel.move_stick(Stick::right_x, 0.75);
  panel.jam(Stick::right_x, true);
  EXPECT_EQ(module.joystick_axis(2, 1), 8'000);
  panel.break_wire(Stick::right_x, true);
  EXPECT_EQ(module.joystick_axis(2, 1), INT16_MIN);
  panel.break_wire(Stick::right_x, false);
  panel.jam(Stick::right_x, false);
  EXPECT_EQ(module.joystick_axis(2, 1), 24'000);
}

TEST_F(SeatPanelModule, PedalsWheelsAndButtonsCountFrom1) {
  panel.move_pedal(0, 0.5);
  panel.move_pedal(1, -0.5);
  panel.turn_wheel(1, 1);
  panel.press(Button::horn, true);
  panel.press(Button::lock, true);
  EXPECT_EQ(module.foot_pedal(1), 16'000);
  EXPECT_EQ(module.foot_pedal(2), -16'000);
  EXPECT_EQ(module.wheel(1), 0);
  EXPECT_EQ(module.wheel(2), 32'000);
  EXPECT_EQ(module.push_buttons(1, 1), 0x11);
  EXPECT_EQ(module.push_buttons(1, 2), 0);
  EXPECT_EQ(module.push_buttons(2, 1), 0);
}

TEST_F(SeatPanelModule, ItsOwnLampsAreLitButThoseThatHaveBurntOut) {
  panel.burn_out(Lamp::beacon);
  module.show_indicators(1, 1, 0x03);
  module.show_indicators(2, 1, 0xF0);
  module.show_indicators(1, 2, 0xF0);
  EXPECT_EQ(panel.lit(), Lamps{0x01});
}

TEST_F(SeatPanelModule, ItsOwnDisplayShowsEightParameters) {
  for (unsigned parameter = 1; parameter <= 9; ++parameter) {
    module.show_parameter(1, parameter, static_cast<std::int16_t>(parameter));
    module.show_parameter(2, parameter, 99);
  }
  EXPECT_EQ(panel.shown(Shown::fuel), 1);
  EXPECT_EQ(panel.shown(Shown::detail), 8);
  panel.go_dark();
  EXPECT_EQ(panel.shown(Shown::fuel), no_value);
}

TEST_F(SeatPanelModule, AFrozenDisplayKeepsItsFirstParameterAlone) {
  panel.freeze_display();
  for (const std::int16_t value : {std::int16_t{1}, std::int16_t{2}}) {
    module.show_parameter(1, 1, value);
    module.show_parameter(1, 2, value);
  }
  EXPECT_EQ(panel.shown(Shown::fuel), 1);
  EXPECT_EQ(panel.shown(Shown::oil), 2);
}

}  // namespace
}  // namespace canvoy::excavator::seat_panel_test
