// Settings of the devices of a simulated lift that differ from their defaults: by values of the
// network's description, written and read on the bus.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/shaft_cams.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_configuration_test {
namespace {

/// A tool on the bus of a lift that reads the cams of its position unit, node 4, by SDO.
class CamReader {
 public:
  explicit CamReader(LiftNetwork& network) : network_(network) {
    const SlotIndex slot = network.world().add_slot(0, {.accept_all = true});
    port_ = network.world().port(slot);
    network.world().occupy(slot, *this);
    network.world().start(slot);
  }

  void start(Time) {}
  void receive(const Frame& frame, Time) {
    if (frame.id == 0x584) answer_ = frame;
  }
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {}
  void overrun(Time) {}

  /// Reads 63A0h:01h.
  unsigned read() {
    port_.send(port_.context, Frame::data_frame(0x604, std::to_array<std::uint8_t>(
                                                           {0x40, 0xA0, 0x63, 0x01, 0, 0, 0, 0})));
    network_.run_until(network_.now() + 10ms);
    return answer_.data[0] == 0x4F ? answer_.data[4] : 0x100U;
  }

 private:
  LiftNetwork& network_;
  Port port_{};
  Frame answer_{};
};

NodeDescription& node_of(LiftNetworkDescription& description, DeviceKind kind) {
  return *std::ranges::find(description.nodes, kind, &NodeDescription::kind);
}

TEST(LiftConfiguration, ADoorHasASlowAndANarrowProfileAndPeopleGoThrough) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(5s), .from = 3, .to = 1, .mass_kg = 80}};
  node_of(description, DeviceKind::door).values = {{0x6304, 1, {1}}, {0x6304, 2, {1}}};
  LiftNetwork network(description);
  ASSERT_FALSE(network.refused());
  double widest = 0;
  while (network.now() < Time(90s)) {
    network.run_until(network.now() + 100ms);
    widest = std::max(widest, network.snapshot().lifts[0].doors[0].open_share);
  }
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
  EXPECT_NEAR(widest, 0.85, 0.001);
}

TEST(LiftConfiguration, AProfileThatADoorDoesNotHaveIsRefused) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  node_of(description, DeviceKind::door).values = {{0x6304, 1, {2}}};
  const LiftNetwork network(description);
  ASSERT_TRUE(network.refused());
  EXPECT_EQ(network.refused()->refusal.reason, AbortCode::value_range);
}

TEST(LiftConfiguration, EnabledCamsSayWhereTheCarIs) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 4, .mass_kg = 80}};
  node_of(description, DeviceKind::position).values = {{0x63A1, 1, {0x07}}};
  LiftNetwork network(description);
  ASSERT_FALSE(network.refused());
  CamReader reader(network);
  network.run_until(Time(3s));
  std::vector<unsigned> seen;
  while (network.now() < Time(60s)) {
    const unsigned cams = reader.read();
    if (seen.empty() || seen.back() != cams) seen.push_back(cams);
  }
  ASSERT_EQ(network.summary().served, 1U);
  // Zone of floor 1, none, 2, none, 3, none, and 4, which is the highest.
  EXPECT_EQ(seen, (std::vector<unsigned>{3, 0, 1, 0, 1, 0, 5}));
}

TEST(ShaftCams, AreWhereACarOfThisSpeedNeedsThem) {
  constexpr double heights[] = {0, 3, 6};
  const auto cams = cams_of_shaft(
      heights, {.door_zone_m = 0.2, .speed_m_s = 1, .acceleration_m_s2 = 1, .jerk_m_s3 = 1});
  ASSERT_EQ(cams.size(), 7U);
  EXPECT_DOUBLE_EQ(cams[1].low, 2800);
  EXPECT_DOUBLE_EQ(cams[1].high, 3200);
  EXPECT_DOUBLE_EQ(cams[3].high, 200) << "lowest floor";
  EXPECT_DOUBLE_EQ(cams[4].low, 5800) << "highest floor";
  EXPECT_DOUBLE_EQ(cams[5].high, 1000) << "2 s from 1 m/s";
  EXPECT_DOUBLE_EQ(cams[6].low, 5000);
}

}  // namespace
}  // namespace canvoy::lift::lift_configuration_test
