#include "canvoy/timing/arrivals.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

#include "canvoy/can/random.hpp"

namespace canvoy::timing::arrivals_test {
namespace {

BusMessage heard_at(std::initializer_list<Duration> times, Duration listened) {
  Arrivals arrivals;
  for (const Duration each : times) arrivals.add(Time(each));
  BusMessage message;
  arrivals.describe(message, listened);
  return message;
}

TEST(Arrivals, OfAFrameEachTenMillisecondsAreThatPeriod) {
  const BusMessage message = heard_at({5ms, 15ms, 25ms, 35ms}, 45ms);
  EXPECT_EQ(message.period, 10ms);
  EXPECT_EQ(message.ahead, 0ms);
  EXPECT_EQ(message.distance, 10ms);
}

TEST(Arrivals, ThatAreLateOnceRunAheadByTheLateness) {
  // 2 ms behind its position in the row, the next is 8 ms behind it.
  const BusMessage message = heard_at({0ms, 10ms, 22ms, 30ms, 40ms}, 40ms);
  EXPECT_EQ(message.period, 10ms);
  EXPECT_EQ(message.ahead, 2ms);
  EXPECT_EQ(message.distance, 8ms);
}

TEST(Arrivals, InAPartOfTheTimeAreABurst) {
  // Four within 3 ms of a second: one in 250 ms, and the last of them 747 ms ahead.
  const BusMessage message = heard_at({500ms, 501ms, 502ms, 503ms}, 1s);
  EXPECT_EQ(message.period, 250ms);
  EXPECT_EQ(message.ahead, 747ms);
  EXPECT_EQ(message.distance, 1ms);
}

TEST(Arrivals, InBurstsHaveARowForEachPace) {
  // Pairs that are 1 ms apart, each 20 ms. At 8.192 ms a frame, the second of a pair is 7.192 ms
  // ahead, and no more come before the row has caught up.
  const BusMessage message =
      heard_at({0ms, 1ms, 20ms, 21ms, 40ms, 41ms, 60ms, 61ms, 80ms, 81ms}, 100ms);
  EXPECT_EQ(message.distance, 1ms);
  ASSERT_EQ(message.bursts.size(), 4U);  // 1.024, 2.048, 4.096 and 8.192 ms
  EXPECT_EQ(message.bursts[0].period, 1024us);
  EXPECT_EQ(message.bursts[0].ahead, 24us);
  EXPECT_EQ(message.bursts[3].period, 8192us);
  EXPECT_EQ(message.bursts[3].ahead, 7192us);
}

TEST(Arrivals, OfOneFrameAreOneInAllThatTime) {
  const BusMessage message = heard_at({3s}, 10s);
  EXPECT_EQ(message.period, 10s);
  EXPECT_EQ(message.ahead, 0s);
  EXPECT_EQ(message.distance, 0s);
}

TEST(Arrivals, AtOneTimeHaveNoDistance) {
  const BusMessage message = heard_at({1s, 1s}, 2s);
  EXPECT_EQ(message.period, 1s);
  EXPECT_EQ(message.distance, 0s);
  EXPECT_EQ(message.ahead, 1s);
}

TEST(Arrivals, ByChanceAllFitWhatIsSaidOfThem) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    Arrivals arrivals;
    std::vector<Duration> times;
    Duration now{};
    const std::uint32_t longest = 1 + random.below(20'000);
    for (std::uint32_t i = 0; i < 2 + random.below(60); ++i) {
      now += Duration(random.below(longest));
      times.push_back(now);
      arrivals.add(Time(now));
    }
    BusMessage message;
    arrivals.describe(message, now + Duration(1 + random.below(100'000)));
    // For any two: their distance in periods less `ahead`, and the distance for each between.
    for (std::size_t a = 0; a < times.size(); ++a) {
      for (std::size_t b = a + 1; b < times.size(); ++b) {
        const auto between = static_cast<std::int64_t>(b - a);
        ASSERT_GE(times[b] - times[a], between * message.period - message.ahead);
        ASSERT_GE(times[b] - times[a], between * message.distance);
        for (const Burst& each : message.bursts) {
          ASSERT_GE(times[b] - times[a], between * each.period - each.ahead);
        }
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::timing::arrivals_test
