#include "canvoy/decoder/entry_cache.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::decoder::by_entry_test {

constexpr sdo::Multiplexer temperature(0x6010, 0);

TEST(ByEntryTest, MakesWhatIsAskedForOnce) {
  EntryCache<int, 16> numbers;
  EXPECT_EQ(numbers.at(cia419::profile, temperature, [] { return 1; }), 1);
  EXPECT_EQ(numbers.at(cia419::profile, temperature, [] { return 2; }), 1);
}

TEST(ByEntryTest, KeepsEntriesOfOneObjectAndOfOtherProfilesApart) {
  EntryCache<int, 16> numbers;
  (void)numbers.at(cia419::profile, temperature, [] { return 1; });
  EXPECT_EQ(numbers.at(cia419::profile, {0x6010, 1}, [] { return 2; }), 2);
  EXPECT_EQ(numbers.at(cia301::profile, temperature, [] { return 3; }), 3);
}

TEST(ByEntryTest, ForgetsForAnotherOneOfTheSameHash) {
  EntryCache<int, 1> numbers;
  (void)numbers.at(cia419::profile, temperature, [] { return 1; });
  EXPECT_EQ(numbers.at(cia419::profile, {0x6011, 0}, [] { return 2; }), 2);
  EXPECT_EQ(numbers.at(cia419::profile, temperature, [] { return 3; }), 3);
}

}  // namespace canvoy::decoder::by_entry_test
