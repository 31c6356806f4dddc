#include "canvoy/tools/page/worst_times.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

namespace canvoy::tools::worst_times_test {
namespace {

constexpr InvariantRow wait{.name = "no_endless_wait", .text = "longest wait", .unit = "s"};
constexpr InvariantRow level{.name = "level", .text = "off its level", .unit = "mm"};

Judged judged(const InvariantRow& kind, double worst, std::uint64_t count = 1) {
  return {.kind = &kind, .worst = worst, .allowed = 10, .judged = count};
}

nlohmann::ordered_json told(const WorstTimes& times, std::span<const Judged> all) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < all.size(); ++i) list.push_back(nlohmann::ordered_json::object());
  times.add_to(list, all);
  return list;
}

TEST(WorstTimes, IsTheTimeWhenTheWorstLastGrew) {
  WorstTimes times;
  times.look(Time(1s), std::array{judged(wait, 2)});
  times.look(Time(2s), std::array{judged(wait, 5)});
  const std::array last = {judged(wait, 5)};
  times.look(Time(3s), last);
  EXPECT_EQ(told(times, last)[0]["worst_at"], 2.0);
  EXPECT_EQ(told(times, last)[0]["words"], "longest wait");
}

TEST(WorstTimes, OfWhatWasNeverJudgedThereIsNone) {
  WorstTimes times;
  const std::array first = {judged(wait, 0, 0)};
  times.look(Time(1s), first);
  EXPECT_FALSE(told(times, first)[0].contains("worst_at"));
  const std::array then = {judged(wait, 0, 1)};
  times.look(Time(2s), then);
  EXPECT_EQ(told(times, then)[0]["worst_at"], 2.0);
}

TEST(WorstTimes, FollowsInvariantsThatChangeTheirPlaces) {
  WorstTimes times;
  times.look(Time(1s), std::array{judged(wait, 2)});
  const std::array both = {judged(level, 1), judged(wait, 2)};
  times.look(Time(2s), both);
  EXPECT_EQ(told(times, both)[0]["worst_at"], 2.0);
  EXPECT_EQ(told(times, both)[1]["worst_at"], 1.0);
}

TEST(WorstTimes, TellsNothingOfAnotherList) {
  WorstTimes times;
  times.look(Time(1s), std::array{judged(wait, 2)});
  auto list = nlohmann::ordered_json::array();
  times.add_to(list, std::array{judged(wait, 2)});
  EXPECT_TRUE(list.empty());
}

}  // namespace
}  // namespace canvoy::tools::worst_times_test
