// Passengers as counted: how many come where and when, their destinations, and their times at the
// doors.
#include "canvoy/worlds/bus_line/demand.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <memory>
#include <set>

#include "canvoy/worlds/bus_line/bus_vehicle.hpp"

namespace canvoy::bus_line::demand_test {
namespace {

TEST(Demand, WhatIsSaidOfADirectionAndAnHourGoesFirst) {
  Demand demand;
  EXPECT_TRUE(demand.add({.stop = 1, .value = {.boarding = 1}}));
  EXPECT_TRUE(demand.add({.stop = 1, .hour = 7, .value = {.boarding = 2}}));
  EXPECT_TRUE(demand.add({.stop = 1, .is_backward = true, .value = {.boarding = 3}}));
  EXPECT_TRUE(demand.add({.stop = 1, .is_backward = true, .hour = 7, .value = {.boarding = 4}}));
  EXPECT_FALSE(demand.add({.stop = 1, .hour = 7, .value = {.boarding = 5}})) << "said already";
  EXPECT_EQ(demand.at(1, false, 6).boarding, 1);
  EXPECT_EQ(demand.at(1, false, 7).boarding, 2);
  EXPECT_EQ(demand.at(1, true, 6).boarding, 3);
  EXPECT_EQ(demand.at(1, true, 7).boarding, 4);
  EXPECT_EQ(demand.at(2, true, 7).boarding, 0) << "nobody says anything";
}

/// People of a day of the built-in line, and the time for which it stood at each stop.
struct Watched {
  explicit Watched(const BusOptions& options) : bus(line, 0, options) {
    bus.on_event([this](Time at, BusEvent event, std::size_t stop) {
      if (event == BusEvent::arrives) arrived = at;
      if (event == BusEvent::leaves) stood[stop] += at - arrived;
      if (event == BusEvent::leaves && left == never) left = at;
    });
    while (!bus.is_over() && bus.deadline() < Time(30h)) {
      bus.advance(bus.deadline());
      for (const Rider& rider : bus.riders().riders_aboard()) {
        if (!seen.insert(rider.number).second) continue;
        const BusTruth truth = bus.truth();
        ++from[{truth.route->stops[rider.from].stop, truth.route->is_backward}];
        ++to[truth.route->stops[rider.to].stop];
      }
    }
  }

  const BusLine line = built_in_line();
  BusVehicle bus;
  std::set<std::uint64_t> seen;
  std::map<std::pair<std::size_t, bool>, unsigned> from;
  std::map<std::size_t, unsigned> to;
  std::map<std::size_t, Duration> stood;
  Time arrived{};
  Time left = never;
};

BusOptions counted(const std::initializer_list<Demand::Row>& rows) {
  auto demand = std::make_shared<Demand>();
  for (const Demand::Row& row : rows) demand->add(row);
  BusOptions options{.seed = 3};
  options.riders.demand = demand;
  return options;
}

/// Of the 29 journeys to the harbour, five begin between 7 and 10: with 6 people at a stop, 30 are
/// expected, and 15 to 45 are within three standard deviations of a Poisson process.
TEST(Demand, PeopleComeWhereAndWhenTheyWereCounted) {
  Exchange six{.boarding = 6};
  const Watched day(counted({{.stop = 2, .is_backward = false, .hour = 7, .value = six},
                             {.stop = 2, .is_backward = false, .hour = 8, .value = six},
                             {.stop = 2, .is_backward = false, .hour = 9, .value = six}}));
  ASSERT_EQ(day.from.size(), 1u);
  const auto& [place, count] = *day.from.begin();
  EXPECT_EQ(place.first, 2u);
  EXPECT_FALSE(place.second);
  EXPECT_GE(count, 13u);
  EXPECT_LE(count, 47u);
}

/// Three of four at the hospital, one of four at the terminal.
TEST(Demand, TheyGoToStopsInProportionToWhoGetsOutThere) {
  const Watched day(counted({{.stop = 0, .is_backward = false, .value = {.boarding = 20}},
                             {.stop = 5, .is_backward = false, .value = {.alighting = 3}},
                             {.stop = 7, .is_backward = false, .value = {.alighting = 1}}}));
  ASSERT_EQ(day.to.size(), 2u);
  const double all = day.to.at(5) + day.to.at(7);
  EXPECT_GT(all, 400);
  // Three standard deviations of a share of 3/4 of 400 are 6.5 %.
  EXPECT_NEAR(day.to.at(5) / all, 0.75, 0.065);
}

TEST(Demand, WhoTakesLongerInTheDoorHasTheBusStandLonger) {
  BusOptions quick = counted({{.stop = 1, .is_backward = false, .value = {.boarding = 10}}});
  quick.riders.pass_percent = 100;
  quick.doors = {{}};
  BusOptions slow = quick;
  slow.riders.boarding_time = 8s;
  const Watched with_quick(quick);
  const Watched with_slow(slow);
  // Six seconds longer in the only door; some more people come while it stands.
  const auto seconds_each = [](const Watched& day) {
    return std::chrono::duration<double>(day.stood.at(1)).count() /
           static_cast<double>(day.seen.size());
  };
  EXPECT_NEAR(seconds_each(with_slow) - seconds_each(with_quick), 6, 1);
}

TEST(BusVehicle, ThatBeginsLateIsLateAndHurries) {
  BusOptions options{.seed = 3};
  options.late = 7min;
  const Watched day(options);
  // The first departure is at 5:00, five minutes after time 0.
  EXPECT_GE(day.left, Time(12min));
  EXPECT_LT(day.left, Time(13min));
  EXPECT_TRUE(day.bus.is_over());
}

}  // namespace
}  // namespace canvoy::bus_line::demand_test
