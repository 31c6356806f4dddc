// The expectations are typed from clause 9 and Annex A of CiA 852, with its errata.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "canvoy/profiles/cia852.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::cia852_objects_test {
namespace {

/// The name with its number.
std::string full_name(const EntryInfo& entry) {
  std::string name(entry.name);
  const std::size_t place = name.find('#');
  if (place != std::string::npos) name.replace(place, 1, std::to_string(entry.first_number));
  return name;
}

const ObjectInfo& object_at(unsigned index) {
  const ObjectInfo* object = find_object(cia852::profile, index);
  EXPECT_NE(object, nullptr) << std::hex << index;
  return object != nullptr ? *object : cia852::device_type_object;
}

constexpr DataType i16 = DataType::integer16, i32 = DataType::integer32, u8 = DataType::unsigned8,
                   u32 = DataType::unsigned32, r32 = DataType::real32;
constexpr Mapping no = Mapping::no, optional = Mapping::optional, by_default = Mapping::by_default;

struct Row {
  const char* source;
  unsigned index;
  unsigned sub;
  const char* name;
  DataType type;
  Access access;
  Mapping mapping;
  int initial = -1;  ///< -1: the text says "No"
};

/// Each table of clause 9 prints the first and the last of its entries. Typed here are those of
/// both ends of each group, and one from the middle.
constexpr Row rows[] = {
    {"Table 1", 0x6000, 0x01, "Joystick 1: Memory function", u8, Access::ro, by_default},
    {"Table 1", 0x6000, 0x02, "Joystick 1: Up to 8 additional buttons", u8, Access::ro, by_default},
    {"Table 1", 0x6000, 0x0F, "Joystick 8: Memory function", u8, Access::ro, by_default},
    {"Table 1", 0x6000, 0x10, "Joystick 8: Up to 8 additional buttons", u8, Access::ro, by_default},
    {"Table 1", 0x6000, 0x1F, "Joystick 16: Memory function", u8, Access::ro, by_default},
    {"Table 1", 0x6000, 0x20, "Joystick 16: Up to 8 additional buttons", u8, Access::ro,
     by_default},
    {"Table 1", 0x6401, 0x01, "Joystick 1: x-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x02, "Joystick 1: y-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x03, "Joystick 1: z-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x04, "Joystick 2: x-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x2E, "Joystick 16: x-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x2F, "Joystick 16: y-dimension", i16, Access::ro, by_default},
    {"Table 1", 0x6401, 0x30, "Joystick 16: z-dimension", i16, Access::ro, by_default},
    {"Table 2", 0x6000, 0x21, "Foot pedal 1: Memory function", u8, Access::ro, by_default},
    {"Table 2", 0x6000, 0x30, "Foot pedal 16: Memory function", u8, Access::ro, by_default},
    {"Table 2", 0x6401, 0x31, "Foot pedal 1: Position", i16, Access::ro, by_default},  // errata 7
    {"Table 2", 0x6401, 0x40, "Foot pedal 16: Position", i16, Access::ro, by_default},
    {"Table 3", 0x6120, 0x81, "Encoder 1: Position", u32, Access::ro, by_default},
    {"Table 3", 0x6120, 0x88, "Encoder 8: Position", u32, Access::ro, by_default},
    {"Table 4", 0x6401, 0x41, "Wheel 1: Position", i16, Access::ro, by_default},
    {"Table 4", 0x6401, 0x48, "Wheel 8: Position", i16, Access::ro, by_default},
    {"Table 5", 0x6000, 0x31, "Push-button cluster 1: Switch 1-to-8", u8, Access::ro, by_default},
    {"Table 5", 0x6000, 0x32, "Push-button cluster 1: Switch 9-to-16", u8, Access::ro, by_default},
    {"Table 5", 0x6000, 0x38, "Push-button cluster 1: Switch 57-to-64", u8, Access::ro, by_default},
    {"errata 1", 0x6000, 0x61, "Push-button cluster 7: Switch 1-to-8", u8, Access::ro, by_default},
    {"errata 1", 0x6000, 0x69, "Push-button cluster 8: Switch 1-to-8", u8, Access::ro, by_default},
    {"Table 5", 0x6000, 0x70, "Push-button cluster 8: Switch 57-to-64", u8, Access::ro, by_default},
    {"Table 6", 0x6200, 0x01, "Indicator cluster 1: Indicator 1-to-8", u8, Access::rw, by_default},
    {"Table 6", 0x6200, 0x08, "Indicator cluster 1: Indicator 57-to-64", u8, Access::rw,
     by_default},
    {"errata 2", 0x6200, 0x39, "Indicator cluster 8: Indicator 1-to-8", u8, Access::rw, by_default},
    {"Table 6", 0x6200, 0x40, "Indicator cluster 8: Indicator 57-to-64", u8, Access::rw,
     by_default},
    {"Table 6", 0x6206, 0x01, "Indicator cluster 1: Error mode 1-to-8", u8, Access::rw, no, 1},
    {"Table 6", 0x6206, 0x08, "Indicator cluster 1: Error mode 57-to-64", u8, Access::rw, no, 1},
    {"errata 3", 0x6206, 0x39, "Indicator cluster 8: Error mode 1-to-8", u8, Access::rw, no, 1},
    {"Table 6", 0x6206, 0x40, "Indicator cluster 8: Error mode 57-to-64", u8, Access::rw, no, 1},
    {"Table 6", 0x6207, 0x01, "Indicator cluster 1: Error value 1-to-8", u8, Access::rw, no, 0},
    {"Table 6", 0x6207, 0x08, "Indicator cluster 1: Error value 57-to-64", u8, Access::rw, no, 0},
    {"errata 3", 0x6207, 0x39, "Indicator cluster 8: Error value 1-to-8", u8, Access::rw, no, 0},
    {"Table 6", 0x6207, 0x40, "Indicator cluster 8: Error value 57-to-64", u8, Access::rw, no, 0},
    {"Table 7", 0x6411, 0x01, "Display 1: parameter 1", i16, Access::rw, by_default, 0},
    {"Table 7", 0x6411, 0x0C, "Display 1: parameter 12", i16, Access::rw, by_default, 0},
    {"errata 5", 0x6411, 0x0D, "Display 2: parameter 1", i16, Access::rw, by_default, 0},
    {"errata 5", 0x6411, 0x55, "Display 8: parameter 1", i16, Access::rw, by_default, 0},
    {"errata 5", 0x6411, 0x60, "Display 8: parameter 12", i16, Access::rw, by_default, 0},
    {"errata 6", 0x6413, 0x01, "Display 1: parameter 1", r32, Access::rw, optional, 0},
    {"errata 6", 0x6413, 0x60, "Display 8: parameter 12", r32, Access::rw, optional, 0},
    {"Table 7", 0x6443, 0x01, "Error mode display 1: parameter 1", u8, Access::rw, no, 1},
    {"errata 4", 0x6443, 0x0C, "Error mode display 1: parameter 12", u8, Access::rw, no, 1},
    {"errata 5", 0x6443, 0x60, "Error mode display 8: parameter 12", u8, Access::rw, no, 1},
    {"Table 7", 0x6444, 0x01, "Error value display 1: parameter 1", i32, Access::rw, no, 0},
    {"errata 4", 0x6444, 0x0C, "Error value display 1: parameter 12", i32, Access::rw, no, 0},
    {"errata 5", 0x6444, 0x60, "Error value display 8: parameter 12", i32, Access::rw, no, 0},
    {"errata 6", 0x6445, 0x01, "Error value display 1: parameter 1", r32, Access::rw, no, 0},
    {"errata 6", 0x6445, 0x60, "Error value display 8: parameter 12", r32, Access::rw, no, 0},
};

TEST(Cia852, EntriesStandAtTheSubIndicesOfClause9) {
  for (const Row& row : rows) {
    SCOPED_TRACE(testing::Message() << row.source << ": " << row.name);
    const EntryInfo* entry = find_entry(object_at(row.index), row.sub);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(full_name(*entry), row.name);
    EXPECT_EQ(entry->type, row.type);
    EXPECT_EQ(entry->access, row.access);
    EXPECT_EQ(entry->mapping, row.mapping);
    EXPECT_EQ(entry->category, Category::conditional);
    EXPECT_EQ(static_cast<bool>(entry->initial), row.initial >= 0);
    if (row.initial >= 0) {
      EXPECT_EQ(entry->initial.number, row.initial);
    }
  }
}

TEST(Cia852, ThereAreNoOtherEntriesAndNoGaps) {
  struct {
    unsigned index;
    unsigned sub_first;
    unsigned sub_last;
    const char* count;
  } constexpr objects[] = {{0x6000, 0x01, 0x70, "16 x 2 + 16 + 8 x 8"},
                           {0x6120, 0x81, 0x88, "8"},
                           {0x6200, 0x01, 0x40, "8 x 8"},
                           {0x6206, 0x01, 0x40, "8 x 8"},
                           {0x6207, 0x01, 0x40, "8 x 8"},
                           {0x6401, 0x01, 0x48, "16 x 3 + 16 + 8"},
                           {0x6411, 0x01, 0x60, "8 x 12"},
                           {0x6413, 0x01, 0x60, "8 x 12"},
                           {0x6443, 0x01, 0x60, "8 x 12"},
                           {0x6444, 0x01, 0x60, "8 x 12"},
                           {0x6445, 0x01, 0x60, "8 x 12"}};
  for (const auto& [index, sub_first, sub_last, count] : objects) {
    SCOPED_TRACE(testing::Message() << std::hex << index << "h: " << count);
    const ObjectInfo& object = object_at(index);
    EXPECT_EQ(object.code, ObjectCode::array);
    EXPECT_EQ(object.subs.size(), 1 + sub_last - sub_first + 1);
    EXPECT_EQ(object.subs[0].sub_first, 0);
    for (unsigned sub = 1; sub <= 0xFF; ++sub) {
      EXPECT_EQ(find_entry(object, sub) != nullptr, sub >= sub_first && sub <= sub_last) << sub;
    }
    std::set<std::string> names;
    for (const EntryInfo& entry : object.subs) names.insert(full_name(entry));
    EXPECT_EQ(names.size(), object.subs.size()) << "two entries of one name";
  }
}

TEST(Cia852, Object6423IsFalseByDefault) {
  const ObjectInfo& object = object_at(0x6423);
  EXPECT_EQ(object.name, "Analogue input global interrupt enable");
  EXPECT_EQ(object.code, ObjectCode::var);
  EXPECT_EQ(object.entry.type, DataType::boolean);
  EXPECT_EQ(object.entry.access, Access::rw);
  EXPECT_EQ(object.entry.initial.number, 0);
}

TEST(Cia852, ObjectsHaveTheNamesAndCategoriesOfAnnexA) {
  using enum Category;
  struct {
    unsigned index;
    const char* name;
    Category category;
  } constexpr objects[] = {{0x1005, "COB-ID SYNC", mandatory},
                           {0x1007, "Synchronous window length", Category::optional},
                           {0x1010, "Store parameters", Category::optional},
                           {0x1011, "Restore default parameters", Category::optional},
                           {0x1014, "COB-ID EMCY", mandatory},
                           {0x1015, "Inhibit time EMCY", mandatory},
                           {0x1016, "Consumer heartbeat time", conditional},
                           {0x1017, "Producer heartbeat time", mandatory},
                           {0x1018, "Identity", mandatory},
                           {0x1028, "Emergency consumer", conditional},
                           {0x1029, "Error behavior", mandatory},  // errata 42
                           {0x6000, "Read input 8-bit", Category::optional},
                           {0x6120, "Read input 32-bit", Category::optional},
                           {0x6200, "Write output 8-bit", Category::optional},  // errata 11
                           {0x6206, "Error mode output 8-bit", Category::optional},
                           {0x6207, "Error value output 8-bit", conditional},
                           {0x6401, "Read analogue input 16-bit", Category::optional},
                           {0x6411, "Write analogue output 16-bit", Category::optional},
                           {0x6413, "Write analogue output float", Category::optional},
                           {0x6423, "Analogue input global interrupt enable", Category::optional},
                           {0x6443, "Analogue output error mode", Category::optional},
                           {0x6444, "Analogue output error value integer", conditional},
                           {0x6445, "Analogue output error value float", conditional}};
  for (const auto& [index, name, category] : objects) {
    EXPECT_EQ(object_at(index).name, name);
    EXPECT_EQ(object_at(index).category, category) << name;
  }
}

TEST(Cia852, AllFourNumbersOfTheIdentityHaveToBeThere) {  // 11.4
  for (unsigned sub = 1; sub <= 4; ++sub) {
    EXPECT_EQ(find_entry(object_at(0x1018), sub)->category, Category::mandatory);
  }
}

struct Bit {
  const char* source;
  unsigned index;
  unsigned sub;
  unsigned bit;
  const char* name;
  unsigned number;
};
constexpr Bit bits[] = {
    {"Figure 5", 0x6000, 0x01, 0, "m-x", 0},   {"Figure 5", 0x6000, 0x1F, 1, "m-y", 0},
    {"Figure 5", 0x6000, 0x01, 2, "m-z", 0},   {"Figure 4", 0x6000, 0x02, 0, "b#", 1},
    {"Figure 4", 0x6000, 0x20, 7, "b#", 8},    {"Figure 6", 0x6000, 0x21, 0, "m-x", 0},
    {"Figure 7", 0x6000, 0x31, 0, "pb#", 1},   {"Figure 7", 0x6000, 0x70, 7, "pb#", 8},
    {"Figure 8", 0x6200, 0x01, 0, "i#", 1},    {"Figure 8", 0x6200, 0x40, 7, "i#", 8},
    {"CiA 401", 0x6206, 0x01, 3, "i#", 4},     {"CiA 401", 0x6207, 0x01, 3, "i#", 4},
    {"Figure 5", 0x6000, 1, 3, "reserved", 0}, {"Figure 6", 0x6000, 0x30, 1, "reserved", 0}};

TEST(Cia852, BitsHaveTheMeaningsOfFigures4To8) {
  for (const Bit& bit : bits) {
    SCOPED_TRACE(testing::Message() << bit.source << ": " << bit.name);
    const FieldInfo* found = nullptr;
    for (const FieldInfo& field : find_entry(object_at(bit.index), bit.sub)->fields) {
      if (field.first_bit == bit.bit) found = &field;
    }
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->name, bit.name);
    EXPECT_EQ(found->number, bit.number);
    const NamedValue* one = find_name(found->value, 1, found->bits, false);
    ASSERT_NE(one, nullptr);
    EXPECT_EQ(one->meaning == Meaning::reserved, found->name == "reserved");
  }
}

TEST(Cia852, EachBitOfAnInputIsDescribedOnce) {
  for (unsigned index : {0x6000U, 0x6200U, 0x6206U, 0x6207U}) {
    for (const EntryInfo& entry : object_at(index).subs) {
      if (entry.sub_first == 0) continue;
      unsigned described = 0;
      for (const FieldInfo& field : entry.fields) described += field.bits;
      EXPECT_EQ(described, 8U) << full_name(entry);
    }
  }
}

TEST(Cia852, EmergencyCodesAreThoseOfTable37) {
  constexpr std::uint16_t codes[] = {0x0000, 0x0080, 0x2000, 0x3000, 0x4000, 0x5000, 0x6000,
                                     0x7000, 0x8110, 0x8120, 0x8140, 0x8150, 0x8200, 0x8240};
  ASSERT_EQ(cia852::profile.error_codes.size(), std::size(codes));
  for (std::size_t i = 0; i < std::size(codes); ++i) {
    EXPECT_EQ(cia852::profile.error_codes[i].code, codes[i]);
    EXPECT_FALSE(cia852::profile.error_codes[i].text.empty());
  }
}

TEST(Cia852, TheDeviceTypeHasTheBitsOfTable8) {
  // 11.2, example: joystick with buttons and memory, wheel, push-buttons: 1001 1001b and 0101b.
  EXPECT_EQ(cia852::device_type({.joystick = true,
                                 .joystick_with_inputs = true,
                                 .wheel = true,
                                 .push_button_cluster = true}),
            0x9985'0191U);
  EXPECT_EQ(cia852::device_type({.joystick = true}), 0x8184'0191U);
  EXPECT_EQ(cia852::device_type({.joystick = true, .joystick_with_inputs = true}), 0x8185'0191U);
  EXPECT_EQ(cia852::device_type({.foot_pedal = true}), 0x8285'0191U);
  EXPECT_EQ(cia852::device_type({.encoder = true}), 0x8481'0191U);  // errata 38
  EXPECT_EQ(cia852::device_type({.wheel = true}), 0x8884'0191U);
  EXPECT_EQ(cia852::device_type({.push_button_cluster = true}), 0x9081'0191U);
  EXPECT_EQ(cia852::device_type({.indicator_cluster = true}), 0xA082'0191U);
  EXPECT_EQ(cia852::device_type({.display = true}), 0xC088'0191U);  // errata 40
}

TEST(Cia852, ToolsTellItFromOtherDevicesOfCia401) {
  EXPECT_EQ(find_profile(0x9985'0191), &cia852::profile);
  EXPECT_EQ(find_profile(0xC088'0191), &cia852::profile);
  EXPECT_EQ(find_profile(0x0005'0191), &cia401::profile);
  EXPECT_EQ(find_profile(0x8005'0191), &cia401::profile) << "pre-defined mapping";
  EXPECT_EQ(find_profile(0xFFFF'0191), &cia401::profile) << "several logical devices of any kind";
  EXPECT_EQ(find_profile(852), nullptr);
}

TEST(Cia852, WhatItDoesNotSayCia401Says) {
  EXPECT_EQ(find_description(cia852::profile, 0x6000), &cia852::read_input_8_bit_object);
  EXPECT_EQ(find_description(cia852::profile, 0x6426),
            &cia401::analogue_input_interrupt_delta_unsigned_object);
  EXPECT_EQ(find_description(cia852::profile, 0x1F51), &cia302::program_control_object);
  const auto address = find_address(cia852::profile, "polarity input 8-bit");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->index, 0x6002);
}

TEST(Cia852, EachOfSeveralSeatsMayBeALogicalDevice) {  // 5.1, note
  EXPECT_EQ(find_object(cia852::profile, 0x6C01), &cia852::read_analogue_input_16_bit_object);
  EXPECT_EQ(find_object(cia852::profile, 0x9800), &cia852::read_input_8_bit_object);
  EXPECT_EQ(find_object(cia852::profile, 0xA000), nullptr);
}

struct Spoken {
  const char* text;
  unsigned index;
  unsigned sub;
};
constexpr Spoken spoken[] = {{"joystick 2: x-dimension", 0x6401, 0x04},
                             {"Foot pedal 16: Position", 0x6401, 0x40},
                             {"push-button cluster 8: switch 57-to-64", 0x6000, 0x70},
                             {"read input 8-bit:joystick 16: memory function", 0x6000, 0x1F},
                             {"write analogue output float:display 2: parameter 1", 0x6413, 0x0D},
                             {"TPDO 20 mapping parameter", 0x1A13, 0},
                             {"RPDO 33 communication parameter:COB-ID", 0x1420, 1}};

TEST(Cia852, ToolsFindElementsByTheirPrintedNames) {
  for (const auto& [text, index, sub] : spoken) {
    const auto address = find_address(cia852::profile, text);
    ASSERT_TRUE(address) << text;
    EXPECT_EQ(address->index, index) << text;
    EXPECT_EQ(address->sub, sub) << text;
    EXPECT_NE(address->entry, nullptr) << text;
  }
  EXPECT_FALSE(find_address(cia852::profile, "joystick 17: x-dimension"));
  EXPECT_FALSE(find_address(cia852::profile, "display 2: parameter 1")) << "in two objects";
}

const ReadingInfo& reading(std::string_view name) {
  for (const ReadingInfo& one : cia852::profile.readings) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << name;
  return cia852::profile.readings[0];
}
const ObjectInfo* object_in(const ReadingInfo& reading, unsigned index) {
  for (const ObjectInfo* object : reading.objects) {
    if (object->index == index) return object;
  }
  return nullptr;
}

TEST(Cia852, DisplaysOf24SubIndicesAreAnotherReadingOfTable7) {  // errata 4, 5
  const ReadingInfo& wide = reading("wide-displays");
  for (unsigned index : {0x6411U, 0x6413U, 0x6443U, 0x6444U, 0x6445U}) {
    const ObjectInfo* object = object_in(wide, index);
    ASSERT_NE(object, nullptr);
    for (unsigned sub = 1; sub <= 0xFF; ++sub) {
      const bool expected = sub <= 0xC0 && (sub - 1) % 24 < 12;
      const EntryInfo* entry = find_entry(*object, sub);
      ASSERT_EQ(entry != nullptr, expected) << std::hex << index << " " << sub;
      if (entry != nullptr) {
        EXPECT_EQ(entry->first_number, (sub - 1) / 24 + 1);
      }
    }
    EXPECT_EQ(find_entry(*object, 0xA9)->name, object_at(index).subs[1].name);
  }
  // RPDO 13 carries parameters 1 to 4 of display 2, which begins at 19h then.
  EXPECT_EQ(find_entry(*object_in(wide, 0x160C), 1)->initial.number, 0x6411'1910);
  EXPECT_EQ(find_entry(*object_in(wide, 0x1620), 4)->initial.number, 0x6411'B410);
  EXPECT_EQ(object_in(wide, 0x160B), nullptr) << "of display 1 nothing changes";
  EXPECT_EQ(wide.objects.size(), 21U + 5);
}

TEST(Cia852, TheReadingOfThePrintedTpdoIndices) {  // errata 16 to 19
  const ReadingInfo& printed = reading("printed-tpdos");
  struct {
    unsigned index;
    unsigned tpdo;
    std::int64_t first;
  } constexpr mappings[] = {{0x1A14, 20, 0x60002108}, {0x1A1B, 27, 0x60002F08},
                            {0x1A1C, 28, 0x61208120}, {0x1A20, 32, 0x64014110},
                            {0x1A22, 34, 0x60003108}, {0x1A29, 41, 0x60006908}};
  for (const auto& [index, tpdo, first] : mappings) {
    const ObjectInfo* mapping = object_in(printed, index);
    ASSERT_NE(mapping, nullptr) << std::hex << index;
    EXPECT_EQ(mapping->first_number, tpdo);
    EXPECT_EQ(mapping->subs[1].initial.number, first);
    const ObjectInfo* parameter = object_in(printed, index - 0x200);
    ASSERT_NE(parameter, nullptr);
    EXPECT_EQ(parameter->first_number, tpdo);
  }
  EXPECT_EQ(printed.objects.size(), 2 * 22U);
  ASSERT_EQ(printed.without.size(), 2U);
  EXPECT_EQ(printed.without[0], 0x1813);
  EXPECT_EQ(printed.without[1], 0x1A13);
}

}  // namespace
}  // namespace canvoy::cia852_objects_test
