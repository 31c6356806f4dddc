// Handles of CiA 417-4 for the drive of the car. Positions, velocities, accelerations and jerks are
// in the units that 6410h to 641Dh define.
//
//     drive[cia417::modes_of_operation] = DriveMode::profile_velocity;
//     drive[cia417::target_velocity] = 1500;  // upward
//     cia417::drive_state(drive[cia417::statusword].raw()) == DriveState::operation_enabled
#pragma once

#include "canvoy/profiles/cia417/factors.hpp"
#include "canvoy/profiles/cia417/motion.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia417 {

// Control and state.

inline constexpr Number<controlword_object> controlword;
inline constexpr Flag<controlword_object, "", "Switch on"> switch_on;
inline constexpr Flag<controlword_object, "", "Enable voltage"> enable_voltage;
inline constexpr Flag<controlword_object, "", "Quick stop"> no_quick_stop;
inline constexpr Flag<controlword_object, "", "Enable operation"> enable_operation;
inline constexpr Flag<controlword_object, "", "New set-point"> new_set_point;
inline constexpr Flag<controlword_object, "", "Change set immediately"> change_set_immediately;
inline constexpr Flag<controlword_object, "", "Relative"> relative_target;
inline constexpr Flag<controlword_object, "", "Fault reset"> fault_reset;
inline constexpr Flag<controlword_object, "", "Halt"> halt;

inline constexpr Number<statusword_object> statusword;
inline constexpr Flag<statusword_object, "", "Ready to switch on"> ready_to_switch_on;
inline constexpr Flag<statusword_object, "", "Switched on"> switched_on;
inline constexpr Flag<statusword_object, "", "Operation enabled"> operation_enabled;
inline constexpr Flag<statusword_object, "", "Fault"> drive_fault;
inline constexpr Flag<statusword_object, "", "Voltage enabled"> voltage_enabled;
inline constexpr Flag<statusword_object, "", "Quick stop"> not_in_quick_stop;
inline constexpr Flag<statusword_object, "", "Switch on disabled"> switch_on_disabled;
inline constexpr Flag<statusword_object, "", "Warning"> drive_warning;
inline constexpr Flag<statusword_object, "", "Remote"> remote;
inline constexpr Flag<statusword_object, "", "Target reached"> target_reached;
inline constexpr Flag<statusword_object, "", "Internal limit active"> internal_limit_active;
inline constexpr Flag<statusword_object, "", "Set-point acknowledge or speed 0">
    set_point_acknowledge;
inline constexpr Flag<statusword_object, "", "Following error or max slippage"> following_error;

inline constexpr State<DriveMode, modes_of_operation_object> modes_of_operation;
inline constexpr State<DriveMode, modes_of_operation_display_object> modes_of_operation_display;
inline constexpr State<ProfileType, motion_profile_type_object> motion_profile_type;
inline constexpr Number<control_effort_object> control_effort;

inline constexpr State<StopReaction, control_option_codes_object, "Shutdown option code">
    shutdown_option;
inline constexpr State<StopReaction, control_option_codes_object, "Disable operation option code">
    disable_operation_option;
inline constexpr State<StopReaction, control_option_codes_object, "Quick stop option code">
    quick_stop_option;
inline constexpr State<StopReaction, control_option_codes_object, "Halt option code"> halt_option;
inline constexpr State<StopReaction, control_option_codes_object, "Fault reaction option code">
    fault_reaction_option;

// Limits and ramps.

inline constexpr Number<max_velocity_object, "Max profile velocity"> max_profile_velocity;
inline constexpr Number<max_velocity_object, "Max motor speed"> max_motor_speed;
inline constexpr Number<max_acceleration_object, "Max acceleration"> max_acceleration;
inline constexpr Number<max_acceleration_object, "Max deceleration"> max_deceleration;
inline constexpr Number<quick_stop_deceleration_object> quick_stop_deceleration;
inline constexpr Number<profile_acceleration_object, "Profile acceleration"> profile_acceleration;
inline constexpr Number<profile_acceleration_object, "Profile deceleration"> profile_deceleration;
inline constexpr Number<profile_jerk_use_object> profile_jerk_use;
inline constexpr Number<profile_jerk_object, "Profile jerk #"> profile_jerk;

// Targets and actual values.

inline constexpr Number<target_position_object> target_position;
inline constexpr Number<position_range_limit_object, "Min position range limit">
    min_position_range_limit;
inline constexpr Number<position_range_limit_object, "Max position range limit">
    max_position_range_limit;
inline constexpr Number<software_position_limit_object, "Min position limit"> min_position_limit;
inline constexpr Number<software_position_limit_object, "Max position limit"> max_position_limit;
inline constexpr Number<profile_velocity_object> profile_velocity;
inline constexpr Number<end_velocity_object> end_velocity;
inline constexpr Number<home_offset_object> home_offset;
inline constexpr Number<target_velocity_object> target_velocity;
inline constexpr Number<velocity_sensor_actual_value_object> velocity_sensor_actual_value;
inline constexpr Number<velocity_demand_value_object> velocity_demand_value;
inline constexpr Number<velocity_actual_value_object> velocity_actual_value;
inline constexpr State<SensorSelection, sensor_selection_code_object> sensor_selection_code;
inline constexpr Number<velocity_window_object, "Velocity window"> velocity_window;
inline constexpr Quantity<velocity_window_object, "Velocity window time"> velocity_window_time;
inline constexpr Number<velocity_threshold_object, "Velocity threshold"> velocity_threshold;
inline constexpr Quantity<velocity_threshold_object, "Velocity threshold time">
    velocity_threshold_time;
inline constexpr Number<max_slippage_object> max_slippage;
inline constexpr Number<velocity_control_parameter_set_object, "Gain"> velocity_control_gain;
inline constexpr Number<velocity_control_parameter_set_object, "Ti – integration time constant">
    velocity_control_integration_time;

// Units and factors.

inline constexpr Number<position_dimension_object, "Position notation index">
    position_notation_index;
inline constexpr Number<position_dimension_object, "Position dimension index">
    position_dimension_index;
inline constexpr Number<velocity_dimension_object, "Velocity notation index">
    velocity_notation_index;
inline constexpr Number<velocity_dimension_object, "Velocity dimension index">
    velocity_dimension_index;
inline constexpr Number<acceleration_dimension_object, "Acceleration notation index">
    acceleration_notation_index;
inline constexpr Number<acceleration_dimension_object, "Acceleration dimension index">
    acceleration_dimension_index;
inline constexpr Number<jerk_dimension_object, "Jerk notation index"> jerk_notation_index;
inline constexpr Number<jerk_dimension_object, "Jerk dimension index"> jerk_dimension_index;

/// The two numbers of a factor.
template <const ObjectInfo& object, Name first = "Numerator", Name second = "Divisor">
struct FactorHandles {
  static constexpr Number<object, first> numerator{};  ///< sub-index 01h
  static constexpr Number<object, second> divisor{};   ///< sub-index 02h; not 0
};
inline constexpr FactorHandles<position_encoder_resolution_object, "Encoder increments",
                               "Motor revolutions">
    position_encoder_resolution;
inline constexpr FactorHandles<velocity_encoder_resolution_object, "Encoder increments per second",
                               "Motor revolutions per second">
    velocity_encoder_resolution;
inline constexpr FactorHandles<gear_ratio_object, "Motor revolutions", "Shaft revolutions">
    gear_ratio;
inline constexpr FactorHandles<feed_constant_object, "Feed", "Shaft revolutions"> feed_constant;
inline constexpr FactorHandles<position_factor_object, "Numerator", "Feed constant">
    position_factor;
inline constexpr FactorHandles<velocity_encoder_factor_object> velocity_encoder_factor;
inline constexpr FactorHandles<velocity_factor_1_object> velocity_factor_1;
inline constexpr FactorHandles<velocity_factor_2_object> velocity_factor_2;
inline constexpr FactorHandles<acceleration_factor_object> acceleration_factor;
inline constexpr FactorHandles<jerk_factor_object> jerk_factor;

inline constexpr Flag<polarity_object, "", "Velocity polarity"> velocity_reversed;
inline constexpr Flag<polarity_object, "", "Position polarity"> position_reversed;

}  // namespace canvoy::cia417
