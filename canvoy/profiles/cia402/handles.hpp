// Typed handles for the values of CiA 402: drives.
//
//     drive[cia402::modes_of_operation] = cia402::DriveMode::profile_velocity;
//     if (drive[cia402::fault].is_set()) drive[cia402::fault_reset] = true;
#pragma once

#include "canvoy/profiles/cia402.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia402 {

inline constexpr Number<abort_connection_option_code_object> abort_connection_option_code;
inline constexpr Number<error_code_object> error_code;
inline constexpr Number<controlword_object> controlword;
inline constexpr Number<statusword_object> statusword;
inline constexpr State<StopReaction, quick_stop_option_code_object> quick_stop_option_code;
inline constexpr State<StopReaction, shutdown_option_code_object> shutdown_option_code;
inline constexpr State<StopReaction, disable_operation_option_code_object>
    disable_operation_option_code;
inline constexpr State<StopReaction, halt_option_code_object> halt_option_code;
inline constexpr State<StopReaction, fault_reaction_option_code_object> fault_reaction_option_code;
inline constexpr State<DriveMode, modes_of_operation_object> modes_of_operation;
inline constexpr State<DriveMode, modes_of_operation_display_object> modes_of_operation_display;
inline constexpr Number<position_actual_value_object> position_actual_value;
inline constexpr Number<following_error_window_object> following_error_window;
inline constexpr Quantity<following_error_time_out_object> following_error_time_out;
inline constexpr Number<position_window_object> position_window;
inline constexpr Quantity<position_window_time_object> position_window_time;
inline constexpr Number<velocity_sensor_actual_value_object> velocity_sensor_actual_value;
inline constexpr State<SensorSelection, sensor_selection_code_object> sensor_selection_code;
inline constexpr Number<velocity_demand_value_object> velocity_demand_value;
inline constexpr Number<velocity_actual_value_object> velocity_actual_value;
inline constexpr Number<velocity_window_object> velocity_window;
inline constexpr Quantity<velocity_window_time_object> velocity_window_time;
inline constexpr Number<velocity_threshold_object> velocity_threshold;
inline constexpr Quantity<velocity_threshold_time_object> velocity_threshold_time;
inline constexpr Quantity<target_torque_object> target_torque;
inline constexpr Quantity<max_torque_object> max_torque;
inline constexpr Quantity<max_current_object> max_current;
inline constexpr Quantity<torque_demand_object> torque_demand;
inline constexpr Quantity<motor_rated_current_object> motor_rated_current;
inline constexpr Quantity<motor_rated_torque_object> motor_rated_torque;
inline constexpr Quantity<torque_actual_value_object> torque_actual_value;
inline constexpr Quantity<current_actual_value_object> current_actual_value;
inline constexpr Quantity<dc_link_circuit_voltage_object> dc_link_circuit_voltage;
inline constexpr Number<target_position_object> target_position;
inline constexpr Number<position_range_limit_object, "Min position range limit">
    min_position_range_limit;
inline constexpr Number<position_range_limit_object, "Max position range limit">
    max_position_range_limit;
inline constexpr Number<home_offset_object> home_offset;
inline constexpr Number<software_position_limit_object, "Min position limit"> min_position_limit;
inline constexpr Number<software_position_limit_object, "Max position limit"> max_position_limit;
inline constexpr Number<polarity_object> polarity;
inline constexpr Number<max_profile_velocity_object> max_profile_velocity;
inline constexpr Quantity<max_motor_speed_object> max_motor_speed;
inline constexpr Number<profile_velocity_object> profile_velocity;
inline constexpr Number<end_velocity_object> end_velocity;
inline constexpr Number<profile_acceleration_object> profile_acceleration;
inline constexpr Number<profile_deceleration_object> profile_deceleration;
inline constexpr Number<quick_stop_deceleration_object> quick_stop_deceleration;
inline constexpr State<ProfileType, motion_profile_type_object> motion_profile_type;
inline constexpr Quantity<torque_slope_object> torque_slope;
inline constexpr Number<position_notation_index_object> position_notation_index;
inline constexpr Number<position_dimension_index_object> position_dimension_index;
inline constexpr Number<velocity_notation_index_object> velocity_notation_index;
inline constexpr Number<velocity_dimension_index_object> velocity_dimension_index;
inline constexpr Number<acceleration_notation_index_object> acceleration_notation_index;
inline constexpr Number<acceleration_dimension_index_object> acceleration_dimension_index;
inline constexpr Number<position_encoder_resolution_object, "Encoder increments">
    position_encoder_resolution_encoder_increments;
inline constexpr Number<position_encoder_resolution_object, "Motor revolutions">
    position_encoder_resolution_motor_revolutions;
inline constexpr Number<velocity_encoder_resolution_object, "Encoder increments per second">
    velocity_encoder_resolution_encoder_increments_per_second;
inline constexpr Number<velocity_encoder_resolution_object, "Motor revolutions per second">
    velocity_encoder_resolution_motor_revolutions_per_second;
inline constexpr Number<gear_ratio_object, "Motor revolutions"> gear_ratio_motor_revolutions;
inline constexpr Number<gear_ratio_object, "Shaft revolutions"> gear_ratio_shaft_revolutions;
inline constexpr Number<feed_constant_object, "Feed"> feed_constant_feed;
inline constexpr Number<feed_constant_object, "Shaft revolutions"> feed_constant_shaft_revolutions;
inline constexpr Number<position_factor_object, "Numerator"> position_factor_numerator;
inline constexpr Number<position_factor_object, "Feed constant"> position_factor_feed_constant;
inline constexpr Number<velocity_encoder_factor_object, "Numerator">
    velocity_encoder_factor_numerator;
inline constexpr Number<velocity_encoder_factor_object, "Divisor"> velocity_encoder_factor_divisor;
inline constexpr Number<velocity_factor_1_object, "Numerator"> velocity_factor_1_numerator;
inline constexpr Number<velocity_factor_1_object, "Divisor"> velocity_factor_1_divisor;
inline constexpr Number<velocity_factor_2_object, "Numerator"> velocity_factor_2_numerator;
inline constexpr Number<velocity_factor_2_object, "Divisor"> velocity_factor_2_divisor;
inline constexpr Number<acceleration_factor_object, "Numerator"> acceleration_factor_numerator;
inline constexpr Number<acceleration_factor_object, "Divisor"> acceleration_factor_divisor;
inline constexpr Number<homing_method_object> homing_method;
inline constexpr Number<homing_speeds_object, "Speed during search for switch">
    speed_during_search_for_switch;
inline constexpr Number<homing_speeds_object, "Speed during search for zero">
    speed_during_search_for_zero;
inline constexpr Number<homing_acceleration_object> homing_acceleration;
inline constexpr Number<profile_jerk_use_object> profile_jerk_use;
inline constexpr Number<profile_jerk_object> profile_jerk;
inline constexpr Number<max_acceleration_object> max_acceleration;
inline constexpr Number<max_deceleration_object> max_deceleration;
inline constexpr Number<following_error_actual_value_object> following_error_actual_value;
inline constexpr Number<max_slippage_object> max_slippage;
inline constexpr Number<velocity_control_parameter_set_object, "Gain"> velocity_control_gain;
inline constexpr Number<velocity_control_parameter_set_object, "Ti – integration time constant">
    velocity_control_integration_time;
inline constexpr Number<control_effort_object> control_effort;
inline constexpr Number<position_demand_internal_value_object> position_demand_internal_value;
inline constexpr Number<digital_inputs_object> digital_inputs;
inline constexpr Number<digital_outputs_object, "Physical outputs"> physical_outputs;
inline constexpr Number<digital_outputs_object, "Bit mask"> output_mask;
inline constexpr Number<target_velocity_object> target_velocity;
inline constexpr Number<motor_type_object> motor_type;
inline constexpr Text<motor_catalogue_number_object> motor_catalogue_number;
inline constexpr Text<motor_manufacturer_object> motor_manufacturer;
inline constexpr Text<http_motor_catalogue_address_object> http_motor_catalogue_address;
inline constexpr Number<supported_drive_modes_object> supported_drive_modes;

// Bits of 6040h.
inline constexpr Flag<controlword_object, "", "Switch on"> switch_on;
inline constexpr Flag<controlword_object, "", "Enable voltage"> enable_voltage;
inline constexpr Flag<controlword_object, "", "Quick stop"> no_quick_stop;  ///< false: quick stop
inline constexpr Flag<controlword_object, "", "Enable operation"> enable_operation;
inline constexpr Flag<controlword_object, "", "New set-point"> new_set_point;
inline constexpr Flag<controlword_object, "", "Change set immediately"> change_set_immediately;
inline constexpr Flag<controlword_object, "", "Relative"> relative;
inline constexpr Flag<controlword_object, "", "Fault reset"> fault_reset;
inline constexpr Flag<controlword_object, "", "Halt"> halt;

// Bits of 6041h. drive_state() returns the state that several of them make up.
inline constexpr Flag<statusword_object, "", "Ready to switch on"> ready_to_switch_on;
inline constexpr Flag<statusword_object, "", "Switched on"> switched_on;
inline constexpr Flag<statusword_object, "", "Operation enabled"> operation_enabled;
inline constexpr Flag<statusword_object, "", "Fault"> fault;
inline constexpr Flag<statusword_object, "", "Voltage enabled"> voltage_enabled;
inline constexpr Flag<statusword_object, "", "Switch on disabled"> switch_on_disabled;
inline constexpr Flag<statusword_object, "", "Warning"> warning;
inline constexpr Flag<statusword_object, "", "Remote"> remote;
inline constexpr Flag<statusword_object, "", "Target reached"> target_reached;
inline constexpr Flag<statusword_object, "", "Internal limit active"> internal_limit_active;

// Bits of 607Eh. True: reversed.
inline constexpr Flag<polarity_object, "", "Velocity polarity"> velocity_reversed;
inline constexpr Flag<polarity_object, "", "Position polarity"> position_reversed;

}  // namespace canvoy::cia402
