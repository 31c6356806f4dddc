#include "canvoy/tools/value_argument.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools::value_argument_test {
namespace {

TEST(ValueArgument, RefusesWhatItsTypeCannotHold) {
  const auto parse = [](DataType type, std::string_view text) {
    return parse_value(EntryInfo{.type = type}, text);
  };
  EXPECT_THROW(parse(DataType::real32, "1e39"), UsageError);
  EXPECT_THROW(parse(DataType::real32, "-1e39"), UsageError);
  EXPECT_THROW(parse(DataType::unsigned64, "-18446744073709551615"), UsageError);
  EXPECT_THROW(parse(DataType::unsigned8, "-18446744073709551615"), UsageError) << "it is not 1";
  EXPECT_THROW(parse(DataType::integer8, "18446744073709551615"), UsageError) << "it is not -1";
  EXPECT_EQ(parse(DataType::unsigned64, "18446744073709551615"),
            std::vector<std::uint8_t>(8, 0xFF));
  EXPECT_EQ(parse(DataType::integer64, "-9223372036854775808").back(), 0x80);
}

TEST(ValueArgument, IsATimeWhereTheEntryIsOne) {
  const std::vector<std::uint8_t> noon = {0x00, 0x2E, 0x93, 0x02, 0x31, 0x3D};
  constexpr EntryInfo time = {.name = "Time", .type = DataType::time_of_day};
  EXPECT_EQ(parse_value(time, "2026-11-21 12:00"), noon);
  EXPECT_THROW(parse_value(time, "noon"), UsageError);
  constexpr EntryInfo span = {.name = "Span", .type = DataType::time_difference};
  EXPECT_EQ(parse_value(span, "15665 d 12:00"), noon);
  EXPECT_THROW(parse_value(span, "noon"), UsageError);
  EXPECT_EQ(parse_type("t"), DataType::time_of_day);
  EXPECT_EQ(parse_type("td"), DataType::time_difference);
}

}  // namespace
}  // namespace canvoy::tools::value_argument_test
