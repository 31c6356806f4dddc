#include "canvoy/profiles/model/si_unit.hpp"

#include <gtest/gtest.h>

namespace canvoy::si_unit_test {
namespace {

// CiA 303-2, tables of base, supplementary and derived units, and of prefixes.

TEST(SiUnit, HasTheCodesOfBaseUnits) {
  EXPECT_EQ(measure_of(0x01, 0x00), Measure{Unit::metre});
  EXPECT_EQ(measure_of(0x02, 0x00), Measure{Unit::kilogram});
  EXPECT_EQ(measure_of(0x03, 0x00), Measure{Unit::second});
  EXPECT_EQ(measure_of(0x04, 0x00), Measure{Unit::ampere});
}

TEST(SiUnit, HasTheCodesOfDerivedUnits) {
  EXPECT_EQ(measure_of(0x20, 0x00), Measure{Unit::hertz});
  EXPECT_EQ(measure_of(0x21, 0x00), Measure{Unit::newton});
  EXPECT_EQ(measure_of(0x22, 0x00), Measure{Unit::pascal});
  EXPECT_EQ(measure_of(0x24, 0x00), Measure{Unit::watt});
  EXPECT_EQ(measure_of(0x2D, 0x00), Measure{Unit::degree_celsius});
  EXPECT_EQ(measure_of(0x4E, 0x00), Measure{Unit::bar});
}

TEST(SiUnit, PrefixIsAPowerOfTenWithItsSign) {
  EXPECT_EQ(measure_of(0x22, 0x03), (Measure{Unit::pascal, {.numerator = 1000}}));
  EXPECT_EQ(measure_of(0x02, 0xFD), (Measure{Unit::kilogram, {.denominator = 1000}}));
  EXPECT_EQ(measure_of(0x22, 0x09), (Measure{Unit::pascal, {.numerator = 1'000'000'000}}));
  EXPECT_EQ(measure_of(0x22, 0xF7), (Measure{Unit::pascal, {.denominator = 1'000'000'000}}));
}

TEST(SiUnit, SaysNothingOfCodesThatItDoesNotKnow) {
  EXPECT_FALSE(measure_of(0x00, 0x00)) << "without dimension";
  EXPECT_FALSE(measure_of(0x08, 0x00)) << "reserved";
  EXPECT_FALSE(measure_of(0xFF, 0xFF)) << "CiA 417-4, 4.13.4: not used";
  EXPECT_FALSE(measure_of(0x02, 0x0A));
  EXPECT_FALSE(measure_of(0x02, 0xF6));
}

TEST(SiUnit, StandsInTwoBytesOfAnEntry) {
  EXPECT_EQ(measure_of({.index = 0x6480, .sub = 2}, 0xFD02),
            (Measure{Unit::kilogram, {.denominator = 1000}}));
  EXPECT_EQ(measure_of({.index = 0x6560, .first_bit = 16}, 0x0322'FF05),
            (Measure{Unit::pascal, {.numerator = 1000}}));
}

TEST(SiUnit, TakesThePlaceOfTheUnitAndKeepsTheScale) {
  const ValueInfo tenths = {.unit = Unit::kilogram, .scale = {.denominator = 10, .offset = 50}};
  const ValueInfo value = with_measure(tenths, {Unit::newton, {.numerator = 1000}});
  EXPECT_EQ(value.unit, Unit::newton);
  // (120 / 10 + 50 / 10) x 1000
  EXPECT_EQ(to_physical(120, value.scale), 17'000);
}

}  // namespace
}  // namespace canvoy::si_unit_test
