#include "canvoy/devices/cia417/lift/door_dwell.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::door_dwell_test {
namespace {

class DoorDwellTest : public testing::Test {
 protected:
  DoorDwellTest() {
    dwell.begin(3s);
    dwell.opened(opened);
  }
  bool ends_at(Duration after, bool is_button_held = false) {
    return dwell.ends(opened + after, 20s, is_button_held);
  }

  const Time opened{100s};
  DoorDwell dwell;
};

TEST_F(DoorDwellTest, DoorsStayOpenForTheirTime) {
  EXPECT_FALSE(ends_at(3s - 1us));
  EXPECT_EQ(dwell.next(20s), opened + 3s);
  EXPECT_TRUE(ends_at(3s));
  EXPECT_FALSE(dwell.is_nudging());
}

TEST_F(DoorDwellTest, SomebodyInTheDoorProlongsItAndNeverShortensIt) {
  dwell.prolong(opened + 5s);
  dwell.prolong(opened + 4s);
  EXPECT_FALSE(ends_at(5s - 1us));
  EXPECT_TRUE(ends_at(5s));
}

TEST_F(DoorDwellTest, DoorsNudgeThoughSomebodyGoesOnToStandInThem) {
  dwell.prolong(opened + 60s);
  EXPECT_EQ(dwell.next(20s), opened + 20s);
  EXPECT_FALSE(ends_at(20s - 1us));
  EXPECT_TRUE(ends_at(20s));
  EXPECT_TRUE(dwell.is_nudging());
}

TEST_F(DoorDwellTest, AButtonThatIsHeldWhenTheyNudgeCountsNoLongerUntilItIsLetGo) {
  EXPECT_TRUE(dwell.obeys_button(true));
  dwell.prolong(opened + 60s);
  EXPECT_TRUE(ends_at(20s, true));
  EXPECT_FALSE(dwell.obeys_button(true));
  EXPECT_FALSE(dwell.obeys_button(false));
  EXPECT_TRUE(dwell.obeys_button(true));
}

TEST_F(DoorDwellTest, NudgingCountsFromTheEndOfWhatHeldThemOpen) {
  EXPECT_TRUE(dwell.hold(true, opened + 1s));
  EXPECT_TRUE(dwell.hold(true, opened + 30s));
  EXPECT_FALSE(dwell.hold(false, opened + 40s));
  dwell.prolong(opened + 90s);
  EXPECT_FALSE(ends_at(60s - 1us));
  EXPECT_TRUE(ends_at(60s));
}

TEST_F(DoorDwellTest, DoorsThatOpenAgainForAnotherTryNudgeAsIfTheyHadStayedOpen) {
  EXPECT_FALSE(dwell.was_late());
  dwell.open_again(2s);
  dwell.opened(opened + 15s);
  dwell.prolong(opened + 60s);
  EXPECT_TRUE(ends_at(20s));
}

TEST_F(DoorDwellTest, TheThirdTimeThatTheyCloseLateIsAnError) {
  EXPECT_FALSE(dwell.was_late());
  EXPECT_FALSE(dwell.was_late());
  EXPECT_TRUE(dwell.was_late());
  dwell.closed();
  EXPECT_FALSE(dwell.was_late());
}

}  // namespace
}  // namespace canvoy::cia417::door_dwell_test
