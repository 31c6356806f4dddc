#include "canvoy/sim/taxi/read_receipts.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::taxi::read_receipts_test {
namespace {

/// Two trips, of 12.30 and 7.00.
const std::vector<Trip> two_trips = {{.paid = 12'300}, {.paid = 7'000}};
const std::vector<std::string> both = {"Receipt 1", "TOTAL      12.30 EUR", "Receipt 2",
                                       "TOTAL       7.00 EUR"};

TEST(ReadReceipts, ReceiptsThatSayWhatWasPaidAreRight) {
  EXPECT_EQ(difference_of_receipts(both, two_trips, false), 0);
}

TEST(ReadReceipts, EachDifferenceCounts) {
  const std::vector<std::string> lines = {"Receipt 1", "TOTAL 12.00 EUR", "Receipt 2",
                                          "TOTAL 7.10 EUR"};
  EXPECT_NEAR(difference_of_receipts(lines, two_trips, false), 300 + 100, 1e-6);
}

TEST(ReadReceipts, AReceiptOfNoTripIsWrong) {
  std::vector<std::string> lines = both;
  lines.insert(lines.end(), {"Receipt 3", "TOTAL 1.00 EUR"});
  EXPECT_EQ(difference_of_receipts(lines, two_trips, true), 1'000);
}

TEST(ReadReceipts, OneMayBeMissingOnlyWhereAFaultMayHaveCostIt) {
  const std::span<const std::string> first = std::span(both).first(2);
  EXPECT_EQ(difference_of_receipts(first, two_trips, false), 7'000);
  EXPECT_EQ(difference_of_receipts(first, two_trips, true), 0);
}

TEST(ReadReceipts, AnAmountIsReadWithPointAndWithComma) {
  const std::vector<std::string> lines = {"Summe 12,30", "Danke 7.00"};
  EXPECT_TRUE(says_amount(lines, 12'300));
  EXPECT_TRUE(says_amount(lines, 7'000));
  EXPECT_FALSE(says_amount(lines, 12'400));
}

}  // namespace
}  // namespace canvoy::taxi::read_receipts_test
