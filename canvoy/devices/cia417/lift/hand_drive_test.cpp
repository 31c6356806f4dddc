#include "canvoy/devices/cia417/lift/hand_drive.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::cia417::hand_drive_test {
namespace {

constexpr std::array<std::int32_t, 2> positions = {0, 4'000'000};
constexpr LiftFloors floors(positions, 10'000);

TEST(HandDrive, TheCarMovesWhileAButtonIsHeld) {
  HandDrive hand;
  EXPECT_TRUE(hand.obey(1, 1'000'000, floors));
  EXPECT_EQ(hand.direction(), 1);
  EXPECT_FALSE(hand.obey(1, 2'000'000, floors)) << "nothing new";
  EXPECT_TRUE(hand.obey(0, 2'000'000, floors));
  EXPECT_EQ(hand.direction(), 0);
}

TEST(HandDrive, TheLastFloorIsTheEndUntilTheButtonIsHeldAnew) {
  HandDrive hand;
  hand.obey(1, 3'999'999, floors);
  EXPECT_TRUE(hand.obey(1, 4'000'000, floors));
  EXPECT_EQ(hand.direction(), 0);
  EXPECT_FALSE(hand.obey(1, 3'990'000, floors)) << "it has come to rest short of it";
  EXPECT_EQ(hand.direction(), 0);
  hand.obey(0, 3'990'000, floors);
  EXPECT_TRUE(hand.obey(1, 3'990'000, floors));
  EXPECT_EQ(hand.direction(), 1);
}

TEST(HandDrive, FromTheFirstFloorItGoesUpOnly) {
  HandDrive hand;
  EXPECT_FALSE(hand.obey(-1, 0, floors));
  EXPECT_EQ(hand.direction(), 0);
  EXPECT_TRUE(hand.obey(1, 0, floors));
  EXPECT_EQ(hand.direction(), 1);
}

}  // namespace
}  // namespace canvoy::cia417::hand_drive_test
