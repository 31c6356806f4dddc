// The values of clause 9.2: steps, offsets and ranges by the numbers of the text, and bits by its
// figures.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/number_rules.hpp"

namespace canvoy::cia407_values_test {
namespace {

const EntryInfo& entry_at(unsigned index, unsigned sub) {
  return *find_entry(*find_object(cia407::profile, index), sub);
}

struct ExpectedValue {
  const char* clause;
  unsigned index;
  unsigned sub;
  Unit unit;
  std::int64_t raw;
  double physical;
};
constexpr ExpectedValue values[] = {
    {"9.2.6.15, errata 52", 0x610E, 1, Unit::year, 0, 1985},
    {"9.2.6.15, errata 52", 0x610E, 1, Unit::year, 250, 2235},
    {"9.2.6.15", 0x610E, 2, Unit::day, 1, 0.25},
    {"9.2.6.15", 0x610E, 2, Unit::day, 127, 31.75},
    {"9.2.6.15", 0x610E, 3, Unit::month, 12, 12},
    {"9.2.6.15", 0x610E, 4, Unit::hour, 23, 23},
    {"9.2.6.15", 0x610E, 5, Unit::minute, 59, 59},
    {"9.2.6.15", 0x610E, 6, Unit::second, 239, 59.75},
    {"9.2.6.16", 0x610F, 0, Unit::minute, 15, 15},
    {"9.2.6.22, errata 52", 0x6115, 1, Unit::year, 41, 2026},
    {"9.2.6.22", 0x6115, 6, Unit::second, 1, 0.25},
    {"9.2.6.26", 0x6119, 0, Unit::degree_celsius, -1000, -100},
    {"9.2.6.26", 0x6119, 0, Unit::degree_celsius, 215, 21.5},
    {"9.2.6.27", 0x611A, 0, Unit::metre, 1, 5},
    {"9.2.6.27", 0x611A, 0, Unit::metre, 0xFAFFFFFF, 21'055'406'075.0},
    {"9.2.6.28", 0x611B, 0, Unit::metre, 2, 10},
    {"9.2.6.36", 0x6123, 0, Unit::kilometre_per_hour, 256, 1},
    {"9.2.6.36", 0x6123, 0, Unit::kilometre_per_hour, 0xFFFF, 255.99609375},
    {"9.2.15.1", 0x6481, 0, Unit::kilometre_per_hour, 64255, 250.99609375},
    {"9.2.15.2", 0x6482, 0, Unit::metre, 200, 1000},
    {"9.2.15.3", 0x6483, 0, Unit::metre, 1, 5},
    {"9.2.15.5, errata 63", 0x6486, 0, Unit::degree, 64255, 501.9921875},
    {"9.2.15.6", 0x6487, 0, Unit::degree, 64, 0.5},
    {"9.2.15.8, errata 60", 0x6489, 0, Unit::degree_celsius, 0, -273},
    {"9.2.15.8, errata 60", 0x6489, 0, Unit::degree_celsius, 64255, 1734.96875},
    {"9.2.15.8", 0x6489, 0, Unit::degree_celsius, 273 * 32 + 1, 0.03125},
    {"9.2.15.9", 0x648A, 1, Unit::litre_per_hour, 64255, 3212.75},
    {"9.2.15.9", 0x648A, 2, Unit::kilometre_per_litre, 512, 1},
    {"9.2.15.9, errata 67", 0x648A, 3, Unit::kilometre_per_litre, 64255, 125.498046875},
    {"9.2.15.9", 0x648A, 4, Unit::litre, 0xFAFFFFFF, 2'105'540'607.5},
    {"9.2.15.9", 0x648A, 5, Unit::litre, 1, 0.5},
    {"9.2.15.9", 0x648A, 6, Unit::litre, 3, 1.5},
    {"9.2.15.11", 0x648C, 0, Unit::degree_celsius, 0, -40},
    {"9.2.15.11", 0x648C, 0, Unit::degree_celsius, 250, 210},
    {"9.2.15.12", 0x648D, 1, Unit::hour, 0xFAFFFFFF, 210'554'060.75},
    {"9.2.15.12", 0x648D, 4, Unit::hour, 1, 0.05},
    {"9.2.17.1, errata 61", 0x6520, 0, Unit::kilometre_per_hour, 64255, 250.99609375},
    {"9.2.17.3", 0x6522, 1, Unit::metre, 1, 5},
    {"9.2.17.3", 0x6522, 2, Unit::metre, 2, 10},
    {"9.2.17.4, errata 53", 0x6523, 1, Unit::hour, -23, -23},
    {"9.2.17.4, errata 53", 0x6523, 2, Unit::minute, 59, 59},
    {"9.2.17.4", 0x6523, 3, Unit::year, 15, 2000},
    {"9.2.17.4", 0x6523, 4, Unit::day, 4, 1},
    {"9.2.17.4, errata 48", 0x6523, 8, Unit::second, 3, 0.75},
    {"9.2.17.6", 0x6525, 1, Unit::minute, 270, 270},
    {"9.2.21.1, errata 57", 0x6660, 1, Unit::degree, 0, -210},
    {"9.2.21.1, errata 57", 0x6660, 2, Unit::degree, 0xFAFFFFFF, 211.1081215},
    {"9.2.21.1", 0x6660, 1, Unit::degree, 2'100'000'001, 1e-7},
    {"9.2.21.2", 0x6661, 0, Unit::metre, 7, 7},
    {"9.2.21.3", 0x6662, 0, Unit::metre_per_second, 1, 0.1},
    {"9.2.21.4, errata 62", 0x6663, 0, Unit::degree, 128, 1},
    {"9.2.21.5", 0x6664, 0, Unit::metre, 1, 5},
    {"9.2.21.6, errata 68", 0x6665, 0, Unit::metre, 1, 1},
    {"9.2.22.1, errata 48", 0x6680, 8, Unit::second, 239, 59.75},
    {"9.2.26.4", 0x6723, 0, Unit::percent, 50, 50},
};

TEST(Cia407Values, HaveTheUnitsStepsAndOffsetsOfClause9) {
  for (const ExpectedValue& expected : values) {
    SCOPED_TRACE(testing::Message() << expected.clause << ": " << std::hex << expected.index);
    const EntryInfo& entry = entry_at(expected.index, expected.sub);
    EXPECT_EQ(entry.value.unit, expected.unit);
    const NumberRules rules(entry.value, bits_of(entry));
    EXPECT_EQ(rules.physical(expected.raw), expected.physical);
  }
}

TEST(Cia407Values, BeyondTheirRangesStandForNothing) {
  constexpr struct {
    unsigned index;
    unsigned sub;
    std::int64_t low;
    std::int64_t high;
  } ranges[] = {{0x610E, 1, 0, 250},        {0x610E, 2, 1, 127},        {0x610E, 3, 1, 12},
                {0x610E, 4, 0, 23},         {0x610E, 5, 0, 59},         {0x610E, 6, 0, 239},
                {0x6115, 2, 1, 127},        {0x6119, 0, -1000, 1000},   {0x611A, 0, 0, 0xFAFFFFFF},
                {0x6481, 0, 0, 0xFAFF},     {0x6482, 0, 0, 0xFAFFFFFF}, {0x6486, 0, 0, 0xFAFF},
                {0x6489, 0, 0, 0xFAFF},     {0x648A, 1, 0, 0xFAFF},     {0x648A, 4, 0, 0xFAFFFFFF},
                {0x648C, 0, 0, 0xFA},       {0x648D, 2, 0, 0xFAFFFFFF}, {0x6520, 0, 0, 0xFAFF},
                {0x6522, 2, 0, 0xFAFFFFFF}, {0x6523, 1, -23, 23},       {0x6523, 2, -59, 59},
                {0x6523, 3, 0, 250},        {0x6660, 2, 0, 0xFAFFFFFF}, {0x6663, 0, 0, 0xFAFF},
                {0x6664, 0, 0, 0xFAFFFFFF}, {0x6680, 8, 0, 239}};
  for (const auto& [index, sub, low, high] : ranges) {
    SCOPED_TRACE(testing::Message() << std::hex << index << ' ' << sub);
    const EntryInfo& entry = entry_at(index, sub);
    const NumberRules rules(entry.value, bits_of(entry));
    EXPECT_TRUE(rules.is_value(low));
    EXPECT_TRUE(rules.is_value(high));
    EXPECT_FALSE(rules.is_value(low - 1));
    EXPECT_FALSE(rules.is_value(high + 1));
  }
}

TEST(Cia407Values, SentinelsAreNotTakenForValues) {
  constexpr struct {
    unsigned index;
    unsigned sub;
    std::int64_t raw;
    Meaning meaning;
  } sentinels[] = {
      {0x610E, 1, 0xFF, Meaning::invalid},       {0x610E, 6, 0xFF, Meaning::invalid},
      {0x611B, 0, 0xFFFF, Meaning::invalid},     {0x6483, 0, 0xFFFF, Meaning::invalid},
      {0x6487, 0, 0xFFFF, Meaning::invalid},     {0x6661, 0, 0xFF, Meaning::invalid},
      {0x6665, 0, 0xFFFF, Meaning::invalid},     {0x6481, 0, 0xFFFF, Meaning::invalid},
      {0x6481, 0, 0xFF00, Meaning::invalid},     {0x6481, 0, 0xFE00, Meaning::failure},
      {0x6481, 0, 0xFB00, Meaning::reserved},    {0x648C, 0, 0xFE, Meaning::failure},
      {0x648C, 0, 0xFF, Meaning::invalid},       {0x6482, 0, 0xFE123456, Meaning::failure},
      {0x6482, 0, 0xFFFFFFFF, Meaning::invalid}, {0x6523, 3, 0xFF, Meaning::invalid},
      {0x6523, 4, 0xFE, Meaning::failure},       {0x6523, 8, 0xFB, Meaning::reserved}};
  for (const auto& [index, sub, raw, meaning] : sentinels) {
    SCOPED_TRACE(testing::Message() << std::hex << index << ' ' << raw);
    const EntryInfo& entry = entry_at(index, sub);
    const NamedValue* named = find_name(entry.value, raw, bit_length(entry.type), false);
    ASSERT_NE(named, nullptr);
    EXPECT_EQ(named->meaning, meaning);
  }
  EXPECT_EQ(find_invalid(entry_at(0x6115, 1).value), nullptr) << "errata 55";
  EXPECT_EQ(find_invalid(entry_at(0x6523, 1).value), nullptr) << "FFh is an offset of -1 hour";
  EXPECT_EQ(find_invalid(entry_at(0x6680, 3).value), nullptr) << "9.2.22.1 names no standard";
}

TEST(Cia407Values, NamedValuesAreThoseOfTheText) {
  constexpr struct {
    unsigned index;
    unsigned sub;
    std::int64_t raw;
    const char* name;
    Meaning meaning;
  } named_values[] = {
      {0x6104, 0, 0, "not used", Meaning::state},
      {0x6104, 0, 1, "bus", Meaning::state},
      {0x6104, 0, 2, "tram", Meaning::state},
      {0x6104, 0, 3, "light railway", Meaning::state},
      {0x6104, 0, 4, "trolley bus", Meaning::state},
      {0x6104, 0, 0xFE, "application-specific", Meaning::state},
      {0x6104, 0, 0xFF, "reserved", Meaning::reserved},
      {0x6108, 0, 0, "no direction specified", Meaning::state},
      {0x6108, 0, 1, "forward", Meaning::state},
      {0x6108, 0, 2, "backward", Meaning::state},
      {0x6108, 0, 0x7F, "reserved", Meaning::reserved},
      {0x6108, 0, 0x80, "manufacturer-specific", Meaning::manufacturer},
      {0x6117, 0, 0xFE, "application-specific priority level", Meaning::state},
      {0x6117, 0, 0xFF, "no or lowest priority level", Meaning::state},
      {0x6204, 0, 1, "bus stop requested", Meaning::state},
      {0x6204, 0, 0, "bus stop not requested", Meaning::state},
      {0x6205, 1, 0, "ISO 646-US", Meaning::state},
      {0x6205, 1, 1, "ISO 8859-1", Meaning::state},
      {0x6205, 2, 0xF, "ISO 8859-15", Meaning::state},
      {0x6205, 1, 0x10, "reserved", Meaning::reserved},
      {0x6205, 1, 0x7FFF, "reserved", Meaning::reserved},
      {0x6205, 254, 0x8000, "manufacturer-specific character set", Meaning::manufacturer},
      {0x66C0, 0, 1, "reverse gear not engaged", Meaning::state},
      {0x66C0, 0, 0, "reverse gear engaged", Meaning::state},
  };
  for (const auto& [index, sub, raw, name, meaning] : named_values) {
    SCOPED_TRACE(testing::Message() << std::hex << index << ' ' << raw);
    const EntryInfo& entry = entry_at(index, sub);
    const NamedValue* named = find_name(entry.value, raw, bit_length(entry.type), false);
    ASSERT_NE(named, nullptr);
    EXPECT_EQ(named->name, name);
    EXPECT_EQ(named->meaning, meaning);
  }
  const ValueInfo& sets = entry_at(0x6205, 1).value;
  EXPECT_EQ(find_name(sets, 0xC, 16, false)->meaning, Meaning::reserved) << "errata 77";
}

struct ExpectedField {
  unsigned index;
  unsigned sub;
  std::uint64_t raw;
  const char* field;
  const char* meaning;
};
constexpr ExpectedField fields[] = {
    // 6116h: bit 7.
    {0x6116, 0, 0x80, "tv", "ticket validator blocked"},
    {0x6116, 0, 0x7F, "tv", "ticket validator in operation"},
    // 6203h, as printed by bit number: format, Index-LSB, Index-MSB, Sub-Index.
    {0x6203, 2, 0xC0000000, "flash speed", "fast"},
    {0x6203, 2, 0x40000000, "flash speed", "slow"},
    {0x6203, 2, 0x30000000, "font style", "scrolling from left"},
    {0x6203, 2, 0x20000000, "font style", "bold"},
    {0x6203, 3, 0x08000000, "alignment", "center"},
    {0x6203, 254, 0x03000000, "font size", "large"},
    {0x6203, 254, 0x00FFFFFF, "font size", "no mode"},
    // 6484h and 6521h: bits 7 and 6, 5 and 4.
    {0x6484, 0, 0x40, "direction indicator", "reverse"},
    {0x6484, 0, 0x10, "drive recognition", "motion detected"},
    {0x6484, 0, 0x80, "direction indicator", "error"},
    {0x6484, 0, 0x30, "drive recognition", "not available"},
    {0x6521, 0, 0x0F, "direction indicator", "forward"},
    {0x6521, 0, 0x1F, "drive recognition", "motion detected"},
    {0x6521, 0, 0x20, "drive recognition", "error"},  // errata 73
    // 6488h.
    {0x6488, 1, 0x80, "all doors", "at least one door open"},
    {0x6488, 1, 0x7F, "all doors", "all valid doors closed"},
    {0x6488, 1, 0x40, "left side doors", "doors released"},
    {0x6488, 1, 0x20, "right side doors", "doors released"},
    {0x6488, 1, 0xDF, "right side doors", "doors blocked"},
    {0x6488, 2, 0x80, "door N", "door open"},
    {0x6488, 2, 0x40, "door N valid", "door valid"},
    {0x6488, 3, 0x20, "door N+1", "door open"},
    {0x6488, 3, 0x10, "door N+1 valid", "door valid"},
    {0x6488, 100, 0x08, "door N+2", "door open"},
    {0x6488, 100, 0x04, "door N+2 valid", "door valid"},
    {0x6488, 254, 0x02, "door N+3", "door open"},
    {0x6488, 254, 0x01, "door N+3 valid", "door valid"},
    {0x6488, 254, 0xFE, "door N+3 valid", "door invalid"},
    // 648Bh: bits 7 and 6.
    {0x648B, 0, 0x3F, "brake pedal", "brake pedal released"},
    {0x648B, 0, 0x40, "brake pedal", "brake pedal depressed"},
    {0x648B, 0, 0x80, "brake pedal", "error"},
    {0x648B, 0, 0xC0, "brake pedal", "information not available"},
};

const FieldInfo* find_field(const EntryInfo& entry, std::string_view name) {
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

TEST(Cia407Values, BitsMeanWhatTheFiguresShow) {
  for (const ExpectedField& expected : fields) {
    SCOPED_TRACE(testing::Message() << std::hex << expected.index << ' ' << expected.raw);
    const FieldInfo* field = find_field(entry_at(expected.index, expected.sub), expected.field);
    ASSERT_NE(field, nullptr);
    const std::int64_t number = extract(expected.raw, bits_of(*field));
    const NamedValue* named = find_name(field->value, number, field->bits, field->is_signed);
    ASSERT_NE(named, nullptr);
    EXPECT_EQ(named->name, expected.meaning);
  }
}

TEST(Cia407Values, NumbersInFieldsStandWhereTheFiguresShow) {
  constexpr struct {
    unsigned index;
    unsigned sub;
    std::uint64_t raw;
    const char* field;
    std::int64_t number;
  } numbers[] = {
      {0x6203, 1, 0xABCDEF07, "number of mapped objects", 7},
      {0x6203, 1, 0xABCDEF07, "manufacturer-specific", 0xABCDEF},
      {0x6203, 2, 0x000C6101, "Index-LSB", 0x0C},
      {0x6203, 2, 0x000C6101, "Index-MSB", 0x61},
      {0x6203, 2, 0x000C6101, "Sub-Index", 0x01},
      {0x6700, 0, 0x0507, "number of incoming passengers", 5},
      {0x6700, 0, 0x0507, "number of outgoing passengers", 7},
      {0x6740, 1, 0x12345678, "device code", 0x1234},
      {0x6740, 254, 0x12345678, "error code", 0x5678},
      {0x6762, 1, 0x80007FFF, "channel 1", -32768},
      {0x6762, 4, 0x80007FFF, "channel 2", 32767},
      {0x6763, 1, 0x0001FFFF, "channel 1", 1},
      {0x6763, 2, 0x0001FFFF, "channel 2", -1},
  };
  for (const auto& [index, sub, raw, name, number] : numbers) {
    SCOPED_TRACE(testing::Message() << std::hex << index << ' ' << name);
    const FieldInfo* field = find_field(entry_at(index, sub), name);
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(extract(raw, bits_of(*field)), number);
  }
}

TEST(Cia407Values, ByTheOtherReadingThe6203HasItsBytesTheOtherWayRound) {  // errata 74
  ASSERT_EQ(cia407::profile.readings.size(), 1U);
  const ReadingInfo& reading = cia407::profile.readings[0];
  EXPECT_EQ(reading.name, "byte-order");
  EXPECT_EQ(reading.errata, "74");
  ASSERT_EQ(reading.objects.size(), 1U);
  const ObjectInfo& object = *reading.objects[0];
  EXPECT_EQ(object.index, 0x6203);
  const EntryInfo& entry = *find_entry(object, 2);
  EXPECT_EQ(entry.initial.number, 0x01610C00);
  EXPECT_EQ(extract(0x01610C40, bits_of(*find_field(entry, "flash speed"))), 1);
  EXPECT_EQ(extract(0x01610C00, bits_of(*find_field(entry, "Index-LSB"))), 0x0C);
  EXPECT_EQ(extract(0x01610C00, bits_of(*find_field(entry, "Index-MSB"))), 0x61);
  EXPECT_EQ(extract(0x01610C00, bits_of(*find_field(entry, "Sub-Index"))), 0x01);
  EXPECT_EQ(find_entry(object, 1)->initial.number, 2) << "the number of objects is in the LSB";
}

}  // namespace
}  // namespace canvoy::cia407_values_test
