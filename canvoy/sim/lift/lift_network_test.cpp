// A building with lifts as a whole: people press buttons of CANopen nodes, and a car comes.
#include "canvoy/sim/lift/lift_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace canvoy::lift {
namespace {

/// What was broken, so that a failure says it.
std::string broken(const LiftNetwork& network) {
  std::string text;
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    text += "invariant " + std::to_string(static_cast<int>(invariant.kind)) + " of lift " +
            std::to_string(invariant.lift) + ": " + std::to_string(invariant.value) +
            " where no more than " + std::to_string(invariant.bound) + " may be\n";
  }
  return text;
}

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

TEST(LiftNetworkTest, NodesBootAndAreStartedByTheController) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  LiftNetwork network(description);
  network.run_until(Time(3s));
  EXPECT_EQ(events_of<BootedUp>(network).size(), description.nodes.size());
  std::size_t operational = 0;
  for (const LiftEvent& event : events_of<NmtStateSeen>(network)) {
    operational += std::get<NmtStateSeen>(event.what).state == NmtState::operational ? 1 : 0;
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
  EXPECT_GT(summary.bus_loads.at(0), 0.001);
  EXPECT_LT(summary.bus_loads.at(0), 0.3);
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
}  // namespace canvoy::lift
