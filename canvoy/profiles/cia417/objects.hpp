// All objects of CiA 417-4, in the order of their indices.
#pragma once

#include "canvoy/profiles/cia417/doors.hpp"
#include "canvoy/profiles/cia417/encoder.hpp"
#include "canvoy/profiles/cia417/factors.hpp"
#include "canvoy/profiles/cia417/inputs.hpp"
#include "canvoy/profiles/cia417/load.hpp"
#include "canvoy/profiles/cia417/motion.hpp"
#include "canvoy/profiles/cia417/outputs.hpp"
#include "canvoy/profiles/cia417/physical.hpp"
#include "canvoy/profiles/cia417/position.hpp"
#include "canvoy/profiles/cia417/sensors.hpp"

namespace canvoy::cia417 {

inline constexpr auto objects = objects_of(
    supported_virtual_device_types_object, lift_number_object, virtual_input_mapping_object,
    virtual_output_mapping_object, virtual_sensor_mapping_object, object_creation_object,
    input_group_object, input_parameter_1_object, input_parameter_2_object,
    input_parameter_3_object, input_parameter_4_object, output_group_object,
    output_parameter_1_object, output_parameter_2_object, output_parameter_3_object,
    output_parameter_4_object, door_controlword_object, door_statusword_object,
    door_position_object, door_configuration_object, light_barrier_status_object,
    operating_parameter_object, units_per_revolution_object, preset_value_object,
    position_value_object, measuring_step_settings_object, speed_value_car_object,
    acceleration_value_car_object, cam_state_object, cam_enable_object, cam_polarity_object,
    area_state_object, work_area_low_limit_1_object, work_area_low_limit_2_object,
    work_area_low_limit_3_object, work_area_low_limit_4_object, work_area_high_limit_1_object,
    work_area_high_limit_2_object, work_area_high_limit_3_object, work_area_high_limit_4_object,
    operating_status_object, single_turn_resolution_object, distinguishable_revolutions_object,
    supported_warnings_object, warnings_object, supported_alarms_object, alarms_object,
    operating_time_object, offset_value_object, module_identification_1_object,
    module_identification_2_object, module_identification_3_object, module_identification_4_object,
    controlword_object, statusword_object, control_option_codes_object, modes_of_operation_object,
    modes_of_operation_display_object, motion_profile_type_object, control_effort_object,
    max_velocity_object, max_acceleration_object, quick_stop_deceleration_object,
    profile_acceleration_object, profile_jerk_use_object, profile_jerk_object, motor_data_object,
    position_dimension_object, velocity_dimension_object, acceleration_dimension_object,
    jerk_dimension_object, position_encoder_resolution_object, velocity_encoder_resolution_object,
    gear_ratio_object, feed_constant_object, position_factor_object, velocity_encoder_factor_object,
    velocity_factor_1_object, velocity_factor_2_object, acceleration_factor_object,
    jerk_factor_object, polarity_object, target_position_object, position_range_limit_object,
    software_position_limit_object, profile_velocity_object, end_velocity_object,
    home_offset_object, target_velocity_object, velocity_sensor_actual_value_object,
    velocity_demand_value_object, velocity_actual_value_object, sensor_selection_code_object,
    velocity_window_object, velocity_threshold_object, max_slippage_object,
    velocity_control_parameter_set_object, load_value_object, load_limits_object,
    load_signaling_object, load_signaling_limits_object, rope_load_object,
    load_system_configuration_object, sensor_group_object, sensor_parameter_1_object,
    sensor_parameter_2_object, sensor_parameter_3_object);

}  // namespace canvoy::cia417
