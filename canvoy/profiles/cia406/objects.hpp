// The objects of CiA 406. For how certain they are, see cia406.hpp.
//
//     cia406::position_value_object.index  // 6004h
#pragma once

#include <array>

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/cia406/values.hpp"

namespace canvoy::cia406 {

/// Sub-index 00h, and an entry for each channel.
constexpr std::array<EntryInfo, 2> channels(EntryInfo each) {
  each.sub_first = 1;
  each.sub_last = 254;
  return {cia301::highest_sub_index, each};
}

// Parameters, positions and speeds.

inline constexpr auto operating_parameters_object =
    var_object(0x6000, "Operating parameters", "", "How the encoder counts.",
               entry(unsigned16, rw, no, 0, {.notation = Notation::bit_mask}, operating_fields),
               {.category = Category::optional});
inline constexpr auto measuring_units_per_revolution_object =
    var_object(0x6001, "Measuring units per revolution", "", "Of rotary encoders.",
               entry(unsigned32, rw), {.category = Category::optional});
inline constexpr auto total_measuring_range_in_measuring_units_object = var_object(
    0x6002, "Total measuring range in measuring units", "", "Where the count begins anew.",
    entry(unsigned32, rw), {.category = Category::optional});
inline constexpr auto preset_value_object =
    var_object(0x6003, "Preset value", "", "What the position is to be where the encoder now is.",
               entry(unsigned32, rw), {.category = Category::optional});
inline constexpr auto position_value_object =
    var_object(0x6004, "Position value", "", "Where the encoder is.",
               entry(unsigned32, ro, by_default), {.category = Category::optional});
inline constexpr auto linear_encoder_measuring_step_settings_entries =
    channels(sub_index(0, "Measuring step #", entry(unsigned32, rw)));
inline constexpr auto linear_encoder_measuring_step_settings_object = array_object(
    0x6005, "Linear encoder measuring step settings", "", "What one count of a linear encoder is.",
    linear_encoder_measuring_step_settings_entries, {.category = Category::optional});
inline constexpr auto preset_values_for_multi_sensor_devices_entries =
    channels(sub_index(0, "Preset value channel #", entry(unsigned32, rw)));
inline constexpr auto preset_values_for_multi_sensor_devices_object =
    array_object(0x6010, "Preset values for multi-sensor devices", "", "As 6003h.",
                 preset_values_for_multi_sensor_devices_entries, {.category = Category::optional});
inline constexpr auto position_values_for_multi_sensor_devices_entries =
    channels(sub_index(0, "Position value channel #", entry(integer32, ro, optional)));
inline constexpr auto position_values_for_multi_sensor_devices_object = array_object(
    0x6020, "Position values for multi-sensor devices", "", "As 6004h, with a sign.",
    position_values_for_multi_sensor_devices_entries, {.category = Category::optional});
inline constexpr auto speed_value_entries =
    channels(sub_index(0, "Speed value channel #", entry(integer16, ro, optional)));
inline constexpr auto speed_value_object =
    array_object(0x6030, "Speed value", "", "How fast the position changes.", speed_value_entries,
                 {.category = Category::optional});
inline constexpr auto acceleration_value_entries =
    channels(sub_index(0, "Acceleration value channel #", entry(integer16, ro, optional)));
inline constexpr auto acceleration_value_object =
    array_object(0x6040, "Acceleration value", "", "How fast the speed changes.",
                 acceleration_value_entries, {.category = Category::optional});
inline constexpr auto cyclic_timer_object = var_object(
    0x6200, "Cyclic timer", "", "The event timer of TPDO 1.",
    entry(unsigned16, rw, no, {}, {.unit = Unit::millisecond}), {.category = Category::optional});

// Cams and work areas.

inline constexpr auto cam_state_register_entries = channels(sub_index(
    0, "CAM state channel #",
    entry(unsigned8, ro, optional, {}, {.notation = Notation::bit_mask}, cam_state_fields)));
inline constexpr auto cam_state_register_object =
    array_object(0x6300, "CAM state register", "", "Which cams the position is on.",
                 cam_state_register_entries, {.category = Category::optional});
inline constexpr auto cam_enable_register_entries = channels(sub_index(
    0, "CAM enable channel #",
    entry(unsigned8, rw, optional, 0, {.notation = Notation::bit_mask}, cam_enable_fields)));
inline constexpr auto cam_enable_register_object =
    array_object(0x6301, "CAM enable register", "", "Which cams are worked out.",
                 cam_enable_register_entries, {.category = Category::optional});
inline constexpr auto cam_polarity_register_entries = channels(sub_index(
    0, "CAM polarity channel #",
    entry(unsigned8, rw, optional, 0, {.notation = Notation::bit_mask}, cam_polarity_fields)));
inline constexpr auto cam_polarity_register_object =
    array_object(0x6302, "CAM polarity register", "", "Which cams are inverted.",
                 cam_polarity_register_entries, {.category = Category::optional});
inline constexpr auto cam_low_limit_entries =
    channels(sub_index(0, "Low limit channel #", entry(integer32, rw)));
inline constexpr auto cam_low_limit_object =
    array_object(0x6310, "CAM # low limit", "", "Where the cam begins.", cam_low_limit_entries,
                 {.count = 8, .category = Category::optional});
inline constexpr auto cam_high_limit_entries =
    channels(sub_index(0, "High limit channel #", entry(integer32, rw)));
inline constexpr auto cam_high_limit_object =
    array_object(0x6320, "CAM # high limit", "", "Where the cam ends.", cam_high_limit_entries,
                 {.count = 8, .category = Category::optional});
inline constexpr auto cam_hysteresis_entries =
    channels(sub_index(0, "Hysteresis channel #", entry(unsigned16, rw)));
inline constexpr auto cam_hysteresis_object =
    array_object(0x6330, "CAM # hysteresis", "", "How far the position has to leave the cam again.",
                 cam_hysteresis_entries, {.count = 8, .category = Category::optional});
inline constexpr auto area_state_register_entries = channels(sub_index(
    0, "Work area state channel #",
    entry(unsigned8, ro, optional, {}, {.notation = Notation::bit_mask}, area_state_fields)));
inline constexpr auto area_state_register_object =
    array_object(0x6400, "Area state register", "", "Whether the position is within the work area.",
                 area_state_register_entries, {.category = Category::optional});
inline constexpr auto work_area_low_limit_entries =
    channels(sub_index(0, "Work area low limit channel #", entry(integer32, rw)));
inline constexpr auto work_area_low_limit_object =
    array_object(0x6401, "Work area low limit", "", "", work_area_low_limit_entries,
                 {.category = Category::optional});
inline constexpr auto work_area_high_limit_entries =
    channels(sub_index(0, "Work area high limit channel #", entry(integer32, rw)));
inline constexpr auto work_area_high_limit_object =
    array_object(0x6402, "Work area high limit", "", "", work_area_high_limit_entries,
                 {.category = Category::optional});

// Diagnostics and identification of the encoder.

inline constexpr auto operating_status_object =
    var_object(0x6500, "Operating status", "", "What of 6000h holds.",
               entry(unsigned16, ro, no, {}, {.notation = Notation::bit_mask}, operating_fields),
               {.category = Category::optional});
inline constexpr auto single_turn_resolution_object = var_object(
    0x6501, "Single-turn resolution", "", "Steps in a revolution, or the step of a linear encoder.",
    entry(unsigned32, ro), {.category = Category::optional});
inline constexpr auto number_of_distinguishable_revolutions_object =
    var_object(0x6502, "Number of distinguishable revolutions", "", "", entry(unsigned16, ro),
               {.category = Category::optional});
inline constexpr auto alarms_object =
    var_object(0x6503, "Alarms", "", "The position may be wrong.",
               entry(unsigned16, ro, optional, {}, {.notation = Notation::bit_mask}, alarm_fields),
               {.category = Category::optional});
inline constexpr auto supported_alarms_object =
    var_object(0x6504, "Supported alarms", "", "",
               entry(unsigned16, ro, no, {}, {.notation = Notation::bit_mask}, alarm_fields),
               {.category = Category::optional});
inline constexpr auto warnings_object = var_object(
    0x6505, "Warnings", "", "The position is good, but something is near its limit.",
    entry(unsigned16, ro, optional, {}, {.notation = Notation::bit_mask}, warning_fields),
    {.category = Category::optional});
inline constexpr auto supported_warnings_object =
    var_object(0x6506, "Supported warnings", "", "",
               entry(unsigned16, ro, no, {}, {.notation = Notation::bit_mask}, warning_fields),
               {.category = Category::optional});
inline constexpr auto profile_and_software_version_object =
    var_object(0x6507, "Profile and software version", "", "",
               entry(unsigned32, ro, no, {}, {.notation = Notation::hexadecimal}),
               {.category = Category::optional});
inline constexpr auto operating_time_object =
    var_object(0x6508, "Operating time", "", "Since the encoder was made.",
               entry(unsigned32, ro, no, {}, tenths_of_an_hour), {.category = Category::optional});
inline constexpr auto offset_value_object =
    var_object(0x6509, "Offset value", "", "What the preset has added to the measured position.",
               entry(integer32, ro), {.category = Category::optional});
inline constexpr EntryInfo module_identification_entries[] = {
    cia301::highest_sub_index, sub_index(1, "Manufacturer offset value", entry(integer32, ro)),
    sub_index(2, "Manufacturer minimum position value", entry(integer32, ro),
              {.category = Category::optional}),
    sub_index(3, "Manufacturer maximum position value", entry(integer32, ro),
              {.category = Category::optional})};
inline constexpr auto module_identification_object =
    array_object(0x650A, "Module identification", "", "Offset and range as the maker has set them.",
                 module_identification_entries, {.category = Category::optional});
inline constexpr auto serial_number_object = var_object(
    0x650B, "Serial number", "", "", entry(unsigned32, ro), {.category = Category::optional});
inline constexpr auto offset_values_for_multi_sensor_devices_entries =
    channels(sub_index(0, "Offset value channel #", entry(integer32, ro)));
inline constexpr auto offset_values_for_multi_sensor_devices_object =
    array_object(0x650C, "Offset values for multi-sensor devices", "", "As 6509h.",
                 offset_values_for_multi_sensor_devices_entries, {.category = Category::optional});

}  // namespace canvoy::cia406
