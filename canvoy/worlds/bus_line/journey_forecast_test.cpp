// Times of a bus at its stops: each expected time is that of the timetable, plus what the comment
// adds.
#include "canvoy/worlds/bus_line/journey_forecast.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::journey_forecast_test {
namespace {

using std::chrono::seconds;

/// Stops at 100, 200 to 220, 300 (a timing point) and 400 s.
Journey journey() {
  Journey made;
  made.passings = {{.arrival = 100s, .departure = 100s},
                   {.arrival = 200s, .departure = 220s, .is_timing_point = false},
                   {.arrival = 300s, .departure = 300s},
                   {.arrival = 400s, .departure = 400s, .is_timing_point = false}};
  return made;
}

/// `200-220 300-300 400-`
std::string text(const std::vector<StopForecast>& stops) {
  std::string made;
  for (const StopForecast& stop : stops) {
    if (!made.empty()) made += " ";
    if (stop.arrival) made += std::to_string(stop.arrival->count());
    made += "-";
    if (stop.departure) made += std::to_string(stop.departure->count());
  }
  return made;
}

TEST(JourneyForecast, WhoWaitsForTheStartGoesByTheTimetable) {
  EXPECT_EQ(text(forecast(journey(), {.place = 0}, seconds(50))), "-100 200-220 300-300 400-");
}

TEST(JourneyForecast, WhoStillStandsAfterTheStartIsLate) {
  EXPECT_EQ(text(forecast(journey(), {.place = 0}, seconds(130))), "-130 230-250 330-330 430-");
}

TEST(JourneyForecast, WhoIsLateStaysLate) {
  // Left 30 s late.
  EXPECT_EQ(text(forecast(journey(), {.place = 1, .left_before = seconds(130)}, seconds(140))),
            "230-250 330-330 430-");
}

TEST(JourneyForecast, WhoIsEarlyWaitsAtATimingPoint) {
  // Arrived 20 s early at a stop that is no timing point, and stays early.
  EXPECT_EQ(text(forecast(journey(), {.place = 1, .arrived = seconds(180)}, seconds(181))),
            "180-200 280-300 400-");
}

TEST(JourneyForecast, NothingThatIsNotOverIsInThePast) {
  EXPECT_EQ(text(forecast(journey(), {.place = 2, .left_before = seconds(220)}, seconds(350))),
            "350-350 450-");
  EXPECT_EQ(text(forecast(journey(), {.place = 3, .arrived = seconds(400)}, seconds(500))), "400-")
      << "when it came is over";
}

TEST(JourneyForecast, TimesRise) {
  Journey same = journey();
  for (Passing& passing : same.passings) passing.arrival = passing.departure = 100s;
  EXPECT_EQ(text(forecast(same, {.place = 0}, seconds(0))), "-100 101-101 102-102 103-");
}

TEST(JourneyForecast, BehindTheLastStopThereIsNone) {
  EXPECT_TRUE(forecast(journey(), {.place = 4}, seconds(0)).empty());
}

}  // namespace
}  // namespace canvoy::bus_line::journey_forecast_test
