#include "canvoy/text/entry_signals.hpp"

#include <gtest/gtest.h>

namespace canvoy::text {
namespace entry_signals_test {

using formats::Signal;

constexpr NamedValue states[] = {
    {0, "closed"}, {1, "open"}, {0xF0, 0xFF, "reserved", Meaning::reserved}};

TEST(EntrySignals, ANumberHasItsScaleItsUnitAndItsLimits) {
  const EntryInfo entry = {
      .type = DataType::integer16,
      .value = {
          .unit = Unit::degree_celsius, .scale = {.denominator = 8}, .limits = within(-320, 680)}};
  const auto signals = entry_signals("temperature", entry);
  ASSERT_EQ(signals.size(), 1U);
  EXPECT_EQ(signals[0].bits, 16U);
  EXPECT_EQ(signals[0].type, Signal::Type::signed_number);
  EXPECT_EQ(signals[0].factor, 0.125);
  EXPECT_EQ(signals[0].unit,
            "\xC2\xB0"
            "C");
  EXPECT_EQ(signals[0].limits, (std::pair{-40.0, 85.0}));
}

TEST(EntrySignals, ReservedStatesAreNoStates) {
  const auto signals =
      entry_signals("door", {.type = DataType::unsigned8, .value = {.names = states}});
  ASSERT_EQ(signals.at(0).states.size(), 2U);
  EXPECT_EQ(signals[0].states[1].name, "open");
}

TEST(EntrySignals, EachFieldIsASignalAndBitsThatMeanSeveralThingsAreANumber) {
  static constexpr FieldCondition when_1 = {.field = "kind", .first = 1, .last = 1};
  static constexpr FieldCondition when_2 = {.field = "kind", .first = 2, .last = 2};
  static constexpr FieldInfo fields[] = {
      {.first_bit = 0, .bits = 4, .name = "kind"},
      {.first_bit = 4, .bits = 2, .name = "floor", .when = when_1},
      {.first_bit = 5, .bits = 3, .name = "door", .when = when_2},
      {.first_bit = 12, .bits = 4, .name = "load", .is_signed = true}};
  const auto signals = entry_signals("input", {.type = DataType::unsigned16, .fields = fields});
  ASSERT_EQ(signals.size(), 3U);
  EXPECT_EQ(signals[0].name, "input, kind");
  EXPECT_EQ(signals[1].name, "input, bits 4 to 7");
  EXPECT_EQ(signals[1].first_bit, 4U);
  EXPECT_EQ(signals[1].bits, 4U);
  EXPECT_EQ(signals[2].type, Signal::Type::signed_number);
}

TEST(EntrySignals, TextsAreNoNumbers) {
  EXPECT_TRUE(entry_signals("name", {.type = DataType::visible_string}).empty());
  EXPECT_EQ(entry_signals("gain", {.type = DataType::real32}).at(0).type, Signal::Type::real32);
}

}  // namespace entry_signals_test
}  // namespace canvoy::text
