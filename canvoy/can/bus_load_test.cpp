#include "canvoy/can/bus_load.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_load_test {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t window = 320 * ms;  // steps of 10 ms

TEST(BusLoad, OfNothingIsZero) {
  const BusLoad sut(window);
  EXPECT_EQ(sut.recent(0), 0.0);
  EXPECT_EQ(sut.recent(1000 * ms), 0.0);
  EXPECT_EQ(sut.total(1000 * ms), 0.0);
}

TEST(BusLoad, BeforeTheFirstWindowIsOverIsThatSinceTheStart) {
  BusLoad sut(window);
  sut.add(0, 20 * ms);
  EXPECT_DOUBLE_EQ(sut.recent(40 * ms), 0.5);
  EXPECT_DOUBLE_EQ(sut.recent(80 * ms), 0.25);
}

TEST(BusLoad, ForgetsWhatIsOlderThanTheWindow) {
  BusLoad sut(window);
  sut.add(0, 160 * ms);
  EXPECT_DOUBLE_EQ(sut.recent(320 * ms), 0.5);
  EXPECT_DOUBLE_EQ(sut.recent(400 * ms), 80.0 / 320.0);
  EXPECT_DOUBLE_EQ(sut.recent(480 * ms), 0.0);
  EXPECT_DOUBLE_EQ(sut.total(480 * ms), 160.0 / 480.0);
}

TEST(BusLoad, SlidesWithTheTimeOfABusThatStaysBusy) {
  BusLoad sut(window);
  for (std::int64_t begin = 0; begin < 2000 * ms; begin += 4 * ms) sut.add(begin, begin + 1 * ms);
  EXPECT_NEAR(sut.recent(2000 * ms), 0.25, 0.005);
  EXPECT_DOUBLE_EQ(sut.total(2000 * ms), 0.25);
}

TEST(BusLoad, ComesBackAfterALongSilence) {
  BusLoad sut(window);
  sut.add(0, 320 * ms);
  sut.add(1'000'000 * ms, 1'000'032 * ms);
  EXPECT_NEAR(sut.recent(1'000'032 * ms), 0.1, 1e-9);
  EXPECT_EQ(sut.total_ns(), 352 * ms);
}

TEST(BusLoad, OfASpanLongerThanTheWindowIsOne) {
  BusLoad sut(window);
  sut.add(0, 1000 * ms);
  EXPECT_DOUBLE_EQ(sut.recent(1000 * ms), 1.0);
}

}  // namespace
}  // namespace canvoy::bus_load_test
