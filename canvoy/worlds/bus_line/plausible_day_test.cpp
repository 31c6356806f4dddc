// Compares days of the built-in line with real buses: the bounds are published figures of others.
// docs/bus.md has the measured values beside them, with the sources.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "canvoy/worlds/bus_line/bus_vehicle.hpp"

namespace canvoy::bus_line::plausible_day_test {
namespace {

constexpr std::uint64_t days = 20;

double in_s(Duration time) {
  return std::chrono::duration<double>(time).count();
}

/// A halt where the bus does not wait for the timetable: the people who got in there, and its
/// duration.
struct Stand {
  double boarded = 0;
  double alighted = 0;
  double seconds = 0;
};

struct Measured {
  unsigned departures = 0;
  unsigned early = 0;  ///< by more than a minute
  unsigned late = 0;   ///< by more than five
  std::uint64_t came = 0;
  std::uint64_t left_behind = 0;
  std::uint64_t ignored = 0;
  unsigned aboard_max = 0;
  std::vector<Stand> stands;
};

void measure_day(const BusLine& line, std::uint64_t seed, Measured& all) {
  BusVehicle bus(line, 0, {.seed = seed});
  Time arrived{};
  RiderStatistics before{};
  bus.on_event([&](Time now, BusEvent event, std::size_t stop) {
    if (event == BusEvent::arrives) {
      arrived = now;
      before = bus.riders().statistics();
    }
    if (event != BusEvent::leaves && event != BusEvent::passes) return;
    ++all.departures;
    if (bus.delay() < -1min) ++all.early;
    if (bus.delay() > 5min) ++all.late;
    const bool is_held = bus.truth().journey->passings[stop].is_timing_point;
    if (event == BusEvent::passes || is_held) return;
    const RiderStatistics& now_is = bus.riders().statistics();
    all.stands.push_back({static_cast<double>(now_is.in - before.in),
                          static_cast<double>(now_is.out - before.out), in_s(now - arrived)});
  });
  while (!bus.is_over() && bus.deadline() < Time(30h)) bus.advance(bus.deadline());
  const RiderStatistics& riders = bus.riders().statistics();
  all.came += riders.came;
  all.left_behind += riders.left_behind;
  all.ignored += riders.ignored;
  all.aboard_max = std::max(all.aboard_max, riders.aboard_max);
}

const Measured& measured() {
  static const Measured all = [] {
    Measured made;
    const BusLine line = built_in_line();
    for (std::uint64_t seed = 1; seed <= days; ++seed) measure_day(line, seed, made);
    return made;
  }();
  return all;
}

/// Seconds for each boarding passenger, by least squares over halts at which no passenger gets out.
double seconds_a_boarding(const std::vector<Stand>& stands) {
  double n = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (const Stand& stand : stands) {
    if (stand.alighted > 0 || stand.boarded == 0) continue;
    n += 1;
    x += stand.boarded;
    y += stand.seconds;
    xx += stand.boarded * stand.boarded;
    xy += stand.boarded * stand.seconds;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// Los Angeles Metro: two seconds for a smart card, four for cash, eight with a purchase (Shockley,
/// Salinas and Taylor); here three of five have a pass, one cancels inside and one buys.
TEST(PlausibleDay, WhoGetsInTakesAsLongAsWasMeasuredElsewhere) {
  const double seconds = seconds_a_boarding(measured().stands);
  std::printf("seconds a boarding: %.2f\n", seconds);
  EXPECT_GE(seconds, 2);
  EXPECT_LE(seconds, 8);
}

/// South East Queensland: 86 to 93 % of its bus services were on time in the months of 2023 to
/// 2026.
TEST(PlausibleDay, MostDeparturesAreNeitherEarlyNorLate) {
  const Measured& all = measured();
  const double on_time = 1 - double(all.early + all.late) / all.departures;
  std::printf("departures: %u, early %.1f %%, late %.1f %%, on time %.1f %%\n", all.departures,
              100.0 * all.early / all.departures, 100.0 * all.late / all.departures, 100 * on_time);
  EXPECT_GE(on_time, 0.86);
}

TEST(PlausibleDay, NobodyIsLeftWithRoomAboard) {
  const Measured& all = measured();
  std::printf("came %lu, left behind %lu, of these with room and in time %lu; at most %u aboard\n",
              static_cast<unsigned long>(all.came), static_cast<unsigned long>(all.left_behind),
              static_cast<unsigned long>(all.ignored), all.aboard_max);
  EXPECT_EQ(all.ignored, 0u);
}

/// Delays of arrivals towards the harbour: 2 min at School (the fifth stop), none before it. The
/// bounds are half a red light.
TEST(PlausibleDay, ArrivesAsLateAsWasMeasured) {
  const BusLine line = built_in_line();
  Delays delays;
  ASSERT_TRUE(delays.add({.stop = 4, .is_backward = false, .value = 2min}));
  const auto shared = std::make_shared<const Delays>(delays);
  double count = 0;
  double late_at_bridge = 0;
  double late_at_school = 0;
  for (std::uint64_t seed = 1; seed <= days; ++seed) {
    BusVehicle bus(line, 0, {.seed = seed, .delays = shared});
    bus.on_event([&](Time, BusEvent event, std::size_t stop) {
      const bool is_there = event == BusEvent::arrives || event == BusEvent::passes;
      if (!is_there || bus.truth().route->is_backward) return;
      if (stop == 3) late_at_bridge += in_s(bus.delay());
      if (stop == 4) late_at_school += in_s(bus.delay());
      if (stop == 4) ++count;
    });
    while (!bus.is_over() && bus.deadline() < Time(30h)) bus.advance(bus.deadline());
  }
  std::printf("late: %.1f s at the bridge, %.1f s at the school\n", late_at_bridge / count,
              late_at_school / count);
  EXPECT_NEAR(late_at_bridge / count, 0, 15);
  EXPECT_NEAR(late_at_school / count, 120, 15);
}

}  // namespace
}  // namespace canvoy::bus_line::plausible_day_test
