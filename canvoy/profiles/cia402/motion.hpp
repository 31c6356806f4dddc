// Position, velocity, torque, homing and units of CiA 402. For how certain they are, see
// cia402.hpp.
//
//     cia402::target_position_object.index  // 607Ah
#pragma once

#include "canvoy/profiles/cia402/shapes.hpp"

namespace canvoy::cia402 {

inline constexpr auto position_actual_value_object =
    variable(0x6064, "Position actual value", entry(integer32, ro, optional, {}, drive_amount),
             "Where the drive is, in position units.");
inline constexpr auto following_error_window_object =
    variable(0x6065, "Following error window", entry(unsigned32, rw, optional, {}, drive_amount),
             "How far the drive may lag behind.");
inline constexpr auto following_error_time_out_object =
    variable(0x6066, "Following error time out",
             entry(unsigned16, rw, optional, {}, {.unit = Unit::millisecond}),
             "How long it may lag behind by more.");
inline constexpr auto position_window_object =
    variable(0x6067, "Position window", entry(unsigned32, rw, optional, {}, drive_amount),
             "How near to the target it has arrived.");
inline constexpr auto position_window_time_object =
    variable(0x6068, "Position window time",
             entry(unsigned16, rw, optional, {}, {.unit = Unit::millisecond}),
             "How long it has to stay there.");
inline constexpr auto velocity_sensor_actual_value_object =
    variable(0x6069, "Velocity sensor actual value",
             entry(integer32, ro, optional, {}, drive_amount), "In increments of the sensor.");
inline constexpr auto sensor_selection_code_object = variable(
    0x606A, "Sensor selection code", entry(integer16, rw, optional, {}, sensor_selection_names),
    "What the actual velocity is made of.");
inline constexpr auto velocity_demand_value_object =
    variable(0x606B, "Velocity demand value", entry(integer32, ro, optional, {}, drive_amount),
             "What the ramp now asks for.");
inline constexpr auto velocity_actual_value_object =
    variable(0x606C, "Velocity actual value", entry(integer32, ro, optional, {}, drive_amount),
             "How fast the drive moves.");
inline constexpr auto velocity_window_object =
    variable(0x606D, "Velocity window", entry(unsigned16, rw, optional, {}, drive_amount),
             "How near to the target velocity it counts as reached.");
inline constexpr auto velocity_window_time_object =
    variable(0x606E, "Velocity window time",
             entry(unsigned16, rw, optional, {}, {.unit = Unit::millisecond}),
             "How long it has to be as near.");
inline constexpr auto velocity_threshold_object =
    variable(0x606F, "Velocity threshold", entry(unsigned16, rw, optional, {}, drive_amount),
             "Below it the drive counts as standing.");
inline constexpr auto velocity_threshold_time_object =
    variable(0x6070, "Velocity threshold time",
             entry(unsigned16, rw, optional, {}, {.unit = Unit::millisecond}),
             "How long it has to be as slow.");
inline constexpr auto target_torque_object =
    variable(0x6071, "Target torque", entry(integer16, rw, optional, {}, per_mille_of_rated),
             "Of the rated torque.");
inline constexpr auto max_torque_object =
    variable(0x6072, "Max torque", entry(unsigned16, rw, optional, {}, per_mille_of_rated),
             "Of the rated torque.");
inline constexpr auto max_current_object =
    variable(0x6073, "Max current", entry(unsigned16, rw, optional, {}, per_mille_of_rated),
             "Of the rated current.");
inline constexpr auto torque_demand_object =
    variable(0x6074, "Torque demand", entry(integer16, ro, optional, {}, per_mille_of_rated),
             "What the ramp of the torque now asks for.");
inline constexpr auto motor_rated_current_object = variable(
    0x6075, "Motor rated current",
    entry(unsigned32, rw, optional, {}, {.unit = Unit::ampere, .scale = {.denominator = 1000}}),
    "By the plate of the motor.");
inline constexpr auto motor_rated_torque_object =
    variable(0x6076, "Motor rated torque",
             entry(unsigned32, rw, optional, {},
                   {.unit = Unit::newton_metre, .scale = {.denominator = 1000}}),
             "By the plate of the motor.");
inline constexpr auto torque_actual_value_object =
    variable(0x6077, "Torque actual value", entry(integer16, ro, optional, {}, per_mille_of_rated),
             "Of the rated torque.");
inline constexpr auto current_actual_value_object =
    variable(0x6078, "Current actual value", entry(integer16, ro, optional, {}, per_mille_of_rated),
             "Of the rated current.");
inline constexpr auto dc_link_circuit_voltage_object = variable(
    0x6079, "DC link circuit voltage",
    entry(unsigned32, ro, optional, {}, {.unit = Unit::volt, .scale = {.denominator = 1000}}),
    "At the drive.");
inline constexpr auto target_position_object =
    variable(0x607A, "Target position", entry(integer32, rw, optional, {}, drive_amount),
             "Where the drive shall move to, in position units.");
inline constexpr auto position_range_limit_entries =
    pair(entry(integer32, rw, optional, {}, drive_amount), "Min position range limit",
         "Max position range limit");
inline constexpr auto position_range_limit_object =
    array(0x607B, "Position range limit", position_range_limit_entries,
          "Where the count of positions turns over.");
inline constexpr auto home_offset_object =
    variable(0x607C, "Home offset", entry(integer32, rw, optional, {}, drive_amount),
             "From the home position to position 0.");
inline constexpr auto software_position_limit_entries = pair(
    entry(integer32, rw, optional, {}, drive_amount), "Min position limit", "Max position limit");
inline constexpr auto software_position_limit_object = array(
    0x607D, "Software position limit", software_position_limit_entries, "No target lies beyond.");
inline constexpr auto polarity_object =
    variable(0x607E, "Polarity",
             entry(unsigned8, rw, optional, {}, {.notation = Notation::bit_mask}, polarity_fields),
             "Whether positions and velocities change their sign.");
inline constexpr auto max_profile_velocity_object =
    variable(0x607F, "Max profile velocity", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto max_motor_speed_object =
    variable(0x6080, "Max motor speed",
             entry(unsigned32, rw, optional, {}, {.unit = Unit::revolution_per_minute}));
inline constexpr auto profile_velocity_object =
    variable(0x6081, "Profile velocity", entry(unsigned32, rw, optional, {}, drive_amount),
             "The velocity between the ramps.");
inline constexpr auto end_velocity_object =
    variable(0x6082, "End velocity", entry(unsigned32, rw, optional, {}, drive_amount),
             "The velocity at the target.");
inline constexpr auto profile_acceleration_object =
    variable(0x6083, "Profile acceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto profile_deceleration_object =
    variable(0x6084, "Profile deceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto quick_stop_deceleration_object =
    variable(0x6085, "Quick stop deceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto motion_profile_type_object =
    variable(0x6086, "Motion profile type", entry(integer16, rw, optional, {}, profile_type_names),
             "The shape of the ramps.");
inline constexpr auto torque_slope_object =
    variable(0x6087, "Torque slope", entry(unsigned32, rw, optional, {}, per_mille_of_rated),
             "In each second, of the rated torque.");
inline constexpr auto position_notation_index_object = variable(
    0x6089, "Position notation index", entry(integer8, rw), "The power of ten of the unit.");
inline constexpr auto position_dimension_index_object = variable(
    0x608A, "Position dimension index",
    entry(unsigned8, rw, no, {}, {.notation = Notation::hexadecimal}), "The code of the unit.");
inline constexpr auto velocity_notation_index_object = variable(
    0x608B, "Velocity notation index", entry(integer8, rw), "The power of ten of the unit.");
inline constexpr auto velocity_dimension_index_object = variable(
    0x608C, "Velocity dimension index",
    entry(unsigned8, rw, no, {}, {.notation = Notation::hexadecimal}), "The code of the unit.");
inline constexpr auto acceleration_notation_index_object = variable(
    0x608D, "Acceleration notation index", entry(integer8, rw), "The power of ten of the unit.");
inline constexpr auto acceleration_dimension_index_object = variable(
    0x608E, "Acceleration dimension index",
    entry(unsigned8, rw, no, {}, {.notation = Notation::hexadecimal}), "The code of the unit.");
inline constexpr auto position_encoder_resolution_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Encoder increments", "Motor revolutions");
inline constexpr auto position_encoder_resolution_object =
    array(0x608F, "Position encoder resolution", position_encoder_resolution_entries);
inline constexpr auto velocity_encoder_resolution_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Encoder increments per second",
         "Motor revolutions per second");
inline constexpr auto velocity_encoder_resolution_object =
    array(0x6090, "Velocity encoder resolution", velocity_encoder_resolution_entries);
inline constexpr auto gear_ratio_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Motor revolutions", "Shaft revolutions");
inline constexpr auto gear_ratio_object = array(0x6091, "Gear ratio", gear_ratio_entries);
inline constexpr auto feed_constant_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Feed", "Shaft revolutions");
inline constexpr auto feed_constant_object = array(0x6092, "Feed constant", feed_constant_entries);
inline constexpr auto position_factor_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Numerator", "Feed constant");
inline constexpr auto position_factor_object =
    array(0x6093, "Position factor", position_factor_entries);
inline constexpr auto velocity_encoder_factor_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Numerator", "Divisor");
inline constexpr auto velocity_encoder_factor_object =
    array(0x6094, "Velocity encoder factor", velocity_encoder_factor_entries);
inline constexpr auto velocity_factor_1_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Numerator", "Divisor");
inline constexpr auto velocity_factor_1_object =
    array(0x6095, "Velocity factor 1", velocity_factor_1_entries);
inline constexpr auto velocity_factor_2_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Numerator", "Divisor");
inline constexpr auto velocity_factor_2_object =
    array(0x6096, "Velocity factor 2", velocity_factor_2_entries);
inline constexpr auto acceleration_factor_entries =
    pair(entry(unsigned32, rw, no, 1, drive_amount), "Numerator", "Divisor");
inline constexpr auto acceleration_factor_object =
    array(0x6097, "Acceleration factor", acceleration_factor_entries);
inline constexpr auto homing_method_object = variable(
    0x6098, "Homing method", entry(integer8, rw, optional), "Negative ones are the maker's.");
inline constexpr auto homing_speeds_entries =
    pair(entry(unsigned32, rw, optional, {}, drive_amount), "Speed during search for switch",
         "Speed during search for zero");
inline constexpr auto homing_speeds_object = array(0x6099, "Homing speeds", homing_speeds_entries);
inline constexpr auto homing_acceleration_object =
    variable(0x609A, "Homing acceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto profile_jerk_use_object = variable(
    0x60A3, "Profile jerk use", entry(unsigned8, rw, optional), "How many of the jerks are used.");
inline constexpr EntryInfo profile_jerk_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 6, "Profile jerk #", entry(unsigned32, rw, optional, {}, drive_amount))};
inline constexpr auto profile_jerk_object = array(0x60A4, "Profile jerk", profile_jerk_entries);
inline constexpr auto max_acceleration_object =
    variable(0x60C5, "Max acceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto max_deceleration_object =
    variable(0x60C6, "Max deceleration", entry(unsigned32, rw, optional, {}, drive_amount));
inline constexpr auto following_error_actual_value_object = variable(
    0x60F4, "Following error actual value", entry(integer32, ro, optional, {}, drive_amount));
inline constexpr auto max_slippage_object =
    variable(0x60F8, "Max slippage", entry(integer32, rw, optional, {}, drive_amount),
             "Beyond it bit 13 of the statusword is set.");
inline constexpr auto velocity_control_parameter_set_entries =
    pair(entry(unsigned16, rw), "Gain", "Ti – integration time constant");
inline constexpr auto velocity_control_parameter_set_object =
    array(0x60F9, "Velocity control parameter set", velocity_control_parameter_set_entries,
          "Further ones are the maker's. As CiA 417-4 prints it.");
inline constexpr auto control_effort_object =
    variable(0x60FA, "Control effort", entry(integer32, ro, optional, {}, drive_amount),
             "What the control loop gives to the drive.");
inline constexpr auto position_demand_internal_value_object =
    variable(0x60FC, "Position demand internal value",
             entry(integer32, ro, optional, {}, drive_amount), "In increments of the encoder.");
inline constexpr auto digital_inputs_object = variable(
    0x60FD, "Digital inputs", entry(unsigned32, ro, optional, {}, {.notation = Notation::bit_mask}),
    "Bits 0 to 15 have meanings in CiA 402, the others are the maker's.");
inline constexpr auto digital_outputs_entries =
    pair(entry(unsigned32, rw, optional, {}, {.notation = Notation::bit_mask}), "Physical outputs",
         "Bit mask");
inline constexpr auto digital_outputs_object =
    array(0x60FE, "Digital outputs", digital_outputs_entries,
          "Which outputs are on, and which of them are switched.");
inline constexpr auto target_velocity_object =
    variable(0x60FF, "Target velocity", entry(integer32, rw, optional, {}, drive_amount),
             "Its sign is the direction; 0 ends the motion.");

}  // namespace canvoy::cia402
