#include "canvoy/worlds/bus_line/bus_vehicle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace canvoy::bus_line::bus_vehicle_test {
namespace {

/// The first journeys of the built-in line.
BusLine short_day(std::size_t journeys) {
  BusLine line = built_in_line();
  line.blocks[0].journeys.resize(journeys);
  return line;
}

/// An event, with the true state at its time.
struct Happened {
  Time at{};
  BusEvent event{};
  std::size_t stop = 0;
  unsigned wanting_out = 0;
  double odometer = 0;
  std::uint32_t journey = 0;

  friend bool operator==(const Happened&, const Happened&) = default;
};

struct Day {
  explicit Day(const BusLine& line, const BusOptions& options = {}, RiderHands hands = {})
      : bus(line, 0, options, std::move(hands)) {
    bus.on_event([this](Time at, BusEvent event, std::size_t stop) {
      diary.push_back({at, event, stop, bus.riders().wanting_out_at(stop), bus.odometer(),
                       bus.truth().journey->number});
    });
  }
  /// Runs to the end of the block, or for 30 h; calls `look` after each step.
  void run(const std::function<void(Time)>& look = {}) {
    for (unsigned at_once = 0; !bus.is_over() && bus.deadline() < Time(30h);) {
      at_once = bus.deadline() > now ? 0 : at_once + 1;
      if (at_once > 1000) return;
      now = std::max(now, bus.deadline());
      bus.advance(now);
      if (look) look(now);
    }
  }
  void run_until(Time until) {
    while (bus.deadline() <= until) {
      now = std::max(now, bus.deadline());
      bus.advance(now);
    }
    now = until;
  }
  void follow(const std::optional<RealMotion>& real) { bus.follow(now, real); }
  std::size_t count(BusEvent event) const {
    std::size_t number = 0;
    for (const Happened& each : diary) number += each.event == event ? 1U : 0U;
    return number;
  }

  BusVehicle bus;
  std::vector<Happened> diary;
  Time now{};
};

TEST(BusVehicle, ADayOfServiceEndsWhereTheTimetableSaysAndNobodyIsLeftAboard) {
  const BusLine line = built_in_line();
  Day day(line);
  day.run();
  ASSERT_TRUE(day.bus.is_over());
  EXPECT_EQ(day.bus.riders().aboard(), 0U);
  EXPECT_GT(day.bus.riders().statistics().in, 500U);
  EXPECT_EQ(day.count(BusEvent::journey_begins), line.blocks[0].journeys.size() - 1);
  const Duration planned = line.blocks[0].journeys.back().passings.back().arrival;
  EXPECT_LT(std::chrono::abs(day.bus.time_of_day(day.now) - planned), 10min);
}

TEST(BusVehicle, TheFirstJourneyBeginsFiveMinutesAfterTheStart) {
  const BusLine line = short_day(1);
  Day day(line);
  day.run();
  for (const Happened& each : day.diary) {
    if (each.event != BusEvent::leaves) continue;
    EXPECT_EQ(each.stop, 0U);
    EXPECT_GE(each.at, Time(5min));
    EXPECT_LT(each.at, Time(6min));
    break;
  }
}

TEST(BusVehicle, TheDisplayTruthIsTheNextStopFromLeavingOnAndTheStopWhereItStands) {
  const BusLine line = short_day(2);
  Day day(line);
  EXPECT_TRUE(day.bus.truth().is_at_stop);
  EXPECT_EQ(day.bus.truth().stop->name, "Central Station");
  EXPECT_EQ(day.bus.truth().route->destination, "Harbour");
  bool has_left = false;
  bool has_turned = false;
  day.bus.on_event([&](Time, BusEvent event, std::size_t stop) {
    if (event == BusEvent::leaves && stop == 0) has_left = true;
    if (event == BusEvent::journey_begins) has_turned = true;
  });
  while (!has_left) day.bus.advance(day.bus.deadline());
  EXPECT_FALSE(day.bus.truth().is_at_stop);
  EXPECT_EQ(day.bus.truth().stop->name, "Market Square");
  while (!has_turned) day.bus.advance(day.bus.deadline());
  EXPECT_EQ(day.bus.truth().route->destination, "Central Station");
  EXPECT_EQ(day.bus.truth().stop->name, "Harbour");
}

/// CiA 407, Table 1, with the zones and segments of the built-in line.
TEST(BusVehicle, FareZoneAndSegmentHaveThoseBeforeThemBeside) {
  const BusLine line = short_day(1);
  Day day(line);
  std::vector<FarePosition> met = {day.bus.truth().fare};
  day.run([&](Time) {
    if (const FarePosition fare = day.bus.truth().fare; fare != met.back()) met.push_back(fare);
  });
  const auto at = [](std::uint8_t zone, std::uint16_t segment,
                     std::optional<std::uint8_t> previous_zone,
                     std::optional<std::uint16_t> previous_segment) {
    return FarePosition{zone, segment, previous_zone, previous_segment, true};
  };
  const std::vector<FarePosition> expected = {at(1, 1, {}, {}), at(1, 2, {}, 1), at(2, 1, 1, 2),
                                              at(2, 2, 1, 1)};
  EXPECT_EQ(met, expected);
}

TEST(BusVehicle, WithoutPeopleItGoesPastStopsAndLeavesNoTimingPointEarly) {
  const BusLine line = short_day(4);
  Day day(line, {.riders = {.boarding_mean = 0}});
  day.run();
  ASSERT_TRUE(day.bus.is_over());
  EXPECT_GT(day.count(BusEvent::passes), 4U);
  for (const Happened& each : day.diary) {
    if (each.event != BusEvent::leaves && each.event != BusEvent::passes) continue;
    const Passing& passing = line.blocks[0].journeys[each.journey - 1].passings[each.stop];
    if (passing.is_timing_point) {
      EXPECT_GE(day.bus.time_of_day(each.at) + 2s, passing.departure) << each.stop;
    }
  }
  EXPECT_EQ(day.count(BusEvent::door_changes), 0U);
}

/// A driver who has braked for a timing point halts there: none passes a stop at a speed at which
/// the bus could still stand near it, 30 m at 0.75 m/s^2.
TEST(BusVehicle, NobodyCreepsPastAStop) {
  const BusLine line = built_in_line();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Day day(line, {.seed = seed, .riders = {.boarding_mean = 0.5}});
    std::size_t passed = 0;
    day.bus.on_event([&](Time, BusEvent event, std::size_t) {
      if (event != BusEvent::passes) return;
      ++passed;
      EXPECT_GT(day.bus.speed() * day.bus.speed(), 2 * 0.75 * 30);
    });
    day.run();
    EXPECT_GT(passed, 0u);
  }
}

TEST(BusVehicle, WhereTheStopButtonIsDeadPeopleAreCarriedPast) {
  const BusLine line = short_day(10);
  Day day(line, {}, {.press_stop = [](Time, const Rider&) { return false; }});
  day.run();
  ASSERT_TRUE(day.bus.is_over());
  EXPECT_GT(day.bus.riders().statistics().carried_past, 0U);
  Day sound(line);
  sound.run();
  EXPECT_EQ(sound.bus.riders().statistics().carried_past, 0U);
}

TEST(BusVehicle, ADoorThatDoesNotCloseHoldsTheBusUntilItDoes) {
  const BusLine line = short_day(1);
  Day day(line);
  while (day.bus.door(1).state() != DoorState::open) day.bus.advance(day.bus.deadline());
  const std::size_t left = day.count(BusEvent::leaves);
  day.bus.break_door(day.now, 1, true);
  while (day.bus.deadline() < Time(40min)) day.bus.advance(day.bus.deadline());
  EXPECT_EQ(day.count(BusEvent::leaves), left);
  day.bus.break_door(Time(40min), 1, false);
  day.run();
  EXPECT_TRUE(day.bus.is_over());
  EXPECT_GT(day.count(BusEvent::leaves), left);
}

TEST(BusVehicle, ADoorThatDoesNotOpenSendsPeopleThroughTheOthers) {
  const BusLine line = short_day(2);
  std::array<unsigned, 2> through{};
  Day day(line, {}, {.through = [&](Time, std::size_t door, bool) { ++through.at(door); }});
  day.bus.break_door(Time{}, 0, true);
  day.run();
  EXPECT_TRUE(day.bus.is_over());
  EXPECT_EQ(through[0], 0U);
  EXPECT_GT(through[1], 0U);
}

TEST(BusVehicle, WithAllDoorsShutNobodyGetsInAndTheBusDrivesOn) {
  const BusLine line = short_day(2);
  Day day(line);
  for (const std::size_t door : {0U, 1U}) day.bus.break_door(Time{}, door, true);
  day.run();
  EXPECT_TRUE(day.bus.is_over());
  EXPECT_EQ(day.bus.riders().statistics().in, 0U);
  EXPECT_GT(day.bus.riders().statistics().left_behind, 0U);
}

TEST(BusVehicle, TheSameSeedGivesTheSameDay) {
  const BusLine line = short_day(6);
  Day a(line, {.seed = 3});
  Day b(line, {.seed = 3});
  Day c(line, {.seed = 4});
  for (Day* day : {&a, &b, &c}) day->run();
  EXPECT_EQ(a.diary, b.diary);
  EXPECT_NE(a.diary, c.diary);
}

TEST(BusVehicle, WhereJourneysEndFarFromTheNextStartItDrivesThere) {
  BusLine line = short_day(2);
  line.blocks[0].journeys[1] = line.blocks[0].journeys[0];  // from the station once more
  line.blocks[0].journeys[1].number = 2;
  for (Passing& passing : line.blocks[0].journeys[1].passings) {
    passing.arrival += 1h;
    passing.departure += 1h;
  }
  Day day(line);
  bool has_transferred = false;
  day.run([&](Time) {
    if (day.bus.state() != BusState::transferring) return;
    has_transferred = true;
    EXPECT_FALSE(day.bus.truth().is_at_stop);
    EXPECT_EQ(day.bus.truth().stop->name, "Central Station");
    EXPECT_EQ(day.bus.riders().aboard(), 0U);
  });
  EXPECT_TRUE(has_transferred);
  EXPECT_TRUE(day.bus.is_over());
}

/// A line of a form that no town has, but a timetable may have.
BusLine any_line() {
  BusLine line{.number = 1, .name = "1"};
  BusRoute route{.number = 1, .destination = "End"};
  const auto count = *rc::gen::inRange<std::size_t>(2, 9);
  std::vector<GeoPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = *rc::gen::inRange(5, 3000) / 100'000.0;  // 5.5 m to 3.3 km
    points.push_back({i == 0 ? 0 : points.back().latitude + step, 0});
    line.stops.push_back({.number = static_cast<std::uint32_t>(i + 1),
                          .name = "stop " + std::to_string(i),
                          .place = points.back()});
    route.stops.push_back({.stop = i, .fare_zone = 1, .route_segment = 1});
  }
  route.path = Path(std::move(points));
  for (std::size_t i = 0; i < count; ++i) route.stops[i].metres = route.path.metres_of(i);
  line.routes.push_back(std::move(route));
  line.blocks.push_back({.number = 1});
  Duration at = 8h;
  for (std::uint32_t number = 1; number <= 3; ++number) {
    Journey journey{.number = number};
    for (std::size_t i = 0; i < count; ++i) {
      journey.passings.push_back(
          {.arrival = at, .departure = at, .is_timing_point = *rc::gen::arbitrary<bool>()});
      at += 1min * *rc::gen::inRange(0, 5);
    }
    at += 10min;
    line.blocks[0].journeys.push_back(std::move(journey));
  }
  return line;
}

BusOptions any_options() {
  return {.seed = *rc::gen::arbitrary<std::uint64_t>(),
          .doors = *rc::gen::element(std::vector<DoorUse>{{}},
                                     std::vector<DoorUse>{{.alights = false}, {}},
                                     std::vector<DoorUse>{{}, {}, {.boards = false}}),
          .riders = {.boarding_mean = *rc::gen::inRange(0, 60) / 10.0,
                     .capacity = *rc::gen::inRange(1U, 80U)}};
}

// A journey begins five minutes after the start.
TEST(BusVehicle, ARealVehicleLeadsIt) {
  const BusLine line = built_in_line();
  Day day(line, {.riders = {.boarding_mean = 20}});
  const BusRoute& route = *day.bus.truth().route;
  day.follow(RealMotion{.known_doors = 3});
  day.run_until(Time(10min));
  EXPECT_EQ(day.count(BusEvent::leaves), 0u) << "it stands, though it is time";
  EXPECT_TRUE(day.bus.door(0).is_closed());
  day.follow(RealMotion{.known_doors = 3, .open_doors = 1});
  day.run_until(Time(11min));
  EXPECT_TRUE(day.bus.door(0).is_open());
  EXPECT_TRUE(day.bus.door(1).is_closed());
  EXPECT_GT(day.bus.truth().aboard, 0u);
  day.follow(RealMotion{.known_doors = 3});
  day.run_until(Time(12min));
  EXPECT_TRUE(day.bus.door(0).is_closed());

  day.follow(RealMotion{.speed = 10, .known_doors = 3});
  day.run_until(Time(12min + 10s));
  EXPECT_EQ(day.count(BusEvent::leaves), 1u);
  EXPECT_NEAR(day.bus.odometer(), 100, 1);
  const double second = route.stops[1].metres;
  const auto at = [&](double metres) {  // at 10 m/s, with a step for what has begun
    const double way = metres - day.bus.metres_on_route();
    day.run_until(day.now + std::chrono::milliseconds(static_cast<int>(way * 100) / 100 * 100));
  };
  at(second + 35);
  EXPECT_EQ(day.count(BusEvent::passes), 1u) << "it does not stand at the second stop";
  EXPECT_EQ(day.bus.truth().place, 2u);
  at(route.stops[2].metres - 40);
  day.follow(RealMotion{.known_doors = 3});
  day.run_until(day.now + 1min);
  EXPECT_EQ(day.bus.state(), BusState::driving) << "40 m before the third";
  day.follow(RealMotion{.speed = 10, .known_doors = 3});
  day.run_until(day.now + 2s);
  day.follow(RealMotion{.known_doors = 3});
  day.run_until(day.now + 1s);
  EXPECT_EQ(day.count(BusEvent::arrives), 0u) << "20 m before it, at red lights";
  day.follow(RealMotion{.known_doors = 3, .open_doors = 1});
  day.run_until(day.now + 1s);
  EXPECT_EQ(day.count(BusEvent::arrives), 1u) << "who opens a door there is at the stop";
  EXPECT_EQ(day.bus.state(), BusState::at_stop);

  day.follow(std::nullopt);
  day.run_until(day.now + 5min);
  EXPECT_GE(day.count(BusEvent::leaves), 2u) << "the driver goes on";
}

/// From 10 m/s, it cannot stop within 30 m at 0.75 m/s^2; from 5 m/s it needs 17 m.
TEST(BusVehicle, ARealVehicleHasPassedAStopWhereItCannotStandThereAnyMore) {
  for (const auto& [speed, beyond] : {std::pair{10.0, 0.0}, std::pair{5.0, 30 - 25 / 1.5}}) {
    const BusLine line = short_day(1);
    Day day(line);
    const double stop = line.routes[0].stops[1].metres;
    day.follow(RealMotion{.speed = speed});
    while (day.count(BusEvent::passes) == 0 && day.now < Time(20min)) {
      day.run_until(day.now + 100ms);
    }
    EXPECT_GE(day.bus.metres_on_route(), stop + beyond);
    EXPECT_LT(day.bus.metres_on_route(), stop + beyond + 2 * speed / 10);
  }
}

TEST(BusVehicle, ARealVehicleThatTellsNothingOfItsDoorsIsAtTheStopWhereItStandsNearIt) {
  const BusLine line = short_day(1);
  Day day(line);
  const double stop = line.routes[0].stops[1].metres;
  day.follow(RealMotion{.speed = 5});
  while (day.bus.metres_on_route() < stop - 25) day.run_until(day.now + 100ms);
  day.follow(RealMotion{});
  day.run_until(day.now + 1s);
  EXPECT_EQ(day.count(BusEvent::arrives), 1u);
}

TEST(BusVehicle, ARealVehicleLeadsItToItsNextStart) {
  BusLine line = short_day(1);
  line.blocks[0].journeys.push_back(line.blocks[0].journeys[0]);  // from the station once more
  Day day(line);
  const auto runs_while = [&](const auto& condition) {
    for (int i = 0; condition() && i < 7200; ++i) day.run_until(day.now + 1s);
  };
  runs_while([&] { return day.bus.state() != BusState::transferring; });
  day.follow(RealMotion{.speed = 10});
  runs_while([&] { return metres_between(day.bus.position(), line.stops[0].place) > 100; });
  day.follow(RealMotion{});
  day.run_until(day.now + 1min);
  EXPECT_EQ(day.bus.state(), BusState::transferring) << "100 m before the stop";
  day.follow(RealMotion{.speed = 10});
  day.run_until(day.now + 8s);
  EXPECT_EQ(day.bus.state(), BusState::transferring) << "it still rolls";
  day.follow(RealMotion{});
  day.run_until(day.now + 1s);
  EXPECT_EQ(day.bus.state(), BusState::at_stop) << "20 m before it";
  EXPECT_EQ(day.bus.truth().stop->name, "Central Station");
}

TEST(BusVehicle, ARealVehicleThatIsLostOnTheWayIsDrivenToTheNextStop) {
  const BusLine line = built_in_line();
  Day day(line);
  day.follow(RealMotion{.speed = 12});
  day.run_until(Time(20s));
  ASSERT_EQ(day.bus.state(), BusState::driving);
  day.follow(std::nullopt);
  day.run_until(Time(10min));
  EXPECT_EQ(
      day.count(BusEvent::leaves) - day.count(BusEvent::arrives) + day.count(BusEvent::passes), 1u);
}

RC_GTEST_PROP(BusVehicle, WhoIsInLessWhoIsOutIsAboardAtAnyTime, ()) {
  const BusLine line = any_line();
  const BusOptions options = any_options();
  unsigned in = 0;
  unsigned out = 0;
  Day day(line, options, {.through = [&](Time, std::size_t, bool is_in) { ++(is_in ? in : out); }});
  bool are_right = true;
  day.run([&](Time) {
    const unsigned aboard = day.bus.riders().aboard();
    are_right = are_right && in - out == aboard && aboard <= options.riders.capacity;
  });
  RC_ASSERT(are_right);
  RC_ASSERT(day.bus.is_over());
  const RiderStatistics& all = day.bus.riders().statistics();
  RC_ASSERT(all.in == in);
  RC_ASSERT(all.out == out);
  RC_ASSERT(in == out);
  RC_ASSERT(all.came >= all.in + all.left_behind);
}

RC_GTEST_PROP(BusVehicle, ItNeverGoesPastAStopWhereSomebodyWantsOut, ()) {
  const BusLine line = any_line();
  Day day(line, any_options());
  day.run();
  RC_ASSERT(day.bus.is_over());
  for (const Happened& each : day.diary) {
    if (each.event == BusEvent::passes) RC_ASSERT(each.wanting_out == 0U);
  }
  RC_ASSERT(day.bus.riders().statistics().carried_past == 0U);
}

RC_GTEST_PROP(BusVehicle, BetweenTwoStopsItDrivesTheMetresOfTheShape, ()) {
  const BusLine line = any_line();
  Day day(line, any_options());
  day.run();
  // Positions where a journey begins and where it ends.
  double begin = 0;
  for (const Happened& each : day.diary) {
    if (each.event == BusEvent::leaves && each.stop == 0) begin = each.odometer;
    if (each.event != BusEvent::arrives || each.stop + 1 != line.stops.size()) continue;
    RC_ASSERT(std::abs(each.odometer - begin - line.routes[0].path.metres()) < 0.001);
  }
}

RC_GTEST_PROP(BusVehicle, NobodyFallsOverAndNobodySpeeds, ()) {
  const BusLine line = any_line();
  Day day(line, any_options());
  double speed = 0;
  constexpr double step_s = 0.1;
  double fastest = 0;
  double most = 0;   // greatest increase from one step to the next
  double least = 0;  // greatest decrease
  bool moves_open = false;
  day.run([&](Time) {
    const double change = day.bus.speed() - std::exchange(speed, day.bus.speed());
    most = std::max(most, change);
    least = std::min(least, change);
    fastest = std::max(fastest, speed);
    for (std::size_t i = 0; speed > 0 && i < day.bus.door_count(); ++i) {
      moves_open = moves_open || !day.bus.door(i).is_closed();
    }
  });
  RC_ASSERT(most <= BusDrive::acceleration * step_s + 1e-6);
  // The last few centimetres are one step.
  RC_ASSERT(-least <= BusDrive::deceleration * step_s + 0.25);
  RC_ASSERT(fastest <= 27.8);
  RC_ASSERT_FALSE(moves_open);
}

}  // namespace
}  // namespace canvoy::bus_line::bus_vehicle_test
