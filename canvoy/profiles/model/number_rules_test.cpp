#include "canvoy/profiles/model/number_rules.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace canvoy::number_rules_test {
namespace {

constexpr NumberRules rules(const ValueInfo& value, unsigned bits, bool with_sign) {
  return {value, BitRange{0, static_cast<std::uint8_t>(bits), with_sign}};
}

TEST(BitRange, ANumberIsTakenOutOfItsBitsAndPutBack) {
  constexpr BitRange middle{4, 8, false};
  EXPECT_EQ(extract(0xABCD, middle), 0xBC);
  EXPECT_EQ(insert(0xABCD, middle, 0x12), 0xA12DU);
  EXPECT_EQ(insert(0xABCD, middle, 0xF12), 0xA12DU) << "what does not fit is cut";
  constexpr BitRange with_sign{4, 8, true};
  EXPECT_EQ(extract(0xABCD, with_sign), -0x44);
  EXPECT_EQ(insert(0, with_sign, -1), 0xFF0U);
  constexpr BitRange all{0, 64, true};
  EXPECT_EQ(extract(~0ULL, all), -1);
  EXPECT_EQ(insert(0, all, -2), ~1ULL);
}

RC_GTEST_PROP(BitRange, InsertAndExtractAreInverse, (std::uint64_t whole, std::int64_t number)) {
  const unsigned first = *rc::gen::inRange(0U, 63U);
  const unsigned bits = *rc::gen::inRange(1U, 65U - first);
  const BitRange range{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(bits),
                       *rc::gen::arbitrary<bool>()};
  const std::uint64_t changed = insert(whole, range, number);
  RC_ASSERT(extract(changed, range) ==
            number_of(static_cast<std::uint64_t>(number), bits, range.is_signed));
  RC_ASSERT(insert(changed, range, extract(whole, range)) == whole);
}

TEST(NumberRules, ARangeIsThatOfTheBitsWhereThereAreNoLimits) {
  EXPECT_EQ(rules({}, 8, false).range().high, 255);
  EXPECT_EQ(rules({}, 8, true).range().low, -128);
  EXPECT_EQ(rules({}, 48, false).range().high, 0xFFFF'FFFF'FFFF);
  EXPECT_EQ(rules({}, 64, true).range().low, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(rules({}, 64, true).range().high, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(rules({}, 1, false).range().high, 1);
}

TEST(NumberRules, AMinimumRangeIsNoLimit) {
  EXPECT_TRUE(rules({.limits = at_least(-320, 680)}, 16, true).is_value(700));
  EXPECT_FALSE(rules({.limits = within(-320, 680)}, 16, true).is_value(700));
}

constexpr NamedValue gaps[] = {{0, "off", Meaning::invalid},
                               {5, 6, "reserved", Meaning::reserved},
                               {7, "broken", Meaning::failure},
                               {8, "eight"},
                               {250, 255, "reserved", Meaning::reserved}};
constexpr NumberRules gapped = rules({.names = gaps}, 8, false);

TEST(NumberRules, NamedStatesAreValuesAndTheOthersAreNot) {
  for (int number = 0; number <= 255; ++number) {
    const bool gap = number == 0 || (number >= 5 && number <= 7) || number >= 250;
    EXPECT_EQ(gapped.is_value(number), !gap) << number;
  }
  EXPECT_EQ(gapped.invalid(), 0);
}

TEST(NumberRules, GapsArePassedOverToTheNearerSide) {
  EXPECT_EQ(gapped.nearest(5.4), 4);
  EXPECT_EQ(gapped.nearest(5.9), 4);
  EXPECT_EQ(gapped.nearest(6.0), 4) << "equally near: nearer to 0";
  EXPECT_EQ(gapped.nearest(6.1), 8);
  EXPECT_EQ(gapped.nearest(0), 1) << "there is nothing below";
  EXPECT_EQ(gapped.nearest(1000), 249) << "there is nothing above";
  EXPECT_EQ(gapped.nearest(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(NumberRules, EquallyNearBelow0IsNearerTo0) {
  constexpr NamedValue sentinel[] = {{-10, "none", Meaning::invalid}};
  EXPECT_EQ(rules({.names = sentinel}, 16, true).nearest(-10), -9);
}

TEST(NumberRules, ASentinelMayBeWrittenAsItsBitPattern) {
  constexpr NamedValue sentinel[] = {{0x8000, "none", Meaning::invalid}};
  constexpr NumberRules sixteen = rules({.names = sentinel}, 16, true);
  EXPECT_EQ(sixteen.invalid(), -32768);
  EXPECT_EQ(sixteen.nearest(-1e9), -32767);
}

TEST(NumberRules, ScalesAreAppliedExactly) {
  // 0.5 degrees a bit, from -50 degrees on.
  constexpr NumberRules cabin = rules({.scale = {.denominator = 2, .offset = -100}}, 8, false);
  EXPECT_EQ(cabin.physical(0), -50.0);
  EXPECT_EQ(cabin.physical(255), 77.5);
  EXPECT_EQ(cabin.nearest(21.3), 143);
  // 100 microseconds a bit.
  constexpr NumberRules inhibit = rules({.scale = {.numerator = 100}}, 16, false);
  EXPECT_EQ(inhibit.physical(7), 700.0);
  EXPECT_EQ(inhibit.nearest(749), 7);
  EXPECT_EQ(inhibit.nearest(751), 8);
  // Falling: 100 minus the raw number.
  constexpr NumberRules falling = rules({.scale = {.numerator = -1, .offset = 100}}, 8, false);
  EXPECT_EQ(falling.physical(30), 70.0);
  EXPECT_EQ(falling.nearest(70), 30);
}

// Latitude as in CiA 447-3, 4.2.10.1.
constexpr Piece latitude_pieces[] = {
    {.first = 0, .last = 0x35A4'E900, .scale = {.denominator = 10'000'000}, .name = "north"},
    {.first = 0x35A4'E901,
     .last = 0x6B49'D200,
     .scale = {.numerator = -1, .denominator = 10'000'000, .offset = 900'000'000},
     .name = "south"}};
constexpr NumberRules latitude =
    rules({.limits = within(0, 0x6B49'D200), .pieces = latitude_pieces}, 32, false);

TEST(NumberRules, EachPieceHasItsOwnScale) {
  EXPECT_EQ(latitude.physical(0), 0.0);
  EXPECT_DOUBLE_EQ(latitude.physical(1).value_or(1e9), 0.0000001);
  EXPECT_EQ(latitude.physical(0x35A4'E900), 90.0);
  EXPECT_DOUBLE_EQ(latitude.physical(0x35A4'E901).value_or(1e9), -0.0000001);
  EXPECT_EQ(latitude.physical(0x6B49'D200), -90.0);
  EXPECT_EQ(latitude.physical(0x6B49'D201), std::nullopt);
}

TEST(NumberRules, AValueComesDownInThePieceThatReachesIt) {
  EXPECT_EQ(latitude.nearest(48.1234567), 481'234'567);
  EXPECT_EQ(latitude.nearest(-33.8567844), 1'238'567'844);
  EXPECT_EQ(latitude.nearest(-0.00000001), 0) << "nearer to 0 than to the first step south";
  EXPECT_EQ(latitude.nearest(-0.0000001), 0x35A4'E901);
  EXPECT_EQ(latitude.nearest(90), 0x35A4'E900);
  EXPECT_EQ(latitude.nearest(-90), 0x6B49'D200);
}

TEST(NumberRules, BeyondAllPiecesTheNearestEndIsSent) {
  EXPECT_EQ(latitude.nearest(91), 0x35A4'E900);
  EXPECT_EQ(latitude.nearest(-91), 0x6B49'D200);
  EXPECT_EQ(latitude.physical_range(), std::pair(-90.0, 90.0));
  EXPECT_GT(latitude.exact(91), 0x6B49'D200 + 0.5) << "and who does not repair refuses it";
  EXPECT_LT(latitude.exact(-91), -0.5);
}

RC_GTEST_PROP(NumberRules, WhatIsSentIsReadBackWithinHalfAStep, (std::int16_t tenths)) {
  constexpr NumberRules eighths = rules({.scale = {.denominator = 8}}, 16, true);
  const double wanted = tenths / 10.0;
  const double got = eighths.physical(eighths.nearest(wanted)).value_or(1e9);
  RC_ASSERT(std::abs(got - wanted) <= 0.0625);
}

}  // namespace
}  // namespace canvoy::number_rules_test
