// Changes of the built-in line for a day: the ways and times follow from the stops and from 6.9
// m/s, and a bus that drives them is judged as on any other day.
#include "canvoy/worlds/bus_line/line_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/bus_line/bus_day_test.hpp"

namespace canvoy::bus_line::line_changes_test {
namespace {

constexpr GeoPoint garage = {0.008, 0.008};  ///< 314 m from Central Station

/// `Central Station Market Square ...`.
std::string stops_of(const BusLine& line, const Journey& journey) {
  std::string names;
  for (std::size_t i = 0; i < journey.passings.size(); ++i) {
    names += (i == 0 ? "" : ", ") + line.stop(journey.route, i).name;
  }
  return names;
}

double end_of_way(const BusLine& line, const Journey& journey) {
  const BusRoute& route = line.routes[journey.route];
  EXPECT_NEAR(route.path.metres(), route.stops.back().metres, 0.01);
  return route.path.metres();
}

TEST(LineChanges, ABlockBeginsAndEndsInTheDepot) {
  BusLine line = built_in_line();
  EXPECT_EQ(add_depot(line, {.place = garage, .name = "Yard", .sign = "Off duty"}), "");
  const Block& block = line.blocks[0];
  ASSERT_EQ(block.journeys.size(), 60U) << "58 of them with passengers";
  const Journey& out = block.journeys.front();
  EXPECT_EQ(stops_of(line, out), "Yard, Central Station");
  EXPECT_EQ(out.number, 59U);
  EXPECT_EQ(out.trip, "");
  EXPECT_EQ(out.passings[1].arrival, 4h + 59min) << "a minute before the first departure";
  EXPECT_EQ(out.passings[0].departure, 4h + 58min) << "314 m at 6.9 m/s, whole minutes";
  EXPECT_FALSE(out.passings[0].boards || out.passings[1].alights);
  EXPECT_EQ(line.routes[out.route].destination, "Off duty");
  EXPECT_NEAR(end_of_way(line, out), 314, 2);
  const Journey& in = block.journeys.back();
  EXPECT_EQ(stops_of(line, in), "Central Station, Yard");
  EXPECT_EQ(in.number, 60U);
  EXPECT_EQ(in.passings[0].departure, 24h + 17min) << "a minute after the last arrival";
}

TEST(LineChanges, AShortTurnIsTheBeginningOfTheNextJourney) {
  BusLine line = built_in_line();
  EXPECT_EQ(turn_short(line, 0, {.journey = 1, .stop = "SCHOOL"}), "");
  const auto& journeys = line.blocks[0].journeys;
  EXPECT_EQ(stops_of(line, journeys[0]),
            "Central Station, Market Square, Town Hall, Old Bridge, School");
  EXPECT_EQ(stops_of(line, journeys[1]),
            "School, Old Bridge, Town Hall, Market Square, Central Station");
  EXPECT_EQ(journeys[0].passings.back().arrival, 5h + 9min);
  EXPECT_EQ(journeys[1].passings.front().departure, 5h + 27min);
  EXPECT_EQ(line.routes[journeys[0].route].destination, "School");
  EXPECT_EQ(line.routes[journeys[1].route].destination, "Central Station");
  EXPECT_NEAR(end_of_way(line, journeys[0]), end_of_way(line, journeys[1]), 1);
  EXPECT_EQ(stops_of(line, journeys[2]).substr(0, 15), "Central Station");
  EXPECT_EQ(journeys[2].passings.size(), 8U) << "others are as ever";
  EXPECT_EQ(line.routes.size(), 4U);
}

TEST(LineChanges, ADetourLeavesOutStops) {
  BusLine line = built_in_line();
  const GeoPoint corner = {0.0240, 0.0208};
  EXPECT_EQ(divert(line, 0, {.journey = 1, .without = {"School"}, .via = {corner}}), "");
  const Journey& journey = line.blocks[0].journeys[0];
  EXPECT_EQ(
      stops_of(line, journey),
      "Central Station, Market Square, Town Hall, Old Bridge, Hospital, Garden City, Harbour");
  const BusRoute& route = line.routes[journey.route];
  const double way = route.stops[4].metres - route.stops[3].metres;
  EXPECT_NEAR(
      way,
      metres_between(line.stops[3].place, corner) + metres_between(corner, line.stops[5].place),
      0.1);
  const BusRoute& whole = line.routes[0];
  EXPECT_NEAR(route.stops[6].metres - route.stops[4].metres,
              whole.stops[7].metres - whole.stops[5].metres, 0.1);
  EXPECT_NEAR(end_of_way(line, journey), route.stops[6].metres, 0.1);
}

TEST(LineChanges, WhatIsNotPossibleChangesNothing) {
  BusLine line = built_in_line();
  EXPECT_EQ(turn_short(line, 0, {.journey = 99, .stop = "School"}), "the block has no journey 99");
  EXPECT_EQ(turn_short(line, 0, {.journey = 1, .stop = "Harbour"}),
            "the journey does not call at 'Harbour' between its ends");
  EXPECT_EQ(turn_short(line, 0, {.journey = 1, .stop = "Zoo"}),
            "the journey does not call at 'Zoo' between its ends");
  EXPECT_EQ(divert(line, 0, {.journey = 1, .without = {}}), "a detour leaves out a stop");
  EXPECT_EQ(divert(line, 0, {.journey = 1, .without = {"Market Square", "School"}}),
            "the stops of a detour follow each other");
  EXPECT_EQ(divert(line, 0, {.journey = 1, .without = {"Central Station"}}),
            "the journey does not call at 'Central Station' between its ends");
  EXPECT_EQ(add_depot(line, {.place = line.stops[2].place}), "the depot is at the stop Town Hall");
  EXPECT_EQ(add_depot(line, {.place = {5, 5}}), "the depot is too far away");
  EXPECT_EQ(line.routes.size(), 2U);
  EXPECT_EQ(line.stops.size(), 8U);
  EXPECT_EQ(line.blocks[0].journeys.size(), 58U);
}

/// A morning with all of them, by the displays and by what the devices were told.
TEST(LineChanges, ABusThatDrivesThemIsJudgedAsEver) {
  for (std::uint64_t seed = 1; seed <= (tries_all() ? 5U : 2U); ++seed) {
    BusNetworkOptions options = with_seed(seed);
    ASSERT_EQ(turn_short(options.line, 0, {.journey = 1, .stop = "School"}), "");
    ASSERT_EQ(divert(options.line, 0, {.journey = 3, .without = {"Town Hall", "Old Bridge"}}), "");
    ASSERT_EQ(add_depot(options.line, {.place = garage}), "");
    options.drivers = {{.journey = 2, .driver = 4711}};
    options.length = 80min;
    BusNetwork network(options);
    const auto driver = [&network] {
      return network.node(computer_id).node().dictionary().word(0x6190, 0);
    };
    // 4:53 is time 0: five minutes before the way out.
    network.run_until(Time(5min + 20s));
    EXPECT_EQ(network.display(front_display_id).text(), "407\nNot in service");
    EXPECT_EQ(network.vehicle().truth().aboard, 0U);
    EXPECT_EQ(driver(), 1234U) << "the first one";
    network.run_until(Time(10min));
    EXPECT_EQ(network.display(front_display_id).text(), "407\nSchool");
    network.run_until(Time(36min));
    EXPECT_EQ(network.display(front_display_id).text(), "407\nCentral Station");
    EXPECT_EQ(driver(), 4711U);
    network.run_until(network.end());
    EXPECT_EQ(broken(network), "") << seed;
    EXPECT_GT(network.snapshot().riders.in, 0U);
  }
}

/// The whole last hour, to the depot.
TEST(LineChanges, TheDayEndsInTheDepot) {
  BusNetworkOptions options = with_seed(3);
  auto& journeys = options.line.blocks[0].journeys;
  journeys = {journeys[0], journeys[1]};
  ASSERT_EQ(add_depot(options.line, {.place = garage}), "");
  BusNetwork network(options);
  network.run_until(network.end());
  EXPECT_TRUE(network.vehicle().is_over());
  EXPECT_LT(metres_between(network.vehicle().position(), garage), 5);
  EXPECT_EQ(network.display(front_display_id).text(), "407\nNot in service");
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::bus_line::line_changes_test
