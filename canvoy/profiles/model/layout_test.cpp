#include "canvoy/profiles/model/layout.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::layout_test {
namespace {

/// True if a description compiles. tests/embed/wrong_descriptions checks the compilers' messages.
template <const auto& device>
concept LaysOut = requires {
  typename std::bool_constant<(detail::lay_out_parts<device>(), true)>;
  requires detail::lay_out_parts<device>().fault.reason.empty();
};

constexpr auto charger = describe(cia419::charger(), cia301::identity({.vendor_id = 1}),
                                  cia301::heartbeat_producer(1000));

constexpr ObjectInfo speed_object = {.index = 0x2000,
                                     .name = "speed",
                                     .entry = {.type = DataType::unsigned16,
                                               .access = Access::rw,
                                               .mapping = Mapping::optional,
                                               .initial = 0,
                                               .value = {.limits = within(0, 1000)}}};

TEST(Layout, PiecesMayComeInAnyOrder) {
  static constexpr auto shuffled = describe(speed_object, cia301::heartbeat_producer(500),
                                            cia301::emergency(), cia301::device_type(1));
  static constexpr auto layout = lay_out_device<shuffled>();
  constexpr std::uint16_t sorted[] = {0x1000, 0x1014, 0x1015, 0x1017, 0x2000};
  ASSERT_EQ(layout.objects.size(), std::size(sorted));
  for (std::size_t i = 0; i < std::size(sorted); ++i) EXPECT_EQ(layout.objects[i].index, sorted[i]);
}

TEST(Layout, AManufacturerObjectStandsBesideTheProfile) {
  static constexpr auto device = describe(charger, speed_object);
  static constexpr auto layout = lay_out_device<device>();
  DeviceMemory memory(layout.tables());
  const std::uint8_t too_fast[] = {0xE9, 0x03};  // 1001
  EXPECT_EQ(memory.dictionary.write(0x2000, 0, too_fast, Source::sdo), AbortCode::value_too_high);
}

TEST(Layout, ObjectsOfOneShapeAreOneRow) {
  static constexpr auto device = describe(cia301::sdo_clients(100));
  static constexpr auto layout = lay_out_device<device>();
  EXPECT_EQ(layout.objects.size(), 1U);
  EXPECT_EQ(layout.objects[0].count, 100);
  EXPECT_EQ(layout.entries.size(), 4U);
}

template <const auto& one, const auto& other>
concept GoTogether = requires { typename std::bool_constant<(describe(one, other), true)>; };
constexpr Part two_clients = cia301::sdo_clients(2);
constexpr Part second_client = Part(cia301::sdo_client_object).only(1);
constexpr Part third_client = Part(cia301::sdo_client_object).only(2);

TEST(Layout, AnObjectTwiceDoesNotCompile) {
  static_assert(GoTogether<charger, speed_object>);
  static_assert(!GoTogether<speed_object, speed_object>);
  static_assert(!GoTogether<charger, cia301::error_register_object>);
  static_assert(!GoTogether<two_clients, second_client>);
  static_assert(!GoTogether<second_client, two_clients>);
  static_assert(GoTogether<third_client, two_clients>);
}

template <const ObjectInfo& object, unsigned sub>
concept MayBeLeftOut = requires { typename std::bool_constant<(Part(object).without(sub), true)>; };

TEST(Layout, AMandatoryEntryCannotBeLeftOut) {
  static_assert(MayBeLeftOut<cia419::rpdo1_parameter_object, 5>);
  static_assert(!MayBeLeftOut<cia419::rpdo1_parameter_object, 1>);
  static_assert(!MayBeLeftOut<cia419::tpdo1_parameter_object, 5>);  // errata 9
  static_assert(!MayBeLeftOut<cia419::rpdo1_parameter_object, 4>);  // there is none
}

// A default outside of its range.
constexpr auto default_too_high = describe(Part(speed_object).initial(1001));
constexpr auto default_negative = describe(Part(speed_object).initial(-1));
constexpr auto default_too_wide = describe(Part(cia301::error_register_object).initial(256));
constexpr auto default_at_limit = describe(Part(speed_object).initial(1000));

TEST(Layout, ADefaultOutOfItsRangeDoesNotCompile) {
  static_assert(!LaysOut<default_too_high>);
  static_assert(!LaysOut<default_negative>);
  static_assert(!LaysOut<default_too_wide>);
  static_assert(LaysOut<default_at_limit>);
}

// A sentinel is outside the limits, and still a valid default.
constexpr auto state_of_charge_ff = describe(Part(cia419::battery_state_of_charge_object));
constexpr auto state_of_charge_fe =
    describe(Part(cia419::battery_state_of_charge_object).initial(0xFE));

TEST(Layout, ASentinelIsAGoodDefault) {
  static_assert(LaysOut<state_of_charge_ff>);
  static_assert(!LaysOut<state_of_charge_fe>);
}

// Mappings.
constexpr auto mapped_missing = describe(Part(cia419::rpdo3_mapping_object));
constexpr auto mapping_of(const ObjectInfo& parameter, std::uint32_t value) {
  return Part(parameter).initial(0, 1).initial(1, value);
}
constexpr EntryInfo one_mapping_entries[] = {cia301::mapping_number_entry,
                                             {.sub_first = 1,
                                              .name = "first",
                                              .type = DataType::unsigned32,
                                              .access = Access::rw,
                                              .initial = 0},
                                             {.sub_first = 2,
                                              .name = "second",
                                              .type = DataType::unsigned32,
                                              .access = Access::rw,
                                              .initial = 0}};
constexpr ObjectInfo rpdo_mapping = {.index = 0x1600,
                                     .code = ObjectCode::record,
                                     .name = "RPDO mapping",
                                     .subs = one_mapping_entries};
constexpr ObjectInfo tpdo_mapping = {.index = 0x1A00,
                                     .code = ObjectCode::record,
                                     .name = "TPDO mapping",
                                     .subs = one_mapping_entries};
constexpr ObjectInfo wide_object = {
    .index = 0x2001,
    .name = "wide",
    .entry = {.type = DataType::unsigned64, .access = Access::rw, .mapping = Mapping::optional}};

constexpr auto maps_well = describe(mapping_of(rpdo_mapping, 0x2000'0010), speed_object);
constexpr auto maps_no_object = describe(mapping_of(rpdo_mapping, 0x2002'0010), speed_object);
constexpr auto maps_no_sub = describe(mapping_of(rpdo_mapping, 0x2000'0110), speed_object);
constexpr auto maps_wrong_length = describe(mapping_of(rpdo_mapping, 0x2000'0008), speed_object);
constexpr auto maps_read_only_to_rpdo =
    describe(mapping_of(rpdo_mapping, 0x1001'0008), cia301::error_register_object);
constexpr auto maps_read_only_to_tpdo =
    describe(mapping_of(tpdo_mapping, 0x1001'0008), cia301::error_register_object);
constexpr auto maps_not_mappable =
    describe(mapping_of(tpdo_mapping, 0x1017'0010), cia301::heartbeat_producer(0));
constexpr auto maps_dummy_to_rpdo = describe(mapping_of(rpdo_mapping, 0x0005'0008));
constexpr auto maps_dummy_to_tpdo = describe(mapping_of(tpdo_mapping, 0x0005'0008));
constexpr auto maps_72_bits = describe(
    Part(rpdo_mapping).initial(0, 2).initial(1, 0x2001'0040).initial(2, 0x0005'0008), wide_object);
constexpr auto maps_more_than_there_is = describe(Part(rpdo_mapping).initial(0, 3));
constexpr auto maps_multiplexed = describe(Part(rpdo_mapping).initial(0, 0xFF));

TEST(Layout, AMappingThatDoesNotFitDoesNotCompile) {
  static_assert(LaysOut<maps_well>);
  static_assert(!LaysOut<mapped_missing>);
  static_assert(!LaysOut<maps_no_object>);
  static_assert(!LaysOut<maps_no_sub>);
  static_assert(!LaysOut<maps_wrong_length>);
  static_assert(!LaysOut<maps_read_only_to_rpdo>);
  static_assert(LaysOut<maps_read_only_to_tpdo>);
  static_assert(!LaysOut<maps_not_mappable>);
  static_assert(LaysOut<maps_dummy_to_rpdo>);
  static_assert(!LaysOut<maps_dummy_to_tpdo>);
  static_assert(!LaysOut<maps_72_bits>);
  static_assert(!LaysOut<maps_more_than_there_is>);
  static_assert(LaysOut<maps_multiplexed>);
}

// Mandatory objects.
constexpr auto without_identity = describe(cia419::charger(), cia301::heartbeat_producer(1000));
constexpr auto without_parameters = describe(cia418::profile, cia418::battery_status_object);

TEST(Layout, AMissingMandatoryObjectDoesNotCompile) {
  static_assert(LaysOut<charger>);
  static_assert(!LaysOut<without_identity>);
  static_assert(!LaysOut<without_parameters>);
}

// Shapes of objects.
constexpr EntryInfo gap_entries[] = {{.name = "first", .initial = highest_sub(3)},
                                     {.sub_first = 1, .name = "one"}};
constexpr ObjectInfo wrong_highest_object = {
    .index = 0x2000, .code = ObjectCode::record, .name = "gap", .subs = gap_entries};
constexpr EntryInfo headless_entries[] = {{.sub_first = 1, .name = "one"},
                                          {.sub_first = 2, .name = "two"}};
constexpr ObjectInfo headless_object = {
    .index = 0x2000, .code = ObjectCode::record, .name = "headless", .subs = headless_entries};
constexpr EntryInfo disordered_entries[] = {
    cia301::highest_sub_index, {.sub_first = 2, .name = "two"}, {.sub_first = 1, .name = "one"}};
constexpr ObjectInfo disordered_object = {
    .index = 0x2000, .code = ObjectCode::record, .name = "disordered", .subs = disordered_entries};
constexpr ObjectInfo record_without_entries_object = {
    .index = 0x2000, .code = ObjectCode::record, .name = "empty"};
constexpr ObjectInfo string_without_capacity_object = {
    .index = 0x2000, .name = "text", .entry = {.type = DataType::visible_string}};
constexpr ObjectInfo text_of_number_object = {
    .index = 0x2000, .name = "number", .entry = {.initial = "text"}};
constexpr ObjectInfo too_long_object = {
    .index = 0x2000,
    .name = "text",
    .entry = {.type = DataType::visible_string, .capacity = 3, .initial = "text"}};
constexpr ObjectInfo limits_of_text_object = {
    .index = 0x2000,
    .name = "text",
    .entry = {.type = DataType::visible_string, .capacity = 3, .value = {.limits = within(0, 1)}}};

constexpr auto wrong_highest = describe(wrong_highest_object);
constexpr auto headless = describe(headless_object);
constexpr auto disordered = describe(disordered_object);
constexpr auto record_without_entries = describe(record_without_entries_object);
constexpr auto string_without_capacity = describe(string_without_capacity_object);
constexpr auto text_of_number = describe(text_of_number_object);
constexpr auto too_long = describe(too_long_object);
constexpr auto limits_of_text = describe(limits_of_text_object);

TEST(Layout, AnObjectOfWrongShapeDoesNotCompile) {
  static_assert(!LaysOut<wrong_highest>);
  static_assert(!LaysOut<headless>);
  static_assert(!LaysOut<disordered>);
  static_assert(!LaysOut<record_without_entries>);
  static_assert(!LaysOut<string_without_capacity>);
  static_assert(!LaysOut<text_of_number>);
  static_assert(!LaysOut<too_long>);
  static_assert(!LaysOut<limits_of_text>);
}

// Features that other profiles need.

constexpr FieldInfo input_fields[] = {
    {.first_bit = 0, .bits = 8, .name = "basic function"},
    {.first_bit = 8, .bits = 8, .name = "sub-function"},
    {.first_bit = 16, .bits = 8, .name = "lift", .value = {.notation = Notation::bit_mask}},
    {.first_bit = 24, .bits = 8, .name = "floor"},
    {.first_bit = 32, .bits = 4, .name = "door", .value = {.notation = Notation::bit_mask}},
};
constexpr EntryInfo group_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "virtual input",
     .type = DataType::unsigned48,
     .fields = input_fields},
};
constexpr ObjectInfo groups_object = {.index = 0x6100,
                                      .count = 32,
                                      .code = ObjectCode::array,
                                      .name = "input group",
                                      .subs = group_entries};

TEST(Layout, ThirtyTwoArraysOf254RecordsOf48BitsAreTwoRows) {
  static constexpr auto device = describe(groups_object);
  static constexpr auto layout = lay_out_device<device>();
  EXPECT_EQ(layout.objects.size(), 1U);
  EXPECT_EQ(layout.entries.size(), 2U);
  DeviceMemory memory(layout.tables());
  EXPECT_EQ(memory.dictionary.number(0x611F, 0), 254U);
  EXPECT_TRUE(memory.dictionary.set_number(0x611F, 254, 0x0102'0304'0506));
  EXPECT_EQ(memory.dictionary.number(0x611F, 254), 0x0102'0304'0506U);
}

TEST(Layout, ADeviceTakesSomeOfTheArraysAndSomeOfTheirEntries) {
  static constexpr auto device = describe(Part(groups_object).only(2, 3).up_to(10));
  static constexpr auto layout = lay_out_device<device>();
  const DeviceMemory memory(layout.tables());
  EXPECT_FALSE(memory.dictionary.find(0x6101, 0));
  EXPECT_TRUE(memory.dictionary.find(0x6104, 10));
  EXPECT_FALSE(memory.dictionary.find(0x6104, 11));
  EXPECT_FALSE(memory.dictionary.find(0x6105, 0));
  EXPECT_EQ(memory.dictionary.number(0x6102, 0), 10U);
}

constexpr NamedValue command_names[] = {{0xFD, "failure", Meaning::failure},
                                        {0xFF, "not available", Meaning::invalid}};
constexpr ObjectInfo mirrored_object = {
    .index = 0x6200,
    .name = "mirrored",
    .entry = {.access = Access::ro,
              .consumer_access = Access::rw,
              .mapping = Mapping::by_default,
              .consumer_initial = 0x12,
              .value = {.limits = within(0, 0xFA), .names = command_names}}};

TEST(Layout, AProducerAndAConsumerHaveTheirOwnAccessAndDefault) {
  static constexpr auto producer = describe(mirrored_object);
  static constexpr auto consumer = describe(Part(mirrored_object).consumed());
  static constexpr auto producer_layout = lay_out_device<producer>();
  static constexpr auto consumer_layout = lay_out_device<consumer>();
  EXPECT_EQ(access_text(producer_layout.entries[0].access), "ro T");
  EXPECT_EQ(access_text(consumer_layout.entries[0].access), "rw TR");
  EXPECT_EQ(producer_layout.defaults[0], 0xFF) << "no default: it begins as invalid";
  EXPECT_EQ(consumer_layout.defaults[0], 0x12);
}

constexpr NamedValue open_states[] = {{0, "open"}, {3, "not available", Meaning::invalid}};
constexpr NamedValue reserved_bits[] = {{0xF, "reserved", Meaning::padding}};
constexpr FieldInfo door_fields[] = {
    {.bits = 2, .name = "left", .value = {.names = open_states}},
    {.first_bit = 2, .bits = 2, .name = "count"},
    {.first_bit = 4, .bits = 4, .name = "r", .value = {.names = reserved_bits}}};
constexpr ObjectInfo door_object = {
    .index = 0x2002, .name = "door", .entry = {.fields = door_fields}};

TEST(Layout, BitsThatNobodyHasSetYetSayThatThereIsNoValue) {
  static constexpr auto device = describe(door_object);
  static constexpr auto layout = lay_out_device<device>();
  EXPECT_EQ(layout.defaults[0], 0xF3) << "the count, which has no code for it, is 0";
}

TEST(Layout, SeveralSentinelsAreAllTaken) {
  static constexpr auto consumer = describe(Part(mirrored_object).consumed());
  static constexpr auto layout = lay_out_device<consumer>();
  DeviceMemory memory(layout.tables());
  for (const std::uint8_t value : std::to_array<std::uint8_t>({0, 0xFA, 0xFD, 0xFF})) {
    EXPECT_EQ(memory.dictionary.check_value(layout.entries[0], std::span(&value, 1)),
              AbortCode::none);
  }
}

constexpr EntryInfo mixed_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1, .name = "domain", .type = DataType::domain, .access = Access::wo},
    {.sub_first = 2, .name = "text", .type = DataType::utf8_string, .capacity = 20, .initial = "ü"},
    {.sub_first = 3, .name = "octets", .type = DataType::octet_string, .capacity = 128},
    {.sub_first = 4, .name = "odd", .type = static_cast<DataType>(0x64), .initial = 31},
    {.sub_first = 9, .name = "after a gap", .type = DataType::integer24, .initial = -5},
};
constexpr ObjectInfo mixed_object = {
    .index = 0x6300, .code = ObjectCode::record, .name = "mixed", .subs = mixed_entries};

TEST(Layout, StringsDomainsOddSizesAndGapsHaveTheirPlace) {
  static constexpr auto device = describe(mixed_object);
  static constexpr auto layout = lay_out_device<device>();
  const DeviceMemory memory(layout.tables());
  EXPECT_EQ(memory.dictionary.number(0x6300, 0), 9U);
  EXPECT_EQ(memory.dictionary.find(0x6300, 2)->bytes().size(), 2U);
  EXPECT_EQ(memory.dictionary.find(0x6300, 3)->row->capacity, 128);
  // Data type 64h has 6 bits (CiA 447-3).
  EXPECT_EQ(memory.dictionary.number(0x6300, 4), 31U);
  EXPECT_EQ(memory.dictionary.find(0x6300, 5).abort(), AbortCode::no_sub_index);
  EXPECT_EQ(memory.dictionary.number(0x6300, 9), 0xFF'FFFBU);
}

}  // namespace
}  // namespace canvoy::layout_test
