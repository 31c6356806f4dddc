#include "canvoy/can/simulated/bit_times.hpp"

#include <gtest/gtest.h>

namespace canvoy::bit_times_test {
namespace {

ControllerSet set_of(std::initializer_list<ControllerId> ids) {
  ControllerSet set;
  for (const ControllerId id : ids) set.insert(id);
  return set;
}

/// Three controllers at 125 kbit/s.
BitTimes bit_times() {
  BitTimes times(8'000);
  for (ControllerId id = 0; id < 3; ++id) times.set(id, 0);
  return times;
}

TEST(BitTimes, AreThoseOfTheBusUnlessAControllerIsSetToOthers) {
  BitTimes sut = bit_times();
  EXPECT_EQ(sut.of(1), 8'000);
  sut.set(1, 1'000'000);
  EXPECT_EQ(sut.of(1), 1'000);
  sut.set(1, 0);
  EXPECT_EQ(sut.of(1), 8'000);
}

TEST(BitTimes, AreMixedUntilAllHaveChanged) {
  BitTimes sut = bit_times();
  EXPECT_FALSE(sut.are_mixed());
  sut.set(2, 250'000);
  EXPECT_TRUE(sut.are_mixed());
  sut.set(0, 250'000);
  EXPECT_TRUE(sut.are_mixed());
  sut.set(1, 250'000);
  EXPECT_FALSE(sut.are_mixed());
}

TEST(BitTimes, TellWhoIsOnAnotherRateAndWhoIsSlowest) {
  BitTimes sut = bit_times();
  sut.set(1, 250'000);
  sut.set(2, 50'000);
  EXPECT_EQ(sut.other_than(8'000, set_of({0, 1, 2})), set_of({1, 2}));
  EXPECT_EQ(sut.other_than(8'000, set_of({0, 1})), set_of({1}));
  EXPECT_EQ(sut.longest(set_of({0, 2}), 1'000), 20'000);
  EXPECT_EQ(sut.longest(set_of({1}), 8'000), 8'000);
}

}  // namespace
}  // namespace canvoy::bit_times_test
