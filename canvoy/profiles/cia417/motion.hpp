// Targets and actual values of the drive of the car: position, homing and velocity (CiA 417-4,
// 4.11.4 to 4.11.6). Values are those of CiA 402, at other indices.
//
//     drive[cia417::target_velocity] = 1500;  // positive: upward; 0 ends the travel
#pragma once

#include "canvoy/profiles/cia417/drive.hpp"

namespace canvoy::cia417 {

// Profile position mode.

inline constexpr auto target_position_object = var_object(
    0x6420, "Target position", "4.11.4.1",
    "As 607Ah of CiA 402; it may change while the car moves.",
    drive_entry(DataType::integer32, drive_amount), {.condition = see_part_2, .errata = "C14"});

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
inline constexpr auto position_range_limit_object =
    array_object(0x6421, "Position range limit", "4.11.4.2",
                 "As 607Bh of CiA 402: where the count of positions turns over.",
                 position_range_limit_entries, {.category = Category::optional, .errata = "A15"});
inline constexpr auto software_position_limit_entries =
    position_limits("Min position limit", "Max position limit", "A14");
inline constexpr auto software_position_limit_object = array_object(
    0x6422, "Software position limit", "4.11.4.3", "As 607Dh of CiA 402: no target lies beyond.",
    software_position_limit_entries, {.category = Category::optional, .errata = "A14"});

inline constexpr auto profile_velocity_object = var_object(
    0x6423, "Profile velocity", "4.11.4.4", "As 6081h of CiA 402: the velocity between the ramps.",
    with_default(drive_setting(DataType::unsigned32, drive_amount), 1), {.condition = see_part_2});
inline constexpr auto end_velocity_object = var_object(
    0x6424, "End velocity", "4.11.4.5", "As 6082h of CiA 402: the velocity at the floor switch.",
    with_default(drive_setting(DataType::unsigned32, drive_amount), 1),
    {.condition = see_part_2, .errata = "B21"});

// Homing mode.

inline constexpr auto home_offset_object = var_object(
    0x6428, "Home offset", "4.11.5.1", "As 607Ch of CiA 402: from the home position to position 0.",
    entry(integer32, rw, optional, 0, drive_amount), {.condition = see_part_2, .errata = "C14"});

// Profile velocity mode.

/// A velocity of the drive, as in CiA 402.
constexpr ObjectInfo velocity_value(std::uint16_t index, std::string_view clause,
                                    std::string_view name, std::string_view description) {
  return var_object(index, name, clause, description,
                    drive_entry(DataType::integer32, drive_amount),
                    {.condition = see_part_2, .errata = "C14"});
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

inline constexpr auto sensor_selection_code_object = var_object(
    0x6434, "Sensor selection code", "4.11.6.5", "As 606Ah of CiA 402: what 6433h is made of.",
    drive_setting(DataType::integer16, {.names = cia402::sensor_selection_names}),
    {.category = Category::optional});

/// Errata B22: Integer32 as printed, also for the time.
constexpr std::array<EntryInfo, 3> window(std::string_view width, std::string_view time) {
  std::array<EntryInfo, 3> entries{
      number_of_entries(0x02),
      at(1, named(width, drive_setting(DataType::integer32, drive_amount))),
      at(2, named(time, drive_setting(DataType::integer32, {.unit = Unit::millisecond})))};
  entries[2].errata = "B22";
  return entries;
}
inline constexpr auto velocity_window_entries = window("Velocity window", "Velocity window time");
inline constexpr auto velocity_window_object =
    array_object(0x6435, "Velocity window", "4.11.6.6",
                 "As 606Dh and 606Eh of CiA 402: when the target velocity counts as reached.",
                 velocity_window_entries, {.condition = see_part_2, .errata = "B22"});
inline constexpr auto velocity_threshold_entries =
    window("Velocity threshold", "Velocity threshold time");
inline constexpr auto velocity_threshold_object =
    array_object(0x6436, "Velocity threshold", "4.11.6.7",
                 "As 606Fh and 6070h of CiA 402: when the car counts as standing.",
                 velocity_threshold_entries, {.condition = see_part_2, .errata = "B22"});

inline constexpr auto max_slippage_object =
    var_object(0x6437, "Max slippage", "4.11.6.8",
               "As 60F8h of CiA 402: beyond it, bit 13 of the statusword is set.",
               drive_setting(DataType::integer32, drive_amount), {.category = Category::optional});

/// Errata B5: the maker defines the entries behind the first two.
inline constexpr EntryInfo further_control_parameter =
    sub_index(0, "Velocity demand value", entry(unsigned16, rw), {.errata = "B5"});
inline constexpr EntryInfo velocity_control_parameter_entries[] = {
    count_entry("Number of entries", 0x02, last_of_many),
    at(1, named("Gain", drive_setting(DataType::unsigned16, drive_amount))),
    at(2,
       named("Ti – integration time constant", drive_setting(DataType::unsigned16, drive_amount))),
    optional_at(3, last_of_many, further_control_parameter)};
inline constexpr auto velocity_control_parameter_set_object =
    array_object(0x6438, "Velocity control parameter set", "4.11.6.9",
                 "As 60F9h of CiA 402; further ones are the maker's.",
                 velocity_control_parameter_entries, {.condition = see_part_2, .errata = "B5"});

}  // namespace canvoy::cia417
