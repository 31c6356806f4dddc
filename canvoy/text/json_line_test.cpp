#include "canvoy/text/json_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <type_traits>

namespace canvoy::text::json_line_test {
namespace {

std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
std::string written(auto value) {
  std::string line;
  if constexpr (std::is_arithmetic_v<decltype(value)>) {
    JsonLine(line).number(value);
  } else {
    JsonLine(line).text(value);
  }
  return line;
}

TEST(JsonLine, PutsCommasBetweenMembersAndElements) {
  std::string line = "the line before\n";
  JsonLine json(line);
  json.begin_object();
  json.key("node").number(10);
  json.key("empty").begin_object();
  json.end_object();
  json.key("list").begin_list();
  json.number(std::uint8_t{1});
  json.text("[:{,");
  json.null();
  json.begin_list();
  json.end_list();
  json.end_list();
  json.written("");
  json.written(R"("more":true)");
  json.key("raw").hex(std::array<std::uint8_t, 3>{0x00, 0xA9, 0xFF});
  json.end_object();
  EXPECT_EQ(line,
            "the line before\n"
            R"({"node":10,"empty":{},"list":[1,"[:{,",null,[]],"more":true,"raw":"00A9FF"})");
}

TEST(JsonLine, EscapesAsRfc8259Says) {
  // The quotation mark, the reverse solidus, and U+0000 to U+001F (RFC 8259, 7).
  EXPECT_EQ(written(std::string_view("a\"b\\c/")), R"("a\"b\\c/")");
  EXPECT_EQ(written(std::string_view("\b\t\n\f\r")), R"("\b\t\n\f\r")");
  EXPECT_EQ(written(std::string_view("\0\x1B\x1F\x7F", 4)), "\"\\u0000\\u001b\\u001f\x7F\"");
  EXPECT_EQ(written(std::string_view("20 °C \"Prüfer\"")), R"("20 °C \"Prüfer\"")");
  std::string line;
  JsonLine(line).key("a\"b").null();
  EXPECT_EQ(line, R"("a\"b":null)");
}

TEST(JsonLine, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(written(std::string_view("Pr\xFC\"fer")), "\"Pr\uFFFD\\\"fer\"");
  EXPECT_EQ(written(std::string_view("\n\xC2")), "\"\\n\uFFFD\"");
}

TEST(JsonLine, WritesTextsAsTheLibraryDoes) {
  for (int c = 0; c < 256; ++c) {
    const std::string text{'x', static_cast<char>(c), 'y'};
    EXPECT_EQ(written(std::string_view(text)), dumped(text)) << c;
  }
  std::mt19937 random(1);
  constexpr std::array<std::string_view, 16> pieces = {
      "a",      "\"",         "\\",           "\n",       "\x1F", "\x7F",     "°",    "\u0085",
      "\u2028", "\U0001F600", "\xED\xA0\x80", "\xC0\x80", "\x80", "\xE2\x82", "\xF5", "\uFFFD"};
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (std::uint64_t left = random() % 6; left > 0; --left)
      text += pieces.at(random() % pieces.size());
    ASSERT_EQ(written(std::string_view(text)), dumped(text));
  }
}

TEST(JsonLine, WritesNumbersAsTheLibraryDoes) {
  EXPECT_EQ(written(20.0), "20.0");
  EXPECT_EQ(written(-0.125), "-0.125");
  EXPECT_EQ(written(1e300), "1e+300");
  EXPECT_EQ(written(std::nan("")), "null");
  EXPECT_EQ(written(-std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(written(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(written(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto bits = random();
    const auto number = std::bit_cast<double>(bits);
    ASSERT_EQ(written(number), dumped(number)) << bits;
    const double scaled = static_cast<double>(static_cast<std::int32_t>(bits)) / 1000;
    ASSERT_EQ(written(scaled), dumped(scaled));
    const double time = static_cast<double>(bits >> 13) / 1'000'000;
    ASSERT_EQ(written(time), dumped(time));
  }
}

}  // namespace
}  // namespace canvoy::text::json_line_test
