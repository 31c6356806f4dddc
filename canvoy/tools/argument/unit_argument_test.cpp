#include "canvoy/tools/argument/unit_argument.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::filter_unit_test {
namespace {

TEST(FilterUnitTest, KnowsEachUnitOfTheProfilesAsItIsPrinted) {
  for (unsigned i = 1; i < unit_count; ++i) {
    const auto unit = find_filter_unit(symbol(static_cast<Unit>(i)));
    ASSERT_TRUE(unit) << symbol(static_cast<Unit>(i));
    EXPECT_EQ(unit->unit, static_cast<Unit>(i));
    EXPECT_EQ(unit->count, 1);
  }
}

TEST(FilterUnitTest, KnowsWhatCanBeTyped) {
  EXPECT_EQ(find_filter_unit("degC")->unit, Unit::degree_celsius);
  EXPECT_EQ(find_filter_unit("degc")->unit, Unit::degree_celsius);
  EXPECT_EQ(find_filter_unit("us")->unit, Unit::microsecond);
  EXPECT_EQ(find_filter_unit("mV")->count, 1e-3);
  EXPECT_EQ(find_filter_unit("kWh")->count, 1e3);
  EXPECT_FALSE(find_filter_unit("furlong"));
  EXPECT_FALSE(find_filter_unit(""));
}

TEST(FilterUnitTest, ConvertsWhatMeasuresTheSame) {
  EXPECT_DOUBLE_EQ(*conversion(Unit::hour, Unit::second), 3600);
  EXPECT_DOUBLE_EQ(*conversion(Unit::millisecond, Unit::second), 1e-3);
  EXPECT_DOUBLE_EQ(*conversion(Unit::kilometre, Unit::millimetre), 1e6);
  EXPECT_DOUBLE_EQ(*conversion(Unit::metre_per_second, Unit::kilometre_per_hour), 3.6);
  EXPECT_DOUBLE_EQ(*conversion(Unit::millimetre_per_second, Unit::metre_per_second), 1e-3);
  EXPECT_DOUBLE_EQ(*conversion(Unit::percent, Unit::per_mille), 10);
  EXPECT_DOUBLE_EQ(*conversion(Unit::bar, Unit::pascal), 1e5);
  EXPECT_DOUBLE_EQ(*conversion(Unit::volt, Unit::volt), 1);
  EXPECT_FALSE(conversion(Unit::volt, Unit::ampere));
  EXPECT_FALSE(conversion(Unit::metre, Unit::second));
}

}  // namespace
}  // namespace canvoy::tools::filter_unit_test
