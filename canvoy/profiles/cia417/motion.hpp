// Targets and actual values of the drive of the car: position, homing and velocity (CiA 417-4,
// 4.11.4 to 4.11.6). Values are those of CiA 402, at other indices.
//
//     drive[cia417::target_velocity] = 1500;  // positive: upward; 0 ends the travel
#pragma once

#include "canvoy/profiles/cia417/drive.hpp"

namespace canvoy::cia417 {

// Profile position mode.

inline constexpr ObjectInfo target_position_object = {
    .index = 0x6420,
    .name = "Target position",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.4.1",
    .errata = "C14",
    .description = "As 607Ah of CiA 402; it may change while the car moves.",
    .entry = drive_entry(DataType::integer32, drive_amount)};

/// Errata A14 and A15: without limit.
constexpr std::array<EntryInfo, 3> position_limits(std::string_view minimum,
                                                   std::string_view maximum,
                                                   std::string_view errata) {
  std::array<EntryInfo, 3> entries{
      number_of_entries(0x02),
      at(1, with_default(named(minimum, drive_setting(DataType::integer32, drive_amount)),
                         -0x8000'0000LL)),
      at(2, with_default(named(maximum, drive_setting(DataType::integer32, drive_amount)),
                         0x7FFF'FFFF))};
  entries[1].errata = errata;
  entries[2].errata = errata;
  return entries;
}
inline constexpr auto position_range_limit_entries =
    position_limits("Min position range limit", "Max position range limit", "A15");
inline constexpr ObjectInfo position_range_limit_object = {
    .index = 0x6421,
    .code = ObjectCode::array,
    .name = "Position range limit",
    .category = Category::optional,
    .clause = "4.11.4.2",
    .errata = "A15",
    .description = "As 607Bh of CiA 402: where the count of positions turns over.",
    .subs = position_range_limit_entries};
inline constexpr auto software_position_limit_entries =
    position_limits("Min position limit", "Max position limit", "A14");
inline constexpr ObjectInfo software_position_limit_object = {
    .index = 0x6422,
    .code = ObjectCode::array,
    .name = "Software position limit",
    .category = Category::optional,
    .clause = "4.11.4.3",
    .errata = "A14",
    .description = "As 607Dh of CiA 402: no target lies beyond.",
    .subs = software_position_limit_entries};

inline constexpr ObjectInfo profile_velocity_object = {
    .index = 0x6423,
    .name = "Profile velocity",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.4.4",
    .description = "As 6081h of CiA 402: the velocity between the ramps.",
    .entry = with_default(drive_setting(DataType::unsigned32, drive_amount), 1)};
inline constexpr ObjectInfo end_velocity_object = {
    .index = 0x6424,
    .name = "End velocity",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.4.5",
    .errata = "B21",
    .description = "As 6082h of CiA 402: the velocity at the floor switch.",
    .entry = with_default(drive_setting(DataType::unsigned32, drive_amount), 1)};

// Homing mode.

inline constexpr ObjectInfo home_offset_object = {
    .index = 0x6428,
    .name = "Home offset",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.5.1",
    .errata = "C14",
    .description = "As 607Ch of CiA 402: from the home position to position 0.",
    .entry = {.type = DataType::integer32,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .initial = 0,
              .value = drive_amount}};

// Profile velocity mode.

constexpr ObjectInfo velocity_value(std::uint16_t index, std::string_view clause,
                                    std::string_view name, std::string_view description) {
  return {.index = index,
          .name = name,
          .category = Category::conditional,
          .condition = see_part_2,
          .clause = clause,
          .errata = "C14",
          .description = description,
          .entry = drive_entry(DataType::integer32, drive_amount)};
}
inline constexpr ObjectInfo target_velocity_object =
    velocity_value(0x6430, "4.11.6.1", "Target velocity",
                   "As 60FFh of CiA 402: upward where it is positive; 0 ends the travel.");
inline constexpr ObjectInfo velocity_sensor_actual_value_object = velocity_value(
    0x6431, "4.11.6.2", "Velocity sensor actual value", "As 6069h of CiA 402: in increments.");
inline constexpr ObjectInfo velocity_demand_value_object =
    velocity_value(0x6432, "4.11.6.3", "Velocity demand value",
                   "As 606Bh of CiA 402: what the ramp now asks for.");
inline constexpr ObjectInfo velocity_actual_value_object = velocity_value(
    0x6433, "4.11.6.4", "Velocity actual value", "As 606Ch of CiA 402: how fast the car moves.");

inline constexpr ObjectInfo sensor_selection_code_object = {
    .index = 0x6434,
    .name = "Sensor selection code",
    .category = Category::optional,
    .clause = "4.11.6.5",
    .description = "As 606Ah of CiA 402: what 6433h is made of.",
    .entry = drive_setting(DataType::integer16, {.names = cia402::sensor_selection_names})};

/// Errata B22: Integer32 as printed, also of the time.
constexpr std::array<EntryInfo, 3> window(std::string_view width, std::string_view time) {
  std::array<EntryInfo, 3> entries{
      number_of_entries(0x02),
      at(1, named(width, drive_setting(DataType::integer32, drive_amount))),
      at(2, named(time, drive_setting(DataType::integer32, {.unit = Unit::millisecond})))};
  entries[2].errata = "B22";
  return entries;
}
inline constexpr auto velocity_window_entries = window("Velocity window", "Velocity window time");
inline constexpr ObjectInfo velocity_window_object = {
    .index = 0x6435,
    .code = ObjectCode::array,
    .name = "Velocity window",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.6.6",
    .errata = "B22",
    .description = "As 606Dh and 606Eh of CiA 402: when the target velocity counts as reached.",
    .subs = velocity_window_entries};
inline constexpr auto velocity_threshold_entries =
    window("Velocity threshold", "Velocity threshold time");
inline constexpr ObjectInfo velocity_threshold_object = {
    .index = 0x6436,
    .code = ObjectCode::array,
    .name = "Velocity threshold",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.6.7",
    .errata = "B22",
    .description = "As 606Fh and 6070h of CiA 402: when the car counts as standing.",
    .subs = velocity_threshold_entries};

inline constexpr ObjectInfo max_slippage_object = {
    .index = 0x6437,
    .name = "Max slippage",
    .category = Category::optional,
    .clause = "4.11.6.8",
    .description = "As 60F8h of CiA 402: beyond it, bit 13 of the statusword is set.",
    .entry = drive_setting(DataType::integer32, drive_amount)};

/// Errata B5: what is behind the first two, the maker says.
inline constexpr EntryInfo further_control_parameter = {.name = "Velocity demand value",
                                                        .type = DataType::unsigned16,
                                                        .access = Access::rw,
                                                        .errata = "B5"};
inline constexpr EntryInfo velocity_control_parameter_entries[] = {
    count_entry("Number of entries", 0x02, last_of_many),
    at(1, named("Gain", drive_setting(DataType::unsigned16, drive_amount))),
    at(2,
       named("Ti – integration time constant", drive_setting(DataType::unsigned16, drive_amount))),
    optional_at(3, last_of_many, further_control_parameter)};
inline constexpr ObjectInfo velocity_control_parameter_set_object = {
    .index = 0x6438,
    .code = ObjectCode::array,
    .name = "Velocity control parameter set",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.6.9",
    .errata = "B5",
    .description = "As 60F9h of CiA 402; further ones are the maker's.",
    .subs = velocity_control_parameter_entries};

}  // namespace canvoy::cia417
