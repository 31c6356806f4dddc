#include "canvoy/can/simulated/fault_timeline.hpp"

#include <gtest/gtest.h>

namespace canvoy::fault_timeline_test {
namespace {

TEST(FaultTimeline, WithoutFaultsHasNothingToCome) {
  EXPECT_EQ(FaultTimeline(BusFaults{}).next_ns(), never_ns);
}

TEST(FaultTimeline, BeginsAndEndsEachFaultInTheOrderOfTimes) {
  FaultTimeline sut({.cable_cut = {.after = 3, .from = Time(1s), .until = Time(4s)},
                     .babbling = {.controller = 7, .from = Time(2s), .until = Time(3s)}});
  EXPECT_EQ(sut.next_ns(), to_ns(Time(1s)));
  EXPECT_EQ(sut.take_next(), (FaultsDue{.cut_after = 3}));
  EXPECT_EQ(sut.next_ns(), to_ns(Time(2s)));
  EXPECT_EQ(sut.take_next(), (FaultsDue{.babble = 7}));
  EXPECT_EQ(sut.next_ns(), to_ns(Time(3s)));
  EXPECT_EQ(sut.take_next(), (FaultsDue{.stop_babbling = 7}));
  EXPECT_EQ(sut.next_ns(), to_ns(Time(4s)));
  EXPECT_EQ(sut.take_next(), (FaultsDue{.mend_after = 3}));
  EXPECT_EQ(sut.next_ns(), never_ns);
}

TEST(FaultTimeline, HasTheStartOfTimeInIt) {
  FaultTimeline sut({.cable_cut = {.after = 3, .from = Time{}}});
  EXPECT_EQ(sut.next_ns(), 0);
  EXPECT_EQ(sut.take_next(), (FaultsDue{.cut_after = 3}));
  EXPECT_EQ(sut.next_ns(), never_ns);
}

TEST(FaultTimeline, GivesWhatIsDueAtOneTimeTogether) {
  FaultTimeline sut({.cable_cut = {.after = 3, .from = Time(1s), .until = Time(2s)},
                     .babbling = {.controller = 7, .from = Time(2s)}});
  sut.take_next();
  EXPECT_EQ(sut.take_next(), (FaultsDue{.mend_after = 3, .babble = 7}));
  EXPECT_EQ(sut.next_ns(), never_ns);
}

}  // namespace
}  // namespace canvoy::fault_timeline_test
