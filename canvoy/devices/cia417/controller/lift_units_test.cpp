// Nodes that a lift controller monitors, and its reports of a loss: emergency 8130h with the
// node-ID in byte 3, and 0000h when the node is received again (CiA 301, 7.2.8.3.2.2 and 7.5.2.19).
#include "canvoy/devices/cia417/controller/lift_units.hpp"

#include <set>
#include <string>

#include "canvoy/devices/cia417/controller_device/lift_controller_device_test.hpp"

namespace canvoy::cia417::lift_units_test {
namespace {

class LiftUnitsTest : public WholeLift {
 protected:
  using WholeLift::WholeLift;
  void heartbeat(unsigned node, unsigned state = 5) {
    cable.send(wire_text(Frame::data_frame(0x700 + node, {static_cast<std::uint8_t>(state)})));
  }
  std::vector<std::string> emergencies() const {
    std::vector<std::string> all;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == 0x081) all.push_back(wire_text(heard.frame));
    }
    return all;
  }
  using Texts = std::vector<std::string>;
};

TEST_F(LiftUnitsTest, TheRecommendedNodesAreWatchedByDefault) {
  const Dictionary& dictionary = controller.node().dictionary();
  std::set<std::uint64_t> watched;
  for (unsigned sub = 1; sub <= 127; ++sub) {
    const std::uint64_t entry = dictionary.number(0x1016, static_cast<std::uint8_t>(sub));
    if (entry == 0) continue;
    const std::uint64_t node = entry >> 16;
    EXPECT_TRUE(watched.insert(node).second) << "twice: " << node;
    const bool is_needed = node == 2 || node == 4 || (node >= 6 && node <= 8) || node == 13;
    EXPECT_EQ(entry & 0xFFFF, is_needed ? 1500u : 3000u) << node;
  }
  for (const unsigned node : {2U, 4U, 5U, 6U, 7U, 8U, 9U, 12U, 13U, 14U, 16U, 20U, 21U, 120U}) {
    EXPECT_TRUE(watched.contains(node)) << node;
  }
  EXPECT_FALSE(watched.contains(1)) << "itself";
  EXPECT_FALSE(watched.contains(121));
}

TEST_F(LiftUnitsTest, ALostPanelIsToldWithItsNodeIdAndTheLiftGoesOn) {
  for (const unsigned panel : {16U, 21U, 120U}) {
    cable.clear();
    heartbeat(panel);
    const Time last = cable.now;
    run_for(2980ms);
    EXPECT_EQ(emergencies(), Texts{});
    run_for(40ms);
    Frame told = wire_frame("081#30 81 11 00 00 00 00 00");
    told.data[3] = static_cast<std::uint8_t>(panel);
    const auto heard = std::ranges::find_if(
        cable.heard, [&](const Cable::Heard& one) { return one.frame == told; });
    ASSERT_NE(heard, cable.heard.end()) << panel;
    EXPECT_GE(heard->at, last + 3s);
    EXPECT_LE(heard->at, last + 3s + 2ms) << "behind another one";
    EXPECT_EQ(controller.lift().fault(), LiftFault::none);
    cable.clear();
    heartbeat(panel);
    ASSERT_EQ(emergencies().size(), 1u);
    EXPECT_EQ(emergencies()[0].substr(0, 9), "081#00 00") << "others may still be lost";
  }
}

TEST_F(LiftUnitsTest, WithoutItsCarPanelItServesTheCallsThatItHas) {
  heartbeat(16);
  press_in_car(8);
  run_for(4s);
  EXPECT_EQ(cable.last(0x081), "081#30 81 11 10 00 00 00 00");
  EXPECT_TRUE(arrives_at(8));
}

TEST_F(LiftUnitsTest, AllPanelsThatAreLostAtOnceAreTold) {
  for (unsigned panel = 16; panel <= 120; ++panel) heartbeat(panel);
  cable.clear();
  run_for(4s);
  EXPECT_EQ(emergencies().size(), 105u);
  std::set<unsigned> told;
  for (const Cable::Heard& heard : cable.heard) {
    if (heard.frame.id == 0x081) told.insert(heard.frame.data[3]);
  }
  EXPECT_EQ(told.size(), 105u);
  cable.clear();
  for (unsigned panel = 16; panel <= 120; ++panel) heartbeat(panel);
  cable.run_for(104 * 2ms);
  EXPECT_EQ(emergencies().size(), 105u);
  EXPECT_EQ(cable.last(0x081), "081#00 00 00 00 00 00 00 00") << "nothing is left in 1001h";
}

TEST_F(LiftUnitsTest, A1016hThatIsWrittenWatchesOtherNodes) {
  cable.send("601#23 16 10 7F E8 03 7A 00");  // sub-index 127: node 122 within 1 s
  EXPECT_EQ(cable.last(0x581), "581#60 16 10 7F 00 00 00 00");
  heartbeat(122);
  run_for(1020ms);
  EXPECT_EQ(cable.last(0x081), "081#30 81 11 7A 00 00 00 00");
}

TEST(LiftUnits, AreThoseOfTheSettingsInOrderAndEachOnce) {
  static constexpr NodeId others[] = {30, 9, 31, 0, 30};
  LiftControllerDeviceSettings settings = lift_settings();
  settings.doors.door_units = {6, 6, 0, 0};
  settings.doors.light_barrier_units = {9, 10, 0, 0};
  settings.load_unit = 0;
  settings.others = others;
  Cable cable;
  LiftControllerDevice<> controller(cable.port(0), 1, settings);
  cable.connect(0, controller.node());
  cable.start_all();
  const std::uint32_t expected[] = {0x2'05DC, 0x4'05DC,  0x6'05DC,  0x9'05DC,
                                    0xA'05DC, 0x1E'0BB8, 0x1F'0BB8, 0};
  const Dictionary& dictionary = controller.node().dictionary();
  for (std::uint8_t sub = 1; sub <= 8; ++sub) {
    EXPECT_EQ(dictionary.number(0x1016, sub), expected[sub - 1]) << unsigned{sub};
  }
  EXPECT_EQ(dictionary.number(0x1028, 9), 0x89u);
  EXPECT_EQ(dictionary.number(0x1028, 30), 0x8000'0000u);
}

// A light barrier that is a node of its own.

LiftControllerDeviceSettings with_light_barrier() {
  LiftControllerDeviceSettings settings = lift_settings();
  settings.doors.light_barrier_units = {9, 0, 0, 0};
  return settings;
}
class LightBarrierOfLift : public LiftUnitsTest {
 protected:
  LightBarrierOfLift() : LiftUnitsTest(with_light_barrier()) {
    cable.send("205#3F");
    heartbeat(9);
  }
  /// The velocity in the last controlword of door 1: bits 11 and 10.
  unsigned commanded_velocity() const {
    const std::string text = cable.last(0x200);
    return wire_frame(text).data[1] >> 2U & 3U;
  }
};

TEST_F(LightBarrierOfLift, LostItIsToldAndDoorsCloseAtReducedVelocityAndTheLiftServes) {
  press_in_car(8);
  run_for(1480ms);
  EXPECT_EQ(cable.count(0x081), 0u);
  run_for(40ms);
  EXPECT_EQ(cable.last(0x081), "081#30 81 11 09 00 00 00 00");
  ASSERT_TRUE(arrives_at(8));
  ASSERT_TRUE(run_until([&] { return controller.lift().phase() == LiftPhase::closing; }));
  const unsigned reduced = commanded_velocity();
  ASSERT_TRUE(run_until([&] { return door_bench.is_locked; }));
  heartbeat(9);
  EXPECT_EQ(cable.last(0x081), "081#00 00 00 00 00 00 00 00");
  run_for(1s);
  for (int i = 0; i < 100; ++i) {
    heartbeat(9);
    if (i == 0) press_in_car(7);
    run_for(1s);
    if (is_open_at(7)) break;
  }
  while (controller.lift().phase() == LiftPhase::open) {
    heartbeat(9);
    run_for(500ms);
  }
  EXPECT_NE(commanded_velocity(), reduced);
}

TEST_F(LightBarrierOfLift, AnErrorOfItsUnitCountsTheSame) {
  cable.send("089#00 50 01 00 00 00 00 00");
  EXPECT_EQ(controller.lift().fault(), LiftFault::none);
  EXPECT_EQ(cable.count(0x081), 0u);
}

}  // namespace
}  // namespace canvoy::cia417::lift_units_test
