// The load in the car, and the signals that it gives (CiA 417-4, 4.12).
//
//     load[cia417::absolute_load_value] = 450;  // kilograms
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

// Loads are in the unit that 6480h:02h says: kilograms by default, and where that is not there.

inline constexpr NamedValue load_names[] = {
    {0xFFFF, "sensor error, or no actual value", Meaning::invalid}};
inline constexpr UnitEntry load_unit_entry = {0x6480, 2};
inline constexpr ValueInfo load_in_kilograms = {.unit = Unit::kilogram,
                                                .unit_entry = load_unit_entry};
inline constexpr std::uint8_t kilogram_code = 0x02;
inline constexpr NamedValue si_unit_names[] = {{kilogram_code, "kg"}};
inline constexpr FieldInfo si_unit_fields[] = {
    field(0, 8, "SI unit", {.names = si_unit_names, .notation = Notation::hexadecimal}),
    field(8, 8, "Prefix", hexadecimal)};
inline constexpr EntryInfo load_value_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, provided({.name = "Absolute load value",
                    .type = DataType::unsigned16,
                    .mapping = Mapping::by_default,
                    .value = {.unit = Unit::kilogram,
                              .names = load_names,
                              .unit_entry = load_unit_entry}})),
    optional_at(2, 2,
                {.name = "SI unit",
                 .type = DataType::unsigned16,
                 .access = Access::rw,
                 .initial = kilogram_code,
                 .value = hexadecimal,
                 .fields = si_unit_fields,
                 .description = "By CiA 303-2."})};
inline constexpr ObjectInfo load_value_object = {.index = 0x6480,
                                                 .code = ObjectCode::array,
                                                 .name = "Load value",
                                                 .category = Category::conditional,
                                                 .condition = see_part_2,
                                                 .clause = "4.12.1",
                                                 .description = "The load, and its unit.",
                                                 .subs = load_value_entries};

constexpr EntryInfo load_setting(std::string_view name, const ValueInfo& value) {
  return {.name = name, .type = DataType::unsigned16, .access = Access::rw, .value = value};
}
inline constexpr EntryInfo load_limits_entries[] = {
    number_of_entries(0x02), at(1, load_setting("Lowlimit", load_in_kilograms)),
    at(2, load_setting("Highlimit", load_in_kilograms))};
inline constexpr ObjectInfo load_limits_object = {
    .index = 0x6481,
    .code = ObjectCode::array,
    .name = "Load limits",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.12.2",
    .errata = "B26",
    .description = "The least and the most that the load value can be.",
    .subs = load_limits_entries};

inline constexpr NamedValue limit_names[] = {{0, "limit not reached"}, {1, "limit reached"}};
inline constexpr NamedValue interrupt_names[] = {{0, "do not generate interrupt"},
                                                 {1, "generate interrupt"}};
constexpr std::array<FieldInfo, 5> load_signal_bits(const ValueInfo& value) {
  return {field(0, 1, "Zero load", value), field(1, 1, "Norm load", value),
          field(2, 1, "Full load", value), field(3, 1, "Overload", value), reserved_zeros<4>(4)};
}
inline constexpr auto load_signal_fields = load_signal_bits({.names = limit_names});
inline constexpr auto load_interrupt_fields = load_signal_bits({.names = interrupt_names});
inline constexpr EntryInfo load_signaling_entries[] = {
    number_of_entries(0x02),
    at(1, provided({.name = "Load signal",
                    .type = DataType::unsigned8,
                    .mapping = Mapping::by_default,
                    .value = {.notation = Notation::bit_mask},
                    .fields = load_signal_fields})),
    at(2, {.name = "Load signal interrupt",
           .type = DataType::unsigned8,
           .access = Access::rw,
           .initial = 0x0F,
           .value = {.notation = Notation::bit_mask},
           .fields = load_interrupt_fields})};
inline constexpr ObjectInfo load_signaling_object = {
    .index = 0x6482,
    .code = ObjectCode::array,
    .name = "Load signaling",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.12.3",
    .errata = "B25",
    .description = "Which limits of 6483h the load has reached, and which of them are told.",
    .subs = load_signaling_entries};

inline constexpr NamedValue unused_limit_names[] = {{0xFFFF, "unused limit", Meaning::invalid}};
inline constexpr ValueInfo signaling_limit = {
    .unit = Unit::kilogram, .names = unused_limit_names, .unit_entry = load_unit_entry};
inline constexpr EntryInfo load_signaling_limits_entries[] = {
    number_of_entries(0x04), at(1, load_setting("Zero load limit", signaling_limit)),
    at(2, load_setting("Norm load limit", signaling_limit)),
    at(3, load_setting("Full load limit", signaling_limit)),
    at(4, load_setting("Overload limit", signaling_limit))};
inline constexpr ObjectInfo load_signaling_limits_object = {
    .index = 0x6483,
    .code = ObjectCode::array,
    .name = "Load signaling limits",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.12.4",
    .errata = "B25, C4",
    .description = "The loads that give the signals of 6482h.",
    .subs = load_signaling_limits_entries};

inline constexpr EntryInfo rope_entry =
    provided({.name = "Rope #", .type = DataType::unsigned16, .value = load_in_kilograms});
inline constexpr EntryInfo rope_load_entries[] = {count_entry("Number of ropes", 1, last_of_many),
                                                  at(1, rope_entry),
                                                  optional_at(2, last_of_many, rope_entry)};
inline constexpr ObjectInfo rope_load_object = {.index = 0x6484,
                                                .code = ObjectCode::array,
                                                .name = "Rope load",
                                                .category = Category::conditional,
                                                .condition = see_part_2,
                                                .clause = "4.12.5",
                                                .errata = "B26",
                                                .description = "The load on each rope.",
                                                .subs = rope_load_entries};

inline constexpr FieldInfo rope_ratio_fields[] = {field(0, 8, "Ratio denominator"),
                                                  field(8, 8, "Ratio nominator")};
inline constexpr EntryInfo load_system_configuration_entries[] = {
    count_entry("Number of entries", 0x01, 0x01), at(1, {.name = "Rope ratio",
                                                         .type = DataType::unsigned16,
                                                         .access = Access::rw,
                                                         .value = hexadecimal,
                                                         .fields = rope_ratio_fields})};
inline constexpr ObjectInfo load_system_configuration_object = {
    .index = 0x6485,
    .code = ObjectCode::array,
    .name = "Load measuring system configuration",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.12.6",
    .description = "How the ropes run.",
    .subs = load_system_configuration_entries};

}  // namespace canvoy::cia417
