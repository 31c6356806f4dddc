#include "canvoy/sim/deadline_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "canvoy/can/random.hpp"

namespace canvoy::deadline_tree_test {
namespace {

TEST(DeadlineTreeTest, WithoutActorsNothingIsEverDue) {
  EXPECT_EQ(DeadlineTree().earliest(), never);
}

TEST(DeadlineTreeTest, TheEarliestDeadlineWins) {
  DeadlineTree sut;
  sut.add(Time(30us));
  sut.add(Time(10us));
  sut.add(Time(20us));
  EXPECT_EQ(sut.earliest(), Time(10us));
  EXPECT_EQ(sut.winner(), 1U);
}

TEST(DeadlineTreeTest, OfEqualDeadlinesTheActorThatWasAddedFirstWins) {
  DeadlineTree sut;
  for (int i = 0; i < 9; ++i) sut.add(Time(5us));
  for (std::size_t expected = 0; expected < 9; ++expected) {
    EXPECT_EQ(sut.winner(), expected);
    sut.set(expected, Time(6us));
  }
}

TEST(DeadlineTreeTest, ADeadlineMayMoveBackToBecomeTheEarliest) {
  DeadlineTree sut;
  for (int i = 0; i < 5; ++i) sut.add(Time(10us));
  sut.set(4, Time(3us));
  EXPECT_EQ(sut.winner(), 4U);
  sut.set(4, Time(2us));
  EXPECT_EQ(sut.earliest(), Time(2us));
  sut.set(4, never);
  EXPECT_EQ(sut.winner(), 0U);
  EXPECT_EQ(sut.earliest(), Time(10us));
}

TEST(DeadlineTreeTest, AgreesWithASearchThroughAllActors) {
  for (std::size_t actors = 1; actors <= 130; actors += 43) {
    DeadlineTree sut;
    std::vector<Time> deadlines(actors, never);
    for (std::size_t i = 0; i < actors; ++i) ASSERT_EQ(sut.add(), i);
    Random random(actors);
    for (int i = 0; i < 3000; ++i) {
      const auto actor = random.below(static_cast<std::uint32_t>(actors));
      const Time deadline = random.below(10) == 0 ? never : Time(Duration(random.below(50)));
      deadlines[actor] = deadline;
      sut.set(actor, deadline);
      const auto expected = std::min_element(deadlines.begin(), deadlines.end());
      ASSERT_EQ(sut.earliest(), *expected);
      if (*expected != never) {
        ASSERT_EQ(sut.winner(), static_cast<std::size_t>(expected - deadlines.begin()));
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::deadline_tree_test
