#include "canvoy/worlds/bus_line/bus_depot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace canvoy::bus_line::bus_depot_test {
namespace {

constexpr Duration played = 22min;

BusNetworkOptions depot() {
  BusNetworkOptions options;
  options.faults.seed = 40;
  options.length = played;
  return options;
}

VehicleReport report(const BusNetworkOptions& options, std::uint32_t number) {
  BusNetwork network(options);
  network.run_until(network.end());
  return report_of(network, number);
}

TEST(BusDepot, AVehicleIsABusOfTheNextSeed) {
  BusNetworkOptions alone = depot();
  alone.faults.seed = 42;
  const VehicleReport third = report(depot_vehicle(depot(), 3), 3);
  const VehicleReport same = report(alone, 3);
  EXPECT_EQ(third.number, 3);
  EXPECT_EQ(third.seed, 42);
  EXPECT_EQ(third.length, played);
  EXPECT_EQ(third.bus.frames, same.bus.frames);
  EXPECT_EQ(third.riders.in, same.riders.in);
  EXPECT_EQ(third.odometer, same.odometer);
  EXPECT_NE(third.bus.frames, report(depot_vehicle(depot(), 4), 4).bus.frames);
}

TEST(BusDepot, AfterTheLastSeedComesTheFirst) {
  BusNetworkOptions options = depot();
  options.faults.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(depot_vehicle(options, 1).faults.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(depot_vehicle(options, 2).faults.seed, 0);
}

TEST(BusDepot, VehiclesDriveTheBlocksInTurn) {
  BusNetworkOptions options = depot();
  Block second = options.line.blocks.front();
  second.number = 2;
  options.line.blocks.push_back(second);
  for (const auto& [vehicle, block] : {std::pair{1U, 0U}, {2U, 1U}, {3U, 0U}, {1000U, 1U}}) {
    EXPECT_EQ(depot_vehicle(options, vehicle).block, block);
  }
  EXPECT_EQ(report(depot_vehicle(options, 2), 2).block, 2);
}

/// Vehicles 1 and 2 of a depot belong to one day, which has both of them, by their own seeds.
TEST(BusDepot, TheDayOfALineHasEachBlockWithTheSeedOfItsVehicle) {
  BusNetworkOptions options = depot();
  Block second = options.line.blocks.front();
  second.number = 2;
  for (Journey& journey : second.journeys) {
    journey.number += 100;
    for (Passing& passing : journey.passings) {
      passing.arrival += 10min;
      passing.departure += 10min;
    }
  }
  options.line.blocks.push_back(second);
  std::vector<BusOptions> both(2, vehicle_options(options));
  both[1].seed = both[0].seed + 1;
  const LineDay day(options.line, both, 12h);
  for (const std::uint32_t number : {1U, 2U}) {
    const auto same = line_day_of(depot_vehicle(options, number), 12h);
    ASSERT_NE(same, nullptr);
    for (std::size_t stop = 0; stop < 4; ++stop) {
      const auto ahead = day.ahead(1, 101, stop);
      const auto ahead_too = same->ahead(1, 101, stop);
      ASSERT_TRUE(ahead && ahead_too);
      EXPECT_TRUE(ahead->left);
      EXPECT_EQ(ahead->left, ahead_too->left) << number << ' ' << stop;
    }
  }
}

VehicleReport vehicle(std::uint32_t number, double worst, bool held) {
  VehicleReport made{.number = number, .length = number * 1min};
  made.statistics = {
      .journeys = 2, .stops = 3, .announced = 4, .texts = 5, .worst_delay = number * 1s};
  made.riders = {.came = 9,
                 .in = 8,
                 .out = 7,
                 .left_behind = 1,
                 .carried_past = 2,
                 .bought = 3,
                 .cancelled = 4,
                 .without_ticket = 5,
                 .aboard_max = number};
  made.odometer = 1000;
  made.bus = {.load = number / 100.0, .frames = 10, .error_frames = 2};
  made.invariants = {{.kind = InvariantKind::lie, .worst = worst, .allowed = 1, .held = held},
                     {.kind = InvariantKind::texts}};
  return made;
}

TEST(BusDepot, TotalsSumWhatIsCountedAndKeepTheWorst) {
  DepotTotals totals;
  totals.add(vehicle(1, 0.5, true));
  totals.add(vehicle(2, 1.5, false));
  totals.add(vehicle(3, 0.25, true));
  EXPECT_EQ(totals.vehicles, 3);
  EXPECT_EQ(totals.failed, std::vector<std::uint32_t>{2});
  EXPECT_EQ(totals.longest, 3min);
  EXPECT_EQ(totals.statistics.journeys, 6);
  EXPECT_EQ(totals.statistics.stops, 9);
  EXPECT_EQ(totals.statistics.announced, 12);
  EXPECT_EQ(totals.statistics.texts, 15);
  EXPECT_EQ(totals.statistics.worst_delay, 3s);
  EXPECT_EQ(totals.riders.came, 27);
  EXPECT_EQ(totals.riders.in, 24);
  EXPECT_EQ(totals.riders.out, 21);
  EXPECT_EQ(totals.riders.left_behind, 3);
  EXPECT_EQ(totals.riders.carried_past, 6);
  EXPECT_EQ(totals.riders.bought, 9);
  EXPECT_EQ(totals.riders.cancelled, 12);
  EXPECT_EQ(totals.riders.without_ticket, 15);
  EXPECT_EQ(totals.riders.aboard_max, 3U);
  EXPECT_EQ(totals.odometer, 3000);
  EXPECT_EQ(totals.bus.load, 0.03);
  EXPECT_EQ(totals.bus.frames, 30);
  EXPECT_EQ(totals.bus.error_frames, 6);
  ASSERT_EQ(totals.invariants.size(), 2);
  EXPECT_EQ(totals.invariants[0].worst, 1.5);
  EXPECT_FALSE(totals.invariants[0].held);
  EXPECT_TRUE(totals.invariants[1].held);
}

TEST(BusDepot, AVehicleThatLiesHasFailed) {
  BusNetworkOptions options = depot_vehicle(depot(), 1);
  options.sabotage.freezes_destination = true;
  const VehicleReport liar = report(options, 1);
  EXPECT_FALSE(liar.all_hold());
  EXPECT_TRUE(report(depot_vehicle(depot(), 1), 1).all_hold());
}

}  // namespace
}  // namespace canvoy::bus_line::bus_depot_test
