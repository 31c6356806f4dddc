// CiA 402: drives and motion control, in the parts to which CiA 417 refers.
//
// The text of CiA 402 is not at hand. Indices and types are those of CiA's conformance test, and
// the patterns of statusword and controlword are certain. Names, units, access, mapping, the
// meanings of option codes and of mode-dependent bits are common practice. Defaults are widely used
// ones; where none is given, the drive has its own.
//
//     cia402::profile.objects.size()
//     cia402::drive_state(drive.number(0x6041, 0))
#pragma once

#include "canvoy/profiles/cia402/control.hpp"
#include "canvoy/profiles/cia402/motion.hpp"

namespace canvoy::cia402 {

inline constexpr std::uint16_t profile_number = 402;

inline constexpr NamedValue profile_names[] = {{profile_number, "CiA 402"}};
inline constexpr FieldInfo device_type_fields[] = {
    field(0, 16, "Device profile number", profile_names),
    field(16, 16, "Additional information"),
};

inline constexpr auto objects = objects_of(
    abort_connection_option_code_object, error_code_object, controlword_object, statusword_object,
    quick_stop_option_code_object, shutdown_option_code_object,
    disable_operation_option_code_object, halt_option_code_object,
    fault_reaction_option_code_object, modes_of_operation_object, modes_of_operation_display_object,
    position_actual_value_object, following_error_window_object, following_error_time_out_object,
    position_window_object, position_window_time_object, velocity_sensor_actual_value_object,
    sensor_selection_code_object, velocity_demand_value_object, velocity_actual_value_object,
    velocity_window_object, velocity_window_time_object, velocity_threshold_object,
    velocity_threshold_time_object, target_torque_object, max_torque_object, max_current_object,
    torque_demand_object, motor_rated_current_object, motor_rated_torque_object,
    torque_actual_value_object, current_actual_value_object, dc_link_circuit_voltage_object,
    target_position_object, position_range_limit_object, home_offset_object,
    software_position_limit_object, polarity_object, max_profile_velocity_object,
    max_motor_speed_object, profile_velocity_object, end_velocity_object,
    profile_acceleration_object, profile_deceleration_object, quick_stop_deceleration_object,
    motion_profile_type_object, torque_slope_object, position_notation_index_object,
    position_dimension_index_object, velocity_notation_index_object,
    velocity_dimension_index_object, acceleration_notation_index_object,
    acceleration_dimension_index_object, position_encoder_resolution_object,
    velocity_encoder_resolution_object, gear_ratio_object, feed_constant_object,
    position_factor_object, velocity_encoder_factor_object, velocity_factor_1_object,
    velocity_factor_2_object, acceleration_factor_object, homing_method_object,
    homing_speeds_object, homing_acceleration_object, profile_jerk_use_object, profile_jerk_object,
    max_acceleration_object, max_deceleration_object, following_error_actual_value_object,
    max_slippage_object, velocity_control_parameter_set_object, control_effort_object,
    position_demand_internal_value_object, digital_inputs_object, digital_outputs_object,
    target_velocity_object, motor_type_object, motor_catalogue_number_object,
    motor_manufacturer_object, http_motor_catalogue_address_object, motor_calibration_date_object,
    supported_drive_modes_object);
/// With several logical devices in a node, the objects of each are 800h above those of the one
/// before (CiA 301).
inline constexpr Profile profile = {.number = profile_number,
                                    .name = "CiA 402",
                                    .title = "Device profile for drives and motion control",
                                    .objects = objects,
                                    .block_count = 8,
                                    .device_type = device_type_fields};

}  // namespace canvoy::cia402
