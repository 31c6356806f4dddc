// Entries of CiA 407 that canvoy/profiles/clauses/407.txt does not hold.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia407.hpp"

namespace canvoy::cia407_entries_test {
namespace {

constexpr unsigned i8 = 2, u8 = 5, u16 = 6, u32 = 7;  // as CiA 301 numbers them

TEST(Cia407, ObjectsHaveADescriptionEach) {
  for (const ObjectInfo* object : cia407::profile.objects) {
    EXPECT_FALSE(object->description.empty() && object->index >= 0x6000) << object->name;
  }
}

TEST(Cia407, WhoConsumesAnObjectIsWrittenTo) {  // 9.2.1, clause 6
  for (const ObjectInfo* object : cia407::profile.objects) {
    // Objects of the display itself, and outputs, are consumed by no other device.
    const bool is_own =
        (object->index >= 0x6200 && object->index <= 0x6203) || object->index == 0x6763;
    for (const EntryInfo& entry : object->entries()) {
      if (!entry.access_by_device) continue;
      EXPECT_EQ(entry.access, is_own || object->index == 0x6741 ? Access::rw : Access::ro);
      EXPECT_EQ(entry.consumer_access, is_own ? Access::none : Access::wo) << object->name;
    }
  }
}

TEST(Cia407, PrecisionsAreThereWhereTheirValuesAre) {  // errata 2, 104
  constexpr struct {
    unsigned index;
    const char* condition;
  } precisions[] = {{0x611B, "if object 611Ah is implemented"},
                    {0x6483, "if object 6482h is implemented"},
                    {0x6487, "if object 6486h is implemented"},
                    {0x6661, "if object 6660h is implemented"},
                    {0x6665, "if object 6664h is implemented"}};
  for (const auto& [index, condition] : precisions) {
    EXPECT_EQ(find_object(cia407::profile, index)->condition, condition);
  }
}

TEST(Cia407, TextsHaveTheLengthsOfClause9) {
  constexpr struct {
    unsigned index;
    unsigned octets;
  } texts[] = {{0x610C, 128}, {0x610D, 128}, {0x6112, 128}, {0x6524, 19},
               {0x6742, 64},  {0x6743, 64},  {0x6744, 64}};
  for (const auto& [index, length] : texts) {
    EXPECT_EQ(find_entry(*find_object(cia407::profile, index), 1)->capacity, length);
  }
}

TEST(Cia407, Object1029SaysWhatAnErrorWithinTheDeviceDoes) {  // 8.1.3
  const EntryInfo& entry = *find_entry(*find_object(cia407::profile, 0x1029), 2);
  EXPECT_EQ(entry.name, "Internal_Device_Error");
  EXPECT_EQ(entry.access, Access::rw);
  EXPECT_EQ(entry.category, Category::optional);
  EXPECT_EQ(entry.initial.number, 0);
  EXPECT_EQ(entry.value.limits.low, 0);
  EXPECT_EQ(entry.value.limits.high, 2);
  ASSERT_EQ(entry.value.names.size(), 3U);
  EXPECT_EQ(entry.value.names[1].name, "no change of state");
}

TEST(Cia407, Object67FFIsADeviceType) {  // 9.2.30.1
  const ObjectInfo& object = *find_object(cia407::profile, 0x67FF);
  EXPECT_EQ(object.entry.type, DataType::unsigned32);
  EXPECT_EQ(object.entry.fields.size(), cia407::profile.device_type.size());
}

TEST(Cia407, RecordTypesHaveTheMembersOfClause9) {  // 9.2.2; errata 48, 66
  constexpr struct {
    const char* name;
    unsigned type;
  } fuel[] = {{"number_of_entries", u8},
              {"fuel_rate", u16},
              {"instantaneous_fuel_economy", u16},
              {"average_fuel_economy", u16},
              {"total_fuel_used", u32},
              {"trip_fuel", u32},
              {"total_idle_fuel_used", u32}},
    time[] = {{"number_of_entries", u8},
              {"local_hour", i8},
              {"local_minute", i8},
              {"year", u8},
              {"day", u8},
              {"month", u8},
              {"hour", u8},
              {"minute", u8},
              {"second", u8}};
  const auto expect = [](const RecordTypeInfo& type, unsigned index, const auto& members) {
    EXPECT_EQ(type.index, index);
    ASSERT_EQ(type.members.size(), std::size(members));
    for (std::size_t sub = 0; sub < std::size(members); ++sub) {
      EXPECT_EQ(type.members[sub].sub_first, sub);
      EXPECT_EQ(type.members[sub].name, members[sub].name);
      EXPECT_EQ(static_cast<unsigned>(type.members[sub].type), members[sub].type);
    }
  };
  ASSERT_EQ(cia407::profile.record_types.size(), 2U);
  expect(cia407::profile.record_types[0], 0x80, fuel);
  expect(cia407::profile.record_types[1], 0x81, time);
}

}  // namespace
}  // namespace canvoy::cia407_entries_test
