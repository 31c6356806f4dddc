// Fares of trips, computed by hand: the expected amounts are products of rates and driven
// distances, in 0,001 of the currency unit.
#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace canvoy::cia447::fare_calculation_test {
namespace {

/// 3,90 initial fare; 2,30 per kilometre; 33,00 per hour; in steps of 0,10. Both cost the same at
/// 14,35 km/h.
constexpr TariffLevel day = {.name = {'1', 0},
                             .initial_fare = 3900,
                             .distance_rate = 2300,
                             .time_rate = 33'000,
                             .increment = 100};
constexpr std::uint32_t k = 8000;  ///< pulses a kilometre

FareCalculation trip(FareMode mode, const TariffLevel& level = day, std::uint32_t constant = k) {
  FareCalculation fare;
  fare.begin({.mode = mode, .k = constant}, level);
  return fare;
}
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  /// 0 to `count` - 1.
  unsigned of(unsigned count) { return static_cast<unsigned>(engine_() % count); }

 private:
  std::mt19937 engine_;
};

/// Slices of a second, as in a taximeter.
void drive(FareCalculation& fare, unsigned seconds, std::uint32_t pulses_a_second) {
  for (unsigned i = 0; i < seconds; ++i) {
    fare.advance(pulses_a_second, 1s);
    fare.close_slice();
  }
}

TEST(FareCalculation, BeginsWithTheInitialFare) {
  EXPECT_EQ(trip(FareMode::single_calculation).fare(), 3900u);
  EXPECT_EQ(trip(FareMode::double_calculation).fare(), 3900u);
}

TEST(FareCalculation, InModeSDistanceCostsAboveTheCrossoverSpeed) {
  auto fare = trip(FareMode::single_calculation);
  drive(fare, 100, 80);  // 36 km/h, 1 km: 2,30
  EXPECT_EQ(fare.fare(), 3900u + 2300u);
  EXPECT_EQ(fare.charged_time(), 0s);
}

TEST(FareCalculation, InModeSTimeCostsBelowIt) {
  auto fare = trip(FareMode::single_calculation);
  drive(fare, 360, 10);  // 4,5 km/h; a tenth of an hour: 3,30; the distance alone: 1,035
  EXPECT_EQ(fare.fare(), 3900u + 3300u);
  EXPECT_EQ(fare.charged_time(), 360s);
}

TEST(FareCalculation, InModeDBothCostAtOnce) {
  auto fare = trip(FareMode::double_calculation);
  drive(fare, 360, 80);  // 3,6 km: 8,28, and a tenth of an hour: 3,30; together 11,58
  EXPECT_EQ(fare.fare(), 3900u + 11'500u);
  EXPECT_EQ(fare.charged_time(), 360s);
}

/// No count came for an hour, while half an hour was not decided yet: what exceeds an hour is
/// another slice.
TEST(FareCalculation, ASliceThatExceedsAnHourEndsAtTheHour) {
  auto fare = trip(FareMode::single_calculation);
  fare.advance(0, 30min);
  fare.advance(144'000, 60min);  // 18 km within the first hour: 41,40; then half an hour: 16,50
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 3900u + 41'400u + 16'500u) << "not 12 km/h for 1,5 hours: 49,50";
  EXPECT_EQ(fare.charged_time(), 30min);
}

TEST(FareCalculation, TheCrossoverSpeedMayBeGiven) {
  TariffLevel level = day;
  level.crossover_speed = 20'000;  // 20 km/h are 44,4 pulses a second
  auto fare = trip(FareMode::single_calculation, level);
  drive(fare, 360, 44);
  EXPECT_EQ(fare.charged_time(), 360s);
  EXPECT_EQ(fare.fare(), 3900u + 3300u);
  drive(fare, 1000, 45);
  EXPECT_EQ(fare.charged_time(), 360s) << "faster: 45000 pulses, 12,9375";
  EXPECT_EQ(fare.fare(), 3900u + 16'200u) << "16,2375 in all";
}

TEST(FareCalculation, GrowsWhenASwitchingUnitIsUsedAndNotBefore) {
  // 0,10 are 800 / 23 = 347,8 pulses.
  auto fare = trip(FareMode::single_calculation);
  drive(fare, 1, 347);
  EXPECT_EQ(fare.fare(), 3900u);
  fare = trip(FareMode::single_calculation);
  drive(fare, 1, 348);
  EXPECT_EQ(fare.fare(), 4000u);
}

TEST(FareCalculation, NothingIsLostInSmallPieces) {
  // A pulse of 0,3 thousandths: 1/3 of 0,001 each, with k = 3 and a rate of 0,001.
  TariffLevel level = {.distance_rate = 1, .increment = 1};
  auto fare = trip(FareMode::single_calculation, level, 3);
  for (unsigned pulse = 1; pulse <= 3000; ++pulse) {
    fare.advance(1, 1us);
    fare.close_slice();
    ASSERT_EQ(fare.fare(), pulse / 3) << pulse;
  }
}

TEST(FareCalculation, TwoFractionsMakeAWhole) {
  // A half of 0,001 by distance (1 of 2 pulses) and a half by time (half an hour at 0,001).
  TariffLevel level = {.distance_rate = 1, .time_rate = 1, .increment = 1};
  auto fare = trip(FareMode::double_calculation, level, 2);
  fare.advance(1, 30min - 1us);
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 0u);
  fare.advance(0, 1us);
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 1u);
  fare.advance(1, 30min);
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 2u);
}

TEST(FareCalculation, ATripCostsAtLeastTheMinimumFare) {
  TariffLevel level = day;
  level.minimum_fare = 7000;
  auto fare = trip(FareMode::single_calculation, level);
  EXPECT_EQ(fare.fare(), 7000u);
  drive(fare, 100, 80);
  EXPECT_EQ(fare.fare(), 7000u);
  drive(fare, 100, 80);
  EXPECT_EQ(fare.fare(), 3900u + 4600u);
  EXPECT_EQ(fare.minimum_fare(), 7000u);
  EXPECT_EQ(fare.initial_fare(), 3900u);
}

TEST(FareCalculation, AFixedPriceIsAllThatCounts) {
  FareCalculation fare;
  fare.begin({.mode = FareMode::fixed_price, .k = k, .fixed_price = 25'000}, day);
  drive(fare, 1000, 80);
  EXPECT_EQ(fare.fare(), 25'000u);
  EXPECT_EQ(fare.charged_time(), 0s);
  auto agreed = trip(FareMode::double_calculation);
  drive(agreed, 360, 80);
  agreed.agree(12'340);
  drive(agreed, 1000, 80);
  EXPECT_EQ(agreed.fare(), 12'340u);
}

TEST(FareCalculation, TheLevelChangesInTheMiddleOfATrip) {
  const TariffLevel night = {.initial_fare = 9999,
                             .minimum_fare = 9999,
                             .distance_rate = 2600,
                             .time_rate = 33'000,
                             .increment = 200};
  auto fare = trip(FareMode::single_calculation);
  drive(fare, 150, 80);  // 1,5 km: 3,45, of which 0,05 are not yet switched
  EXPECT_EQ(fare.fare(), 3900u + 3400u);
  fare.change_level(night);
  EXPECT_EQ(fare.fare(), 3900u + 3400u) << "no second initial fare, no other minimum";
  drive(fare, 100, 80);  // 2,60, and 0,05 of before: 2,65, by 0,20
  EXPECT_EQ(fare.fare(), 3900u + 3400u + 2600u);
  drive(fare, 6, 80);  // 0,156: 2,806 in all
  EXPECT_EQ(fare.fare(), 3900u + 3400u + 2800u);
}

TEST(FareCalculation, TheOpenSliceCountsAsFarAsItIsCertain) {
  TariffLevel level = {.distance_rate = 1000, .time_rate = 36'000, .increment = 1};
  auto fare = trip(FareMode::single_calculation, level, 1000);
  fare.advance(4, 1s);  // 0,004 by distance, 0,010 by time: slow
  EXPECT_EQ(fare.fare(), 4u);
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 10u);
  fare.advance(20, 1s);
  EXPECT_EQ(fare.fare(), 20u) << "10 by time";
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 30u);
}

TEST(FareCalculation, TheFareNeverDecreases) {
  Dice dice(447);
  for (unsigned run = 0; run < 200; ++run) {
    TariffLevel level = day;
    level.increment = 1 + dice.of(300);
    level.crossover_speed = dice.of(3) == 0 ? dice.of(60'000) : 0;
    auto fare =
        trip(dice.of(2) == 0 ? FareMode::single_calculation : FareMode::double_calculation, level);
    std::uint32_t before = fare.fare();
    for (unsigned step = 0; step < 300; ++step) {
      fare.advance(dice.of(20), Duration(dice.of(1'000'000)));
      ASSERT_GE(fare.fare(), before);
      before = fare.fare();
      if (dice.of(4) == 0) fare.close_slice();
      ASSERT_GE(fare.fare(), before);
      before = fare.fare();
      if (dice.of(50) == 0) fare.change_level({.distance_rate = 1, .increment = 1000});
      ASSERT_GE(fare.fare(), before);
    }
  }
}

/// Against sums in 128 bits, of random slices and levels: never more than a switching unit below
/// what was used, and never above it.
TEST(FareCalculation, IsExactOverLongTrips) {
  __extension__ using Wide = __int128;
  Dice dice(2);
  for (unsigned run = 0; run < 50; ++run) {
    const std::uint32_t constant = 1 + dice.of(100'000);
    const TariffLevel level = {.distance_rate = dice.of(10'000'000),
                               .time_rate = dice.of(100'000'000),
                               .increment = 1 + dice.of(1000)};
    auto fare = trip(FareMode::double_calculation, level, constant);
    Wide pulses = 0;
    Wide microseconds = 0;
    for (unsigned slice = 0; slice < 2000; ++slice) {
      const auto some = dice.of(500);
      const auto time = dice.of(3'000'000);
      fare.advance(some, Duration(time));
      fare.close_slice();
      pulses += some;
      microseconds += time;
    }
    const Wide hour = 3'600'000'000;
    const Wide used =
        (pulses * level.distance_rate * hour + microseconds * level.time_rate * constant) /
        (hour * constant);
    const Wide expected = used / level.increment * level.increment;
    const Wide shown = expected < amount_max ? expected : amount_max;
    EXPECT_EQ(fare.fare(), static_cast<std::uint32_t>(shown));
  }
}

TEST(FareCalculation, GoesOnFromWhatWasKept) {
  auto fare = trip(FareMode::double_calculation);
  drive(fare, 77, 33);
  fare.advance(5, 400ms);
  FareCalculation other;
  other.restore(fare.state());
  for (FareCalculation* each : {&fare, &other}) drive(*each, 100, 41);
  EXPECT_EQ(fare.fare(), other.fare());
  EXPECT_EQ(fare.charged_time(), other.charged_time());
}

TEST(FareCalculation, ExtremesStayWithinWhatCanBeTold) {
  const TariffLevel dear = {.initial_fare = 0xFFFF'FFFD,
                            .distance_rate = 0xFFFF'FFFD,
                            .time_rate = 0xFFFF'FFFD,
                            .increment = 0};
  auto fare = trip(FareMode::double_calculation, dear, 0xFFFF'FFFD);
  fare.advance(0xFFFF'FFFF, 1000h);
  fare.close_slice();
  EXPECT_EQ(fare.fare(), amount_max);
  auto free = trip(FareMode::single_calculation, {}, 0);
  free.advance(1'000'000, 24h);
  free.close_slice();
  EXPECT_EQ(free.fare(), 0u);
}

TEST(FareCalculation, LongSilenceIsSlicesOfAnHour) {
  auto fare = trip(FareMode::single_calculation);
  fare.advance(0, 2h + 30min);  // 82,50
  fare.close_slice();
  EXPECT_EQ(fare.fare(), 3900u + 82'500u);
  EXPECT_EQ(fare.charged_time(), 150min);
}

}  // namespace
}  // namespace canvoy::cia447::fare_calculation_test
