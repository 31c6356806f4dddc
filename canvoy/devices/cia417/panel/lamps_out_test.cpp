// Lamps of panels after a restart of their controller, or of one of them: they show the actual
// state (CiA 417-4, 4.4.1).
#include "canvoy/devices/cia417/panel/lamps_out.hpp"

#include "canvoy/devices/cia417/controller_device/lift_controller_device_test.hpp"
#include "canvoy/devices/cia417/panel/lift_panel_device.hpp"

namespace canvoy::cia417::lamps_out_test {
namespace {

TEST(LampsOutTest, AreARecordForEachKindOfLampWithoutDataForTheLift) {
  LampsOut sut;
  EXPECT_FALSE(sut.waits());
  sut.begin();
  std::vector<VirtualOutput> all;
  while (sut.waits()) all.push_back(sut.next(lift_bit(3)));
  ASSERT_EQ(all.size(), 3u + 3 + 3 + 3 + 2 * 22 + 2 + 1);
  for (const VirtualOutput& output : all) {
    EXPECT_EQ(output.lifts, 0x04);
    EXPECT_EQ(output.doors, 0xFF);
    EXPECT_EQ(output.data, 0x00);
  }
  const auto has = [&](unsigned function, unsigned sub_function, unsigned floor) {
    return std::ranges::count_if(all, [&](const VirtualOutput& output) {
             return static_cast<unsigned>(output.function) == function &&
                    output.sub_function == sub_function && output.floor == floor;
           }) == 1;
  };
  for (const unsigned hall_call : {0x02U, 0x03U, 0x04U}) EXPECT_TRUE(has(hall_call, 0x03, 0xFF));
  for (const unsigned car_call : {0x05U, 0x06U, 0x07U}) EXPECT_TRUE(has(car_call, 0xFF, 0x00));
  for (unsigned call = 0x08; call <= 0x0D; ++call) EXPECT_TRUE(has(call, 0xFF, 0xFF)) << call;
  for (unsigned key = 0x01; key <= 0x16; ++key) {
    EXPECT_TRUE(has(0x0E, key, 0x00)) << key;
    EXPECT_TRUE(has(0x0E, key, 0xFF)) << key;
  }
  EXPECT_TRUE(has(0x43, 0x00, 0x00));
  EXPECT_TRUE(has(0x43, 0x00, 0xFF));
  EXPECT_TRUE(has(0x41, 0x03, 0xFF));
}

class PanelLamps : public WholeLift {
 protected:
  PanelLamps() {
    cable.connect(3, car.node());
    cable.connect(4, landing.node());
    car.node().start(cable.now);
    landing.node().start(cable.now);
    run_for(2s);
    hold_drive();
  }
  /// So that calls stay where they are.
  void hold_drive() {
    has_load = false;
    run_for(2s);
  }
  bool hall_lamp_up() { return landing.outputs().view(0).on; }
  bool car_lamp(unsigned floor) { return car.outputs().view(floor - 1).on; }
  void press_both() {
    cable.send("495#02 01 01 04 10 01");
    cable.send("490#05 07 01 00 11 01");
    run_for(100ms);
    ASSERT_TRUE(hall_lamp_up());
    ASSERT_TRUE(car_lamp(7));
  }

  static OutputHardware nothing() { return {}; }
  CarPanelDevice<> car{cable.port(3), 16, nothing(), CarPanel{.highest_floor = 8}};
  LandingPanelDevice<> landing{cable.port(4), 24, nothing(),
                               LandingPanel{.floor = 4, .highest_floor = 8}};
};

TEST_F(PanelLamps, GoOutWhenTheirControllerStartsAgainSinceItKnowsNoCallsAnyMore) {
  press_both();
  cable.clear();
  controller.node().command(NmtCommand::reset_node);
  run_for(100ms);
  EXPECT_EQ(count("400#02 03 01 FF FF 00"), 1u);
  EXPECT_EQ(count("400#05 FF 01 00 FF 00"), 1u);
  EXPECT_FALSE(hall_lamp_up());
  EXPECT_FALSE(car_lamp(7));
}

TEST_F(PanelLamps, OfAPanelThatStartsLaterShowWhatOthersShow) {
  press_both();
  cable.clear();
  car.node().command(NmtCommand::reset_node);
  landing.node().command(NmtCommand::reset_node);
  cable.run_for(0ms);
  EXPECT_FALSE(hall_lamp_up());
  EXPECT_FALSE(car_lamp(7));
  const Time booted = cable.now;
  run_for(300ms);
  EXPECT_TRUE(hall_lamp_up());
  EXPECT_TRUE(car_lamp(7));
  EXPECT_EQ(count("400#02 01 01 04 10 81"), 1u);
  EXPECT_EQ(count("400#05 07 01 00 F1 81"), 1u);
  EXPECT_EQ(count("400#40 01 01 00 F0 01"), 1u) << "the car is at floor 1";
  for (const Cable::Heard& heard : cable.heard) {
    const bool is_of_key = heard.frame.data[0] == 0x0E;  // the answer to a panel's input
    if (heard.frame.id != 0x400 || is_of_key) continue;
    EXPECT_GE(heard.at, booted + 200ms);
  }
}

TEST_F(PanelLamps, OfCallsThatAreGoneStayOutOnAPanelThatStartsLater) {
  press_both();
  landing.node().command(NmtCommand::reset_node);
  cable.run_for(0ms);
  controller.calls().cancel(all_calls);
  run_for(2s);
  EXPECT_FALSE(hall_lamp_up());
  EXPECT_FALSE(car_lamp(7));
}

TEST_F(PanelLamps, AreToldAgainToPanelsThatAreHeardWithoutABootUp) {
  press_both();
  run_for(2s);
  cable.clear();
  cable.send("732#05");
  run_for(180ms);
  EXPECT_EQ(count("400#02 01 01 04 10 81"), 0u);
  run_for(40ms);
  EXPECT_EQ(count("400#02 01 01 04 10 81"), 1u);
}

}  // namespace
}  // namespace canvoy::cia417::lamps_out_test
