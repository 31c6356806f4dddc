// Position and speed of the car, and settings of the encoder: up to four position units (CiA 417-4,
// 4.9), and the cams of the position CAM unit (4.10). Values are those of CiA 406.
//
//     cia417::position_value_object.subs[1].value.step.index  // 6384h
#pragma once

#include "canvoy/profiles/cia406/values.hpp"
#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

inline constexpr unsigned position_unit_count = 4;
inline constexpr std::string_view position_unit_name = "Position unit #";

// 6384h to 6387h Measuring steps: the size of one count of position, speed and acceleration.

inline constexpr std::uint16_t measuring_step_index = 0x6384;
inline constexpr std::int64_t position_step_default = 10;
inline constexpr std::int64_t speed_step_default = 10;
inline constexpr std::int64_t acceleration_step_default = 1;
/// In micrometres, mm/s and mm/s2.
inline constexpr Scale position_step = {.numerator = 10};
inline constexpr Scale speed_step = {.denominator = 10};
inline constexpr Scale acceleration_step = {};

/// Errata A13: transferred as Unsigned32, with the range of an Unsigned16.
constexpr EntryInfo step_entry(std::string_view name, Unit unit, const Scale& scale,
                               std::int64_t initial) {
  return sub_index(0, name,
                   entry(unsigned32, rw, no, initial,
                         {.unit = unit, .scale = scale, .limits = within(0, 0xFFFF)}),
                   {.errata = "A13"});
}
inline constexpr EntryInfo measuring_step_entries[] = {
    number_of_entries(0x03),
    at(1, step_entry("Measuring step", Unit::micrometre, position_step, position_step_default)),
    at(2, step_entry("Speed measuring step", Unit::millimetre_per_second, speed_step,
                     speed_step_default)),
    at(3, step_entry("Acceleration measuring step", Unit::millimetre_per_second_squared,
                     acceleration_step, acceleration_step_default))};
inline constexpr auto measuring_step_settings_object = array_object(
    measuring_step_index, "Encoder measuring step settings position unit #", "4.9.5 to 4.9.8",
    "What one count of position, speed and acceleration is.", measuring_step_entries,
    {.count = position_unit_count, .condition = see_part_2, .errata = "A3, A13, A19"});

/// Counts of position unit `unit`, counted from 1.
constexpr ValueInfo steps(Unit of, Scale step, std::int64_t count, unsigned unit, unsigned sub) {
  step.numerator *= count;
  return {.unit = of,
          .scale = step,
          .step = {static_cast<std::uint16_t>(measuring_step_index + unit - 1),
                   static_cast<std::uint8_t>(sub)}};
}
/// In the steps of 6384h ff. of that position unit, in mm.
constexpr ValueInfo position_counts(unsigned unit) {
  Scale in_millimetres = position_step;
  in_millimetres.denominator *= 1000;
  return steps(Unit::millimetre, in_millimetres, position_step_default, unit, 1);
}
/// In the steps of 6384h ff. of that position unit, in mm/s.
constexpr ValueInfo speed_counts(unsigned unit) {
  return steps(Unit::millimetre_per_second, speed_step, speed_step_default, unit, 2);
}
/// In the steps of 6384h ff. of that position unit, in mm/s^2.
constexpr ValueInfo acceleration_counts(unsigned unit) {
  return steps(Unit::millimetre_per_second_squared, acceleration_step, acceleration_step_default,
               unit, 3);
}

// Arrays with an entry for each position unit; only the first one is mandatory.

/// Sub-index 00h, and one entry for each position unit.
using PositionUnitEntries = std::array<EntryInfo, position_unit_count + 1>;

/// `of_unit` returns the value of position unit 1 to 4; `mapping` applies to the first.
template <class ValueOfUnit>
constexpr PositionUnitEntries for_each_unit(const EntryInfo& shape, ValueOfUnit of_unit,
                                            Mapping mapping = Mapping::no) {
  PositionUnitEntries entries{number_of_entries(1, position_unit_count)};
  for (std::uint8_t unit = 1; unit <= position_unit_count; ++unit) {
    EntryInfo& entry = entries[unit];
    entry = unit == 1 ? at(1, shape) : optional_at(unit, unit, shape);
    entry.name = position_unit_name;
    entry.value = of_unit(unit);
    const bool is_first = unit == 1 || mapping == Mapping::no;
    entry.mapping = is_first ? mapping : Mapping::optional;
  }
  return entries;
}
/// See for_each_unit(); all units have the same shape.
constexpr std::array<EntryInfo, 3> for_units_alike(EntryInfo shape) {
  shape.name = position_unit_name;
  return {number_of_entries(1, position_unit_count), at(1, shape),
          optional_at(2, position_unit_count, shape)};
}
/// Values from the encoder and its settings.
constexpr EntryInfo measured(DataType type) {
  return provided(entry(type, ro));
}
/// See measured(): a setting can be written.
constexpr EntryInfo setting(DataType type) {
  return entry(type, rw);
}

// Settings.

/// The entry as hexadecimal code with fields.
constexpr EntryInfo with_fields(EntryInfo entry, Items<FieldInfo> fields) {
  entry.value = hexadecimal;
  entry.fields = fields;
  return entry;
}

inline constexpr auto operating_parameter_entries =
    for_units_alike(with_fields(setting(DataType::unsigned16), cia406::operating_fields));
inline constexpr auto operating_parameter_object = array_object(
    0x6380, "Operating parameter", "4.9.1", "As 6000h of CiA 406: direction, scaling, diagnostics.",
    operating_parameter_entries, {.condition = see_part_2});

inline constexpr auto units_per_revolution_entries = for_units_alike(setting(DataType::unsigned32));
inline constexpr auto units_per_revolution_object =
    array_object(0x6381, "Measuring units per revolution", "4.9.2",
                 "As 6001h of CiA 406: counts of a rotary encoder in one revolution.",
                 units_per_revolution_entries, {.condition = see_part_2});

inline constexpr auto preset_value_entries =
    for_each_unit(setting(DataType::unsigned32), position_counts);
inline constexpr auto preset_value_object =
    array_object(0x6382, "Preset value", "4.9.3",
                 "As 6003h of CiA 406: what the position is to be where the car now is.",
                 preset_value_entries, {.condition = see_part_2});

// Position, speed, acceleration.

inline constexpr auto position_value_entries =
    for_each_unit(measured(DataType::unsigned32), position_counts, Mapping::by_default);
inline constexpr auto position_value_object =
    array_object(0x6383, "Position value", "4.9.4",
                 "As 6004h of CiA 406, in the measuring steps of 6384h and above.",
                 position_value_entries, {.condition = see_part_2});

inline constexpr auto speed_value_entries =
    for_each_unit(measured(DataType::integer16), speed_counts, Mapping::by_default);
inline constexpr auto speed_value_car_object = array_object(
    0x6390, "Speed value car", "4.9.9", "In the speed measuring steps of 6384h and above.",
    speed_value_entries, {.condition = see_part_2, .errata = "A19, C11"});

inline constexpr auto acceleration_value_entries =
    for_each_unit(measured(DataType::integer16), acceleration_counts, Mapping::by_default);
inline constexpr auto acceleration_value_car_object =
    array_object(0x6391, "Acceleration value car", "4.9.10",
                 "In the acceleration measuring steps of 6384h and above.",
                 acceleration_value_entries, {.condition = see_part_2, .errata = "A19, C11"});

// 63A0h to 63A2h Cams: a bit for each cam of a channel.

inline constexpr EntryInfo available_channels =
    count_entry("Number of available channels", 0x01, last_of_many);

inline constexpr EntryInfo cam_state_entry = sub_index(
    0, "CAM state channel #",
    entry(unsigned8, ro, optional, {}, {.notation = Notation::bit_mask}, cia406::cam_state_fields));
/// A bit for each of eight cams of a channel.
constexpr EntryInfo cam_setting(std::string_view name, Items<FieldInfo> fields) {
  return sub_index(0, name,
                   entry(unsigned8, rw, optional, 0x00, {.notation = Notation::bit_mask}, fields));
}
inline constexpr EntryInfo cam_enable_entry =
    cam_setting("CAM enable channel #", cia406::cam_enable_fields);
inline constexpr EntryInfo cam_polarity_entry =
    cam_setting("CAM polarity channel #", cia406::cam_polarity_fields);
inline constexpr EntryInfo cam_state_entries[] = {available_channels, at(1, cam_state_entry),
                                                  optional_at(2, last_of_many, cam_state_entry)};
inline constexpr EntryInfo cam_enable_entries[] = {available_channels, at(1, cam_enable_entry),
                                                   optional_at(2, last_of_many, cam_enable_entry)};
inline constexpr EntryInfo cam_polarity_entries[] = {
    available_channels, at(1, cam_polarity_entry),
    optional_at(2, last_of_many, cam_polarity_entry)};
inline constexpr auto cam_state_object = array_object(
    0x63A0, "CAM state register", "4.10.1", "As 6300h of CiA 406: which cams the position is on.",
    cam_state_entries, {.condition = see_part_2, .errata = "B29"});
inline constexpr auto cam_enable_object = array_object(
    0x63A1, "CAM enable register", "4.10.2", "As 6301h of CiA 406: which cams are worked out.",
    cam_enable_entries, {.condition = see_part_2, .errata = "B29"});
inline constexpr auto cam_polarity_object = array_object(
    0x63A2, "CAM polarity register", "4.10.3", "As 6302h of CiA 406: which cams are inverted.",
    cam_polarity_entries, {.condition = see_part_2, .errata = "A17, B4, B29"});

}  // namespace canvoy::cia417
