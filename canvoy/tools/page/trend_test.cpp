#include "canvoy/tools/page/trend.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

namespace canvoy::tools::trend_test {
namespace {

using Json = nlohmann::ordered_json;

Json trend_of(const Trend& trend, const std::string& name) {
  return trend.json(std::array{name});
}

TEST(Trend, HasNumbersByTheirPlaces) {
  Trend trend;
  trend.add(Time(1s),
            Json::parse(R"({"plant":{"current_a":1.5,"name":"x"},"lifts":[{"load":7}]})"));
  trend.add(Time(2s), Json::parse(R"({"plant":{"current_a":2.5}})"));
  EXPECT_EQ(trend_of(trend, "plant.current_a").dump(),
            R"({"times":[1.0,2.0],"values":{"plant.current_a":[1.5,2.5]}})");
  // Missing values at the end are null.
  EXPECT_EQ(trend_of(trend, "lifts.0.load")["values"]["lifts.0.load"].dump(), "[7.0,null]");
  EXPECT_EQ(trend_of(trend, "plant.name")["values"], Json::object());
}

TEST(Trend, PassesListsOfNodesAndLandingsOver) {
  Trend trend;
  trend.add(Time{}, Json::parse(R"({"nodes":[{"node":5}],"landings":[{"waiting_up":3}]})"));
  EXPECT_EQ(
      trend.json(std::array<std::string, 2>{"nodes.0.node", "landings.0.waiting_up"})["values"],
      Json::object());
}

TEST(Trend, OfALongRunHasAsManySamplesAndCoversAllOfIt) {
  Trend trend;
  std::size_t taken = 0;
  for (int second = 0; second <= 8 * 3600; ++second) {
    if (!trend.is_due(Time(std::chrono::seconds(second)))) continue;
    trend.add(Time(std::chrono::seconds(second)),
              Json::parse(fmt::format(R"({{"x":{}}})", second)));
    ++taken;
  }
  const Json told = trend_of(trend, "x");
  const Json& times = told["times"];
  EXPECT_LE(times.size(), Trend::samples_max);
  EXPECT_GE(times.size(), Trend::samples_max / 4);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_GE(times.back().get<double>(), 8 * 3600 - 64);
  EXPECT_EQ(told["values"]["x"], times);
  EXPECT_LT(taken, 3000U);
}

TEST(Trend, KeepsSoManyNumbersAndNoMore) {
  Trend trend;
  Json many = Json::object();
  for (std::size_t i = 0; i < Trend::numbers_max + 5; ++i) many["n" + std::to_string(i)] = i;
  trend.add(Time{}, many);
  const std::string last = "n" + std::to_string(Trend::numbers_max - 1);
  EXPECT_EQ(trend_of(trend, last)["values"].size(), 1U);
  const std::string beyond = "n" + std::to_string(Trend::numbers_max);
  EXPECT_EQ(trend_of(trend, beyond)["values"].size(), 0U);
}

}  // namespace
}  // namespace canvoy::tools::trend_test
