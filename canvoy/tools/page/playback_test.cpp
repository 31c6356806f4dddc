#include "canvoy/tools/page/playback.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::playback_test {
namespace {

TEST(Playback, PlaysSoManyTimesFasterThanTheClock) {
  Playback playback(1h, 10);
  EXPECT_EQ(playback.wanted(Time(5s)), Time{});  // the clock begins here
  EXPECT_EQ(playback.wanted(Time(5s + 50ms)), Time(500ms));
  playback.reached(Time(500ms));
  EXPECT_EQ(playback.wanted(Time(5s + 100ms)), Time(1s));
}

TEST(Playback, StandsWhileItIsPausedAndGoesOnFromThere) {
  Playback playback(1h, 1);
  playback.wanted(Time{});
  playback.set_paused(true);
  EXPECT_EQ(playback.wanted(Time(1min)), Time{});
  playback.set_paused(false);
  EXPECT_EQ(playback.wanted(Time(1min + 50ms)), Time(50ms));
}

TEST(Playback, DoesNotCatchUpWithWhatTheComputerCouldNotDo) {
  Playback playback(1h, 100);
  playback.wanted(Time{});
  EXPECT_EQ(playback.wanted(Time(1s)), Time(100s));
  playback.reached(Time(3s));
  EXPECT_EQ(playback.wanted(Time(1s)), Time(23s));  // 200 ms of the clock
}

TEST(Playback, EndsAtTheEnd) {
  Playback playback(10s, 1000);
  playback.wanted(Time{});
  EXPECT_EQ(playback.wanted(Time(1s)), Time(10s));
  EXPECT_FALSE(playback.is_over());
  playback.reached(Time(10s));
  EXPECT_TRUE(playback.is_over());
}

TEST(Playback, AStepGoesSoFarAndPauses) {
  Playback playback(1h, 1);
  playback.wanted(Time{});
  playback.reached(Time(2s));
  playback.step(500ms);
  EXPECT_TRUE(playback.is_paused());
  EXPECT_TRUE(playback.is_seeking());
  EXPECT_EQ(playback.wanted(Time(10s)), Time(2s + 500ms));
  playback.reached(Time(2s + 500ms));
  EXPECT_FALSE(playback.is_seeking());
  EXPECT_EQ(playback.wanted(Time(20s)), Time(2s + 500ms));
}

TEST(Playback, ARestartIsPlayedAtOnceUpToWhereItWas) {
  Playback playback(1h, 1);
  playback.wanted(Time{});
  playback.reached(Time(90s));
  playback.restart(Time(90s));
  EXPECT_TRUE(playback.is_seeking());
  EXPECT_EQ(playback.wanted(Time(1ms)), Time(90s));
  playback.reached(Time(40s));
  EXPECT_EQ(playback.wanted(Time(2ms)), Time(90s));
  playback.reached(Time(90s));
  EXPECT_EQ(playback.wanted(Time(3ms)), Time(90s + 1ms));
}

TEST(Playback, IsSoughtNoFurtherThanTheEnd) {
  Playback playback(1min, 1);
  playback.seek(Time(1h));
  EXPECT_EQ(playback.wanted(Time{}), Time(1min));
}

}  // namespace
}  // namespace canvoy::tools::playback_test
