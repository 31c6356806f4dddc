// The taxi trip data sequence counter (60DBh; CiA 447-3, 4.2.12.9): a client reads it before and
// after the objects of the trip, and again where it has changed.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_sequence_test {
namespace {

/// Each kilometre costs 1000, and each second and each pulse is counted: distance and fare are the
/// same number at any moment, and supplements are ten times the hirings.
constexpr TariffLevel levels[] = {{.distance_rate = 1000}};

struct Read {
  std::uint64_t fare;
  std::uint64_t distance;
  std::uint64_t supplements;
  std::uint64_t total;

  bool is_of_one_moment() const { return fare == distance && total == fare + supplements; }
};

class Sequence : public testing::Test {
 protected:
  Sequence()
      : car({.k = 80,
             .calculation = FareMode::double_calculation,
             .tariff = {.id = 1, .levels = levels},
             .fastest_speed = 4000}) {}
  /// Time passes between two requests, and the taxi moves on.
  std::uint64_t slowly(std::uint16_t index, unsigned sub = 0) {
    car.drive(1, 80);
    return car.get(index, sub);
  }
  Read read() { return {slowly(0x60D0, 1), slowly(0x60D1), slowly(0x60D0, 2), slowly(0x60D0, 3)}; }

  MeterBench car;
};

TEST_F(Sequence, ChangesWhenTheTripDoesAndNotElse) {
  car.begin_shift();
  const std::uint64_t before = car.get(0x60DB);
  car.drive(5, 80);
  EXPECT_EQ(car.get(0x60DB), before) << "nothing of the last trip has changed";
  car.meter->hire();
  EXPECT_EQ(car.get(0x60DB), before + 1);
  car.meter->add_supplement(10);
  EXPECT_EQ(car.get(0x60DB), before + 2);
  car.meter->stop();
  const std::uint64_t stopped = car.get(0x60DB);
  car.drive(5, 80);
  EXPECT_EQ(car.get(0x60DB), stopped);
  car.meter->for_hire();
  EXPECT_EQ(car.get(0x60DB), stopped) << "it is the same trip";
}

TEST_F(Sequence, AClientThatGoesByItHasValuesOfOneMoment) {
  car.begin_shift();
  car.meter->hire();
  car.meter->add_supplement(500);
  unsigned torn = 0;
  for (unsigned attempt = 0; attempt < 50; ++attempt) {
    const std::uint64_t before = car.get(0x60DB);
    const Read values = read();
    const std::uint64_t after = car.get(0x60DB);
    EXPECT_NE(before, after) << "it takes the client seconds";
    if (!values.is_of_one_moment()) ++torn;
  }
  EXPECT_GT(torn, 40u) << "without the counter it would be wrong";
  // Sometimes it reads faster than the taxi changes.
  unsigned good = 0;
  for (unsigned attempt = 0; attempt < 50; ++attempt) {
    car.drive(1, 80);
    const std::uint64_t before = car.get(0x60DB);
    const std::uint64_t fare = car.get(0x60D0, 1);
    if (attempt % 2 == 0) car.drive(1, 80);
    const Read values = {fare, car.get(0x60D1), car.get(0x60D0, 2), car.get(0x60D0, 3)};
    if (car.get(0x60DB) != before) continue;
    ++good;
    EXPECT_TRUE(values.is_of_one_moment());
    EXPECT_EQ(values.supplements, 500u);
  }
  EXPECT_EQ(good, 25u);
}

TEST_F(Sequence, GoesFromFDhToZero) {
  car.begin_shift();
  car.meter->hire();
  std::uint64_t before = car.get(0x60DB);
  bool has_wrapped = false;
  for (unsigned change = 0; change < 600; ++change) {
    car.meter->add_supplement(1);
    const std::uint64_t now = car.get(0x60DB);
    ASSERT_EQ(now, before == 0xFD ? 0 : before + 1);
    has_wrapped = has_wrapped || now == 0;
    before = now;
  }
  EXPECT_TRUE(has_wrapped);
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_sequence_test
