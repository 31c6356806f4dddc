#include "canvoy/tools/argument/value_argument.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"

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

/// 1017h is in ms (CiA 301); 6010h has 0.125 °C per step (CiA 418).
const EntryInfo& heartbeat = *find_address(base_profile(), "1017")->entry;
const EntryInfo& temperature = *find_address(cia418::profile, "6010")->entry;

using Bytes = std::vector<std::uint8_t>;

TEST(ValueArgument, IsInAnyUnitThatMeasuresTheSame) {
  for (const char* text : {"1500", "1500 ms", "1500ms", "1.5s", "1s 500ms", "1.5 s", "0x5DC"}) {
    EXPECT_EQ(parse_value(heartbeat, text), (Bytes{0xDC, 0x05})) << text;
  }
  EXPECT_EQ(parse_value(temperature, "21.5 degC"), (Bytes{0xAC, 0x00}));
  EXPECT_EQ(parse_value(temperature, "0xAC"), (Bytes{0xAC, 0x00})) << "the stored number";
  EXPECT_THROW(parse_value(temperature, "5 V"), UsageError);
  EXPECT_THROW(parse_value(temperature, "0x10000"), UsageError);
}

std::string complaint_of(const EntryInfo& entry, std::string_view text) {
  try {
    parse_value(entry, text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(ValueArgument, IsNeverRoundedUnseen) {
  EXPECT_EQ(complaint_of(heartbeat, "500.5"),
            "'500.5' cannot be stored exactly: 500 ms or 501 ms can");
  EXPECT_EQ(complaint_of(temperature, "21.3"),
            "'21.3' cannot be stored exactly: 21.250 °C or 21.375 °C can");
  EXPECT_EQ(complaint_of(EntryInfo{.type = DataType::unsigned8}, "1.5"),
            "'1.5' cannot be stored exactly: 1 or 2 can");
  EXPECT_EQ(complaint_of(heartbeat, "0.0000001h"),
            "'0.0000001h' cannot be stored exactly: 0 ms or 1 ms can");
  EXPECT_EQ(complaint_of(heartbeat, "9.5"), "'9.5' cannot be stored exactly: 9 ms or 10 ms can");
  EXPECT_EQ(parse_value(temperature, "21.375"), (Bytes{0xAB, 0x00}));
  // 0.1 has no exact binary fraction, but is exactly one step of a tenth.
  constexpr EntryInfo tenths = {.type = DataType::unsigned16, .value = {.scale = {1, 10}}};
  for (unsigned raw = 0; raw < 2000; ++raw) {
    const std::string text = std::to_string(raw / 10) + "." + std::to_string(raw % 10);
    EXPECT_EQ(complaint_of(tenths, text), "none") << text;
  }
}

TEST(ValueArgument, OfSeveralFieldsIsWrittenAsItIsPrinted) {
  constexpr FieldInfo fields[] = {{.first_bit = 0, .bits = 4, .name = "speed"},
                                  {.first_bit = 4, .bits = 4, .name = "level"}};
  const EntryInfo entry = {.type = DataType::unsigned8, .fields = fields};
  EXPECT_EQ(parse_value(entry, "speed: 3, level: 10"), Bytes{0xA3});
  EXPECT_EQ(parse_value(entry, "level: 2", 0xA3), Bytes{0x23}) << "the other stays as it is";
  EXPECT_EQ(parse_value(entry, "0x5A"), Bytes{0x5A});
  EXPECT_THROW(parse_value(entry, "speed: 16"), UsageError);
  EXPECT_THROW(parse_value(entry, "sped: 1"), UsageError);
  EXPECT_THROW(parse_value(entry, "speed: 1, 2"), UsageError);
}

TEST(ValueArgument, OfATextMayStandInQuotes) {
  constexpr EntryInfo text = {.type = DataType::visible_string};
  EXPECT_EQ(parse_value(text, "\"ab\""), (Bytes{'a', 'b'}));
  EXPECT_EQ(parse_value(text, "\""), Bytes{'"'});
}

TEST(ValueArgument, TypesAreSpeltAsInCia309Cia301CAndPython) {
  for (const char* text : {"u16", "U16", "UNSIGNED16", "unsigned16", "uint16", "uint16_t"}) {
    EXPECT_EQ(parse_type(text), DataType::unsigned16) << text;
  }
  EXPECT_EQ(parse_type("INTEGER8"), DataType::integer8);
  EXPECT_EQ(parse_type("int64_t"), DataType::integer64);
  EXPECT_EQ(parse_type("REAL32"), DataType::real32);
  EXPECT_EQ(parse_type("VISIBLE_STRING"), DataType::visible_string);
  EXPECT_EQ(parse_type("string"), DataType::visible_string);
  for (const char* text : {"", "u", "u7", "uint", "16", "unsigned 16", "reals"}) {
    EXPECT_FALSE(parse_type(text)) << text;
  }
}

}  // namespace
}  // namespace canvoy::tools::value_argument_test
