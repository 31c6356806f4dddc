#include "canvoy/worlds/taxi/screen_text.hpp"

#include <gtest/gtest.h>

namespace canvoy::taxi::screen_text_test {
namespace {

using cia447::Taximeter;
using cia447::TripData;

cia447::TaximeterDisplay hired(std::uint32_t fare, std::uint32_t supplements) {
  cia447::TaximeterDisplay shown;
  shown.state = Taximeter::hired;
  shown.trip.level = {'1', 0x00};
  shown.trip.fare = fare;
  shown.trip.supplements = supplements;
  return shown;
}

// Amounts end in column 16, the currency in column 20.
TEST(ScreenText, AFareStandsUnderItsTariff) {
  EXPECT_EQ(trip_text(hired(12'300, 0), {}), "Tariff 1\nFARE       12.30 EUR");
  EXPECT_EQ(trip_text(hired(1'234'560, 0), {}), "Tariff 1\nFARE     1234.56 EUR");
  EXPECT_EQ(trip_text(hired(500'000, 0), {.code = "JPY", .coin = 1000}),
            "Tariff 1\nFARE         500 JPY");
}

TEST(ScreenText, SupplementsAreShownWhereThereAreAny) {
  EXPECT_EQ(trip_text(hired(12'300, 2'500), {}),
            "Tariff 1\nFARE       12.30 EUR\nEXTRAS      2.50 EUR");
  EXPECT_EQ(trip_text(hired(12'300, TripData::unknown), {}), "Tariff 1\nFARE       12.30 EUR");
}

TEST(ScreenText, WithoutPassengersOrFareThereIsNothing) {
  EXPECT_EQ(trip_text(hired(TripData::unknown, 0), {}), "");
  cia447::TaximeterDisplay shown = hired(12'300, 0);
  shown.state = Taximeter::stopped;
  EXPECT_EQ(trip_text(shown, {}), "Tariff 1\nFARE       12.30 EUR");
  shown.state = Taximeter::for_hire;
  EXPECT_EQ(trip_text(shown, {}), "");
}

TEST(ScreenText, OfATariffWhatIsNoLetterIsLeftOut) {
  cia447::TaximeterDisplay shown = hired(100, 0);
  shown.trip.level = {0x1F, ' '};
  EXPECT_TRUE(trip_text(shown, {}).starts_with("Tariff  \n"));
  shown.trip.level = {'~', 0x7F};
  EXPECT_TRUE(trip_text(shown, {}).starts_with("Tariff ~\n"));
}

TEST(ScreenText, APlaceIsTheStreetAndTheCityOrTheWayToGo) {
  EXPECT_EQ(place_text({.street = "Odeonsplatz", .city = "Munich"}), "Odeonsplatz\nMunich");
  EXPECT_EQ(place_text({.street = "Odeonsplatz"}), "Odeonsplatz");
  EXPECT_EQ(place_text({.street = "Odeonsplatz", .city = "Munich", .destination = "Freimann"}),
            "Odeonsplatz\n> Freimann");
  EXPECT_EQ(place_text({.street = "Odeonsplatz", .destination = "Freimann", .metres_to_go = 779}),
            "Odeonsplatz\n> Freimann\n0.8 km to go");
}

TEST(ScreenText, WhatIsShownIsRead) {
  EXPECT_EQ(read_fare("Tariff 1\nFARE       12.30 EUR\nEXTRAS      2.50 EUR"), 12'300);
  EXPECT_EQ(read_fare("Tariff 1"), std::nullopt);
  EXPECT_EQ(read_fare("FARE"), std::nullopt);
  constexpr std::string_view place = "Odeonsplatz\n> Freimann\n0.8 km to go";
  EXPECT_EQ(read_street(place), "Odeonsplatz");
  EXPECT_EQ(read_destination(place), "Freimann");
  EXPECT_EQ(read_metres_to_go(place), 800);
  EXPECT_EQ(read_destination("Odeonsplatz\nMunich"), "");
  EXPECT_EQ(read_metres_to_go("Odeonsplatz\nMunich"), std::nullopt);
}

}  // namespace
}  // namespace canvoy::taxi::screen_text_test
