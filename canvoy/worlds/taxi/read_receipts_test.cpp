#include "canvoy/worlds/taxi/read_receipts.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::taxi::read_receipts_test {
namespace {

/// 2026-11-21 18:00, by `date -u`.
constexpr std::int64_t six_in_the_evening = 1'795'284'000;

constexpr cia447::SupplementKind kinds[] = {{.name = "Luggage", .price = 1000},
                                            {.name = "Airport", .price = 5000}};
constexpr std::array<std::array<char, 2>, 2> by_day = {{{'1', 0}, {'1', 0}}};

PaperTruth truth() {
  return {.clock = six_in_the_evening,
          .tariff = {.supplements = kinds},
          .currency = {},
          .taxi = "M-TX 447",
          .company = "Isar Taxi",
          .driver = "A. Driver",
          .vat_percent = 7};
}

/// Two trips: 4,200 m from 18:02:30 to 18:10:00 for 11.30 and a piece of luggage, by card; 1,500 m
/// from 18:20 to 18:25 for an agreed 7.00, in cash.
std::vector<Trip> two_trips() {
  Trip first{.begin = Time(150s), .end = Time(600s), .metres = 4200, .sure_metres = 4200};
  first.waiting_low = 60;
  first.waiting_high = 70;
  first.metered_fare = 11'300;
  first.paid = 12'300;
  first.pressed_extras = 1000;
  first.pressed[0] = 1;
  first.is_by_card = true;
  first.levels = by_day;
  Trip second{.begin = Time(20min), .end = Time(25min), .metres = 1500, .sure_metres = 1500};
  second.metered_fare = 7000;
  second.paid = 7000;
  second.agreed = 7000;
  second.levels = by_day;
  return {first, second};
}
using Lines = std::vector<std::string>;
/// 7 % of 11.495 are 0.805.
Lines first_receipt() {
  return {"TAXI M-TX 447",
          "Isar Taxi",
          "Receipt 1",
          "Driver A. Driver",
          "From 2026-11-21 18:02",
          "To   2026-11-21 18:10",
          "Tariff 1",
          "Distance           4.20 km",
          "Waiting         0:01:05",
          "Fare              11.30",
          "Luggage            1.00",
          "TOTAL             12.30 EUR",
          "VAT 7.0 %          0.80",
          "Paid: card"};
}
Lines second_receipt() {
  return {"TAXI M-TX 447",
          "Isar Taxi",
          "Receipt 2",
          "Driver A. Driver",
          "From 2026-11-21 18:20",
          "To   2026-11-21 18:25",
          "Tariff 1",
          "Distance           1.50 km",
          "Waiting         0:00:00",
          "Agreed             7.00",
          "TOTAL              7.00 EUR",
          "VAT 7.0 %          0.46",
          "Paid: cash"};
}
Lines both() {
  Lines lines = first_receipt();
  for (const std::string& line : second_receipt()) lines.push_back(line);
  return lines;
}
Lines both_with(std::size_t line, const std::string& wrong) {
  Lines lines = both();
  lines.at(line) = wrong;
  return lines;
}
ReceiptVerdict read(const Lines& lines, const std::vector<Trip>& trips = two_trips()) {
  return judge_receipts(lines, trips, truth());
}

TEST(ReadReceipts, ReceiptsThatSayWhatWasAreRight) {
  const ReceiptVerdict verdict = read(both());
  EXPECT_EQ(verdict.difference, 0);
  EXPECT_EQ(verdict.receipts, 2u);
  EXPECT_EQ(verdict.wrong_lines, 0u);
  EXPECT_GT(verdict.lines, 0u);
}

TEST(ReadReceipts, WithoutATripThereIsNothingToJudge) {
  const ReceiptVerdict verdict = read({}, {});
  EXPECT_EQ(verdict.receipts, 0u);
  EXPECT_EQ(verdict.lines, 0u);
}

TEST(ReadReceipts, ATripHasOneReceiptWithItsNumberAndTheTaxThatIsTheTowns) {
  Lines lines = both();
  for (const std::string& line : first_receipt()) lines.push_back(line);
  EXPECT_EQ(read(lines).wrong_lines, 1u) << "the first one is printed twice";
  EXPECT_NE(read(both_with(2, "Receipt 2")).difference, 0);
  EXPECT_NE(read(both_with(12, "VAT 9.0 %          0.80")).wrong_lines, 0u);
}

TEST(ReadReceipts, EachTotalThatIsNotWhatWasPaidCounts) {
  Lines lines = both_with(11, "TOTAL             12.00 EUR");
  lines.at(24) = "TOTAL              7.10 EUR";
  EXPECT_NEAR(read(lines).difference, 300 + 100, 1e-6);
  EXPECT_GE(read(lines).wrong_lines, 2u) << "nor are they what fare and extras come to";
}

struct WrongLine {
  std::size_t line;
  const char* text;
};
class ReadReceiptsLine : public testing::TestWithParam<WrongLine> {};

TEST_P(ReadReceiptsLine, ThatIsWrongIsSeen) {
  EXPECT_GE(read(both_with(GetParam().line, GetParam().text)).wrong_lines, 1u) << GetParam().text;
}

constexpr WrongLine wrong_lines[] = {
    {0, "TAXI M-TX 448"},
    {1, "Isar Cabs"},
    {3, "Driver B. Driver"},
    {4, "From 2026-11-21 18:03"},
    {4, "From 2026-11-21 18:01"},
    {4, "From 2026-11-22 18:02"},
    {4, "From 2026-13-21 18:02"},
    {5, "To   2026-11-21 18:11"},
    {5, "To   2026-11-21 18:08"},
    {6, "Tariff 2"},
    {7, "Distance           4.22 km"},  // 0.2 % of 4,200 m are 8.4 m
    {7, "Distance           4.17 km"},  // a hundredth is cut off beside them
    {7, "Distance           4.20 m"},
    {8, "Waiting         0:01:11"},
    {8, "Waiting         0:00:58"},
    {8, "Waiting            65 s"},
    {9, "Fare              11.40"},
    {9, "Fare              11.3"},
    {9, "Agreed            11.30"},  // a price that was not agreed
    {10, "Luggage            2.00"},
    {10, "Airport            1.00"},  // it was luggage, and the airport costs 5.00
    {10, "Extras             1.00"},
    {10, "Somebody's advertisement"},
    {11, "TOTAL             12.30 USD"},
    {12, "VAT 7.0 %          0.82"},
    {13, "Paid: cash"},
    {23, "Fare               7.00"}};  // it was agreed
INSTANTIATE_TEST_SUITE_P(Each, ReadReceiptsLine, testing::ValuesIn(wrong_lines));

TEST(ReadReceipts, EachLineThatIsNotThereIsWrong) {
  for (std::size_t line = 0; line < first_receipt().size(); ++line) {
    constexpr std::size_t number = 2;
    if (line == number) continue;
    Lines lines = both();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
    const ReceiptVerdict verdict = read(lines);
    EXPECT_TRUE(verdict.wrong_lines != 0 || verdict.difference != 0) << both()[line];
  }
}

TEST(ReadReceipts, WhatHappensAtTheTurnOfAMinuteMayBeOfEither) {
  EXPECT_EQ(read(both_with(5, "To   2026-11-21 18:09")).wrong_lines, 0u) << "it ended at 18:10:00";
}

TEST(ReadReceipts, WhereTheTariffJustChangesEitherLevelIsRight) {
  std::vector<Trip> trips = two_trips();
  trips.front().levels[1] = {'2', 0};
  EXPECT_EQ(read(both(), trips).wrong_lines, 0u);
  EXPECT_EQ(read(both_with(6, "Tariff 2"), trips).wrong_lines, 0u);
  EXPECT_EQ(read(both_with(6, "Tariff 3"), trips).wrong_lines, 1u);
}

TEST(ReadReceipts, AReceiptOfNoTripIsWrong) {
  Lines lines = both();
  lines.insert(lines.end(), {"TAXI M-TX 447", "Receipt 3", "TOTAL              1.00 EUR"});
  EXPECT_EQ(read(lines).difference, 1'000);
}

TEST(ReadReceipts, OneMayBeMissingOnlyWhereAFaultMayHaveCostIt) {
  EXPECT_EQ(read(first_receipt()).difference, 7'000);
  std::vector<Trip> trips = two_trips();
  trips.front().may_lack_receipt = true;
  EXPECT_EQ(read(first_receipt(), trips).difference, 7'000) << "another one's fault";
  trips.back().may_lack_receipt = true;
  EXPECT_EQ(read(first_receipt(), trips).difference, 0);
}

TEST(ReadReceipts, APieceOfOneIsPassedOverWhereAFaultMayHaveLeftIt) {
  Lines lines = {"TAXI M-TX 447", "Receipt 1", "From 2026-11TAXI M-TX 447"};
  for (const std::string& line : both()) lines.push_back(line);
  EXPECT_NE(read(lines).wrong_lines, 0u);
  std::vector<Trip> trips = two_trips();
  trips.front().may_lack_receipt = true;
  EXPECT_EQ(read(lines, trips).wrong_lines, 0u);
  EXPECT_NE(read(both_with(9, "Fare              99.99"), trips).wrong_lines, 0u)
      << "one that is whole is to be right";
}

TEST(ReadReceipts, WhereAFaultMayHaveCostMetresNoneAreAdded) {
  std::vector<Trip> trips = two_trips();
  trips.front().sure_metres = 3000;
  EXPECT_EQ(read(both_with(7, "Distance           3.00 km"), trips).wrong_lines, 0u);
  EXPECT_EQ(read(both_with(7, "Distance           2.90 km"), trips).wrong_lines, 1u);
  EXPECT_EQ(read(both_with(7, "Distance           4.30 km"), trips).wrong_lines, 1u);
}

/// Francs: Fr. 12.30, of which 7 % in it are 0.805: 0.80 in coins of 0.05.
TEST(ReadReceipts, AreReadInTheTownsCurrency) {
  PaperTruth swiss = truth();
  swiss.currency = {.code = "CHF", .symbol = "Fr.", .leads = true, .coin = 50};
  Lines lines = first_receipt();
  const auto wrong = [&] {
    return judge_receipts(lines, std::vector{two_trips().front()}, swiss).wrong_lines;
  };
  lines.at(11) = "TOTAL       Fr.   12.30";
  EXPECT_EQ(wrong(), 0u);
  lines.at(12) = "VAT 7.0 %          0.75";
  EXPECT_EQ(wrong(), 1u);
}

TEST(ReadReceipts, AnAmountIsReadWithPointAndWithComma) {
  const std::vector<std::string> lines = {"Summe 12,30", "Danke 7.00"};
  EXPECT_TRUE(says_amount(lines, 12'300));
  EXPECT_TRUE(says_amount(lines, 7'000));
  EXPECT_FALSE(says_amount(lines, 12'400));
}

}  // namespace
}  // namespace canvoy::taxi::read_receipts_test
