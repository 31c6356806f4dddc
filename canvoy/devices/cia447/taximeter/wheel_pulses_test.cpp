// The wheel pulse counter as cars send it, well and badly (CiA 447-3, 4.2.4.6 and 4.2.4.7).
#include "canvoy/devices/cia447/taximeter/wheel_pulses.hpp"

#include <gtest/gtest.h>

#include <random>

namespace canvoy::cia447::wheel_pulses_test {
namespace {

/// 300 km/h with 8 pulses a metre.
constexpr std::uint32_t fastest = 667;

class Wheel : public testing::Test {
 protected:
  Wheel() { sut.set_fastest(fastest); }
  /// After another 100 ms.
  std::uint32_t take(unsigned value, Signal valid = Signal::yes) {
    now += 100ms;
    return sut.count(static_cast<std::uint16_t>(value), valid, now);
  }

  WheelPulses sut;
  Time now{};
};

TEST_F(Wheel, TheFirstValueIsOnlyWhereToCountFrom) {
  EXPECT_EQ(take(40'000), 0u);
  EXPECT_EQ(take(40'010), 10u);
}

TEST_F(Wheel, GoesOnOverTheOverrunOfTheCounter) {
  take(0xFFF0);
  EXPECT_EQ(take(0xFFFF), 15u);
  EXPECT_EQ(take(0x0000), 1u) << "while 6056h is not known, the counter has 65536 values";
  EXPECT_EQ(take(0x0004), 4u);
}

TEST_F(Wheel, TheOverrunValueIsTheHighestThatTheCounterHas) {
  sut.set_overrun_value(999);
  take(990);
  EXPECT_EQ(take(999), 9u);
  EXPECT_EQ(take(5), 6u) << "999, 0, 1, ... 5";
  EXPECT_EQ(take(1000), 0u) << "it has no such value";
  EXPECT_EQ(sut.counters().out_of_range, 1u);
  EXPECT_EQ(take(7), 2u);
}

TEST_F(Wheel, AnotherOverrunValueIsAnotherCounter) {
  take(500);
  sut.set_overrun_value(999);
  EXPECT_EQ(take(600), 0u);
  EXPECT_EQ(take(610), 10u);
  sut.set_overrun_value(999);
  EXPECT_EQ(take(620), 10u) << "the same as before is no news";
}

TEST_F(Wheel, WhatIsSentTwiceCountsOnce) {
  take(100);
  EXPECT_EQ(take(120), 20u);
  EXPECT_EQ(take(120), 0u);
  EXPECT_EQ(take(140), 20u);
}

TEST_F(Wheel, WhatIsLostIsInTheNext) {
  take(100);
  now += 2s;
  EXPECT_EQ(take(500), 400u);
}

TEST_F(Wheel, AValueThatComesLateIsPutAside) {
  take(100);
  EXPECT_EQ(take(120), 20u);
  EXPECT_EQ(take(100), 0u) << "sent again, after its successor";
  EXPECT_EQ(take(100), 0u);
  EXPECT_EQ(take(140), 20u);
  EXPECT_EQ(sut.counters().implausible, 2u);
  EXPECT_EQ(sut.counters().restarts, 0u);
}

TEST_F(Wheel, NoCarIsSoFast) {
  take(0);
  EXPECT_EQ(take(5000), 0u) << "in 100 ms, with 500 ms that a value may be late: 400 at most";
  EXPECT_EQ(take(400), 400u);
}

TEST_F(Wheel, ACounterThatBeginsAnewIsFollowedWithoutWhatLiesBetween) {
  take(30'000);
  EXPECT_EQ(take(10), 0u);
  EXPECT_EQ(take(20), 0u);
  EXPECT_EQ(take(30), 0u);
  EXPECT_EQ(take(40), 30u) << "the fourth that goes on from the first";
  EXPECT_EQ(take(50), 10u);
  EXPECT_EQ(sut.counters().restarts, 1u);
}

TEST_F(Wheel, ASourceThatIsNotAvailableBeginsAnew) {
  take(1000);
  EXPECT_EQ(take(1020, Signal::not_available), 0u);
  EXPECT_EQ(take(1040), 0u) << "only where to count from";
  EXPECT_EQ(take(1050), 10u);
}

TEST_F(Wheel, OfAFailureThatPassesNothingIsLost) {
  take(1000);
  EXPECT_EQ(take(0, Signal::failure), 0u);
  EXPECT_EQ(take(0xFFFF, Signal::no), 0u);
  EXPECT_EQ(take(1060), 60u) << "the counter went on";
  EXPECT_EQ(sut.counters().not_valid, 2u);
}

TEST_F(Wheel, AfterASilenceInWhichItMayHaveOverrunItBeginsAnew) {
  take(1000);
  now += 80s;  // 53360 pulses at most, of 49152 that are accepted
  EXPECT_EQ(take(20'000), 0u);
  EXPECT_EQ(sut.counters().gaps, 1u);
  EXPECT_EQ(take(20'010), 10u);
}

/// A car that never exceeds the fastest speed, of which each value may be lost, sent twice, or be
/// sent again late, with counters of any length: in the end all pulses were counted, once.
TEST_F(Wheel, CountsEachPulseOnceWhateverIsLostOrDoubled) {
  std::mt19937 engine(6055);
  const auto dice = [&engine](unsigned count) { return static_cast<unsigned>(engine() % count); };
  for (unsigned run = 0; run < 300; ++run) {
    WheelPulses wheel;
    wheel.set_fastest(fastest);
    const unsigned highest = run % 3 == 0 ? 0xFFFF : 999 + dice(60'000);
    wheel.set_overrun_value(static_cast<std::uint16_t>(highest));
    std::uint64_t driven = dice(1'000'000);
    std::uint64_t first = driven;
    std::uint64_t counted = 0;
    unsigned old = static_cast<unsigned>(driven % (highest + 1));
    Time at{};
    for (unsigned cycle = 0; cycle < 2000; ++cycle) {
      at += Duration(90'000 + dice(20'000));
      driven += dice(60);
      const auto value = static_cast<unsigned>(driven % (highest + 1));
      const bool is_lost = cycle != 0 && cycle != 1999 && dice(4) == 0;
      if (is_lost) continue;
      counted += wheel.count(static_cast<std::uint16_t>(value), Signal::yes, at);
      if (dice(4) == 0) {
        counted += wheel.count(static_cast<std::uint16_t>(value), Signal::yes, at + 1ms);
      }
      const bool is_late = cycle > 1 && cycle < 1990 && dice(16) == 0;
      if (is_late) counted += wheel.count(static_cast<std::uint16_t>(old), Signal::yes, at + 2ms);
      old = value;
      if (cycle == 0) first = driven;
    }
    EXPECT_EQ(counted, driven - first);
  }
}

}  // namespace
}  // namespace canvoy::cia447::wheel_pulses_test
