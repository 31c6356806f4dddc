#include "canvoy/sim/taxi/read_receipts.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::taxi::read_receipts_test {
namespace {

/// 2026-11-21 18:00, by `date -u`.
constexpr std::int64_t six_in_the_evening = 1'795'284'000;

/// Two trips: 4,200 m from 18:02:30 to 18:10:00 for 11.30 and 1.00 of extras; 1,500 m from 18:20 to
/// 18:25 for 7.00.
std::vector<Trip> two_trips() {
  return {{.begin = Time(150s),
           .end = Time(600s),
           .metres = 4200,
           .sure_metres = 4200,
           .metered_fare = 11'300,
           .paid = 12'300,
           .pressed_extras = 1000},
          {.begin = Time(20min),
           .end = Time(25min),
           .metres = 1500,
           .sure_metres = 1500,
           .metered_fare = 7'000,
           .paid = 7'000}};
}
using Lines = std::vector<std::string>;
Lines first_receipt() {
  return {"TAXI M-TX 447",
          "Receipt 1",
          "From 2026-11-21 18:02",
          "To   2026-11-21 18:10",
          "Distance     4.20 km",
          "Fare           11.30",
          "Extras          1.00",
          "TOTAL          12.30",
          "EUR"};
}
Lines second_receipt() {
  return {"TAXI M-TX 447",         "Receipt 2",
          "From 2026-11-21 18:20", "To   2026-11-21 18:25",
          "Distance     1.50 km",  "Fare            7.00",
          "TOTAL           7.00",  "EUR"};
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
  return judge_receipts(lines, trips, six_in_the_evening);
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

TEST(ReadReceipts, EachTotalThatIsNotWhatWasPaidCounts) {
  Lines lines = both_with(7, "TOTAL          12.00");
  lines.at(15) = "TOTAL           7.10";
  EXPECT_NEAR(read(lines).difference, 300 + 100, 1e-6);
  EXPECT_EQ(read(lines).wrong_lines, 2u) << "nor are they what fare and extras come to";
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
    {2, "From 2026-11-21 18:03"}, {2, "From 2026-11-21 18:01"},   {2, "From 2026-11-22 18:02"},
    {2, "From 2026-13-21 18:02"}, {3, "To   2026-11-21 18:11"},   {3, "To   2026-11-21 18:08"},
    {4, "Distance     4.22 km"},  // 0.2 % of 4,200 m are 8.4 m
    {4, "Distance     4.17 km"},  // a hundredth is cut off beside them
    {4, "Distance     4.20 m"},   {5, "Fare           11.40"},    {5, "Fare           11.3"},
    {6, "Extras          2.00"},  {6, "Somebody's advertisement"}};
INSTANTIATE_TEST_SUITE_P(Each, ReadReceiptsLine, testing::ValuesIn(wrong_lines));

TEST(ReadReceipts, ALineThatIsNotThereIsWrong) {
  Lines lines = both();
  lines.erase(lines.begin() + 4);
  EXPECT_EQ(read(lines).wrong_lines, 1u);
}

TEST(ReadReceipts, WhatHappensAtTheTurnOfAMinuteMayBeOfEither) {
  EXPECT_EQ(read(both_with(3, "To   2026-11-21 18:09")).wrong_lines, 0u) << "it ended at 18:10:00";
}

TEST(ReadReceipts, AReceiptOfNoTripIsWrong) {
  Lines lines = both();
  lines.insert(lines.end(), {"TAXI M-TX 447", "Receipt 3", "TOTAL           1.00"});
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
  EXPECT_NE(read(both_with(5, "Fare           99.99"), trips).wrong_lines, 0u)
      << "one that is whole is to be right";
}

TEST(ReadReceipts, WhereAFaultMayHaveCostMetresNoneAreAdded) {
  std::vector<Trip> trips = two_trips();
  trips.front().sure_metres = 3000;
  EXPECT_EQ(read(both_with(4, "Distance     3.00 km"), trips).wrong_lines, 0u);
  EXPECT_EQ(read(both_with(4, "Distance     2.90 km"), trips).wrong_lines, 1u);
  EXPECT_EQ(read(both_with(4, "Distance     4.30 km"), trips).wrong_lines, 1u);
}

TEST(ReadReceipts, AnAmountIsReadWithPointAndWithComma) {
  const std::vector<std::string> lines = {"Summe 12,30", "Danke 7.00"};
  EXPECT_TRUE(says_amount(lines, 12'300));
  EXPECT_TRUE(says_amount(lines, 7'000));
  EXPECT_FALSE(says_amount(lines, 12'400));
}

}  // namespace
}  // namespace canvoy::taxi::read_receipts_test
