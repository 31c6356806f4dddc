// The expectations are typed from the clauses of CiA 419 version 1.0.1, with its errata.
#include "canvoy/profiles/cia419.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia419_test {
namespace {

using namespace entry_rows;

constexpr auto full_charger =
    describe(cia419::charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000));
constexpr auto full_layout = lay_out_device<full_charger>();

constexpr auto small_charger = describe(cia419::charger(), cia301::identity({.vendor_id = 1}),
                                        cia301::heartbeat_producer(1000));
constexpr auto small_layout = lay_out_device<small_charger>();

constexpr Expected communication_objects[] = {
    {0x1000, 0, u32, "ro", 0x000001A3, "6.2.1"},
    {0x1001, 0, u8, "ro T", 0, "6.2.2"},
    // 1st RPDO
    {0x1400, 0, u8, "ro", 5, "6.2.3.2"},
    {0x1400, 1, u32, "rw", 0x80000000, "6.2.3.2"},
    {0x1400, 2, u8, "ro", 255, "6.2.3.2"},
    {0x1400, 5, u16, "rw", 0, "6.2.3.2"},
    {0x1600, 0, u8, "ro", 2, "6.2.3.3, errata 6"},
    {0x1600, 1, u32, "ro", 0x60100010, "6.2.3.3"},
    {0x1600, 2, u32, "ro", 0x60000008, "6.2.3.3"},
    // 1st TPDO
    {0x1800, 0, u8, "ro", 5, "6.2.4.2"},
    {0x1800, 1, u32, "rw", 0x80000000, "6.2.4.2, errata 10"},
    {0x1800, 2, u8, "ro", 255, "6.2.4.2"},
    {0x1800, 3, u16, "rw", 0, "6.2.4.2, errata 7"},
    {0x1800, 5, u16, "rw", 200, "6.2.4.2, errata 9"},
    {0x1A00, 0, u8, "ro", 1, "6.2.4.3, errata 6"},
    {0x1A00, 1, u32, "ro", 0x60010008, "6.2.4.3"},
    // 2nd RPDO
    {0x1401, 0, u8, "ro", 5, "6.2.5.2"},
    {0x1401, 1, u32, "rw", 0x80000000, "6.2.5.2"},
    {0x1401, 2, u8, "ro", 255, "6.2.5.2"},
    {0x1401, 5, u16, "rw", 0, "6.2.5.2"},
    {0x1601, 0, u8, "ro", 3, "6.2.5.3, errata 11"},
    {0x1601, 1, u32, "ro", 0x60100010, "6.2.5.3"},
    {0x1601, 2, u32, "ro", 0x60000008, "6.2.5.3"},
    {0x1601, 3, u32, "ro", 0x60600020, "6.2.5.3"},
    // 2nd TPDO
    {0x1801, 0, u8, "ro", 5, "6.2.6.2"},
    {0x1801, 1, u32, "rw", 0x80000000, "6.2.6.2"},
    {0x1801, 2, u8, "ro", 255, "6.2.6.2"},
    {0x1801, 3, u16, "rw", 0, "6.2.6.2"},
    {0x1801, 5, u16, "rw", 200, "6.2.6.2"},
    {0x1A01, 0, u8, "ro", 2, "6.2.6.3"},
    {0x1A01, 1, u32, "ro", 0x60010008, "6.2.6.3"},
    {0x1A01, 2, u32, "ro", 0x60520010, "6.2.6.3"},
    // 3rd RPDO
    {0x1402, 0, u8, "ro", 5, "6.2.7.2"},
    {0x1402, 1, u32, "rw", 0x80000000, "6.2.7.2"},
    {0x1402, 2, u8, "ro", 255, "6.2.7.2"},
    {0x1402, 5, u16, "rw", 0, "6.2.7.2"},
    {0x1602, 0, u8, "ro", 2, "6.2.7.3"},
    {0x1602, 1, u32, "ro", 0x60700010, "6.2.7.3"},
    {0x1602, 2, u32, "ro", 0x60810008, "6.2.7.3"},
    // 3rd TPDO
    {0x1802, 0, u8, "ro", 5, "6.2.8.2, errata 3"},
    {0x1802, 1, u32, "rw", 0x80000000, "6.2.8.2"},
    {0x1802, 2, u8, "ro", 255, "6.2.8.2"},
    {0x1802, 3, u16, "rw", 0, "6.2.8.2"},
    {0x1802, 5, u16, "rw", 200, "6.2.8.2"},
    {0x1A02, 0, u8, "ro", 3, "6.2.8.3"},
    {0x1A02, 1, u32, "ro", 0x60010008, "6.2.8.3"},
    {0x1A02, 2, u32, "ro", 0x60520010, "6.2.8.3"},
    {0x1A02, 3, u32, "ro", 0x60800008, "6.2.8.3"},
};

/// Without a default in clause 7, an object starts as invalid, or as not ready.
constexpr Expected application_objects[] = {
    {0x6000, 0, u8, "rw TR", 0, "7.2.1"},           {0x6001, 0, u8, "ro T", 0, "7.2.2"},
    {0x6010, 0, i16, "rw TR", 0xFFFF, "7.2.3"},     {0x6052, 0, u16, "ro T", 0xFFFF, "7.2.4"},
    {0x6060, 0, u32, "rw TR", 0xFFFFFFFF, "7.2.5"}, {0x6070, 0, u16, "rw TR", 0xFFFF, "7.2.6"},
    {0x6080, 0, u8, "ro T", 0xFF, "7.2.7"},         {0x6081, 0, u8, "rw TR", 0xFF, "7.2.8"},
};

TEST(Cia419, CommunicationObjectsHaveTheTypesAccessAndDefaultsOfClause6) {
  const DeviceMemory charger(full_layout.tables(), 5);
  expect_entries(charger.dictionary, communication_objects);
}

TEST(Cia419, ApplicationObjectsHaveTheTypesAccessAndDefaultsOfClause7) {
  const DeviceMemory charger(full_layout.tables(), 5);
  expect_entries(charger.dictionary, application_objects);
}

TEST(Cia419, NothingButTheDescribedEntriesIsThere) {
  constexpr std::size_t of_cia301 = 1 + 5;  // 1017h, and 1018h with five entries
  std::size_t entries = 0;
  for (const EntryShape& row : full_layout.entries) entries += row.sub_last - row.sub_first + 1U;
  EXPECT_EQ(entries, std::size(communication_objects) + std::size(application_objects) + of_cia301);
}

TEST(Cia419, SubIndex4OfPdoParametersIsNotThere) {
  const DeviceMemory charger(full_layout.tables());
  constexpr std::uint16_t parameters[] = {0x1400, 0x1401, 0x1402, 0x1800, 0x1801, 0x1802};
  for (const std::uint16_t index : parameters) {
    EXPECT_EQ(charger.dictionary.find(index, 4).abort(), AbortCode::no_sub_index);
    EXPECT_EQ(charger.dictionary.find(index, 6).abort(), AbortCode::no_sub_index);
  }
}

TEST(Cia419, TheSmallestChargerHasTheMandatoryObjectsOnly) {
  constexpr std::uint16_t mandatory[] = {0x1000, 0x1001, 0x1017, 0x1018, 0x1400, 0x1600,
                                         0x1800, 0x1A00, 0x6000, 0x6001, 0x6010};
  ASSERT_EQ(small_layout.objects.size(), std::size(mandatory));
  for (std::size_t i = 0; i < std::size(mandatory); ++i) {
    EXPECT_EQ(small_layout.objects[i].index, mandatory[i]);
  }
}

template <cia419::ChargerOptions options>
bool has(std::uint16_t index) {
  static constexpr auto device = cia419::charger(options);
  return device.find(index) != nullptr;
}

TEST(Cia419, Object6052IsThereIfTpdo2OrTpdo3Is) {  // errata 4
  EXPECT_FALSE((has<cia419::ChargerOptions{.rpdo2 = true, .rpdo3 = true}>(0x6052)));
  EXPECT_TRUE((has<cia419::ChargerOptions{.tpdo2 = true}>(0x6052)));
  EXPECT_TRUE((has<cia419::ChargerOptions{.tpdo3 = true}>(0x6052)));
}

TEST(Cia419, Object6060IsThereIfRpdo2Is) {  // errata 12: 1601h comes with 1401h
  EXPECT_TRUE((has<cia419::ChargerOptions{.rpdo2 = true}>(0x6060)));
  EXPECT_FALSE((has<cia419::ChargerOptions{.rpdo3 = true, .tpdo2 = true, .tpdo3 = true}>(0x6060)));
  EXPECT_FALSE((has<cia419::ChargerOptions{.rpdo3 = true, .tpdo2 = true, .tpdo3 = true}>(0x1601)));
}

TEST(Cia419, Objects6070And6081AreThereIfRpdo3Is) {
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x6070, 0x6081})) {
    EXPECT_TRUE((has<cia419::ChargerOptions{.rpdo3 = true}>(index)));
    EXPECT_FALSE((has<cia419::ChargerOptions{.rpdo2 = true, .tpdo2 = true, .tpdo3 = true}>(index)));
  }
}

TEST(Cia419, Object6080IsThereIfTpdo3Is) {  // errata 5: not with TPDO2 alone
  EXPECT_TRUE((has<cia419::ChargerOptions{.tpdo3 = true}>(0x6080)));
  EXPECT_FALSE((has<cia419::ChargerOptions{.tpdo2 = true}>(0x6080)));
}

struct ExpectedValue {
  const char* clause;
  unsigned index;
  const char* name;
  Unit unit;
  std::int64_t raw;
  double physical;
};
constexpr ExpectedValue resolutions[] = {
    {"7.2.3", 0x6010, "battery_temperature", Unit::degree_celsius, 1, 0.125},
    {"7.2.4", 0x6052, "ah_returned_during_last_charge", Unit::ampere_hour, 1, 0.125},
    {"7.2.5", 0x6060, "battery_voltage", Unit::volt, 1, 1.0 / 1024},
    {"7.2.6", 0x6070, "charge_current_requested", Unit::ampere, 1, 1.0 / 16},
    {"7.2.7", 0x6080, "charger_state_of_charge", Unit::percent, 1, 1},
    {"7.2.8", 0x6081, "battery_state_of_charge", Unit::percent, 1, 1},
    {"7.2.3", 0x6010, "battery_temperature", Unit::degree_celsius, -320, -40.0},
    {"7.2.3", 0x6010, "battery_temperature", Unit::degree_celsius, 680, 85.0},
    {"7.2.5", 0x6060, "battery_voltage", Unit::volt, 24 * 1024, 24.0},
    {"7.2.6", 0x6070, "charge_current_requested", Unit::ampere, 800, 50.0},
    {"7.2.7", 0x6080, "charger_state_of_charge", Unit::percent, 0x64, 100},
};

TEST(Cia419, ValuesHaveTheUnitsAndResolutionsOfClause7) {
  for (const ExpectedValue& expected : resolutions) {
    SCOPED_TRACE(expected.name);
    const ObjectInfo* object = find_object(cia419::profile, expected.index);
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->name, expected.name);
    EXPECT_EQ(object->clause, expected.clause);
    EXPECT_EQ(object->entry.value.unit, expected.unit);
    const NumberRules rules(object->entry.value, bits_of(object->entry));
    EXPECT_EQ(rules.physical(expected.raw), expected.physical);
  }
}

TEST(Cia419, TheSentinelsOfClause7StandForNoValue) {
  struct {
    unsigned index;
    std::int64_t sentinel;
  } constexpr sentinels[] = {{0x6010, -1},     {0x6052, 0xFFFF}, {0x6060, 0xFFFFFFFF},
                             {0x6070, 0xFFFF}, {0x6080, 0xFF},   {0x6081, 0xFF}};
  for (const auto& [index, sentinel] : sentinels) {
    const ObjectInfo& object = *find_object(cia419::profile, index);
    const NumberRules rules(object.entry.value, bits_of(object.entry));
    EXPECT_EQ(rules.invalid(), sentinel) << object.name;
    EXPECT_FALSE(rules.is_value(sentinel)) << object.name;
    EXPECT_TRUE(rules.is_value(0)) << object.name;
  }
}

AbortCode write_u8(Dictionary& dictionary, std::uint16_t index, std::uint8_t value) {
  return dictionary.write(index, 0, std::span(&value, 1), Source::sdo);
}

TEST(Cia419, StatesOfChargeAre0To100AndFF) {
  DeviceMemory charger(full_layout.tables());
  for (unsigned value = 0; value <= 0xFF; ++value) {
    const AbortCode expected =
        value <= 100 || value == 0xFF ? AbortCode::none : AbortCode::value_too_high;
    EXPECT_EQ(write_u8(charger.dictionary, 0x6081, static_cast<std::uint8_t>(value)), expected)
        << value;
  }
}

AbortCode write_temperature(Dictionary& dictionary, int raw, Source source) {
  const std::uint8_t bytes[] = {static_cast<std::uint8_t>(raw & 0xFF),
                                static_cast<std::uint8_t>(raw >> 8 & 0xFF)};
  return dictionary.write(0x6010, 0, bytes, source);
}

TEST(Cia419, TemperaturesAreFEC0hTo02A8hAndFFFFh) {  // 7.2.3
  DeviceMemory charger(full_layout.tables());
  for (const Source source : {Source::sdo, Source::pdo}) {
    for (const int raw : {-320, 0, 680, -1}) {
      EXPECT_EQ(write_temperature(charger.dictionary, raw, source), AbortCode::none) << raw;
    }
    for (const int raw : {-321, -32768}) {
      EXPECT_EQ(write_temperature(charger.dictionary, raw, source), AbortCode::value_too_low)
          << raw;
    }
    for (const int raw : {681, 0x7000, 32767}) {
      EXPECT_EQ(write_temperature(charger.dictionary, raw, source), AbortCode::value_too_high)
          << raw;
    }
  }
}

TEST(Cia419, TheReservedBitsOfAStatusAre0) {  // 7.2.1
  DeviceMemory charger(full_layout.tables());
  Values values(charger.dictionary);
  ASSERT_EQ(write_u8(charger.dictionary, 0x6000, 0x01), AbortCode::none);
  for (unsigned value = 2; value <= 0xFF; ++value) {
    EXPECT_EQ(write_u8(charger.dictionary, 0x6000, static_cast<std::uint8_t>(value)),
              AbortCode::value_too_high)
        << value;
  }
  EXPECT_TRUE(values[cia419::battery_status].is(Readiness::ready));
  ASSERT_EQ(write_u8(charger.dictionary, 0x6000, 0x00), AbortCode::none);
  EXPECT_TRUE(values[cia419::battery_status].is(Readiness::not_ready));
}

TEST(Cia419, TheBitOfTheProfileInTheErrorRegisterIsReserved) {  // 6.2.2
  const ObjectInfo* error_register = find_object(cia419::profile, 0x1001);
  ASSERT_NE(error_register, nullptr);
  for (const FieldInfo& field : error_register->entry.fields) {
    EXPECT_EQ(field.name == "reserved", field.first_bit == 5) << field.name;
  }
}

TEST(Cia419, TheDeviceTypeIsTheNumberOfTheProfileAlone) {  // 6.2.1
  EXPECT_EQ(cia419::device_type, 0x0000'01A3U);
  const auto& fields = cia419::profile.device_type;
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(find_name(fields[0].value, 0x01A3, 16, false)->name, "CiA 419");
  EXPECT_EQ(find_name(fields[1].value, 1, 16, false)->meaning, Meaning::reserved);
}

TEST(Cia419, EachObjectSaysInWhichClauseItStands) {
  for (const ObjectInfo* object : cia419::profile.objects) {
    EXPECT_FALSE(object->clause.empty()) << object->name;
    const char first = object->clause.front();
    if (object->index >= 0x6000) {
      EXPECT_EQ(first, '7') << object->name;
    } else {
      EXPECT_TRUE(first >= '4' && first <= '6') << object->name;
    }
  }
}

TEST(Cia419, CategoriesAreThoseOfTheObjectDescriptions) {
  using enum Category;
  struct {
    unsigned index;
    Category category;
  } constexpr categories[] = {
      {0x1001, mandatory},   {0x1012, optional},    {0x1017, mandatory},   {0x1029, optional},
      {0x1400, mandatory},   {0x1600, mandatory},   {0x1800, mandatory},   {0x1A00, mandatory},
      {0x1401, optional},    {0x1601, conditional}, {0x1801, optional},    {0x1A01, optional},
      {0x1402, optional},    {0x1602, optional},    {0x1802, optional},    {0x1A02, optional},
      {0x6000, mandatory},   {0x6001, mandatory},   {0x6010, mandatory},   {0x6052, conditional},
      {0x6060, conditional}, {0x6070, conditional}, {0x6080, conditional}, {0x6081, conditional}};
  for (const auto& [index, category] : categories) {
    EXPECT_EQ(find_object(cia419::profile, index)->category, category) << std::hex << index;
  }
  EXPECT_EQ(std::size(categories), cia419::profile.objects.size());
}

TEST(Cia419, PdoEntriesThatMayBeLeftOutAreTheOptionalOnes) {
  static constexpr auto lean =
      describe(cia419::charger()
                   .without(cia419::rpdo1_parameter_object, 5)
                   .without(cia419::tpdo1_parameter_object, 3),
               cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000));
  static constexpr auto layout = lay_out_device<lean>();
  const DeviceMemory charger(layout.tables());
  EXPECT_EQ(charger.dictionary.number(0x1400, 0), 2U);  // errata 13
  EXPECT_FALSE(charger.dictionary.find(0x1400, 5));
  EXPECT_EQ(charger.dictionary.number(0x1800, 0), 5U);
  EXPECT_FALSE(charger.dictionary.find(0x1800, 3));
}

}  // namespace
}  // namespace canvoy::cia419_test
