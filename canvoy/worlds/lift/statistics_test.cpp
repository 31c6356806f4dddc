#include "canvoy/worlds/lift/statistics.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::statistics_test {
namespace {

TEST(DurationSampleTest, OfNothingIsZero) {
  const DurationSample sut;
  EXPECT_EQ(sut.mean(), 0s);
  EXPECT_EQ(sut.longest(), 0s);
  EXPECT_EQ(sut.percentile(90), 0s);
}

TEST(DurationSampleTest, HasMeanPercentileAndLongest) {
  DurationSample sut;
  for (int i = 20; i >= 1; --i) sut.add(std::chrono::seconds(i));
  EXPECT_EQ(sut.mean(), 10'500ms);
  EXPECT_EQ(sut.percentile(90), 18s);  // 18 of 20 are not longer
  EXPECT_EQ(sut.percentile(91), 19s);
  EXPECT_EQ(sut.percentile(100), 20s);
  EXPECT_EQ(sut.percentile(1), 1s);
  EXPECT_EQ(sut.longest(), 20s);
}

TEST(PassengerStatisticsTest, CapacityIsTheMostInAnyFiveMinutes) {
  PassengerStatistics sut;
  sut.served(Time(0min), 10s);
  sut.served(Time(4min), 20s);
  sut.served(Time(5min), 30s);  // the first one is five minutes ago: outside
  EXPECT_EQ(sut.most_in_5_minutes(), 2U);
  sut.served(Time(6min), 30s);
  sut.served(Time(30min), 30s);
  EXPECT_EQ(sut.most_in_5_minutes(), 3U);
  EXPECT_EQ(sut.served_count(), 5U);
}

TEST(PassengerStatisticsTest, CountsWaitingAndThoseWhoGaveUpApart) {
  PassengerStatistics sut;
  sut.boarded(7s);
  sut.gave_up(60s);
  EXPECT_EQ(sut.waiting().count(), 2U) << "he waited, too";
  EXPECT_EQ(sut.waiting().longest(), 60s);
  EXPECT_EQ(sut.gave_up_count(), 1U);
  EXPECT_EQ(sut.served_count(), 0U);
}

TEST(DepartureStatisticsTest, IntervalIsBetweenDeparturesAndThePersonsOfTheFirstAreNotCounted) {
  DepartureStatistics sut;
  EXPECT_EQ(sut.interval_s(), 0);
  sut.departed(Time(10s), 99);
  sut.departed(Time(40s), 8);
  sut.departed(Time(70s), 10);
  EXPECT_EQ(sut.count(), 3U);
  EXPECT_DOUBLE_EQ(sut.interval_s(), 30);
  EXPECT_DOUBLE_EQ(sut.persons_mean(), 9);
  EXPECT_DOUBLE_EQ(sut.persons_in_5_minutes(), 90);
  sut.restart();
  EXPECT_EQ(sut.count(), 0U);
}

TEST(LiftStatisticsTest, StartsAreGivenForAnHour) {
  const LiftStatistics sut{.starts = 90};
  EXPECT_DOUBLE_EQ(sut.starts_an_hour(30min), 180);
  EXPECT_DOUBLE_EQ(sut.starts_an_hour(0s), 0);
}

}  // namespace
}  // namespace canvoy::lift::statistics_test
