#include "canvoy/canopen/manager/slave_restarts.hpp"

#include <gtest/gtest.h>

namespace canvoy::slave_restarts_test {
namespace {

using Delay = std::optional<Duration>;

TEST(SlaveRestarts, AreAnsweredAtOnceThreeTimesThenLaterEachTimeThenNoMore) {
  SlaveRestarts sut;
  Time now(100s);
  for (const Delay delay : {0s, 0s, 0s, 1s, 2s, 4s, 8s}) {
    EXPECT_FALSE(sut.is_exhausted());
    EXPECT_EQ(sut.count(now += 10s), delay);
  }
  EXPECT_TRUE(sut.is_exhausted());
  EXPECT_EQ(sut.count(now += 10s), std::nullopt);
  EXPECT_EQ(sut.count(now += 30s), std::nullopt) << "half a minute is not over yet";
}

TEST(SlaveRestarts, BeginAnewAfterMoreThanHalfAMinute) {
  SlaveRestarts sut;
  Time now(100s);
  for (int i = 0; i < 8; ++i) sut.count(now);
  EXPECT_EQ(sut.count(now + 30s + 1us), Delay(0s));
  EXPECT_FALSE(sut.is_exhausted());
}

TEST(SlaveRestarts, AreSlowFromTheFirstThatWasWaitedForUntilHalfAMinuteIsOver) {
  SlaveRestarts sut;
  const Time now(100s);
  for (int i = 0; i < 3; ++i) sut.count(now);
  EXPECT_FALSE(sut.is_slow(now));
  sut.count(now);
  EXPECT_TRUE(sut.is_slow(now + 30s));
  EXPECT_FALSE(sut.is_slow(now + 30s + 1us));
}

}  // namespace
}  // namespace canvoy::slave_restarts_test
