#include "canvoy/profiles/model/numbered_name.hpp"

#include <gtest/gtest.h>

namespace canvoy::numbered_name_test {
namespace {

TEST(NumberedName, ANumberStandsWhereTheDescriptionHasItsSign) {
  EXPECT_TRUE(is_named("TPDO # mapping parameter", 20, "TPDO 20 mapping parameter"));
  EXPECT_TRUE(is_named("b#", 3, "b3"));
  EXPECT_TRUE(is_named("#", 7, "7"));
  EXPECT_TRUE(is_named("#: x", 0, "0: x"));
}

TEST(NumberedName, TheDescribedNameItselfIsAName) {
  EXPECT_TRUE(is_named("b#", 3, "b#"));
  EXPECT_TRUE(is_named("battery_status", 1, "battery_status"));
}

TEST(NumberedName, AnotherNumberOrTextIsAnotherName) {
  EXPECT_FALSE(is_named("b#", 3, "b4"));
  EXPECT_FALSE(is_named("b#", 3, "b03"));
  EXPECT_FALSE(is_named("b#", 3, "b33"));
  EXPECT_FALSE(is_named("b#", 13, "b3"));
  EXPECT_FALSE(is_named("b#", 30, "b3"));
  EXPECT_FALSE(is_named("b#", 3, "b"));
  EXPECT_FALSE(is_named("b#", 3, "b3 "));
  EXPECT_FALSE(is_named("b#", 3, "c3"));
  EXPECT_FALSE(is_named("b", 3, "b3"));
  EXPECT_FALSE(is_named("b#", 0, "b00"));
}

}  // namespace
}  // namespace canvoy::numbered_name_test
