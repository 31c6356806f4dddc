// A building with lifts as a whole: people press buttons of CANopen nodes, and a car comes.
#include "canvoy/worlds/lift/lift_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_network_test {
namespace {

template <class What>
std::vector<LiftEvent> events_of(const LiftNetwork& network) {
  std::vector<LiftEvent> found;
  std::copy_if(network.events().begin(), network.events().end(), std::back_inserter(found),
               [](const LiftEvent& event) { return std::holds_alternative<What>(event.what); });
  return found;
}

TEST(LiftNetworkTest, OnePersonCallsTheCarIsAcknowledgedBoardsAndIsBroughtThere) {
  LiftNetworkDescription description = standard_lift_network({.floors = 6});
  description.arrivals = {{.at = Time(5s), .from = 4, .to = 2, .mass_kg = 80}};
  LiftNetwork network(description);
  network.run_until(Time(90s));
  const LiftSummary summary = network.summary();
  EXPECT_EQ(summary.served, 1U);
  EXPECT_LT(summary.waiting.longest, 30s);
  EXPECT_EQ(broken(network), "");
  const auto lamps = events_of<LampChanged>(network);
  ASSERT_EQ(lamps.size(), 4U);
  const auto& hall = std::get<LampChanged>(lamps[0].what);
  EXPECT_EQ(hall.call, (CallKey{.floor = 4, .direction = Direction::down}));
  EXPECT_TRUE(hall.lit);
  EXPECT_LT(lamps[0].at - Time(5s), 1s);
  const auto& car = std::get<LampChanged>(lamps[2].what);
  EXPECT_EQ(car.call, (CallKey{.lift = 1, .floor = 2}));
}

NodeDescription& node_of(LiftNetworkDescription& description, DeviceKind kind) {
  return *std::ranges::find(description.nodes, kind, &NodeDescription::kind);
}

/// Like a configuration tool: a PDO changes while it is invalid (CiA 301, 7.5.2.35).
void move_pdo(NodeDescription& node, std::uint16_t parameters, std::uint8_t can_id) {
  node.values.push_back({parameters, 1, {can_id, 0x01, 0x00, 0x80}});
  node.values.push_back({parameters, 1, {can_id, 0x01, 0x00, 0x00}});
}

TEST(LiftNetworkTest, TheDriveIsCommandedOnAnotherCanIdWhereBothEndsAreGivenIt) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(5s), .from = 3, .to = 1, .mass_kg = 80}};
  move_pdo(node_of(description, DeviceKind::lift_controller), 0x1904, 0x94);
  move_pdo(node_of(description, DeviceKind::drive), 0x1504, 0x94);
  LiftNetwork network(description);
  struct {
    unsigned usual = 0, chosen = 0;
  } frames;
  network.observe(
      0, {.context = &frames, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
            auto& count = *static_cast<decltype(frames)*>(self);
            count.usual += frame.id == 0x180 ? 1 : 0;
            count.chosen += frame.id == 0x194 ? 1 : 0;
          }});
  network.run_until(Time(60s));
  EXPECT_FALSE(network.refused());
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_GT(frames.chosen, 0U);
  EXPECT_EQ(frames.usual, 0U);
}

TEST(LiftNetworkTest, AValueThatANodeDoesNotTakeIsTold) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  node_of(description, DeviceKind::landing_panel).values = {{0x5FFF, 0, {1}}};
  const LiftNetwork network(description);
  const std::optional<RefusedValue> refused = network.refused();
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->node.kind, DeviceKind::landing_panel);
  EXPECT_EQ(refused->refusal.value.index, 0x5FFF);
  EXPECT_EQ(refused->refusal.reason, AbortCode::no_object);
}

TEST(LiftNetworkTest, NodesBootAndAreStartedByTheController) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  LiftNetwork network(description);
  network.run_until(Time(3s));
  EXPECT_EQ(events_of<BootedUp>(network).size(), description.nodes.size());
  std::size_t operational = 0;
  for (const LiftEvent& event : events_of<NmtStateSeen>(network)) {
    if (std::get<NmtStateSeen>(event.what).state == NmtState::operational) ++operational;
  }
  EXPECT_EQ(operational, description.nodes.size());
}

TEST(LiftNetworkTest, AQuarterOfAnHourOfInterfloorTrafficIsServedWithAllInvariants) {
  StandardLifts options{.floors = 8};
  options.traffic.percent_in_5_minutes = 4;
  LiftNetwork network(standard_lift_network(options));
  network.run_until(Time(15min));
  const LiftSummary summary = network.summary();
  EXPECT_GT(summary.served, 10U);
  EXPECT_EQ(broken(network), "");
  EXPECT_GT(summary.lifts.at(0).energy_wh, 0);
  EXPECT_GT(summary.buses.at(0).load, 0.001);
  EXPECT_LT(summary.buses.at(0).load, 0.3);
}

TEST(LiftNetworkTest, TheSameDescriptionGivesTheSameFramesAtTheSameTimes) {
  const auto trace = [] {
    LiftNetwork network(standard_lift_network({.floors = 5, .seed = 3}));
    std::uint64_t hash = 0;
    network.observe(0, {.context = &hash,
                        .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
                          auto& sum = *static_cast<std::uint64_t*>(context);
                          sum = sum * 31 + frame.id + frame.data[0] +
                                static_cast<std::uint64_t>(now.time_since_epoch().count());
                        }});
    network.run_until(Time(3min));
    return hash;
  };
  EXPECT_EQ(trace(), trace());
}

TEST(LiftNetworkTest, AGroupServesInterfloorTrafficWithAllInvariants) {
  StandardLifts options{.lifts = 3, .floors = 8};
  options.traffic.percent_in_5_minutes = 8;
  LiftNetwork network(standard_lift_network(options));
  network.run_until(Time(10min));
  EXPECT_GT(network.summary().served, 30U);
  EXPECT_EQ(broken(network), "");
  for (const LiftSummary::Lift& lift : network.summary().lifts) EXPECT_GT(lift.starts, 5U);
  EXPECT_EQ(network.summary().buses.size(), 4U);
}

TEST(LiftNetworkTest, WithDestinationControlPeopleTakeTheLiftThatTheirPanelNames) {
  StandardLifts options{.lifts = 2, .floors = 6, .destination_control = true};
  LiftNetworkDescription description = standard_lift_network(options);
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 4},
                          {.at = Time(9s), .from = 5, .to = 2}};
  LiftNetwork network(description);
  network.run_until(Time(2min));
  EXPECT_EQ(network.summary().served, 2U);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftNetworkTest, ADeviceThatIsLeftOutIsNotThereAndTheOthersAre) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  std::erase_if(description.nodes,
                [](const NodeDescription& node) { return node.kind == DeviceKind::load; });
  LiftNetwork network(description);
  network.run_until(Time(3s));
  EXPECT_EQ(events_of<BootedUp>(network).size(), description.nodes.size());
}

TEST(LiftNetworkTest, ASnapshotShowsCarsDoorsLandingsAndBuses) {
  LiftNetworkDescription description = standard_lift_network({.floors = 5});
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 5}};
  LiftNetwork network(description);
  network.run_until(Time(8s));
  const LiftNetworkSnapshot view = network.snapshot();
  ASSERT_EQ(view.lifts.size(), 1U);
  EXPECT_EQ(view.landings.size(), 5U);
  EXPECT_EQ(view.buses.size(), 1U);
  EXPECT_EQ(view.lifts[0].nearest_floor, 1);
  EXPECT_EQ(view.lifts[0].mode, LiftMode::normal);
  EXPECT_GT(view.lifts[0].doors[0].open_share, 0.5);
  EXPECT_FALSE(view.lifts[0].doors[1].is_there);
}

}  // namespace
}  // namespace canvoy::lift::lift_network_test
