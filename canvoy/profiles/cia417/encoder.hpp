// What the encoders of the position units watch and say of themselves: work areas, warnings,
// alarms, properties (CiA 417-4, 4.9.11 to 4.9.35).
//
//     cia417::alarms_object.index  // 63C7h
#pragma once

#include "canvoy/profiles/cia417/position.hpp"

namespace canvoy::cia417 {

// 63B0h to 63BBh Work areas: three objects for each position unit.

inline constexpr EntryInfo area_state_entry = {.name = "Work area state channel #",
                                               .mapping = Mapping::optional,
                                               .value = {.notation = Notation::bit_mask},
                                               .fields = cia406::area_state_fields};
inline constexpr EntryInfo area_state_entries[] = {available_channels, at(1, area_state_entry),
                                                   optional_at(2, last_of_many, area_state_entry)};
inline constexpr ObjectInfo area_state_object = {
    .index = 0x63B0,
    .count = position_unit_count,
    .code = ObjectCode::array,
    .name = "Area state register position unit #",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.11 to 4.9.14",
    .description = "As 6400h of CiA 406: whether the position is within the work areas.",
    .subs = area_state_entries};

constexpr std::array<EntryInfo, 3> work_area_limits(std::string_view name, unsigned unit) {
  const EntryInfo limit = {.name = name,
                           .type = DataType::integer32,
                           .access = Access::rw,
                           .value = position_counts(unit)};
  return {available_channels, at(1, limit), optional_at(2, last_of_many, limit)};
}
template <unsigned unit>
inline constexpr auto low_limit_entries = work_area_limits("Work area lowlimit channel #", unit);
template <unsigned unit>
inline constexpr auto high_limit_entries = work_area_limits("Work area highlimit channel #", unit);

constexpr ObjectInfo low_limit_of_unit(unsigned unit, std::string_view clause,
                                       Items<EntryInfo> entries) {
  return {.index = static_cast<std::uint16_t>(0x63B4 + unit - 1),
          .code = ObjectCode::array,
          .name = "Work area lowlimit position unit #",
          .first_number = static_cast<std::uint16_t>(unit),
          .category = Category::conditional,
          .condition = see_part_2,
          .clause = clause,
          .description = "As 6401h of CiA 406.",
          .subs = entries};
}
constexpr ObjectInfo high_limit_of_unit(unsigned unit, std::string_view clause,
                                        Items<EntryInfo> entries) {
  return {.index = static_cast<std::uint16_t>(0x63B8 + unit - 1),
          .code = ObjectCode::array,
          .name = "Work area highlimit position unit #",
          .first_number = static_cast<std::uint16_t>(unit),
          .category = Category::conditional,
          .condition = see_part_2,
          .clause = clause,
          .description = "As 6402h of CiA 406.",
          .subs = entries};
}
inline constexpr ObjectInfo work_area_low_limit_1_object =
    low_limit_of_unit(1, "4.9.15", low_limit_entries<1>);
inline constexpr ObjectInfo work_area_low_limit_2_object =
    low_limit_of_unit(2, "4.9.16", low_limit_entries<2>);
inline constexpr ObjectInfo work_area_low_limit_3_object =
    low_limit_of_unit(3, "4.9.17", low_limit_entries<3>);
inline constexpr ObjectInfo work_area_low_limit_4_object =
    low_limit_of_unit(4, "4.9.18", low_limit_entries<4>);
inline constexpr ObjectInfo work_area_high_limit_1_object =
    high_limit_of_unit(1, "4.9.19", high_limit_entries<1>);
inline constexpr ObjectInfo work_area_high_limit_2_object =
    high_limit_of_unit(2, "4.9.20", high_limit_entries<2>);
inline constexpr ObjectInfo work_area_high_limit_3_object =
    high_limit_of_unit(3, "4.9.21", high_limit_entries<3>);
inline constexpr ObjectInfo work_area_high_limit_4_object =
    high_limit_of_unit(4, "4.9.22", high_limit_entries<4>);

// 63C0h to 63C9h Status and properties.

inline constexpr auto operating_status_entries =
    for_units_alike(with_fields(measured(DataType::unsigned16), cia406::operating_fields));
inline constexpr ObjectInfo operating_status_object = {
    .index = 0x63C0,
    .code = ObjectCode::array,
    .name = "Operating status",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.23",
    .description = "As 6500h of CiA 406: what of the operating parameter holds.",
    .subs = operating_status_entries};

inline constexpr auto single_turn_resolution_entries =
    for_units_alike(measured(DataType::unsigned32));
inline constexpr ObjectInfo single_turn_resolution_object = {
    .index = 0x63C1,
    .code = ObjectCode::array,
    .name = "Single turn resolution",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.24",
    .description = "As 6501h of CiA 406: steps in a revolution, or the step of a linear encoder.",
    .subs = single_turn_resolution_entries};

inline constexpr auto distinguishable_revolutions_entries =
    for_units_alike(measured(DataType::unsigned16));
inline constexpr ObjectInfo distinguishable_revolutions_object = {
    .index = 0x63C2,
    .code = ObjectCode::array,
    .name = "Number of distinguishable revolutions",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.25",
    .description = "As 6502h of CiA 406.",
    .subs = distinguishable_revolutions_entries};

inline constexpr auto warnings_entries =
    for_units_alike(with_fields(measured(DataType::unsigned16), cia406::warning_fields));
inline constexpr auto alarms_entries =
    for_units_alike(with_fields(measured(DataType::unsigned16), cia406::alarm_fields));
inline constexpr ObjectInfo supported_warnings_object = {.index = 0x63C4,
                                                         .code = ObjectCode::array,
                                                         .name = "Supported warnings",
                                                         .category = Category::conditional,
                                                         .condition = see_part_2,
                                                         .clause = "4.9.26",
                                                         .description = "As 6506h of CiA 406.",
                                                         .subs = warnings_entries};
inline constexpr ObjectInfo warnings_object = {
    .index = 0x63C5,
    .code = ObjectCode::array,
    .name = "Warnings",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.27",
    .description = "As 6505h of CiA 406: the position is good, but something is near its limit.",
    .subs = warnings_entries};
inline constexpr ObjectInfo supported_alarms_object = {.index = 0x63C6,
                                                       .code = ObjectCode::array,
                                                       .name = "Supported alarms",
                                                       .category = Category::conditional,
                                                       .condition = see_part_2,
                                                       .clause = "4.9.28",
                                                       .description = "As 6504h of CiA 406.",
                                                       .subs = alarms_entries};
inline constexpr ObjectInfo alarms_object = {
    .index = 0x63C7,
    .code = ObjectCode::array,
    .name = "Alarms",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.29",
    .description = "As 6503h of CiA 406: the position may be wrong.",
    .subs = alarms_entries};

constexpr EntryInfo with_value(EntryInfo entry, const ValueInfo& value) {
  entry.value = value;
  return entry;
}
inline constexpr auto operating_time_entries =
    for_units_alike(with_value(measured(DataType::unsigned32), cia406::tenths_of_an_hour));
inline constexpr ObjectInfo operating_time_object = {.index = 0x63C8,
                                                     .code = ObjectCode::array,
                                                     .name = "Operating time",
                                                     .category = Category::conditional,
                                                     .condition = see_part_2,
                                                     .clause = "4.9.30",
                                                     .errata = "A12",
                                                     .description = "As 6508h of CiA 406.",
                                                     .subs = operating_time_entries};

inline constexpr auto offset_value_entries =
    for_each_unit(measured(DataType::integer16), position_counts);
inline constexpr ObjectInfo offset_value_object = {
    .index = 0x63C9,
    .code = ObjectCode::array,
    .name = "Offset value",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.9.31",
    .errata = "A12, B23",
    .description = "As 6509h of CiA 406: what the preset has added to the measured position.",
    .subs = offset_value_entries};

// 63D0h to 63D3h Module identification.

constexpr std::array<EntryInfo, 4> module_identification_of(unsigned unit) {
  const EntryInfo shape = {.type = DataType::unsigned32, .value = position_counts(unit)};
  std::array<EntryInfo, 4> entries{number_of_entries(0x01, 0x03), at(1, shape),
                                   optional_at(2, 2, shape), optional_at(3, 3, shape)};
  entries[1].name = "Manufacturer offset value";
  entries[1].initial = 0;
  entries[2].name = "Manufacturer minimum position value";
  entries[3].name = "Manufacturer maximum position value";
  return entries;
}
template <unsigned unit>
inline constexpr auto module_identification_entries = module_identification_of(unit);
constexpr ObjectInfo module_identification(unsigned unit, std::string_view clause,
                                           Items<EntryInfo> entries) {
  return {.index = static_cast<std::uint16_t>(0x63D0 + unit - 1),
          .code = ObjectCode::array,
          .name = "Module identification position unit #",
          .first_number = static_cast<std::uint16_t>(unit),
          .category = Category::conditional,
          .condition = see_part_2,
          .clause = clause,
          .errata = "B23",
          .description = "As 650Ah of CiA 406: offset and range as the maker has set them.",
          .subs = entries};
}
inline constexpr ObjectInfo module_identification_1_object =
    module_identification(1, "4.9.32", module_identification_entries<1>);
inline constexpr ObjectInfo module_identification_2_object =
    module_identification(2, "4.9.33", module_identification_entries<2>);
inline constexpr ObjectInfo module_identification_3_object =
    module_identification(3, "4.9.34", module_identification_entries<3>);
inline constexpr ObjectInfo module_identification_4_object =
    module_identification(4, "4.9.35", module_identification_entries<4>);

}  // namespace canvoy::cia417
