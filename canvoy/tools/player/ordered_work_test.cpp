#include "canvoy/tools/player/ordered_work.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace canvoy::tools::ordered_work_test {
namespace {

std::vector<std::size_t> taken_of(std::size_t count, unsigned threads) {
  std::vector<std::size_t> taken;
  in_order<std::size_t>(
      count, threads, [](std::size_t i) { return i * i; },
      [&](std::size_t result) { taken.push_back(result); });
  return taken;
}

TEST(OrderedWork, ResultsAreTakenInOrderWhateverTheNumberOfThreads) {
  const std::vector<std::size_t> expected{0, 1, 4, 9, 16, 25, 36};
  for (const unsigned threads : {1U, 2U, 7U, 50U}) EXPECT_EQ(taken_of(7, threads), expected);
}

TEST(OrderedWork, WithoutThreadsTheCallingOneDoesAll) {
  EXPECT_EQ(taken_of(3, 0), (std::vector<std::size_t>{0, 1, 4}));
}

TEST(OrderedWork, NothingToDoIsDone) {
  EXPECT_TRUE(taken_of(0, 4).empty());
}

// The first task ends only after the second has begun, which a single thread could not do.
TEST(OrderedWork, PiecesAreDoneAtTheSameTime) {
  std::atomic<bool> has_second_begun = false;
  std::vector<bool> taken;
  in_order<bool>(
      2, 2,
      [&](std::size_t i) {
        if (i == 0) has_second_begun.wait(false);
        has_second_begun = true;
        has_second_begun.notify_one();
        return true;
      },
      [&](bool result) { taken.push_back(result); });
  EXPECT_EQ(taken.size(), 2);
}

TEST(OrderedWork, WhatAPieceThrowsIsThrown) {
  for (const unsigned threads : {0U, 1U, 4U}) {
    EXPECT_THROW(in_order<int>(
                     20, threads,
                     [](std::size_t i) {
                       if (i == 5) throw std::runtime_error("five");
                       return 0;
                     },
                     [](int) {}),
                 std::runtime_error);
  }
}

TEST(OrderedWork, WhoeverTakesEndsAllByThrowing) {
  std::atomic<unsigned> done = 0;
  EXPECT_THROW(in_order<int>(
                   1'000'000, 2, [&](std::size_t) { return ++done, 0; },
                   [](int) { throw std::runtime_error("enough"); }),
               std::runtime_error);
  EXPECT_LT(done, 1'000'000);
}

}  // namespace
}  // namespace canvoy::tools::ordered_work_test
