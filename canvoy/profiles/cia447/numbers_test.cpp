// CiA 447-3: numbers with their units, typed from the text: the ends of the ranges, and what the
// clauses calculate themselves.
#include <gtest/gtest.h>

#include <optional>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/number_rules.hpp"

namespace canvoy::numbers_test {
namespace {

struct Measured {
  unsigned index;
  unsigned sub;
  const char* field;  ///< empty: the whole entry
  std::int64_t raw;
  double physical;
  Unit unit;
};
constexpr Measured numbers[] = {
    {0x6005, 0, "", 0x64, 100, Unit::percent},
    {0x6006, 0, "", 0x00, 0, Unit::percent},
    {0x601C, 0, "steering wheel angle", 0x3800, 1433.6, Unit::degree},
    {0x6020, 0, "", 0x00, -50, Unit::degree_celsius},
    {0x6020, 0, "", 0xFD, 76.5, Unit::degree_celsius},
    {0x6021, 0, "", 0xFD, 76.5, Unit::degree_celsius},
    {0x6031, 0, "", 0x64, 100, Unit::percent},
    {0x6049, 0, "", 0x01, 1, Unit::percent},
    {0x6050, 0, "actual engine revolutions", 0x3FFD, 16381, Unit::revolution_per_minute},
    {0x6053, 0, "", 0x3FFE, 8191, Unit::revolution_per_minute},
    {0x6055, 0, "wheel pulse counter", 0xFFFF, 65535, Unit::none},
    {0x6056, 0, "wheel pulse counter overrun value", 0xFFFF, 65535, Unit::none},
    {0x6057, 0, "", 0x15, 21, Unit::none},
    {0x605A, 0, "", 0x0FFE, 409.4, Unit::local_distance_per_hour},
    {0x605B, 0, "", 0x98'967F, 999'999.9, Unit::local_distance},
    {0x605C, 0, "tank level", 0xC8, 200, Unit::litre},
    {0x605D, 0, "current average fuel consumption", 0x7F00, 32.512, Unit::fuel_unit_per_second},
    {0x6096, 1, "", 0x00, 1, Unit::none},  // A6
    {0x6096, 2, "", 0xFD, 254, Unit::none},
    {0x609B, 3, "", 0x13, 20, Unit::none},
    {0x60B0, 1, "", 0x0000'0001, 0.0000001, Unit::degree},  // Z36
    {0x60B0, 1, "", 0x35A4'E900, 90, Unit::degree},
    {0x60B0, 1, "", 0x35A4'E901, -0.0000001, Unit::degree},
    {0x60B0, 1, "", 0x6B49'D200, -90, Unit::degree},
    {0x60B0, 2, "", 0x6B49'D200, 180, Unit::degree},
    {0x60B0, 2, "", 0x6B49'D201, -0.0000001, Unit::degree},
    {0x60B0, 2, "", 0xD693'A400, -180, Unit::degree},
    {0x60B1, 0, "tracked satellites", 0xD, 13, Unit::none},
    {0x60B2, 0, "GPS hdop", 0x50, 80, Unit::none},  // Z27
    {0x60B3, 0, "GPS date year", 2026, 2026, Unit::year},
    {0x60B3, 0, "GPS date month", 0xC, 12, Unit::month},
    {0x60B3, 0, "GPS date day", 0x1F, 31, Unit::day},
    {0x60B4, 0, "GPS UTC hour", 0x17, 23, Unit::hour},
    {0x60B4, 0, "GPS UTC minute", 0x3B, 59, Unit::minute},
    {0x60B4, 0, "GPS UTC second", 0x176F, 59.99, Unit::second},
    {0x60B5, 1, "", 0xFFFD, 655.33, Unit::metre_per_second},
    {0x60B5, 2, "", 0x0E0F, 359.9, Unit::degree},
    {0x60B6, 0, "", 0x0000, -1000, Unit::metre},
    {0x60B6, 0, "", 0x0E0F, 2599, Unit::metre},
    {0x60B6, 0, "", 0x16A8, 4800, Unit::metre},  // Z26
    {0x60C0, 0, "", 0xFFFC, 6553.2, Unit::kilometre},
    {0x60C1, 1, "", 0x6B49'D200, -90, Unit::degree},
    {0x60C3, 2, "", 0xD693'A400, -180, Unit::degree},
    {0x60D0, 1, "", 12'340, 12.34, Unit::local_currency},
    {0x60D1, 0, "", 0xFFFF'FFFD, 4'294'967.293, Unit::local_distance},
    {0x60D2, 1, "", 3600, 3600, Unit::second},
    {0x60D4, 1, "", 36'000, 36, Unit::local_currency_per_hour},
    {0x60D4, 2, "", 2'200, 2.2, Unit::local_currency_per_distance},
    {0x60D9, 4, "", 1500, 1.5, Unit::local_distance},
    {0x60D9, 5, "", 1500, 1.5, Unit::local_currency},
    {0x60D9, 8, "", 7, 7, Unit::none},
    {0x60D9, 12, "", 1500, 1.5, Unit::local_currency},
    {0x60DA, 1, "", 1000, 1000, Unit::pulse_per_local_distance},
    {0x60DA, 7, "", 0xFFFF, 65535, Unit::none},
    {0x60DB, 0, "taxi trip data sequence counter", 0xFD, 253, Unit::none},
    {0x60E2, 0, "logo number", 0x14, 20, Unit::none},
    {0x60E2, 0, "ltff", 5, 5, Unit::none},
    {0x60E3, 4, "", 0xFD, 253, Unit::pixel},
    {0x60E3, 3, "", 0x28, 40, Unit::none},
    {0x60E4, 1, "", 0x0180, 384, Unit::pixel},
    {0x60E5, 0, "width of used font", 0xFC, 252, Unit::pixel},
    {0x60E6, 0, "number of chars per line", 0xFD, 253, Unit::none},
    {0x60F0, 0, "RTC date day", 0x1F, 31, Unit::day},
    {0x60F2, 0, "RTC second", 0x0000, 0, Unit::second},  // Z07
    {0x60F3, 0, "RTC second", 0x176F, 59.99, Unit::second},
    {0x60F4, 0, "offset from UTC", 0x00, -12, Unit::hour},
    {0x60F4, 0, "offset from UTC", 0x01, -11.75, Unit::hour},
    {0x60F4, 0, "offset from UTC", 0x2F, -0.25, Unit::hour},
    {0x60F4, 0, "offset from UTC", 0x30, 0, Unit::hour},
    {0x60F4, 0, "offset from UTC", 0x67, 13.75, Unit::hour},
    {0x60F4, 0, "offset from UTC", 0x68, 14, Unit::hour},
    {0x60FC, 2, "", 1'700'000'000, 1'700'000'000, Unit::second},
    {0x6100, 0, "number of lamps/lights", 0x10, 16, Unit::none},
    {0x6100, 0, "tlc", 2, 2, Unit::none},
    {0x6120, 0, "audio input channel", 0x10, 16, Unit::none},
    {0x6120, 0, "gain", 0xFD, 253, Unit::none},
    {0x6122, 0, "", 0x01, 1, Unit::none},
    {0x613A, 1, "sound volume", 0x3C, 61, Unit::none},  // Z09
    {0x613B, 1, "sound volume", 0x3D, 62, Unit::none},
};

struct Bits {
  const ValueInfo* value = nullptr;
  BitRange range;
};
Bits find_bits(const EntryInfo& entry, std::string_view name) {
  if (name.empty()) return {&entry.value, bits_of(entry)};
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return {&field.value, bits_of(field)};
  }
  return {};
}
std::optional<Bits> find_bits(unsigned index, unsigned sub, std::string_view name) {
  const ObjectInfo* object = find_object(cia447::profile, index);
  const EntryInfo* entry = object == nullptr ? nullptr : find_entry(*object, sub);
  if (entry == nullptr) return std::nullopt;
  const Bits bits = find_bits(*entry, name);
  return bits.value == nullptr ? std::nullopt : std::optional(bits);
}

TEST(Cia447Numbers, HaveTheirUnitAndScale) {
  for (const Measured& measured : numbers) {
    SCOPED_TRACE(testing::Message() << std::hex << measured.index << "h:" << measured.sub << " "
                                    << measured.field << " " << measured.raw);
    const auto bits = find_bits(measured.index, measured.sub, measured.field);
    ASSERT_TRUE(bits);
    EXPECT_EQ(bits->value->unit, measured.unit);
    const NumberRules rules(*bits->value, bits->range);
    const std::optional<double> physical = rules.physical(measured.raw);
    ASSERT_TRUE(physical);
    EXPECT_DOUBLE_EQ(*physical, measured.physical);
    EXPECT_EQ(rules.nearest(measured.physical), measured.raw);
  }
}

struct Beyond {
  unsigned index;
  unsigned sub;
  const char* field;
  std::int64_t last;  ///< the highest number; the next code is none
};
constexpr Beyond ends[] = {
    {0x6005, 0, "", 0x64},
    {0x601C, 0, "steering wheel angle", 0x3800},
    {0x6020, 0, "", 0xFD},
    {0x6053, 0, "", 0x3FFE},
    {0x605B, 0, "", 0x98'967F},
    {0x605D, 0, "current average fuel consumption", 0x7F00},
    {0x6096, 1, "", 0xFD},
    {0x60B0, 1, "", 0x6B49'D200},
    {0x60B0, 2, "", 0xD693'A400},
    {0x60B2, 0, "GPS pdop", 0x50},
    {0x60B6, 0, "", 0xFFFD},  // Z26
    {0x60C0, 0, "", 0xFFFC},
    {0x60F4, 0, "offset from UTC", 0x68},
    {0x6122, 0, "", 0xFD},
    {0x613A, 1, "sound volume", 0x3C},
    {0x613B, 1, "sound volume", 0x3D},
};
TEST(Cia447Numbers, EndWhereTheTablesSay) {
  for (const Beyond& end : ends) {
    SCOPED_TRACE(testing::Message()
                 << std::hex << end.index << "h:" << end.sub << " " << end.field);
    const auto bits = find_bits(end.index, end.sub, end.field);
    ASSERT_TRUE(bits);
    const NumberRules rules(*bits->value, bits->range);
    EXPECT_TRUE(rules.is_value(end.last));
    EXPECT_FALSE(rules.is_value(end.last + 1));
  }
}

TEST(Cia447Numbers, DatesBeginWithTheFirst) {
  for (const char* field : {"RTC date year", "RTC date month", "RTC date day"}) {
    const auto bits = find_bits(0x60F0, 0, field);
    ASSERT_TRUE(bits);
    const NumberRules rules(*bits->value, bits->range);
    EXPECT_FALSE(rules.is_value(0)) << field;
    EXPECT_TRUE(rules.is_value(1)) << field;
  }
}

}  // namespace
}  // namespace canvoy::numbers_test
