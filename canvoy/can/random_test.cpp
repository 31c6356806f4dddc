#include "canvoy/can/random.hpp"

#include <gtest/gtest.h>

namespace canvoy::random_test {
namespace {

TEST(Random, GivesTheNumbersOfThePublishedAlgorithmsForSeedZero) {
  // SplitMix64 from 0 gives E220A8397B1DCDAF, 6E789E6AA1B965F4, 06C45D188009454F, F88BB8A8724C81EC,
  // the values that its authors' program prints. xoshiro256** answers rotl(second * 5, 7) * 9.
  Random random(0);
  const std::uint64_t product = 0x6E789E6AA1B965F4ULL * 5;
  EXPECT_EQ(random.next(), ((product << 7) | (product >> 57)) * 9);
}

TEST(Random, GivesTheSameNumbersForTheSameSeedAndOthersForAnother) {
  Random first(7);
  Random same(7);
  Random other(8);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t number = first.next();
    EXPECT_EQ(number, same.next());
    EXPECT_NE(number, other.next());
  }
}

TEST(Random, SpreadsEvenlyBelowABound) {
  Random random(1);
  int counts[10] = {};
  for (int i = 0; i < 100'000; ++i) ++counts[random.below(10)];
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 400);  // four standard deviations
}

TEST(Random, LetsHappenWhatIsCertainAndNothingThatIsImpossible) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 10'000; ++i) {
    EXPECT_FALSE(random.happens(Probability(0.0)));
    EXPECT_FALSE(random.happens(Probability(-1.0)));
    EXPECT_TRUE(random.happens(Probability(1.0)));
    EXPECT_TRUE(random.happens(Probability(2.0)));
    if (random.happens(Probability(0.25))) ++hits;
  }
  EXPECT_NEAR(hits, 2500, 180);
}

}  // namespace
}  // namespace canvoy::random_test
