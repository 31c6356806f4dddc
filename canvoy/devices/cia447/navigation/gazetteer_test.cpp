// Distances and places.
#include "canvoy/devices/cia447/navigation/gazetteer.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::gazetteer_test {
namespace {

constexpr GeoPosition marienplatz = {48.137154, 11.575382};
constexpr GeoPosition vienna = {48.208176, 16.373819};

TEST(Distance, IsKnownBetweenKnownPlaces) {
  EXPECT_EQ(metres_between(marienplatz, marienplatz), 0);
  // A degree of a great circle is 6371.0088 km * pi / 180.
  EXPECT_NEAR(metres_between({0, 0}, {1, 0}), 111'195.08, 0.1);
  EXPECT_NEAR(metres_between({0, 0}, {0, 1}), 111'195.08, 0.1);
  EXPECT_NEAR(metres_between({60, 10}, {60, 10.001}), 111.195 / 2, 0.01)
      << "half of it at 60 degrees";
  EXPECT_NEAR(metres_between({90, 0}, {-90, 77}), 20'015'114.35, 0.5)
      << "from pole to pole: pi * 6371.0088 km";
  EXPECT_NEAR(metres_between(marienplatz, vienna), 355'600, 1'000);
}

TEST(Distance, GoesTheShortWayOverTheDateLine) {
  EXPECT_NEAR(metres_between({0, 179.5}, {0, -179.5}), 111'195.08, 0.1);
  EXPECT_NEAR(metres_between({0, 180}, {0, -180}), 0, 1e-6);
}

TEST(Distance, IsNotLessThanThatAlongTheMeridian) {
  for (double latitude = -30; latitude <= 90; latitude += 0.37) {
    for (const double away : {0.0, 1e-9, 1e-6, 1e-4, 0.01, 1.0, 60.0}) {
      const GeoPosition there = {latitude - away, 11.5 + away / 3};
      EXPECT_LE(metres_at_least({latitude, 11.5}, {latitude - away, 11.5}),
                metres_between({latitude, 11.5}, {latitude - away, 11.5}));
      EXPECT_LE(metres_at_least({latitude, 11.5}, there), metres_between({latitude, 11.5}, there));
    }
  }
  EXPECT_NEAR(metres_at_least({0, 7}, {1, 7}), 111'195.08 - 1, 0.1);
}

TEST(Distance, IsTheSameBothWays) {
  EXPECT_DOUBLE_EQ(metres_between(marienplatz, vienna), metres_between(vienna, marienplatz));
}

constexpr NamedPlace places[] = {
    {.position = marienplatz, .city = "Munich", .street = "Marienplatz", .country = "Germany"},
    {.position = {48.140, 11.558},
     .city = "Munich",
     .street = "Bahnhofplatz",
     .country = "Germany"},
    {.position = vienna, .city = "Vienna", .street = "Stephansplatz", .country = "Austria"},
    {.position = vienna, .city = "Vienna", .street = "again", .country = "Austria"}};

TEST(Gazetteer, TellsTheNearestPlace) {
  const Gazetteer sut(places);
  EXPECT_EQ(sut.nearest(marienplatz)->street, "Marienplatz");
  EXPECT_EQ(sut.nearest({48.1398, 11.560})->street, "Bahnhofplatz");
  EXPECT_EQ(sut.nearest({48.2, 16.37})->city, "Vienna");
  EXPECT_EQ(sut.nearest(vienna)->street, "Stephansplatz") << "the first of two at one place";
}

TEST(Gazetteer, ThereIsNoneBeyondItsReach) {
  const Gazetteer sut(places, 500);
  EXPECT_NE(sut.nearest({48.137154 + 0.0044, 11.575382}), nullptr) << "489 m north";
  EXPECT_EQ(sut.nearest({48.137154 + 0.0046, 11.575382}), nullptr) << "511 m north";
  EXPECT_EQ(Gazetteer().nearest(vienna), nullptr);
  EXPECT_EQ(Gazetteer(places).nearest({0, 0}), nullptr);
}

}  // namespace
}  // namespace canvoy::cia447::gazetteer_test
