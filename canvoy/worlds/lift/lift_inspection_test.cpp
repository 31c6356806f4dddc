// Inspection control in a building (EN 81-20, 5.12.1.5): a station on the roof of the car and one
// in the pit, on the bus or wired; their records are those of CiA 417-4, 4.3.1 and 4.4.1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_inspection_test {
namespace {

using cia417::SpecialFunction;

constexpr NodeId roof_id = 12;
constexpr NodeId pit_id = 14;

NodeDescription station(NodeId id, DeviceKind kind, std::vector<FloorNumber> floors) {
  NodeDescription made{.id = id, .kind = kind, .floors = std::move(floors)};
  made.panel.keys = {SpecialFunction::service_run, SpecialFunction::dogging_service_up,
                     SpecialFunction::dogging_service_down};
  made.panel.displays.emplace();
  made.panel.calls = false;
  return made;
}

class LiftInspection : public testing::TestWithParam<bool> {
 protected:
  LiftInspection() {
    network.observe(
        0, {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
              static_cast<LiftInspection*>(self)->heard.push_back(wire_text(frame));
            }});
    network.run_until(Time(10s));
    heard.clear();
  }
  static bool is_on_bus() { return GetParam(); }
  static LiftNetworkDescription description() {
    LiftNetworkDescription made = standard_lift_network({.floors = 6});
    made.arrivals = {{.at = Time(1h), .from = 1, .to = 6}};
    if (!is_on_bus()) return made;
    made.nodes.push_back(station(roof_id, DeviceKind::car_panel, {}));
    made.nodes.push_back(station(pit_id, DeviceKind::landing_panel, {1}));
    return made;
  }
  bool was_heard(const std::string& frame) const {
    return std::ranges::find(heard, frame) != heard.end();
  }
  LiftShaft& shaft() { return network.shaft(1); }
  void run_for(Duration time) { network.run_until(network.now() + time); }
  double speed() const { return network.snapshot().lifts[0].speed_m_s; }
  double position() const { return network.snapshot().lifts[0].position_m; }

  std::vector<std::string> heard;
  LiftNetwork network{description()};
};

TEST_P(LiftInspection, MovesTheCarSlowlyWhileAButtonIsHeldAndTakesNoCalls) {
  ASSERT_EQ(check(description()), "");
  shaft().turn_inspection(Station::roof, true);
  run_for(1s);
  shaft().hold_inspection(Station::roof, Direction::up);
  run_for(3s);
  EXPECT_NEAR(speed(), 0.63, 1e-3);
  ASSERT_TRUE(network.visit(1, 6));
  run_for(10s);
  EXPECT_EQ(network.snapshot().riding, 0U);
  EXPECT_NEAR(speed(), 0.63, 1e-3) << "the call is not answered";
  shaft().hold_inspection(Station::roof, Direction::none);
  run_for(2s);
  EXPECT_EQ(speed(), 0);
  shaft().hold_inspection(Station::roof, Direction::down);
  run_for(1min);
  EXPECT_EQ(speed(), 0) << "not below the first floor";
  EXPECT_GT(position(), -0.05);
  EXPECT_LT(position(), 1.5);
  shaft().hold_inspection(Station::roof, Direction::none);
  shaft().turn_inspection(Station::roof, false);
  run_for(2min);
  EXPECT_EQ(network.summary().served, 1U) << "it serves again";
  for (const Invariant& one : network.invariants()) {
    const bool is_of_inspection = one.kind == InvariantKind::inspection_speed ||
                                  one.kind == InvariantKind::inspection_buttons;
    if (is_of_inspection) {
      EXPECT_TRUE(one.is_decided() && one.held) << one.worst;
    }
  }
}

/// 0Eh 13h, 15h and 16h: service run, up, down; floor 0 is in the car, 1 above the pit.
TEST_P(LiftInspection, TellsItByItsRecords) {
  shaft().turn_inspection(Station::roof, true);
  run_for(100ms);
  shaft().hold_inspection(Station::roof, Direction::up);
  run_for(100ms);
  shaft().hold_inspection(Station::roof, Direction::none);
  run_for(100ms);
  shaft().turn_inspection(Station::pit, true);
  run_for(100ms);
  EXPECT_EQ(was_heard("48C#0E 13 01 00 10 81"), is_on_bus());
  EXPECT_EQ(was_heard("48C#0E 15 01 00 10 01"), is_on_bus());
  EXPECT_EQ(was_heard("48C#0E 15 01 00 10 00"), is_on_bus());
  EXPECT_EQ(was_heard("48E#0E 13 01 01 10 81"), is_on_bus());
  const std::string doors = is_on_bus() ? "10" : "00";
  EXPECT_TRUE(was_heard("400#0E 13 01 00 " + doors + " 81")) << "acknowledged";
  EXPECT_TRUE(was_heard("400#0E 15 01 00 " + doors + " 81"));
  EXPECT_TRUE(was_heard("400#43 07 01 FF F0 01")) << "special service";
}

TEST_P(LiftInspection, WithBothStationsOnTheCarMovesByBoth) {
  shaft().turn_inspection(Station::roof, true);
  shaft().turn_inspection(Station::pit, true);
  run_for(1s);
  shaft().hold_inspection(Station::pit, Direction::up);
  run_for(3s);
  EXPECT_EQ(position(), 0);
  shaft().hold_inspection(Station::roof, Direction::up);
  run_for(3s);
  EXPECT_NEAR(speed(), 0.63, 1e-3);
  shaft().hold_inspection(Station::pit, Direction::none);
  run_for(2s);
  EXPECT_EQ(speed(), 0);
}

TEST_P(LiftInspection, AStopSwitchHoldsTheCarWhateverButtonIsHeld) {
  shaft().turn_inspection(Station::roof, true);
  run_for(1s);
  shaft().hold_inspection(Station::roof, Direction::up);
  run_for(3s);
  shaft().press_stop(true);
  run_for(1s);
  EXPECT_EQ(speed(), 0);
  run_for(20s);
  EXPECT_EQ(speed(), 0);
}

INSTANTIATE_TEST_SUITE_P(Stations, LiftInspection, testing::Bool(),
                         [](const auto& it) { return it.param ? "OnTheBus" : "Wired"; });

}  // namespace
}  // namespace canvoy::lift::lift_inspection_test
