// Typed handles for the values of CiA 406: encoders.
//
//     encoder[cia406::position_value] = 123456;
//     encoder[cia406::speed_value(2)] = -7;  // of channel 2
#pragma once

#include "canvoy/profiles/cia406.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia406 {

inline constexpr Number<operating_parameters_object> operating_parameters;
inline constexpr Number<measuring_units_per_revolution_object> measuring_units_per_revolution;
inline constexpr Number<total_measuring_range_in_measuring_units_object>
    total_measuring_range_in_measuring_units;
inline constexpr Number<preset_value_object> preset_value;
inline constexpr Number<position_value_object> position_value;
inline constexpr Number<linear_encoder_measuring_step_settings_object>
    linear_encoder_measuring_step_settings;
inline constexpr Number<preset_values_for_multi_sensor_devices_object>
    preset_values_for_multi_sensor_devices;
inline constexpr Number<position_values_for_multi_sensor_devices_object>
    position_values_for_multi_sensor_devices;
inline constexpr Number<speed_value_object> speed_value;
inline constexpr Number<acceleration_value_object> acceleration_value;
inline constexpr Quantity<cyclic_timer_object> cyclic_timer;
inline constexpr Number<cam_state_register_object> cam_state_register;
inline constexpr Number<cam_enable_register_object> cam_enable_register;
inline constexpr Number<cam_polarity_register_object> cam_polarity_register;
inline constexpr Number<cam_low_limit_object> cam_low_limit;
inline constexpr Number<cam_high_limit_object> cam_high_limit;
inline constexpr Number<cam_hysteresis_object> cam_hysteresis;
inline constexpr Number<area_state_register_object> area_state_register;
inline constexpr Number<work_area_low_limit_object> work_area_low_limit;
inline constexpr Number<work_area_high_limit_object> work_area_high_limit;
inline constexpr Number<operating_status_object> operating_status;
inline constexpr Number<single_turn_resolution_object> single_turn_resolution;
inline constexpr Number<number_of_distinguishable_revolutions_object>
    number_of_distinguishable_revolutions;
inline constexpr Number<alarms_object> alarms;
inline constexpr Number<supported_alarms_object> supported_alarms;
inline constexpr Number<warnings_object> warnings;
inline constexpr Number<supported_warnings_object> supported_warnings;
inline constexpr Number<profile_and_software_version_object> profile_and_software_version;
inline constexpr Quantity<operating_time_object> operating_time;
inline constexpr Number<offset_value_object> offset_value;
inline constexpr Number<module_identification_object, "Manufacturer offset value">
    manufacturer_offset_value;
inline constexpr Number<module_identification_object, "Manufacturer minimum position value">
    manufacturer_minimum_position_value;
inline constexpr Number<module_identification_object, "Manufacturer maximum position value">
    manufacturer_maximum_position_value;
inline constexpr Number<serial_number_object> serial_number;
inline constexpr Number<offset_values_for_multi_sensor_devices_object>
    offset_values_for_multi_sensor_devices;

// Bits of 6000h (settings), 6503h (alarms) and 6505h (warnings).
inline constexpr Flag<operating_parameters_object, "", "Code sequence"> counter_clockwise;
inline constexpr Flag<operating_parameters_object, "", "Scaling function control"> scaling_enabled;
inline constexpr Flag<operating_parameters_object, "", "Measuring direction"> direction_reversed;
inline constexpr Flag<alarms_object, "", "Position error"> position_error;
inline constexpr Flag<alarms_object, "", "Commissioning diagnostics"> commissioning_diagnostics;
inline constexpr Flag<warnings_object, "", "Frequency exceeded"> frequency_exceeded;
inline constexpr Flag<warnings_object, "", "Light control reserve"> light_control_reserve;
inline constexpr Flag<warnings_object, "", "CPU watchdog status"> cpu_watchdog_status;
inline constexpr Flag<warnings_object, "", "Operating time limit"> operating_time_limit;
inline constexpr Flag<warnings_object, "", "Battery charge"> battery_charge;
inline constexpr Flag<warnings_object, "", "Reference point"> reference_point;

}  // namespace canvoy::cia406
