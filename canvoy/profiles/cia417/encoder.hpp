// Monitoring and properties of the encoders of the position units: work areas, warnings, alarms,
// identification (CiA 417-4, 4.9.11 to 4.9.35).
//
//     cia417::alarms_object.index  // 63C7h
#pragma once

#include "canvoy/profiles/cia417/position.hpp"

namespace canvoy::cia417 {

// 63B0h to 63BBh Work areas: three objects for each position unit.

inline constexpr EntryInfo area_state_entry =
    sub_index(0, "Work area state channel #",
              entry(unsigned8, ro, optional, {}, {.notation = Notation::bit_mask},
                    cia406::area_state_fields));
inline constexpr EntryInfo area_state_entries[] = {available_channels, at(1, area_state_entry),
                                                   optional_at(2, last_of_many, area_state_entry)};
inline constexpr auto area_state_object =
    array_object(0x63B0, "Area state register position unit #", "4.9.11 to 4.9.14",
                 "As 6400h of CiA 406: whether the position is within the work areas.",
                 area_state_entries, {.count = position_unit_count, .condition = see_part_2});

/// Limits of up to 254 channels, in the measuring steps of the position unit.
constexpr std::array<EntryInfo, 3> work_area_limits(std::string_view name, unsigned unit) {
  const EntryInfo limit = sub_index(0, name, entry(integer32, rw, no, {}, position_counts(unit)));
  return {available_channels, at(1, limit), optional_at(2, last_of_many, limit)};
}
template <unsigned unit>
inline constexpr auto low_limit_entries = work_area_limits("Work area lowlimit channel #", unit);
template <unsigned unit>
inline constexpr auto high_limit_entries = work_area_limits("Work area highlimit channel #", unit);

/// One of 63B4h to 63B7h, for position unit 1 to 4.
constexpr ObjectInfo low_limit_of_unit(unsigned unit, std::string_view clause,
                                       Items<EntryInfo> entries) {
  return array_object(static_cast<std::uint16_t>(0x63B4 + unit - 1),
                      "Work area lowlimit position unit #", clause, "As 6401h of CiA 406.", entries,
                      {.first_number = static_cast<std::uint16_t>(unit), .condition = see_part_2});
}
/// One of 63B8h to 63BBh, for position unit 1 to 4.
constexpr ObjectInfo high_limit_of_unit(unsigned unit, std::string_view clause,
                                        Items<EntryInfo> entries) {
  return array_object(static_cast<std::uint16_t>(0x63B8 + unit - 1),
                      "Work area highlimit position unit #", clause, "As 6402h of CiA 406.",
                      entries,
                      {.first_number = static_cast<std::uint16_t>(unit), .condition = see_part_2});
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
inline constexpr auto operating_status_object =
    array_object(0x63C0, "Operating status", "4.9.23",
                 "As 6500h of CiA 406: what of the operating parameter holds.",
                 operating_status_entries, {.condition = see_part_2});

inline constexpr auto single_turn_resolution_entries =
    for_units_alike(measured(DataType::unsigned32));
inline constexpr auto single_turn_resolution_object =
    array_object(0x63C1, "Single turn resolution", "4.9.24",
                 "As 6501h of CiA 406: steps in a revolution, or the step of a linear encoder.",
                 single_turn_resolution_entries, {.condition = see_part_2});

inline constexpr auto distinguishable_revolutions_entries =
    for_units_alike(measured(DataType::unsigned16));
inline constexpr auto distinguishable_revolutions_object =
    array_object(0x63C2, "Number of distinguishable revolutions", "4.9.25", "As 6502h of CiA 406.",
                 distinguishable_revolutions_entries, {.condition = see_part_2});

inline constexpr auto warnings_entries =
    for_units_alike(with_fields(measured(DataType::unsigned16), cia406::warning_fields));
inline constexpr auto alarms_entries =
    for_units_alike(with_fields(measured(DataType::unsigned16), cia406::alarm_fields));
inline constexpr auto supported_warnings_object =
    array_object(0x63C4, "Supported warnings", "4.9.26", "As 6506h of CiA 406.", warnings_entries,
                 {.condition = see_part_2});
inline constexpr auto warnings_object =
    array_object(0x63C5, "Warnings", "4.9.27",
                 "As 6505h of CiA 406: the position is good, but something is near its limit.",
                 warnings_entries, {.condition = see_part_2});
inline constexpr auto supported_alarms_object =
    array_object(0x63C6, "Supported alarms", "4.9.28", "As 6504h of CiA 406.", alarms_entries,
                 {.condition = see_part_2});
inline constexpr auto alarms_object =
    array_object(0x63C7, "Alarms", "4.9.29", "As 6503h of CiA 406: the position may be wrong.",
                 alarms_entries, {.condition = see_part_2});

/// The entry with another unit and range.
constexpr EntryInfo with_value(EntryInfo entry, const ValueInfo& value) {
  entry.value = value;
  return entry;
}
inline constexpr auto operating_time_entries =
    for_units_alike(with_value(measured(DataType::unsigned32), cia406::tenths_of_an_hour));
inline constexpr auto operating_time_object =
    array_object(0x63C8, "Operating time", "4.9.30", "As 6508h of CiA 406.", operating_time_entries,
                 {.condition = see_part_2, .errata = "A12"});

inline constexpr auto offset_value_entries =
    for_each_unit(measured(DataType::integer16), position_counts);
inline constexpr auto offset_value_object =
    array_object(0x63C9, "Offset value", "4.9.31",
                 "As 6509h of CiA 406: what the preset has added to the measured position.",
                 offset_value_entries, {.condition = see_part_2, .errata = "A12, B23"});

// 63D0h to 63D3h Module identification.

/// Offset, minimum and maximum as the maker has set them.
constexpr std::array<EntryInfo, 4> module_identification_of(unsigned unit) {
  const EntryInfo shape = entry(unsigned32, ro, no, {}, position_counts(unit));
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
/// One of 63D0h to 63D3h, for position unit 1 to 4.
constexpr ObjectInfo module_identification(unsigned unit, std::string_view clause,
                                           Items<EntryInfo> entries) {
  return array_object(
      static_cast<std::uint16_t>(0x63D0 + unit - 1), "Module identification position unit #",
      clause, "As 650Ah of CiA 406: offset and range as the maker has set them.", entries,
      {.first_number = static_cast<std::uint16_t>(unit), .condition = see_part_2, .errata = "B23"});
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
