#include "canvoy/tools/device/seat/hand_mapping.hpp"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/seat/hands.hpp"

namespace canvoy::tools::hand_mapping_test {
namespace {

constexpr cia852::OperatorEnvironment seat = {.joysticks = 2,
                                              .foot_pedals = 1,
                                              .encoders = 1,
                                              .wheels = 1,
                                              .push_button_clusters = 1,
                                              .indicator_clusters = 1};

HandMapping mapping_of(const std::string& text) {
  TomlFile file("stick.toml", "device = \"/dev/input/event5\"\n" + text);
  return read_hand_mapping(file, seat);
}
/// The error in it.
std::string refusal(const std::string& text) {
  try {
    mapping_of(text);
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}
std::string axis_text(const std::string& code, const std::string& moves,
                      const std::string& more = "") {
  return "[[axis]]\ncode = \"" + code + "\"\nmoves = \"" + moves + "\"\n" + more;
}

// Calibration: 0 to 1023 with the centre at 500, and a dead band of 100 around it.

constexpr AxisCalibration stick = {.least = 0, .centre = 500, .most = 1000, .dead_band = 100};

TEST(AxisCalibration, ReachesBothEndsAndIsZeroAboutTheCentre) {
  EXPECT_EQ(stick.position(0), -32768);
  EXPECT_EQ(stick.position(1000), 32767);
  for (const double value : {400, 500, 600}) EXPECT_EQ(stick.position(value), 0) << value;
  EXPECT_EQ(stick.position(2000), 32767) << "a device that goes beyond its ends";
  EXPECT_EQ(stick.position(-2000), -32768);
}
TEST(AxisCalibration, BeginsAtTheEdgeOfTheDeadBandWithoutAStep) {
  EXPECT_EQ(stick.position(601), 82) << "one of 400, of 32767";
  EXPECT_EQ(stick.position(399), -82);
  EXPECT_EQ(stick.position(800), 16384) << "half of the way, rounded";
  EXPECT_EQ(stick.position(200), -16384);
}
TEST(AxisCalibration, EitherSideHasItsOwnLength) {
  const AxisCalibration crooked = {.least = 0, .centre = 200, .most = 1000};
  EXPECT_EQ(crooked.position(100), -16384);
  EXPECT_EQ(crooked.position(600), 16384);
}
TEST(AxisCalibration, InvertedTheLeastIsTheMost) {
  AxisCalibration turned = stick;
  turned.is_inverted = true;
  EXPECT_EQ(turned.position(0), 32767);
  EXPECT_EQ(turned.position(1000), -32768);
  EXPECT_EQ(turned.position(500), 0);
  const AxisCalibration crooked = {.least = 0, .centre = 200, .most = 1000, .is_inverted = true};
  EXPECT_EQ(crooked.position(100), 16384);
  EXPECT_EQ(crooked.position(600), -16384);
}
TEST(AxisCalibration, APedalRestsAtItsEnd) {
  const AxisCalibration pedal = AxisCalibration{}.completed(0, 255, true);
  EXPECT_EQ(pedal.position(0), 0);
  EXPECT_EQ(pedal.position(255), 32767);
  // Many pedals are at the maximum when they are released.
  const AxisCalibration turned = AxisCalibration{.is_inverted = true}.completed(0, 255, true);
  EXPECT_EQ(turned.position(255), 0);
  EXPECT_EQ(turned.position(0), 32767);
  EXPECT_EQ(AxisCalibration{}.completed(-10, 10, false).centre, 0);
}
TEST(AxisCalibration, SaysWhatIsWrong) {
  EXPECT_EQ(stick.complaint(), "");
  EXPECT_EQ((AxisCalibration{.least = 5, .centre = 5, .most = 5}.complaint()),
            "least 5 is not below most 5");
  EXPECT_EQ((AxisCalibration{.least = 0, .centre = 11, .most = 10}.complaint()),
            "centre 11 is not from 0 to 10");
  EXPECT_EQ((AxisCalibration{.least = 0, .centre = 2, .most = 10, .dead_band = 2}.complaint()),
            "dead-band 2 leaves nothing to move");
  EXPECT_EQ((AxisCalibration{.least = 0, .centre = 0, .most = 10, .dead_band = 9}.complaint()), "");
}

// The file.

TEST(HandMapping, HasAxesButtonsAndLights) {
  const HandMapping mapping = mapping_of(
      axis_text("ABS_X", "joystick2.y",
                "least = -7\ncentre = 1\nmost = 1000\ndead-band = 3\ninverted = true\n") +
      axis_text("REL_WHEEL", "encoder1", "step = -4\n") +
      "[[button]]\ncode = \"BTN_TRIGGER\"\npresses = \"push-button-cluster1.b64\"\n"
      "[[light]]\ncode = \"LED_MUTE\"\nshows = \"indicator-cluster1.i64\"\n");
  EXPECT_EQ(mapping.device, "/dev/input/event5");
  ASSERT_EQ(mapping.axes.size(), 2u);
  EXPECT_EQ(mapping.axes[0].code, (HandCode{EV_ABS, ABS_X}));
  EXPECT_EQ(mapping.axes[0].control, (Control{Control::Kind::axis, 2, 2}));
  EXPECT_EQ(mapping.axes[0].calibration.least, -7);
  EXPECT_EQ(mapping.axes[0].calibration.centre, 1);
  EXPECT_EQ(mapping.axes[0].calibration.most, 1000);
  EXPECT_EQ(mapping.axes[0].calibration.dead_band, 3);
  EXPECT_TRUE(mapping.axes[0].calibration.is_inverted);
  EXPECT_EQ(mapping.axes[1].code, (HandCode{EV_REL, REL_WHEEL}));
  EXPECT_EQ(mapping.axes[1].step, -4);
  ASSERT_EQ(mapping.buttons.size(), 1u);
  EXPECT_EQ(mapping.buttons[0].code, (HandCode{EV_KEY, BTN_TRIGGER}));
  EXPECT_EQ(mapping.buttons[0].control, (Control{Control::Kind::push_button, 1, 64}));
  ASSERT_EQ(mapping.lights.size(), 1u);
  EXPECT_EQ(mapping.lights[0].cluster, 1u);
  EXPECT_EQ(mapping.lights[0].indicator, 64u);
}

struct Refused {
  std::string text;
  const char* line;
};
TEST(HandMapping, RefusesWhatMakesNoSenseInOneLine) {
  const std::string button = "[[button]]\ncode = \"BTN_TRIGGER\"\npresses = ";
  const std::string light = "[[light]]\ncode = \"LED_MUTE\"\nshows = ";
  const Refused all[] = {
      {"", "stick.toml line 1: there is nothing in it"},
      {axis_text("ABS_Q", "joystick1.x"), "stick.toml line 3: code: 'ABS_Q' is none"},
      {axis_text("BTN_TRIGGER", "joystick1.x"), "line 3: code: 'BTN_TRIGGER' is none"},
      {"[[axis]]\nmoves = \"joystick1.x\"\n", "code: '' is none"},
      {axis_text("ABS_X", "joystick3.x"), "stick.toml line 4: moves: 'joystick3.x' is nothing"},
      {axis_text("ABS_X", "joystick1.b1"), "line 4: moves: this is pressed"},
      {axis_text("REL_X", "joystick1.x"), "line 4: moves: a relative axis turns"},
      {axis_text("REL_X", "wheel1", "step = 0\n"), "line 5: step: write a whole number"},
      {axis_text("REL_X", "wheel1", "step = 1.5\n"), "line 5: step: write a whole number"},
      {axis_text("REL_X", "wheel1", "least = 1\n"), "line 5: least: is not known here"},
      {axis_text("ABS_X", "wheel1", "step = 1\n"), "line 5: step: is not known here"},
      {axis_text("ABS_X", "wheel1", "dead-band = -1\n"), "line 5: dead-band: -1 is not from 0"},
      {axis_text("ABS_X", "wheel1", "most = inf\n"), "line 5: most: inf is not from"},
      {axis_text("ABS_X", "wheel1", "most = \"a\"\n"), "line 5: most: write a number"},
      {axis_text("ABS_X", "wheel1") + axis_text("ABS_X", "joystick1.x"),
       "line 6: code: ABS_X is given twice"},
      {button + "\"joystick1.x\"\n", "line 4: presses: this is moved"},
      {button + "1\n", "line 4: presses: write a text"},
      {light + "\"indicator-cluster2.i1\"\n", "line 4: shows: 'indicator-cluster2.i1' is no"},
      {light + "\"indicator-cluster1.i65\"\n", "is no indicator"},
      {light + "\"indicator-cluster1.i0\"\n", "is no indicator"},
      {light + "\"indicator-cluster1\"\n", "is no indicator"},
      {light + "\"\"\n", "'' is no indicator"},
      {"axis = 3\n", "line 2: axis: write tables"},
      {"speed = 3\n", "line 2: speed: is not known here"},
      {"[[axis]\n", "stick.toml line 2: "},
  };
  for (const Refused& refused : all) {
    const std::string said = refusal(refused.text);
    EXPECT_NE(said.find(refused.line), std::string::npos) << refused.text << " said " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  TomlFile file("stick.toml", axis_text("ABS_X", "wheel1"));
  EXPECT_THROW(read_hand_mapping(file, seat), Failure) << "of which device?";
}

TEST(HandMapping, NoControlIsMovedByTwo) {
  HandMapping one = mapping_of(axis_text("ABS_X", "joystick1.x"));
  HandMapping other = mapping_of(axis_text("ABS_Y", "joystick1.x"));
  EXPECT_THROW(check_hand_mappings({one, other}), UsageError) << "and the device is the same";
  other.device = "/dev/input/event6";
  EXPECT_THROW(check_hand_mappings({one, other}), UsageError);
  other.axes[0].control.part = 2;
  EXPECT_NO_THROW(check_hand_mappings({one, other}));
  other.device = one.device;
  EXPECT_THROW(check_hand_mappings({one, other}), UsageError) << "one device, two mappings";
}

// Effects of events on the seat.

struct MovedSeat : testing::Test {
  MovedSeat() {
    mapping.axes = {{{EV_ABS, ABS_X}, {Control::Kind::axis, 1, 1}, stick},
                    {{EV_ABS, ABS_MISC}, {Control::Kind::encoder, 1, 1}},
                    {{EV_REL, REL_WHEEL}, {Control::Kind::wheel, 1, 1}, {}, 1000},
                    {{EV_REL, REL_DIAL}, {Control::Kind::encoder, 2, 1}, {}, -1}};
    mapping.buttons = {{{EV_KEY, BTN_TRIGGER}, {Control::Kind::joystick_button, 1, 3}}};
  }
  void happens(unsigned type, unsigned code, std::int32_t value) {
    move_seat(state, mapping, {{type, code}, value});
  }
  HandMapping mapping;
  SeatState state;
  cia852::OperatorHardware hardware = state.inputs();
};

TEST_F(MovedSeat, FollowsWhatIsMappedAndNothingElse) {
  happens(EV_ABS, ABS_X, 1000);
  happens(EV_KEY, BTN_TRIGGER, 1);
  happens(EV_ABS, ABS_Y, 1000);
  happens(EV_KEY, BTN_THUMB, 1);
  EXPECT_EQ(hardware.joystick_axis(1, 1), 32767);
  EXPECT_EQ(hardware.joystick_axis(1, 2), 0);
  EXPECT_EQ(hardware.joystick_buttons(1), 0x04);
  happens(EV_KEY, BTN_TRIGGER, 2);  // the key repeats
  EXPECT_EQ(hardware.joystick_buttons(1), 0x04);
  happens(EV_KEY, BTN_TRIGGER, 0);
  EXPECT_EQ(hardware.joystick_buttons(1), 0);
}
TEST_F(MovedSeat, WheelsStopAtTheirEndsAndEncodersBeginAnew) {
  happens(EV_REL, REL_WHEEL, 30);
  EXPECT_EQ(hardware.wheel(1), 30000);
  happens(EV_REL, REL_WHEEL, 30);
  EXPECT_EQ(hardware.wheel(1), 32767);
  happens(EV_REL, REL_WHEEL, -1);
  EXPECT_EQ(hardware.wheel(1), 31767);
  happens(EV_REL, REL_DIAL, 1);
  EXPECT_EQ(hardware.encoder(2), 0xFFFF'FFFF);
  happens(EV_REL, REL_DIAL, -3);
  EXPECT_EQ(hardware.encoder(2), 2u);
  happens(EV_ABS, ABS_MISC, 4095);
  EXPECT_EQ(hardware.encoder(1), 4095u);
}
TEST_F(MovedSeat, RestsWhenTheDeviceIsGone) {
  happens(EV_ABS, ABS_X, 0);
  happens(EV_REL, REL_WHEEL, 1);
  happens(EV_REL, REL_DIAL, -1);
  happens(EV_KEY, BTN_TRIGGER, 1);
  rest_seat(state, mapping);
  EXPECT_EQ(hardware.joystick_axis(1, 1), 0);
  EXPECT_EQ(hardware.wheel(1), 0);
  EXPECT_EQ(hardware.joystick_buttons(1), 0);
  EXPECT_EQ(hardware.encoder(2), 1u) << "an encoder has no rest";
}

}  // namespace
}  // namespace canvoy::tools::hand_mapping_test
