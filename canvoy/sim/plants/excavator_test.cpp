// The plant of an excavator alone: geometry, valves, earth.
#include "canvoy/sim/plants/excavator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace canvoy::excavator_plant_test {
namespace {

constexpr double step_seconds = 0.02;

void run(Excavator& machine, double seconds) {
  for (double at = 0; at < seconds; at += step_seconds) machine.step(step_seconds);
}

Excavator running(std::uint64_t soil = 1) {
  Excavator machine(soil);
  machine.set_pilot_pressure(true);
  machine.set_throttle(1);
  run(machine, 5);
  return machine;
}

/// Calculated by hand: boom 5.7 m, stick 2.9 m, bucket 1.4 m, hinged 0.2 m in front and 1.8 m high.
TEST(ExcavatorPlant, TheTipIsWhereTheAnglesSay) {
  const Excavator::Point stretched = Excavator::tip_at(0, 0, 0);
  EXPECT_DOUBLE_EQ(stretched.x, 0.2 + 5.7 + 2.9 + 1.4);
  EXPECT_DOUBLE_EQ(stretched.z, 1.8);
  const Excavator::Point down = Excavator::tip_at(0, -90, 0);
  EXPECT_NEAR(down.x, 0.2 + 5.7, 1e-9);
  EXPECT_NEAR(down.z, 1.8 - 2.9 - 1.4, 1e-9);
  const Excavator::Point folded = Excavator::tip_at(30, -120, -90);
  EXPECT_NEAR(folded.x, 0.2 + 5.7 * std::sqrt(3) / 2 - 1.4, 1e-9);
  EXPECT_NEAR(folded.z, 1.8 + 5.7 / 2 - 2.9, 1e-9);
}

/// Law of cosines: at a right angle, the cylinder is the hypotenuse of 1.8 m and 2.3 m.
TEST(ExcavatorPlant, ACylinderIsAsLongAsItsTriangleWants) {
  HydraulicCylinder boom({.near_metres = 1.8,
                          .far_metres = 2.3,
                          .at_zero = -90,
                          .direction = 1,
                          .lowest = -45,
                          .highest = 60,
                          .rate = 0.35});
  while (boom.angle() < 0) boom.step(0.2, 1, 0.001);
  EXPECT_NEAR(boom.length(), std::sqrt(1.8 * 1.8 + 2.3 * 2.3), 0.001);
  for (int i = 0; i < 10'000; ++i) boom.step(1, 1, 0.01);
  EXPECT_NEAR(boom.angle(), 60, 1e-6) << "the end of the stroke";
  EXPECT_EQ(boom.speed(), 0);
}

TEST(ExcavatorPlant, AValveHasADeadBandAndALag) {
  ValveSpool spool;
  for (int i = 0; i < 100; ++i) spool.step(0.05, 0.02);
  EXPECT_EQ(spool.opening(), 0);
  ValveSpool fast;
  fast.step(1, ValveSpool::lag_seconds);
  EXPECT_NEAR(fast.opening(), (1 - std::exp(-1) - 0.05) / 0.95, 1e-9);
}

TEST(ExcavatorPlant, NothingMovesWithoutPilotPressure) {
  Excavator machine = running();
  machine.set_pilot_pressure(false);
  const double before = machine.angle(Movement::boom);
  for (std::size_t i = 0; i < movements; ++i) machine.command(static_cast<Movement>(i), 1);
  run(machine, 1);
  EXPECT_EQ(machine.angle(Movement::boom), before);
  EXPECT_EQ(machine.angle(Movement::slew), 0);
  EXPECT_EQ(machine.angle(Movement::left_track), 0);
}

/// 36 degrees per second at full speed; it comes to rest within 0.4 s when the valve closes.
TEST(ExcavatorPlant, SlewsAndComesToRest) {
  Excavator machine = running();
  machine.command(Movement::slew, 1);
  run(machine, 1);
  const double before = machine.angle(Movement::slew);
  run(machine, 1);
  EXPECT_NEAR(machine.angle(Movement::slew) - before, 36, 1);
  machine.command(Movement::slew, 0);
  run(machine, 0.4);
  EXPECT_EQ(machine.speed(Movement::slew), 0);
}

TEST(ExcavatorPlant, NoEarthIsLost) {
  Excavator machine = running();
  double seconds = 0;
  for (int i = 0; i < 4000; ++i) {
    seconds += step_seconds;
    machine.command(Movement::boom, std::sin(seconds / 3));
    machine.command(Movement::stick, std::sin(seconds / 2));
    machine.command(Movement::bucket, std::sin(seconds));
    machine.command(Movement::slew, std::cos(seconds / 7));
    machine.step(step_seconds);
    const Excavator::Earth& earth = machine.earth();
    ASSERT_NEAR(earth.dug, earth.in_bucket + earth.heaped + earth.spilled, 1e-9);
    ASSERT_LE(earth.in_bucket, Excavator::bucket_capacity + 1e-9);
  }
  EXPECT_GT(machine.earth().dug, 1);
}

/// Contents of each of the first `count` buckets of a soil, in m3: dug by the stick, and dumped
/// beside.
std::vector<double> buckets_of(std::uint64_t soil, std::size_t count) {
  Excavator machine = running(soil);
  std::vector<double> buckets;
  double most = 0;
  for (double seconds = 0; buckets.size() < count && seconds < 10'000; seconds += step_seconds) {
    machine.command(Movement::boom, std::sin(seconds / 3));
    machine.command(Movement::stick, std::sin(seconds / 2));
    machine.command(Movement::bucket, std::sin(seconds));
    machine.command(Movement::left_track, 1);
    machine.command(Movement::right_track, 1);
    machine.step(step_seconds);
    const double now = machine.earth().in_bucket;
    if (now == 0 && most > 0) buckets.push_back(most);
    most = now == 0 ? 0 : std::max(most, now);
  }
  return buckets;
}

TEST(ExcavatorPlant, BucketsAreNotAlwaysFull) {
  const std::vector<double> buckets = buckets_of(7, 60);
  ASSERT_EQ(buckets.size(), 60U);
  EXPECT_LE(std::ranges::max(buckets), Excavator::bucket_capacity);
  EXPECT_GT(std::ranges::max(buckets), 0.95 * Excavator::bucket_capacity);
  const auto is_filled = [](double earth) {
    return earth >= Excavator::fill_least * Excavator::bucket_capacity;
  };
  const std::set<double> filled = [&] {
    std::set<double> all;
    std::ranges::copy_if(buckets, std::inserter(all, all.end()), is_filled);
    return all;
  }();
  EXPECT_GT(filled.size(), 20U) << "no two are alike";
  EXPECT_EQ(buckets_of(7, 60), buckets) << "the same soil, the same buckets";
  EXPECT_NE(buckets_of(8, 60), buckets);
}

TEST(ExcavatorPlant, AnEngineWithoutFuelMovesNothing) {
  Excavator machine = running();
  run(machine, 8 * 3600);
  EXPECT_EQ(machine.litres(), 0);
  machine.command(Movement::slew, 1);
  run(machine, 10);
  const double before = machine.angle(Movement::slew);
  run(machine, 1);
  EXPECT_NEAR(machine.angle(Movement::slew), before, 1e-3);
}

}  // namespace
}  // namespace canvoy::excavator_plant_test
