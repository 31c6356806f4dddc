#include "canvoy/worlds/taxi/read_screens.hpp"

#include <gtest/gtest.h>

#include "canvoy/worlds/taxi/town.hpp"

namespace canvoy::taxi::read_screens_test {
namespace {

TEST(ReadScreens, TheFareIsReadInHundredthsWhileThereArePassengers) {
  cia447::TaximeterDisplay shown;
  shown.state = cia447::Taximeter::hired;
  shown.trip.fare = 12'304;
  shown.trip.level = {'1', 0};
  EXPECT_TRUE(fare_is_right("Tariff 1\nFARE      12.30 EUR", shown, {}));
  EXPECT_FALSE(fare_is_right("Tariff 1\nFARE      12.20 EUR", shown, {}));
  EXPECT_FALSE(fare_is_right("", shown, {}));
  shown.state = cia447::Taximeter::for_hire;
  EXPECT_TRUE(fare_is_right("", shown, {}));
  EXPECT_FALSE(fare_is_right("Tariff 1\nFARE      12.30 EUR", shown, {}));
}

TEST(ReadScreens, TariffExtrasAndCurrencyAreReadAsWell) {
  cia447::TaximeterDisplay shown;
  shown.state = cia447::Taximeter::hired;
  shown.trip.fare = 12'300;
  shown.trip.supplements = 2500;
  shown.trip.level = {'N', '2'};
  const cia447::Currency francs = {.code = "CHF"};
  EXPECT_TRUE(fare_is_right("Tariff N2\nFARE      12.30 CHF\nEXTRAS     2.50 CHF", shown, francs));
  EXPECT_FALSE(fare_is_right("Tariff N\nFARE      12.30 CHF\nEXTRAS     2.50 CHF", shown, francs));
  EXPECT_FALSE(fare_is_right("FARE      12.30 CHF\nEXTRAS     2.50 CHF", shown, francs));
  EXPECT_FALSE(fare_is_right("Tariff N2\nFARE      12.30 EUR\nEXTRAS     2.50 CHF", shown, francs));
  EXPECT_FALSE(fare_is_right("Tariff N2\nFARE      12.30 CHF\nEXTRAS     1.50 CHF", shown, francs));
  EXPECT_FALSE(fare_is_right("Tariff N2\nFARE      12.30 CHF", shown, francs));
}

TEST(ReadScreens, TheStreetIsTheNearestOne) {
  const TruePlace truth{.here = town_places[1].position, .places = town_places};
  EXPECT_TRUE(place_is_right("Odeonsplatz\nMunich", truth));
  EXPECT_FALSE(place_is_right("Marienplatz\nMunich", truth));
}

/// Odeonsplatz to Universitaet: 0.007 degrees of latitude, 779 m.
TEST(ReadScreens, TheDestinationIsReadWithItsDistance) {
  const TruePlace truth{.here = town_places[1].position,
                        .destination = town_places[2].position,
                        .places = town_places};
  EXPECT_TRUE(place_is_right("Odeonsplatz\n> Universitaet\n0.8 km to go", truth));
  EXPECT_FALSE(place_is_right("Odeonsplatz\n> Universitaet\n1.1 km to go", truth));
  EXPECT_FALSE(place_is_right("Odeonsplatz\n> Freimann\n0.8 km to go", truth));
  EXPECT_FALSE(place_is_right("Odeonsplatz\nMunich", truth));
}

TEST(ReadScreens, WithoutSatellitesNothingMayBeSaidButNothingWrong) {
  const TruePlace truth{
      .here = town_places[1].position, .has_satellites = false, .places = town_places};
  EXPECT_TRUE(place_is_right("", truth));
  EXPECT_FALSE(place_is_right("Marienplatz", truth));
}

}  // namespace
}  // namespace canvoy::taxi::read_screens_test
