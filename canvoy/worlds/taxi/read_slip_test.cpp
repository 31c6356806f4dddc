#include "canvoy/worlds/taxi/read_slip.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::taxi::read_slip_test {
namespace {

/// 2026-11-21 18:00, by `date -u`.
constexpr std::int64_t six_in_the_evening = 1'795'284'000;
using Lines = std::vector<std::string>;

/// 4,200 m for 11.30 and 1.00 of extras, 1,500 m for 7.00; 12,000 m from 18:02 to 20:00.
std::vector<Trip> two_trips() {
  return {{.metres = 4200, .metered_fare = 11'300, .extras = 1000},
          {.metres = 1500, .metered_fare = 7'000}};
}
constexpr DrivenShift driven = {.begin = Time(2min), .end = Time(2h), .metres = 12'000};
const Lines slip = {"SHIFT OF M-TX 447",
                    "Isar Taxi",
                    "Driver A. Driver",
                    "From 2026-11-21 18:02",
                    "To   2026-11-21 20:00",
                    "Shift",
                    "Driven            12.00 km",
                    "Hired              5.70 km",
                    "Hirings               2",
                    "Fares             18.30",
                    "Supplements        1.00",
                    "INCOME            19.30 EUR",
                    "All time",
                    "Driven           112.00 km",
                    "Hired             55.70 km",
                    "Hirings              12",
                    "Fares            118.30",
                    "Supplements       11.00",
                    "INCOME           129.30 EUR"};

SlipVerdict read(const Lines& lines) {
  return judge_slip(lines, two_trips(),
                    {.clock = six_in_the_evening,
                     .taxi = "M-TX 447",
                     .company = "Isar Taxi",
                     .driver = "A. Driver"},
                    driven);
}

TEST(ReadSlip, OneThatSaysWhatWasIsRight) {
  EXPECT_EQ(read(slip).wrong_lines, 0u);
  EXPECT_GT(read(slip).lines, slip.size());
}

TEST(ReadSlip, OneThatIsNotThereIsWrong) {
  EXPECT_NE(read({}).wrong_lines, 0u);
  EXPECT_NE(read({"TAXI M-TX 447", "Receipt 2"}).wrong_lines, 0u);
}

TEST(ReadSlip, EachLineThatIsNotThereIsWrong) {
  for (std::size_t line = 0; line < slip.size(); ++line) {
    Lines lines = slip;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
    EXPECT_NE(read(lines).wrong_lines, 0u) << slip[line];
  }
}

struct WrongLine {
  std::size_t line;
  const char* text;
};
class ReadSlipLine : public testing::TestWithParam<WrongLine> {};

TEST_P(ReadSlipLine, ThatIsWrongIsSeen) {
  Lines lines = slip;
  lines.at(GetParam().line) = GetParam().text;
  EXPECT_NE(read(lines).wrong_lines, 0u) << GetParam().text;
}

constexpr WrongLine wrong_lines[] = {{0, "SHIFT OF M-TX 448"},
                                     {1, "Isar Cabs"},
                                     {2, "Driver B. Driver"},
                                     {3, "From 2026-11-21 18:00"},
                                     {4, "To   2026-11-21 20:01"},
                                     {6, "Driven            12.05 km"},  // 0.2 %, and 4 m
                                     {6, "Driven            11.95 km"},
                                     {7, "Hired              5.73 km"},  // 8.4 m, 4 m, and 4 m
                                     {8, "Hirings               3"},
                                     {9, "Fares             18.40"},
                                     {10, "Supplements        0.00"},
                                     {11, "INCOME            19.40 EUR"},
                                     {12, "Shift"},
                                     {13, "Driven            11.00 km"},  // less than the shift
                                     {18, "INCOME            19.20 EUR"},
                                     {18, "Thank you"}};
INSTANTIATE_TEST_SUITE_P(Each, ReadSlipLine, testing::ValuesIn(wrong_lines));

}  // namespace
}  // namespace canvoy::taxi::read_slip_test
