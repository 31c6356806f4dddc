// The objects of CiA 406: see cia406.hpp for how certain they are.
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

inline constexpr ObjectInfo operating_parameters_object = {
    .index = 0x6000,
    .name = "Operating parameters",
    .category = Category::optional,
    .description = "How the encoder counts.",
    .entry = {.type = DataType::unsigned16,
              .access = Access::rw,
              .initial = 0,
              .value = {.notation = Notation::bit_mask},
              .fields = operating_fields}};
inline constexpr ObjectInfo measuring_units_per_revolution_object = {
    .index = 0x6001,
    .name = "Measuring units per revolution",
    .category = Category::optional,
    .description = "Of rotary encoders.",
    .entry = {.type = DataType::unsigned32, .access = Access::rw}};
inline constexpr ObjectInfo total_measuring_range_in_measuring_units_object = {
    .index = 0x6002,
    .name = "Total measuring range in measuring units",
    .category = Category::optional,
    .description = "Where the count begins anew.",
    .entry = {.type = DataType::unsigned32, .access = Access::rw}};
inline constexpr ObjectInfo preset_value_object = {
    .index = 0x6003,
    .name = "Preset value",
    .category = Category::optional,
    .description = "What the position is to be where the encoder now is.",
    .entry = {.type = DataType::unsigned32, .access = Access::rw}};
inline constexpr ObjectInfo position_value_object = {
    .index = 0x6004,
    .name = "Position value",
    .category = Category::optional,
    .description = "Where the encoder is.",
    .entry = {.type = DataType::unsigned32, .access = Access::ro, .mapping = Mapping::by_default}};
inline constexpr auto linear_encoder_measuring_step_settings_entries =
    channels({.name = "Measuring step #", .type = DataType::unsigned32, .access = Access::rw});
inline constexpr ObjectInfo linear_encoder_measuring_step_settings_object = {
    .index = 0x6005,
    .code = ObjectCode::array,
    .name = "Linear encoder measuring step settings",
    .category = Category::optional,
    .description = "What one count of a linear encoder is.",
    .subs = linear_encoder_measuring_step_settings_entries};
inline constexpr auto preset_values_for_multi_sensor_devices_entries = channels(
    {.name = "Preset value channel #", .type = DataType::unsigned32, .access = Access::rw});
inline constexpr ObjectInfo preset_values_for_multi_sensor_devices_object = {
    .index = 0x6010,
    .code = ObjectCode::array,
    .name = "Preset values for multi-sensor devices",
    .category = Category::optional,
    .description = "As 6003h.",
    .subs = preset_values_for_multi_sensor_devices_entries};
inline constexpr auto position_values_for_multi_sensor_devices_entries =
    channels({.name = "Position value channel #",
              .type = DataType::integer32,
              .access = Access::ro,
              .mapping = Mapping::optional});
inline constexpr ObjectInfo position_values_for_multi_sensor_devices_object = {
    .index = 0x6020,
    .code = ObjectCode::array,
    .name = "Position values for multi-sensor devices",
    .category = Category::optional,
    .description = "As 6004h, with a sign.",
    .subs = position_values_for_multi_sensor_devices_entries};
inline constexpr auto speed_value_entries = channels({.name = "Speed value channel #",
                                                      .type = DataType::integer16,
                                                      .access = Access::ro,
                                                      .mapping = Mapping::optional});
inline constexpr ObjectInfo speed_value_object = {.index = 0x6030,
                                                  .code = ObjectCode::array,
                                                  .name = "Speed value",
                                                  .category = Category::optional,
                                                  .description = "How fast the position changes.",
                                                  .subs = speed_value_entries};
inline constexpr auto acceleration_value_entries = channels({.name = "Acceleration value channel #",
                                                             .type = DataType::integer16,
                                                             .access = Access::ro,
                                                             .mapping = Mapping::optional});
inline constexpr ObjectInfo acceleration_value_object = {
    .index = 0x6040,
    .code = ObjectCode::array,
    .name = "Acceleration value",
    .category = Category::optional,
    .description = "How fast the speed changes.",
    .subs = acceleration_value_entries};
inline constexpr ObjectInfo cyclic_timer_object = {
    .index = 0x6200,
    .name = "Cyclic timer",
    .category = Category::optional,
    .description = "The event timer of TPDO 1.",
    .entry = {
        .type = DataType::unsigned16, .access = Access::rw, .value = {.unit = Unit::millisecond}}};

// Cams and work areas.

inline constexpr auto cam_state_register_entries =
    channels({.name = "CAM state channel #",
              .type = DataType::unsigned8,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.notation = Notation::bit_mask},
              .fields = cam_state_fields});
inline constexpr ObjectInfo cam_state_register_object = {
    .index = 0x6300,
    .code = ObjectCode::array,
    .name = "CAM state register",
    .category = Category::optional,
    .description = "Which cams the position is on.",
    .subs = cam_state_register_entries};
inline constexpr auto cam_enable_register_entries =
    channels({.name = "CAM enable channel #",
              .type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .initial = 0,
              .value = {.notation = Notation::bit_mask},
              .fields = cam_enable_fields});
inline constexpr ObjectInfo cam_enable_register_object = {
    .index = 0x6301,
    .code = ObjectCode::array,
    .name = "CAM enable register",
    .category = Category::optional,
    .description = "Which cams are worked out.",
    .subs = cam_enable_register_entries};
inline constexpr auto cam_polarity_register_entries =
    channels({.name = "CAM polarity channel #",
              .type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .initial = 0,
              .value = {.notation = Notation::bit_mask},
              .fields = cam_polarity_fields});
inline constexpr ObjectInfo cam_polarity_register_object = {
    .index = 0x6302,
    .code = ObjectCode::array,
    .name = "CAM polarity register",
    .category = Category::optional,
    .description = "Which cams are inverted.",
    .subs = cam_polarity_register_entries};
inline constexpr auto cam_low_limit_entries =
    channels({.name = "Low limit channel #", .type = DataType::integer32, .access = Access::rw});
inline constexpr ObjectInfo cam_low_limit_object = {.index = 0x6310,
                                                    .count = 8,
                                                    .code = ObjectCode::array,
                                                    .name = "CAM # low limit",
                                                    .category = Category::optional,
                                                    .description = "Where the cam begins.",
                                                    .subs = cam_low_limit_entries};
inline constexpr auto cam_high_limit_entries =
    channels({.name = "High limit channel #", .type = DataType::integer32, .access = Access::rw});
inline constexpr ObjectInfo cam_high_limit_object = {.index = 0x6320,
                                                     .count = 8,
                                                     .code = ObjectCode::array,
                                                     .name = "CAM # high limit",
                                                     .category = Category::optional,
                                                     .description = "Where the cam ends.",
                                                     .subs = cam_high_limit_entries};
inline constexpr auto cam_hysteresis_entries =
    channels({.name = "Hysteresis channel #", .type = DataType::unsigned16, .access = Access::rw});
inline constexpr ObjectInfo cam_hysteresis_object = {
    .index = 0x6330,
    .count = 8,
    .code = ObjectCode::array,
    .name = "CAM # hysteresis",
    .category = Category::optional,
    .description = "How far the position has to leave the cam again.",
    .subs = cam_hysteresis_entries};
inline constexpr auto area_state_register_entries =
    channels({.name = "Work area state channel #",
              .type = DataType::unsigned8,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.notation = Notation::bit_mask},
              .fields = area_state_fields});
inline constexpr ObjectInfo area_state_register_object = {
    .index = 0x6400,
    .code = ObjectCode::array,
    .name = "Area state register",
    .category = Category::optional,
    .description = "Whether the position is within the work area.",
    .subs = area_state_register_entries};
inline constexpr auto work_area_low_limit_entries = channels(
    {.name = "Work area low limit channel #", .type = DataType::integer32, .access = Access::rw});
inline constexpr ObjectInfo work_area_low_limit_object = {.index = 0x6401,
                                                          .code = ObjectCode::array,
                                                          .name = "Work area low limit",
                                                          .category = Category::optional,
                                                          .subs = work_area_low_limit_entries};
inline constexpr auto work_area_high_limit_entries = channels(
    {.name = "Work area high limit channel #", .type = DataType::integer32, .access = Access::rw});
inline constexpr ObjectInfo work_area_high_limit_object = {.index = 0x6402,
                                                           .code = ObjectCode::array,
                                                           .name = "Work area high limit",
                                                           .category = Category::optional,
                                                           .subs = work_area_high_limit_entries};

// What the encoder says of itself.

inline constexpr ObjectInfo operating_status_object = {
    .index = 0x6500,
    .name = "Operating status",
    .category = Category::optional,
    .description = "What of 6000h holds.",
    .entry = {.type = DataType::unsigned16,
              .access = Access::ro,
              .value = {.notation = Notation::bit_mask},
              .fields = operating_fields}};
inline constexpr ObjectInfo single_turn_resolution_object = {
    .index = 0x6501,
    .name = "Single-turn resolution",
    .category = Category::optional,
    .description = "Steps in a revolution, or the step of a linear encoder.",
    .entry = {.type = DataType::unsigned32, .access = Access::ro}};
inline constexpr ObjectInfo number_of_distinguishable_revolutions_object = {
    .index = 0x6502,
    .name = "Number of distinguishable revolutions",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned16, .access = Access::ro}};
inline constexpr ObjectInfo alarms_object = {.index = 0x6503,
                                             .name = "Alarms",
                                             .category = Category::optional,
                                             .description = "The position may be wrong.",
                                             .entry = {.type = DataType::unsigned16,
                                                       .access = Access::ro,
                                                       .mapping = Mapping::optional,
                                                       .value = {.notation = Notation::bit_mask},
                                                       .fields = alarm_fields}};
inline constexpr ObjectInfo supported_alarms_object = {
    .index = 0x6504,
    .name = "Supported alarms",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned16,
              .access = Access::ro,
              .value = {.notation = Notation::bit_mask},
              .fields = alarm_fields}};
inline constexpr ObjectInfo warnings_object = {
    .index = 0x6505,
    .name = "Warnings",
    .category = Category::optional,
    .description = "The position is good, but something is near its limit.",
    .entry = {.type = DataType::unsigned16,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.notation = Notation::bit_mask},
              .fields = warning_fields}};
inline constexpr ObjectInfo supported_warnings_object = {
    .index = 0x6506,
    .name = "Supported warnings",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned16,
              .access = Access::ro,
              .value = {.notation = Notation::bit_mask},
              .fields = warning_fields}};
inline constexpr ObjectInfo profile_and_software_version_object = {
    .index = 0x6507,
    .name = "Profile and software version",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned32,
              .access = Access::ro,
              .value = {.notation = Notation::hexadecimal}}};
inline constexpr ObjectInfo operating_time_object = {
    .index = 0x6508,
    .name = "Operating time",
    .category = Category::optional,
    .description = "Since the encoder was made.",
    .entry = {.type = DataType::unsigned32, .access = Access::ro, .value = tenths_of_an_hour}};
inline constexpr ObjectInfo offset_value_object = {
    .index = 0x6509,
    .name = "Offset value",
    .category = Category::optional,
    .description = "What the preset has added to the measured position.",
    .entry = {.type = DataType::integer32, .access = Access::ro}};
inline constexpr EntryInfo module_identification_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1, .name = "Manufacturer offset value", .type = DataType::integer32},
    {.sub_first = 2,
     .name = "Manufacturer minimum position value",
     .type = DataType::integer32,
     .category = Category::optional},
    {.sub_first = 3,
     .name = "Manufacturer maximum position value",
     .type = DataType::integer32,
     .category = Category::optional}};
inline constexpr ObjectInfo module_identification_object = {
    .index = 0x650A,
    .code = ObjectCode::array,
    .name = "Module identification",
    .category = Category::optional,
    .description = "Offset and range as the maker has set them.",
    .subs = module_identification_entries};
inline constexpr ObjectInfo serial_number_object = {
    .index = 0x650B,
    .name = "Serial number",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned32, .access = Access::ro}};
inline constexpr auto offset_values_for_multi_sensor_devices_entries =
    channels({.name = "Offset value channel #", .type = DataType::integer32, .access = Access::ro});
inline constexpr ObjectInfo offset_values_for_multi_sensor_devices_object = {
    .index = 0x650C,
    .code = ObjectCode::array,
    .name = "Offset values for multi-sensor devices",
    .category = Category::optional,
    .description = "As 6509h.",
    .subs = offset_values_for_multi_sensor_devices_entries};

}  // namespace canvoy::cia406
