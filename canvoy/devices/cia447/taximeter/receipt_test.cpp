// What a passenger reads on a receipt, and what the printer makes of its bytes: lines end with 0Ah,
// and 04h cuts the paper (CiA 447-3, 4.2.13.10).
#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::cia447::receipt_test {
namespace {

constexpr ReceiptFacts facts = {
    .number = 7, .taxi = "M-TX 447", .currency = "EUR", .distance_unit = "km", .utc_offset = 3600};

/// From 2026-11-23 11:05 to 11:17 UTC.
TripData trip_of_noon() {
  TripData trip;
  trip.fare = 12'400;
  trip.supplements = 700;
  trip.total = 13'100;
  trip.distance = 2'509;
  trip.start = 1'795'431'900;
  trip.finish = 1'795'432'620;
  return trip;
}

std::string printed(const TripData& trip, const ReceiptFacts& of = facts) {
  return std::string(Receipt(trip, of).text());
}

TEST(TaxiReceipt, SaysWhatWasPaidForWhat) {
  EXPECT_EQ(printed(trip_of_noon()),
            "TAXI M-TX 447\n"
            "Receipt 7\n"
            "From 2026-11-23 12:05\n"
            "To   2026-11-23 12:17\n"
            "Distance        2.50 km\n"
            "Fare           12.40\n"
            "Extras          0.70\n"
            "TOTAL          13.10\n"
            "EUR\n\n\n\x04");
}

TEST(TaxiReceipt, NothingIsSaidOfWhatWasNotTaken) {
  TripData trip = trip_of_noon();
  trip.supplements = 0;
  trip.total = trip.fare;
  EXPECT_EQ(printed(trip).find("Extras"), std::string::npos);
  trip.supplements = 1;
  EXPECT_NE(printed(trip).find("Extras          0.00\n"), std::string::npos);
}

TEST(TaxiReceipt, WhatIsNotKnownIsNotMadeUp) {
  EXPECT_EQ(printed(TripData{}),
            "TAXI M-TX 447\n"
            "Receipt 7\n"
            "Fare            -\n"
            "Extras          -\n"
            "TOTAL           -\n"
            "EUR\n\n\n\x04");
}

TEST(TaxiReceipt, WhatThereIsNoRoomForIsLeftOut) {
  const std::string name(600, 'x');
  EXPECT_EQ(printed(trip_of_noon(), {.taxi = name}).size(), 512u);
}

}  // namespace
}  // namespace canvoy::cia447::receipt_test
