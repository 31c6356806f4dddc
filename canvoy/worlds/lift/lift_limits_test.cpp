// Speed, acceleration, jerk and travel of a car stay within their limits, and the referee of a
// whole building detects where they do not: a unit is set wrongly, as by a tool, without the other
// devices.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_limits_test {
namespace {

constexpr InvariantKind limits[] = {InvariantKind::speed, InvariantKind::acceleration,
                                    InvariantKind::jerk, InvariantKind::travel};

struct Row {
  const char* name;
  InvariantKind broken;
  DeviceKind unit;
  std::vector<NodeValue> values;
};
std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << row.name;
}

/// A lift of 1.6 m/s, 1 m/s2 and 1.2 m/s3; each may be 5 % more. Its buffers are 300 mm away.
struct LiftLimitsTest : testing::TestWithParam<Row> {
  static LiftNetworkDescription description() {
    LiftNetworkDescription made = standard_lift_network({.floors = 6});
    made.arrivals = {{.at = Time(20s), .from = 1, .to = 6}, {.at = Time(70s), .from = 6, .to = 1}};
    return made;
  }
  static const Invariant* find(const std::vector<Invariant>& all, InvariantKind kind) {
    const auto found = std::ranges::find(all, kind, &Invariant::kind);
    return found == all.end() ? nullptr : &*found;
  }
};

TEST_F(LiftLimitsTest, AllAreKeptWhereEachUnitIsSetAsTheLiftIsDesigned) {
  LiftNetwork network(description());
  network.run_until(Time(3min));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(network.summary().served, 2U);
  const std::vector<Invariant> all = network.invariants();
  for (const InvariantKind kind : limits) {
    const Invariant* const judged = find(all, kind);
    ASSERT_NE(judged, nullptr);
    EXPECT_TRUE(judged->is_decided());
  }
}

TEST_P(LiftLimitsTest, OneThatIsNotKeptIsSeenAndTheOthersAreKept) {
  LiftNetworkDescription wrong = description();
  std::ranges::find(wrong.nodes, GetParam().unit, &NodeDescription::kind)->values =
      GetParam().values;
  // Its final limits would stop the car.
  wrong.building.lifts[0].has_safety_chain = GetParam().broken != InvariantKind::travel;
  LiftNetwork network(wrong);
  network.run_until(Time(3min));
  EXPECT_FALSE(network.refused()) << "the unit has taken them";
  const std::vector<Invariant> all = network.invariants();
  for (const InvariantKind kind : limits) {
    const Invariant* const judged = find(all, kind);
    ASSERT_NE(judged, nullptr);
    const bool may_follow = GetParam().broken == InvariantKind::travel;  // buffers jolt
    if (kind != GetParam().broken && may_follow) continue;
    EXPECT_EQ(judged->held, kind != GetParam().broken) << judged->worst;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, LiftLimitsTest,
    testing::Values(
        // 6408h:01h and 6423h: 1.7 m/s.
        Row{"Speed",
            InvariantKind::speed,
            DeviceKind::drive,
            {{0x6408, 1, {0xA4, 0x06, 0x00, 0x00}}, {0x6423, 0, {0xA4, 0x06, 0x00, 0x00}}}},
        // 640Bh: 1.1 m/s2 to start and to stop with.
        Row{"Acceleration",
            InvariantKind::acceleration,
            DeviceKind::drive,
            {{0x640B, 1, {0x4C, 0x04, 0x00, 0x00}}, {0x640B, 2, {0x4C, 0x04, 0x00, 0x00}}}},
        // 640Dh:01h: 1.4 m/s3 in all bends.
        Row{"Jerk",
            InvariantKind::jerk,
            DeviceKind::drive,
            {{0x640D, 1, {0x78, 0x05, 0x00, 0x00}}}},
        // 6382h:01h: floor 1 is at 500 mm, and so below the buffer.
        Row{"Travel",
            InvariantKind::travel,
            DeviceKind::position,
            {{0x6382, 1, {0x88, 0x13, 0x00, 0x00}}}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace canvoy::lift::lift_limits_test
