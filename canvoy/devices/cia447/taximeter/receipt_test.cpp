// Contents of a receipt for a passenger and of a slip for the driver, and their bytes for the
// printer: lines end with 0Ah, and 04h cuts the paper (CiA 447-3, 4.2.13.10).
#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::cia447::receipt_test {
namespace {

constexpr SupplementKind kinds[] = {{.name = "Luggage", .price = 1000},
                                    {.name = "Booking", .price = 1500},
                                    {.name = "Airport", .price = 5000}};
constexpr ReceiptFacts plain = {
    .number = 7, .head = {.taxi = "M-TX 447", .distance_unit = "km"}, .utc_offset = 3600};

/// From 2026-11-23 11:05 to 11:17 UTC.
TripData trip_of_noon() {
  TripData trip;
  trip.fare = 12'400;
  trip.supplements = 700;
  trip.total = 13'100;
  trip.mode = FareMode::single_calculation;
  trip.distance = 2'509;
  trip.waiting = 200;
  trip.level = {'1', 0};
  trip.start = 1'795'431'900;
  trip.finish = 1'795'432'620;
  return trip;
}

std::string printed(const TripData& trip, const ReceiptFacts& of = plain) {
  return std::string(Receipt(trip, of).text());
}

TEST(TaxiReceipt, SaysWhatWasPaidForWhat) {
  EXPECT_EQ(printed(trip_of_noon()),
            "TAXI M-TX 447\n"
            "Receipt 7\n"
            "From 2026-11-23 12:05\n"
            "To   2026-11-23 12:17\n"
            "Tariff 1\n"
            "Distance           2.50 km\n"
            "Waiting         0:03:20\n"
            "Fare              12.40\n"
            "Extras             0.70\n"
            "TOTAL             13.10 EUR\n"
            "\n\n\x04");
}

/// 13.10 with 7 % in it has 0.857 of tax; 16.60 has 1.086.
TEST(TaxiReceipt, SaysWhoHasDrivenAndEachServiceOnALineOfItsOwn) {
  TripData trip = trip_of_noon();
  trip.supplements = 4'200;
  trip.total = 16'600;
  constexpr std::uint32_t of_kinds[] = {2000, 1500, 0};
  ReceiptFacts facts = plain;
  facts.head.company = "Isar Taxi";
  facts.head.driver = "A. Driver";
  facts.kinds = kinds;
  facts.of_kinds = of_kinds;
  facts.vat_permille = 70;
  facts.payment = "card";
  EXPECT_EQ(printed(trip, facts),
            "TAXI M-TX 447\n"
            "Isar Taxi\n"
            "Receipt 7\n"
            "Driver A. Driver\n"
            "From 2026-11-23 12:05\n"
            "To   2026-11-23 12:17\n"
            "Tariff 1\n"
            "Distance           2.50 km\n"
            "Waiting         0:03:20\n"
            "Fare              12.40\n"
            "Luggage            2.00\n"
            "Booking            1.50\n"
            "Extras             0.70\n"
            "TOTAL             16.60 EUR\n"
            "VAT 7.0 %          1.09\n"
            "Paid: card\n"
            "\n\n\x04");
}

TEST(TaxiReceipt, AnAgreedPriceIsNoFare) {
  TripData trip = trip_of_noon();
  trip.mode = FareMode::fixed_price;
  EXPECT_NE(printed(trip).find("Agreed            12.40\n"), std::string::npos);
  EXPECT_EQ(printed(trip).find("Fare"), std::string::npos);
}

/// Swiss francs have coins of 0.05, yen no parts, dinars of Kuwait thousandths.
TEST(TaxiReceipt, HasTheCurrencysDecimalsAndItsSymbolWhereItStands) {
  const auto total = [](const Currency& currency) {
    ReceiptFacts facts = plain;
    facts.head.currency = currency;
    const std::string text = printed(trip_of_noon(), facts);
    const std::size_t at = text.find("TOTAL");
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(total({.code = "CHF", .symbol = "Fr.", .leads = true, .coin = 50}),
            "TOTAL       Fr.   13.10");
  EXPECT_EQ(total({.code = "JPY", .symbol = "Yen", .coin = 1000}), "TOTAL                13 Yen");
  EXPECT_EQ(total({.code = "KWD", .symbol = "KD", .coin = 5}), "TOTAL            13.100 KD");
}

/// Of 100.00 including 19 %: 15.966; of francs, in steps of 0.05: 8.1 % of 20.00 are 1.499.
TEST(TaxiReceipt, TaxIsOfWholeCoins) {
  EXPECT_EQ(tax_in(100'000, 190, 10), 15'970u);
  EXPECT_EQ(tax_in(20'000, 81, 50), 1'500u);
  EXPECT_EQ(tax_in(0, 70, 10), 0u);
  EXPECT_EQ(tax_in(amount_max, 0xFFFF, 1), 4'230'415'293u) << "4294967293 by 65535/66535";
}

TEST(TaxiReceipt, NothingIsSaidOfWhatWasNotTaken) {
  TripData trip = trip_of_noon();
  trip.supplements = 0;
  trip.total = trip.fare;
  EXPECT_EQ(printed(trip).find("Extras"), std::string::npos);
  trip.supplements = 1;
  EXPECT_NE(printed(trip).find("Extras             0.00\n"), std::string::npos);
}

TEST(TaxiReceipt, WhatIsNotKnownIsNotMadeUp) {
  EXPECT_EQ(printed(TripData{}),
            "TAXI M-TX 447\n"
            "Receipt 7\n"
            "Fare                  -\n"
            "Extras                -\n"
            "TOTAL                 -\n"
            "\n\n\x04");
}

TEST(TaxiReceipt, WhatThereIsNoRoomForIsLeftOut) {
  const std::string name(2000, 'x');
  EXPECT_EQ(printed(trip_of_noon(), {.head = {.taxi = name}}).size(), printed_text_max);
}

/// 60D9h has all of it; 1'795'435'200 is 2026-11-23 12:00.
TEST(TaxiSlip, HasTheTotalsOfTheShiftAndOfAllTime) {
  constexpr TaxiTotals shift = {.distance = 123'459,
                                .distance_hired = 60'001,
                                .income = 246'500,
                                .hirings = 12,
                                .supplements = 12'000,
                                .fare = 234'500};
  constexpr TaxiTotals total = {.distance = 1'000'000,
                                .distance_hired = 500'000,
                                .income = 999'990,
                                .hirings = 77,
                                .supplements = 1'000,
                                .fare = 998'990};
  constexpr PaperHead head = {
      .taxi = "M-TX 447", .company = "Isar Taxi", .driver = "A. Driver", .distance_unit = "km"};
  const ShiftSlip slip(shift, total,
                       {.head = head, .begin = 1'795'435'200, .end = 1'795'435'200 + 8 * 3600});
  EXPECT_EQ(slip.text(),
            "SHIFT OF M-TX 447\n"
            "Isar Taxi\n"
            "Driver A. Driver\n"
            "From 2026-11-23 12:00\n"
            "To   2026-11-23 20:00\n"
            "Shift\n"
            "Driven           123.45 km\n"
            "Hired             60.00 km\n"
            "Hirings              12\n"
            "Fares            234.50\n"
            "Supplements       12.00\n"
            "INCOME           246.50 EUR\n"
            "All time\n"
            "Driven          1000.00 km\n"
            "Hired            500.00 km\n"
            "Hirings              77\n"
            "Fares            998.99\n"
            "Supplements        1.00\n"
            "INCOME           999.99 EUR\n"
            "\n\n\x04");
}

}  // namespace
}  // namespace canvoy::cia447::receipt_test
