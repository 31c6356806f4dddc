// Values of CiA 407 that canvoy/profiles/clauses/407.txt does not hold.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::cia407_values_test {
namespace {

const EntryInfo& entry_at(unsigned index, unsigned sub) {
  return *find_entry(*find_object(cia407::profile, index), sub);
}

const FieldInfo* find_field(const EntryInfo& entry, std::string_view name) {
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

TEST(Cia407Values, SomeHaveNoSentinel) {
  EXPECT_EQ(find_invalid(entry_at(0x6115, 1).value), nullptr) << "errata 55";
  EXPECT_EQ(find_invalid(entry_at(0x6523, 1).value), nullptr) << "FFh is an offset of -1 hour";
  EXPECT_EQ(find_invalid(entry_at(0x6680, 3).value), nullptr) << "9.2.22.1 names no standard";
  const ValueInfo& sets = entry_at(0x6205, 1).value;
  EXPECT_EQ(find_name(sets, 0xC, 16, false)->meaning, Meaning::reserved) << "errata 77";
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
