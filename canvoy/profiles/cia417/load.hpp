// The load in the car and the load signals (CiA 417-4, 4.12).
//
//     load[cia417::absolute_load_value] = 450;  // kilograms
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

// Loads are in the unit that 6480h:02h defines: kilograms by default, and where that entry does not
// exist.

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
    at(1,
       provided(sub_index(
           0, "Absolute load value",
           entry(unsigned16, ro, by_default, {},
                 {.unit = Unit::kilogram, .names = load_names, .unit_entry = load_unit_entry})))),
    optional_at(2, 2,
                sub_index(0, "SI unit",
                          entry(unsigned16, rw, no, kilogram_code, hexadecimal, si_unit_fields),
                          {.description = "By CiA 303-2."}))};
inline constexpr auto load_value_object =
    array_object(0x6480, "Load value", "4.12.1", "The load, and its unit.", load_value_entries,
                 {.condition = see_part_2});

/// A limit or factor of the load that can be written.
constexpr EntryInfo load_setting(std::string_view name, const ValueInfo& value) {
  return sub_index(0, name, entry(unsigned16, rw, no, {}, value));
}
inline constexpr EntryInfo load_limits_entries[] = {
    number_of_entries(0x02), at(1, load_setting("Lowlimit", load_in_kilograms)),
    at(2, load_setting("Highlimit", load_in_kilograms))};
inline constexpr auto load_limits_object = array_object(
    0x6481, "Load limits", "4.12.2", "The least and the most that the load value can be.",
    load_limits_entries, {.condition = see_part_2, .errata = "B26"});

inline constexpr NamedValue limit_names[] = {{0, "limit not reached"}, {1, "limit reached"}};
inline constexpr NamedValue interrupt_names[] = {{0, "do not generate interrupt"},
                                                 {1, "generate interrupt"}};
/// Zero load, norm load, full load and overload, and reserved bits.
constexpr std::array<FieldInfo, 5> load_signal_bits(const ValueInfo& value) {
  return {field(0, 1, "Zero load", value), field(1, 1, "Norm load", value),
          field(2, 1, "Full load", value), field(3, 1, "Overload", value), reserved_zeros<4>(4)};
}
inline constexpr auto load_signal_fields = load_signal_bits({.names = limit_names});
inline constexpr auto load_interrupt_fields = load_signal_bits({.names = interrupt_names});
inline constexpr EntryInfo load_signaling_entries[] = {
    number_of_entries(0x02),
    at(1, provided(sub_index(0, "Load signal",
                             entry(unsigned8, ro, by_default, {}, {.notation = Notation::bit_mask},
                                   load_signal_fields)))),
    at(2, sub_index(0, "Load signal interrupt",
                    entry(unsigned8, rw, no, 0x0F, {.notation = Notation::bit_mask},
                          load_interrupt_fields)))};
inline constexpr auto load_signaling_object =
    array_object(0x6482, "Load signaling", "4.12.3",
                 "Which limits of 6483h the load has reached, and which of them are told.",
                 load_signaling_entries, {.condition = see_part_2, .errata = "B25"});

inline constexpr NamedValue unused_limit_names[] = {{0xFFFF, "unused limit", Meaning::invalid}};
inline constexpr ValueInfo signaling_limit = {
    .unit = Unit::kilogram, .names = unused_limit_names, .unit_entry = load_unit_entry};
inline constexpr EntryInfo load_signaling_limits_entries[] = {
    number_of_entries(0x04), at(1, load_setting("Zero load limit", signaling_limit)),
    at(2, load_setting("Norm load limit", signaling_limit)),
    at(3, load_setting("Full load limit", signaling_limit)),
    at(4, load_setting("Overload limit", signaling_limit))};
inline constexpr auto load_signaling_limits_object = array_object(
    0x6483, "Load signaling limits", "4.12.4", "The loads that give the signals of 6482h.",
    load_signaling_limits_entries, {.condition = see_part_2, .errata = "B25, C4"});

inline constexpr EntryInfo rope_entry =
    provided(sub_index(0, "Rope #", entry(unsigned16, ro, no, {}, load_in_kilograms)));
inline constexpr EntryInfo rope_load_entries[] = {count_entry("Number of ropes", 1, last_of_many),
                                                  at(1, rope_entry),
                                                  optional_at(2, last_of_many, rope_entry)};
inline constexpr auto rope_load_object =
    array_object(0x6484, "Rope load", "4.12.5", "The load on each rope.", rope_load_entries,
                 {.condition = see_part_2, .errata = "B26"});

inline constexpr FieldInfo rope_ratio_fields[] = {field(0, 8, "Ratio denominator"),
                                                  field(8, 8, "Ratio nominator")};
inline constexpr EntryInfo load_system_configuration_entries[] = {
    count_entry("Number of entries", 0x01, 0x01),
    at(1,
       sub_index(0, "Rope ratio", entry(unsigned16, rw, no, {}, hexadecimal, rope_ratio_fields)))};
inline constexpr auto load_system_configuration_object =
    array_object(0x6485, "Load measuring system configuration", "4.12.6", "How the ropes run.",
                 load_system_configuration_entries, {.condition = see_part_2});

}  // namespace canvoy::cia417
