#include "canvoy/devices/cia417/lift/floor_set.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace canvoy::cia417::floor_set_test {
namespace {

TEST(FloorSet, HoldsTheFloorsThatTheProfileCounts) {
  FloorSet floors;
  EXPECT_TRUE(floors.empty());
  for (unsigned floor = 0; floor <= 300; ++floor) floors.insert(floor);
  EXPECT_EQ(floors.size(), 254u);
  EXPECT_EQ(floors.lowest(), 1);
  EXPECT_EQ(floors.highest(), 254);
  EXPECT_FALSE(floors.contains(0));
  EXPECT_FALSE(floors.contains(255));
  EXPECT_EQ(floors, FloorSet::between(1, 254));
  EXPECT_EQ(floors, FloorSet::between(0, 1000));
}

TEST(FloorSet, AnEmptySetHasNoNextFloor) {
  const FloorSet floors;
  for (unsigned floor = 0; floor <= 300; ++floor) {
    EXPECT_EQ(floors.next_up(floor), 0);
    EXPECT_EQ(floors.next_down(floor), 0);
  }
}

TEST(FloorSet, EveryRangeHasItsFloorsAndNoOther) {
  for (unsigned first = 0; first <= 256; ++first) {
    for (unsigned last = first == 0 ? 0 : first - 1; last <= 256; ++last) {
      const FloorSet range = FloorSet::between(first, last);
      const unsigned low = std::max(first, 1U);
      const unsigned high = std::min(last, 254U);
      ASSERT_EQ(range.size(), high + 1 > low ? high + 1 - low : 0) << first << ' ' << last;
      if (high >= low) {
        ASSERT_EQ(range.lowest(), low);
        ASSERT_EQ(range.highest(), high);
      }
    }
  }
}

RC_GTEST_PROP(FloorSet, IsASetOfNumbers, (const std::vector<std::uint8_t>& inserted)) {
  FloorSet floors;
  std::set<unsigned> model;
  for (const std::uint8_t floor : inserted) {
    // One of four takes a floor away again.
    if (floor % 4 == 3) {
      floors.erase(floor - 1U);
      model.erase(floor - 1U);
    } else {
      floors.insert(floor);
      if (floor != 0 && floor != 255) model.insert(floor);
    }
  }
  RC_ASSERT(floors.size() == model.size());
  for (unsigned floor = 0; floor <= 255; ++floor) {
    RC_ASSERT(floors.contains(floor) == model.contains(floor));
    const auto above = model.lower_bound(floor);
    RC_ASSERT(floors.next_up(floor) == (above == model.end() ? 0 : *above));
    const auto beyond = model.upper_bound(floor);
    RC_ASSERT(floors.next_down(floor) == (beyond == model.begin() ? 0 : *std::prev(beyond)));
  }
}

}  // namespace
}  // namespace canvoy::cia417::floor_set_test
