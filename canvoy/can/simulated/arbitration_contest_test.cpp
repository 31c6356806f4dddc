#include "canvoy/can/simulated/arbitration_contest.hpp"

#include <gtest/gtest.h>

#include <map>

#include "canvoy/can/random.hpp"

namespace canvoy::arbitration_contest_test {
namespace {

ControllerSet set_of(std::initializer_list<ControllerId> ids) {
  ControllerSet set;
  for (const ControllerId id : ids) set.insert(id);
  return set;
}

ArbitrationContest contest_of(std::size_t controllers) {
  ArbitrationContest contest(128);
  contest.resize(controllers);
  return contest;
}

TEST(ArbitrationContest, WithoutContendersHasNoWinner) {
  ArbitrationContest sut = contest_of(127);
  EXPECT_TRUE(sut.winners().empty());
  sut.enter(5, 0xFFFF'FFFF);
  sut.leave(5);
  EXPECT_TRUE(sut.winners().empty());
  EXPECT_TRUE(sut.contenders().empty());
}

TEST(ArbitrationContest, IsWonByTheLowestKey) {
  ArbitrationContest sut = contest_of(127);
  sut.enter(3, 30);
  sut.enter(100, 20);
  sut.enter(7, 25);
  EXPECT_EQ(sut.winners(), set_of({100}));
  sut.enter(100, 40);
  EXPECT_EQ(sut.winners(), set_of({7}));
  EXPECT_EQ(sut.contenders(), set_of({3, 7, 100}));
}

TEST(ArbitrationContest, IsWonByAllThatShareTheLowestKey) {
  ArbitrationContest sut = contest_of(8);
  for (const ControllerId id : {ControllerId{1}, ControllerId{2}, ControllerId{6}})
    sut.enter(id, 9);
  sut.enter(0, 10);
  EXPECT_EQ(sut.winners(), set_of({1, 2, 6}));
  sut.leave(2);
  sut.leave(6);
  EXPECT_EQ(sut.winners(), set_of({1}));
}

TEST(ArbitrationContest, AmongSomeIsWonByTheLowestKeyOfThose) {
  ArbitrationContest sut = contest_of(8);
  sut.enter(0, 1);
  sut.enter(1, 2);
  sut.enter(2, 2);
  EXPECT_EQ(sut.winners_among(set_of({1, 2})), set_of({1, 2}));
  EXPECT_TRUE(sut.winners_among({}).empty());
}

TEST(ArbitrationContest, HasTheWinnersThatASearchFindsWhateverTheNumberOfControllers) {
  Random random(1);
  for (const std::uint32_t controllers : {1U, 2U, 3U, 64U, 127U, 128U}) {
    ArbitrationContest sut = contest_of(controllers);
    std::map<ControllerId, std::uint32_t> keys;
    for (int i = 0; i < 3000; ++i) {
      const auto id = static_cast<ControllerId>(random.below(controllers));
      if (random.below(3) == 0) {
        sut.leave(id);
        keys.erase(id);
      } else {
        const std::uint32_t key = random.below(20);
        sut.enter(id, key);
        keys[id] = key;
      }
      ControllerSet expected;
      for (const auto& [candidate, key] : keys) {
        bool is_lowest = true;
        for (const auto& [other, other_key] : keys) is_lowest = is_lowest && key <= other_key;
        if (is_lowest) expected.insert(candidate);
      }
      ASSERT_EQ(sut.winners(), expected);
    }
  }
}

}  // namespace
}  // namespace canvoy::arbitration_contest_test
