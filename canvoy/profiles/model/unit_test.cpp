#include "canvoy/profiles/model/unit.hpp"

#include <gtest/gtest.h>

#include <set>

namespace canvoy::unit_test {
namespace {

TEST(Unit, EachHasASymbolOfItsOwn) {
  std::set<std::string_view> symbols;
  for (unsigned i = 0; i < unit_count; ++i) {
    const std::string_view text = symbol(static_cast<Unit>(i));
    EXPECT_EQ(text.empty(), i == 0) << i;
    EXPECT_TRUE(symbols.insert(text).second) << text;
  }
}

TEST(Unit, SymbolsStandBesideTheirNames) {
  EXPECT_EQ(symbol(Unit::degree_celsius), "°C");
  EXPECT_EQ(symbol(Unit::ampere_hour), "Ah");
  EXPECT_EQ(symbol(Unit::millisecond), "ms");
  EXPECT_EQ(symbol(Unit::kilometre_per_hour), "km/h");
  EXPECT_EQ(symbol(Unit::revolution_per_minute), "1/min");
  EXPECT_EQ(symbol(Unit::newton), "N");
  EXPECT_EQ(symbol(Unit::bit_per_second), "bit/s");
  EXPECT_EQ(symbol(Unit::local_distance_per_hour), "LDU/h");
  EXPECT_EQ(symbol(Unit::pixel), "px");
}

TEST(Scale, DecimalsAreExactUpToThree) {
  EXPECT_EQ(decimals({}), 0U);
  EXPECT_EQ(decimals({.numerator = 100}), 0U);
  EXPECT_EQ(decimals({.denominator = 2}), 1U);
  EXPECT_EQ(decimals({.denominator = 8}), 3U);
  EXPECT_EQ(decimals({.denominator = 10}), 1U);
  EXPECT_EQ(decimals({.numerator = -5, .denominator = 100}), 2U);
  EXPECT_EQ(decimals({.denominator = 1000}), 3U);
}

TEST(Scale, DecimalsBeyondThreeTellStepsApart) {
  EXPECT_EQ(decimals({.denominator = 16}), 2U);    // 0.0625, 0.125: 0.06, 0.13
  EXPECT_EQ(decimals({.denominator = 1024}), 4U);  // 0.00098, 0.00195: 0.0010, 0.0020
  EXPECT_EQ(decimals({.denominator = 3}), 1U);
  EXPECT_EQ(decimals({.denominator = 100'000}), 5U);
}

}  // namespace
}  // namespace canvoy::unit_test
