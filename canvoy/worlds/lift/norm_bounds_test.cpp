#include "canvoy/worlds/lift/norm_bounds.hpp"

#include <gtest/gtest.h>

#include "canvoy/worlds/lift/lift_network_description.hpp"

namespace canvoy::lift::norm_bounds_test {
namespace {

TEST(LiftNorm, DoorsAreUnlockedWithin350MillimetresOfAFloor) {
  EXPECT_EQ(beyond_norm({.door_zone_m = 0.35}), "");
  EXPECT_EQ(beyond_norm({.door_zone_m = 5}), "door_zone_m = 5: EN 81-20, 5.3.8.1, allows 0.35");
}

/// 180 kg in two leaves, each with half of 9 m/s: 180 / 2 * 4.5^2 J. The limit of 10 J is at 2/3
/// m/s, and 1.34 s gives 10.15 J.
TEST(LiftNorm, ADoorHas10JoulesAtMost) {
  EXPECT_EQ(beyond_norm({.door = {.width_m = 0.9, .open_time_s = 0.1}}),
            "door_open_s = 0.1: EN 81-20, 5.3.6.2.2.1, allows a door 10 J, this one has 1822.5 J: "
            "1.35 at least");
  EXPECT_EQ(beyond_norm({.door = {.width_m = 0.9, .close_time_s = 1.34}}),
            "door_close_s = 1.34: EN 81-20, 5.3.6.2.2.1, allows a door 10 J, this one has 10.1 J: "
            "1.35 at least");
  EXPECT_EQ(beyond_norm({.door = {.width_m = 0.9, .open_time_s = 1.36, .close_time_s = 1.36}}), "");
}

TEST(LiftNorm, ACarStaysWithATenthTooMuchOr75Kilograms) {
  EXPECT_EQ(beyond_norm({.car = {.rated_load_kg = 1000, .overload_share = 1.1}}), "");
  EXPECT_EQ(
      beyond_norm({.car = {.rated_load_kg = 300, .rated_persons = 4, .overload_share = 1.25}}), "");
  EXPECT_EQ(beyond_norm({.car = {.rated_load_kg = 1000, .overload_share = 2}}),
            "overload_share = 2: EN 81-20, 5.12.1.2, allows 1.1 of 1000 kg");
}

TEST(LiftNorm, APersonHas75KilogramsOfTheRatedLoad) {
  EXPECT_EQ(beyond_norm({.car = {.rated_load_kg = 630, .rated_persons = 8}}), "");
  EXPECT_EQ(beyond_norm({.car = {.rated_load_kg = 630, .rated_persons = 9}}),
            "rated_persons = 9: EN 81-20, 5.4.2.3.1, allows 8 for 630 kg");
}

TEST(LiftNorm, AFileBeyondItIsRefused) {
  LiftNetworkDescription description = standard_lift_network({.lifts = 2});
  description.building.lifts[1].door_zone_m = 0.5;
  EXPECT_EQ(check(description), "lift 2: door_zone_m = 0.5: EN 81-20, 5.3.8.1, allows 0.35");
}

}  // namespace
}  // namespace canvoy::lift::norm_bounds_test
