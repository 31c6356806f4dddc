// No pulse is lost and none is counted twice (4.2.4.6).
#include "canvoy/devices/cia447/ivn_gateway/wheel_pulse_counter.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::wheel_pulse_counter_test {
namespace {

TEST(WheelPulseCounter, CountsWholePulsesOfADistance) {
  WheelPulseCounter sut({.per_rotation = 48, .circumference_m = 2.0});  // 24 in a metre
  sut.drive(0);
  sut.drive(1);
  EXPECT_EQ(sut.count(), 24);
  sut.drive(1.041666);  // 24.999984 pulses
  EXPECT_EQ(sut.count(), 24);
  sut.drive(1.041667);
  EXPECT_EQ(sut.count(), 25);
}

TEST(WheelPulseCounter, BeginsWhereItIsAskedFirst) {
  WheelPulseCounter sut({.per_rotation = 48, .circumference_m = 2.0});
  sut.drive(123'456.789);
  EXPECT_EQ(sut.count(), 0);
  sut.drive(123'457.789);
  EXPECT_EQ(sut.count(), 24);
}

TEST(WheelPulseCounter, ZeroComesAfterTheHighestCount) {
  WheelPulseCounter sut({.per_rotation = 25, .circumference_m = 2.5, .count_max = 999});
  sut.drive(0);
  sut.drive(99.9);
  EXPECT_EQ(sut.count(), 999);
  sut.drive(100);
  EXPECT_EQ(sut.count(), 0);
  sut.drive(350);
  EXPECT_EQ(sut.count(), 500);
}

TEST(WheelPulseCounter, AllSixteenBitsCount) {
  WheelPulseCounter sut({.per_rotation = 25, .circumference_m = 2.5});
  sut.drive(0);
  sut.drive(6553.5);
  EXPECT_EQ(sut.count(), 0xFFFF);
  sut.drive(6553.6);
  EXPECT_EQ(sut.count(), 0);
}

TEST(WheelPulseCounter, ADistanceThatFallsBackIsAnotherOrigin) {
  WheelPulseCounter sut({.per_rotation = 48, .circumference_m = 2.0});
  sut.drive(0);
  sut.drive(10);
  sut.drive(3);
  EXPECT_EQ(sut.count(), 240);
  sut.drive(4);
  EXPECT_EQ(sut.count(), 264);
}

/// A million kilometres in steps of a car that goes now slow, now fast.
TEST(WheelPulseCounter, IsExactAfterAMillionUnevenSteps) {
  WheelPulseCounter sut({.per_rotation = 47, .circumference_m = 1.937});
  std::int64_t um = 0;
  sut.drive(0);
  for (std::int64_t step = 0; step < 1'000'000; ++step) {
    um += step * 7919 % 2'000'003;
    sut.drive(static_cast<double>(um) / 1e6);
    ASSERT_EQ(sut.count(), um * 47 / 1'937'000 % 65536) << step;
  }
}

}  // namespace
}  // namespace canvoy::cia447::wheel_pulse_counter_test
