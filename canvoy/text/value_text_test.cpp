#include "canvoy/text/value_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::value_text_test {
namespace {

EntryInfo number_entry(DataType type, Scale scale, Unit unit = Unit::none) {
  return {.type = type, .value = {.unit = unit, .scale = scale}};
}
std::string text_of(const EntryInfo& entry, std::int64_t raw) {
  std::array<std::uint8_t, 8> bytes{};
  store(bytes.data(), static_cast<std::uint64_t>(raw));
  return value_text(&entry, std::span(bytes).first(byte_length(entry.type)));
}

std::string json_of(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  std::string json;
  append_value_json(json, &entry, bytes);
  return json;
}

TEST(ValueText, HasAsManyDecimalsAsTheStepNeeds) {
  const EntryInfo eighths = number_entry(DataType::integer16, {.denominator = 8}, Unit::volt);
  EXPECT_EQ(text_of(eighths, 1), "0.125 V");
  EXPECT_EQ(text_of(eighths, -1), "-0.125 V");
  EXPECT_EQ(text_of(eighths, -8), "-1.000 V");
  EXPECT_EQ(text_of(eighths, 0), "0.000 V");
  EXPECT_EQ(text_of(number_entry(DataType::unsigned8, {.numerator = 5}), 3), "15");
  EXPECT_EQ(text_of(number_entry(DataType::unsigned8, {.offset = -40}), 0), "-40");
}

TEST(ValueText, IsRoundedToTheNearestAndToTheEvenOneOfTwo) {
  // 4 decimals distinguish steps of 1/1024: 0.00048828125, 0.0009765625; 0.03125 lies in the
  // middle.
  const EntryInfo small = number_entry(DataType::integer32, {.denominator = 1024});
  EXPECT_EQ(text_of(small, 1), "0.0010");
  EXPECT_EQ(text_of(small, -1), "-0.0010");
  EXPECT_EQ(text_of(small, 32), "0.0312");
  EXPECT_EQ(text_of(small, -32), "-0.0312");
  EXPECT_EQ(text_of(small, 96), "0.0938");
  EXPECT_EQ(text_of(number_entry(DataType::unsigned8, {.denominator = 3}), 2), "0.7");
}

TEST(ValueText, LivesWithTheLargestNumbers) {
  constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
  const EntryInfo whole = number_entry(DataType::integer64, {});
  EXPECT_EQ(text_of(whole, std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
  EXPECT_EQ(text_of(whole, low), "-9223372036854775808");
  const EntryInfo scaled = number_entry(DataType::integer64, {.numerator = 1000});
  EXPECT_EQ(text_of(scaled, low).substr(0, 6), "-92233");
}

TEST(ValueText, ShowsARealWithTheDigitsThatItHas) {
  const EntryInfo small{.type = DataType::real32};
  const EntryInfo large{.type = DataType::real64};
  const auto bytes = [](auto number) {
    std::vector<std::uint8_t> made(sizeof number);
    store(made.data(), number);
    return made;
  };
  EXPECT_EQ(value_text(&small, bytes(1.5F)), "1.5");
  EXPECT_EQ(value_text(&small, bytes(0.1F)), "0.1");
  EXPECT_EQ(value_text(&small, bytes(-3e38F)), "-3e+38");
  EXPECT_EQ(value_text(&large, bytes(0.1)), "0.1");
  EXPECT_EQ(json_of(small, bytes(1.5F)), "1.5") << "not its bits";
  EXPECT_EQ(json_of(large, bytes(-2.0)), "-2.0");
}

/// True if the text is the number with `digits` decimals, to half of the last one.
bool is_number(const std::string& text, double number, unsigned digits) {
  const std::size_t point = text.find('.');
  const std::size_t end = text.find(' ');
  const std::size_t length = end == std::string::npos ? text.size() : end;
  const std::size_t given = point == std::string::npos ? 0 : length - point - 1;
  const double half = 0.5 * std::pow(10.0, -static_cast<double>(digits));
  return given == digits &&
         std::abs(std::strtod(text.c_str(), nullptr) - number) <= half * (1 + 1e-6);
}

TEST(ValueText, IsTheNumberOfEachEntryOfEachProfile) {
  std::size_t compared = 0;
  for (const Profile* profile : all_profiles()) {
    for (const ObjectInfo* object : profile->objects) {
      for (const EntryInfo& entry : object->entries()) {
        if (!entry.fields.empty() || !is_integer(entry.type) || bit_length(entry.type) > 32 ||
            entry.value.notation != Notation::number) {
          continue;
        }
        for (std::uint64_t raw = 1; raw < std::uint64_t{1} << bit_length(entry.type);
             raw = raw * 3 + 1) {
          std::array<std::uint8_t, 8> bytes{};
          store(bytes.data(), raw);
          const auto value = std::span(bytes).first(byte_length(entry.type));
          const Reading reading = read_value(entry, value);
          if (reading.kind != Reading::Kind::number) continue;
          const unsigned digits = decimals(scale_of(entry.value, reading.raw));
          ASSERT_TRUE(is_number(value_text(&entry, value), reading.number, digits))
              << object->name << ": " << value_text(&entry, value) << " for " << reading.number;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace canvoy::text::value_text_test
