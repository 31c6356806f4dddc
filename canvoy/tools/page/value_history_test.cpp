#include "canvoy/tools/page/value_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace canvoy::tools::value_history_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ValueHistory, HasNumbersAndStatesFromTheirTimesOn) {
  ValueHistory history;
  history.add(1.5, 48.25);
  history.add(2, 48.25);  // the same one: it holds on
  history.add(3, -2);
  history.add(4, "ready \"now\"");
  history.add(5, 1);
  EXPECT_EQ(history.json(), Json::parse(R"({"times":[1.5,3.0,4.0,5.0],)"
                                        R"("values":[48.25,-2.0,"ready \"now\"",1.0]})"));
}

TEST(ValueHistory, OfALongTimeKeepsItsEndsAndTheOnlyPeak) {
  ValueHistory history;
  constexpr int length = 100'000;
  constexpr int peak_at = 43'210;
  for (int i = 0; i < length; ++i) {
    history.add(i, i == peak_at ? 1000 : i % 2);
  }
  const Json told = history.json();
  ASSERT_LE(told["times"].size(), ValueHistory::samples_max);
  ASSERT_GE(told["times"].size(), ValueHistory::samples_max / 2);
  EXPECT_EQ(told["times"].front(), 0.0);
  EXPECT_EQ(told["times"].back(), length - 1.0);
  const auto peak = std::ranges::find(told["values"], Json(1000.0));
  ASSERT_NE(peak, told["values"].end());
  EXPECT_EQ(told["times"][static_cast<std::size_t>(peak - told["values"].begin())], peak_at);
  EXPECT_TRUE(std::ranges::is_sorted(told["times"]));
}

TEST(ValueHistory, KeepsAsMuchOfItsBeginningAsOfItsEnd) {
  ValueHistory history;
  constexpr int length = 100'000;
  for (int i = 0; i < length; ++i) history.add(i, i % 7);
  const Json points = history.points(100);
  for (int tenth = 0; tenth < 10; ++tenth) {
    const auto count = std::ranges::count_if(points, [tenth](const Json& point) {
      return static_cast<int>(point[0].get<double>()) * 10 / length == tenth;
    });
    EXPECT_GE(count, 8) << tenth;
    EXPECT_LE(count, 12) << tenth;
  }
}

TEST(ValueHistory, OfValuesAtOneTimeKeepsTheLast) {
  ValueHistory history;
  for (int i = 0; i < 5000; ++i) history.add(1.5, i);
  EXPECT_LE(history.json()["times"].size(), ValueHistory::samples_max);
  EXPECT_EQ(history.json()["values"].back(), 4999.0);
}

TEST(ValueHistory, OfManyStatesKeepsTheLatest) {
  ValueHistory history;
  for (int i = 0; i < 5000; ++i) history.add(i, i % 2 == 0 ? "on" : "off");
  const Json told = history.json();
  ASSERT_LE(told["times"].size(), ValueHistory::samples_max);
  EXPECT_EQ(told["times"].back(), 4999.0);
  EXPECT_EQ(told["values"].back(), "off");
  EXPECT_EQ(told["times"].front().get<double>() + static_cast<double>(told["times"].size()),
            5000.0);
}

TEST(ValueHistory, IsPairsOfTimeAndNumberWithGapsForStates) {
  ValueHistory history;
  history.add(1.5, 48.25);
  history.add(4, "not available");
  history.add(5, 1);
  EXPECT_EQ(history.points(3), Json::parse("[[1.5,48.25],[4.0,null],[5.0,1.0]]"));
}

TEST(ValueHistory, IsFewerPairsWithTheOnlyPeak) {
  ValueHistory history;
  for (int i = 0; i < 900; ++i) history.add(i, i == 432 ? 1000 : i % 2);
  const Json points = history.points(100);
  ASSERT_EQ(points.size(), 100U);
  EXPECT_EQ(points.front(), Json::array({0.0, 0.0}));
  EXPECT_EQ(points.back(), Json::array({899.0, 1.0}));
  EXPECT_NE(std::ranges::find(points, Json::array({432.0, 1000.0})), points.end());
}

TEST(ValueHistory, OfWhichTheBeginningIsGoneIsNoCurve) {
  ValueHistory history;
  for (int i = 0; i < 5000; ++i) history.add(i, i % 2 == 0 ? "on" : "off");
  EXPECT_EQ(history.points(100), Json::array());
}

TEST(ValueHistory, TakesSoManyNamesAndNoMore) {
  ValueHistory history;
  for (std::size_t i = 0; i < 2 * ValueHistory::names_max; ++i) {
    history.add(static_cast<double>(i), "name " + std::to_string(i));
  }
  EXPECT_EQ(history.json()["values"].size(), ValueHistory::names_max);
}

}  // namespace
}  // namespace canvoy::tools::value_history_test
