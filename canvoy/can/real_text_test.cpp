#include "canvoy/can/real_text.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string_view>

namespace canvoy {
namespace {

struct Read {
  double number = -1;
  std::size_t length = 0;
  std::errc error{};
};

template <auto read>
Read read_by(std::string_view text) {
  Read made;
  const auto [rest, error] = read(text.data(), text.data() + text.size(), made.number);
  made.length = static_cast<std::size_t>(rest - text.data());
  made.error = error;
  return made;
}

constexpr auto texts = {"0",
                        "-0",
                        "1.5",
                        "-1.5e3",
                        ".5",
                        "5.",
                        "1e-05",
                        "1e",
                        "12abc",
                        "0x10",
                        "-0X1p",
                        "",
                        "-",
                        "+1",
                        " 1",
                        "inf",
                        "-inf",
                        "nan",
                        "n",
                        "in",
                        "1e400",
                        "-1e400",
                        "1,5",
                        "e5",
                        "--1",
                        "x1",
                        "1x2",
                        "0.1",
                        "1.7976931348623157e308",
                        "4.9e-324"};

TEST(RealText, IsReadByStrtodAsByTheStandardLibrary) {
  for (const std::string_view text : texts) {
    const Read expected = read_by<&real_from_chars>(text);
    const Read read = read_by<&detail::real_by_strtod>(text);
    EXPECT_EQ(read.length, expected.length) << text;
    EXPECT_EQ(read.error, expected.error) << text;
    if (std::isnan(expected.number)) {
      EXPECT_TRUE(std::isnan(read.number)) << text;
    } else {
      EXPECT_EQ(read.number, expected.number) << text;
    }
  }
}

TEST(RealText, LeavesTheNumberWhereThereIsNone) {
  const Read read = read_by<&detail::real_by_strtod>("volts");
  EXPECT_EQ(read.number, -1);
  EXPECT_EQ(read.length, 0U);
  EXPECT_EQ(read.error, std::errc::invalid_argument);
}

TEST(RealText, EndsWhereItsTextEnds) {
  EXPECT_EQ(read_by<&detail::real_by_strtod>(std::string_view("1.25", 3)).number, 1.2);
}

}  // namespace
}  // namespace canvoy
