// Joysticks with two sensors for each axis: what the module tells of them on its wire (TPDO 1 of
// CiA 852, 8.1.1: x, y, z, memory, buttons; emergency 5000h of Table 37).
#include "canvoy/devices/cia852/two_channel_axes.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia852/operator_unit_test.hpp"

namespace canvoy::cia852::two_channel_axes_test {
namespace {

struct Sensors {
  std::map<std::pair<unsigned, unsigned>, std::int16_t> values;
  std::int16_t read(unsigned joystick, unsigned axis) { return values[{joystick, axis}]; }
  TwoChannelAxes::Sense sense() { return TwoChannelAxes::Sense::to<&Sensors::read>(*this); }
};

class TwoChannels : public testing::Test {
 protected:
  TwoChannels() {
    environment.provide(callback<&TwoChannels::elements>(*this));
    environment.provide(callback<&TwoChannels::hardware>(*this));
    environment.provide(callback<&TwoChannels::settings>(*this));
    environment.watch(callback<&TwoChannels::is_made>(*this));
    device =
        std::make_unique<CatalogueDevice>(operator_kind, cable.port(0), NodeId{5}, environment);
    cable.connect(0, device->node());
    cable.start_all();
    cable.send("605#23 00 18 01 85 01 00 00");
    cable.send("605#2F 23 64 00 01 00 00 00");
    cable.send("000#01 05");
    cable.run_for(5ms);
    cable.clear();
  }
  void move(std::int16_t to_first, std::int16_t to_second, unsigned axis = 1) {
    first.values[{1, axis}] = to_first;
    second.values[{1, axis}] = to_second;
    unit->hardware_changed();
    cable.run_for(0s);
  }
  void run_for(Duration time) { cable.run_for(time); }
  std::string told() const { return cable.last(0x185); }

  Sensors first;
  Sensors second;
  TwoChannelAxes axes{first.sense(), second.sense(), {1'600, 100ms}};
  Cable cable;
  OperatorUnit* unit = nullptr;

 private:
  OperatorEnvironment elements() { return {.joysticks = 1}; }
  OperatorHardware hardware() { return {.joystick_axis = axes.checked()}; }
  OperatorSettings settings() { return {.sensing_period = Duration::zero()}; }
  void is_made(OperatorUnit& of, Node& node) {
    unit = &of;
    axes.connect(node, of);
  }
  Environment environment;
  std::unique_ptr<CatalogueDevice> device;
};

TEST_F(TwoChannels, ThatAgreeAreTheReadingNearerToRest) {
  move(0x4000, 0x4000);
  EXPECT_EQ(told(), "185#00 40 00 00 00 00 00 00");
  move(0x4640, 0x4000);
  EXPECT_EQ(told(), "185#00 40 00 00 00 00 00 00") << "1600 digits apart";
  move(-0x4000, -0x4640);
  EXPECT_EQ(told(), "185#00 C0 00 00 00 00 00 00");
  run_for(1s);
  EXPECT_TRUE(axes.is_valid(1, 1));
  EXPECT_EQ(cable.last(0x085), "");
}

TEST_F(TwoChannels, ThatDifferForLongerThanAllowedHaveNoPosition) {
  move(0x4641, 0x4000);
  EXPECT_EQ(told(), "185#00 40 00 00 00 00 00 00");
  run_for(100ms - 1us);
  EXPECT_EQ(told(), "185#00 40 00 00 00 00 00 00");
  EXPECT_TRUE(axes.is_valid(1, 1));
  run_for(1us);
  EXPECT_EQ(told(), "185#00 80 00 00 00 00 00 00") << "no position";
  EXPECT_EQ(cable.last(0x085), "085#00 50 01 01 00 00 00 00") << "joystick 1, x";
  move(0x1000, 0x1000);
  EXPECT_EQ(told(), "185#00 80 00 00 00 00 00 00") << "they agree for a moment";
  run_for(100ms);
  EXPECT_EQ(told(), "185#00 10 00 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00");
}

TEST_F(TwoChannels, ThatDifferForAShortTimeStayValid) {
  for (int i = 0; i < 20; ++i) {
    move(0x4000, 0x2000);
    run_for(90ms);
    move(0x2000, 0x2000);
    run_for(10ms);
  }
  EXPECT_EQ(told(), "185#00 20 00 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x085), "");
}

TEST_F(TwoChannels, ThatReadToBothSidesMoveNothing) {
  move(0x1000, -0x1000, 2);
  EXPECT_EQ(told(), "") << "as before";
  run_for(100ms);
  EXPECT_EQ(told(), "185#00 00 00 80 00 00 00 00");
  EXPECT_EQ(cable.last(0x085), "085#00 50 01 02 00 00 00 00") << "joystick 1, y";
}

TEST_F(TwoChannels, ABrokenWireHasNoPositionAtOnce) {
  move(0x4000, TwoChannelAxes::no_position);
  EXPECT_EQ(told(), "185#00 80 00 00 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia852::two_channel_axes_test
