// Handles of CiA 417-4 for doors, load and position of the car. Doors, position units and ropes are
// numbered from 1.
//
//     door[cia417::door_command(2)] = DoorCommand::open_with_limit_force;
//     if (door[cia417::door_state(2)].is(DoorState::closing)) ...
//     load[cia417::absolute_load_value] = 450;  // kilograms
//
// A position is a count of measuring steps, the size of which can be configured in the device. In
// micrometres it is
//
//     car[cia417::position_value(1)].raw() * car[cia417::measuring_step(1)].value().value_or(0)
#pragma once

#include "canvoy/profiles/cia417/doors.hpp"
#include "canvoy/profiles/cia417/encoder.hpp"
#include "canvoy/profiles/cia417/load.hpp"
#include "canvoy/profiles/cia417/physical.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia417 {

// The physical device.

inline constexpr State<VirtualDevice, supported_virtual_device_types_object,
                       "Virtual device type #", "Virtual device">
    supported_virtual_device;
inline constexpr Number<lift_number_object, "", ""> lift_numbers;  ///< a bit for each lift
template <unsigned lift>
inline constexpr Flag<lift_number_object, "", numbered("Lift ", lift)> belongs_to_lift;
inline constexpr Number<object_creation_object> object_creation;
inline constexpr State<Creation, object_creation_object, "", "Action"> creation_action;
inline constexpr State<CreatedAccess, object_creation_object, "", "Access"> creation_access;
inline constexpr Number<object_creation_object, "", "Sub-index"> creation_sub_index;
inline constexpr Number<object_creation_object, "", "Index"> creation_index;

// Doors.

inline constexpr Number<door_controlword_object, "Door #"> door_controlword;
inline constexpr State<DoorCommand, door_controlword_object, "Door #", "Command"> door_command;
inline constexpr State<DoorVelocity, door_controlword_object, "Door #", "Door velocity">
    door_velocity;
inline constexpr State<Disabling, door_controlword_object, "Door #", "Motion detector">
    motion_detector_command;
inline constexpr State<Disabling, door_controlword_object, "Door #", "Finger protector">
    finger_protector_command;
inline constexpr State<Disabling, door_controlword_object, "Door #", "Door lock"> door_lock_command;
inline constexpr State<Enabling, door_controlword_object, "Door #", "Battery power">
    battery_power_command;

inline constexpr Number<door_statusword_object, "Door #"> door_statusword;
inline constexpr State<DoorState, door_statusword_object, "Door #", "Status"> door_state;
inline constexpr State<Detection, door_statusword_object, "Door #", "Force limit"> force_limit;
inline constexpr State<Detection, door_statusword_object, "Door #", "Motion detector">
    motion_detector;
inline constexpr State<Detection, door_statusword_object, "Door #", "Finger protector">
    finger_protector;
inline constexpr State<Detection, door_statusword_object, "Door #", "Door lock"> door_lock;
inline constexpr State<Detection, door_statusword_object, "Door #", "Battery power"> battery_power;
inline constexpr State<Detection, door_statusword_object, "Door #", "Safety contact">
    safety_contact;
inline constexpr Quantity<door_position_object, "Door #"> door_position;
inline constexpr State<Detection, light_barrier_status_object, "Door #", "Status">
    light_barrier_status;

inline constexpr Number<door_configuration_object, "Door velocity profile"> door_velocity_profile;
inline constexpr Number<door_configuration_object, "Door open width profile"> door_width_profile;
inline constexpr State<DoorType, door_configuration_object, "Door type"> door_type;
inline constexpr State<DoorReaction, door_configuration_object, "Light barrier event modus">
    light_barrier_modus;
inline constexpr State<DoorReaction, door_configuration_object, "Force limit reached modus">
    force_limit_modus;
inline constexpr State<DoorReaction, door_configuration_object, "Finger protector modus">
    finger_protector_modus;
inline constexpr State<DoorReaction, door_configuration_object, "Motion detection modus">
    motion_detection_modus;
inline constexpr Quantity<door_configuration_object, "Light barrier reclose"> light_barrier_reclose;
inline constexpr Quantity<door_configuration_object, "Closing force limit reclose">
    force_limit_reclose;
inline constexpr Quantity<door_configuration_object, "Light barrier broken">
    light_barrier_broken_reclose;
inline constexpr State<HeartbeatLoss, door_configuration_object, "Lost of heartbeat">
    heartbeat_loss;

// Load.

inline constexpr Quantity<load_value_object, "Absolute load value"> absolute_load_value;
inline constexpr Number<load_value_object, "SI unit", "SI unit"> load_si_unit;
inline constexpr Number<load_value_object, "SI unit", "Prefix"> load_si_prefix;
inline constexpr Quantity<load_limits_object, "Lowlimit"> load_low_limit;
inline constexpr Quantity<load_limits_object, "Highlimit"> load_high_limit;
inline constexpr Flag<load_signaling_object, "Load signal", "Zero load"> zero_load_reached;
inline constexpr Flag<load_signaling_object, "Load signal", "Norm load"> norm_load_reached;
inline constexpr Flag<load_signaling_object, "Load signal", "Full load"> full_load_reached;
inline constexpr Flag<load_signaling_object, "Load signal", "Overload"> overload_reached;
inline constexpr Flag<load_signaling_object, "Load signal interrupt", "Zero load">
    zero_load_interrupt;
inline constexpr Flag<load_signaling_object, "Load signal interrupt", "Norm load">
    norm_load_interrupt;
inline constexpr Flag<load_signaling_object, "Load signal interrupt", "Full load">
    full_load_interrupt;
inline constexpr Flag<load_signaling_object, "Load signal interrupt", "Overload">
    overload_interrupt;
inline constexpr Quantity<load_signaling_limits_object, "Zero load limit"> zero_load_limit;
inline constexpr Quantity<load_signaling_limits_object, "Norm load limit"> norm_load_limit;
inline constexpr Quantity<load_signaling_limits_object, "Full load limit"> full_load_limit;
inline constexpr Quantity<load_signaling_limits_object, "Overload limit"> overload_limit;
inline constexpr Quantity<rope_load_object, "Rope #"> rope_load;
inline constexpr Number<load_system_configuration_object, "Rope ratio", "Ratio nominator">
    rope_ratio_nominator;
inline constexpr Number<load_system_configuration_object, "Rope ratio", "Ratio denominator">
    rope_ratio_denominator;

// Position of units 1 to 4. Positions, speeds and accelerations are counts of their steps.

inline constexpr Quantity<measuring_step_settings_object, "Measuring step"> measuring_step;
inline constexpr Quantity<measuring_step_settings_object, "Speed measuring step">
    speed_measuring_step;
inline constexpr Quantity<measuring_step_settings_object, "Acceleration measuring step">
    acceleration_measuring_step;
inline constexpr Number<position_value_object, "Position unit #"> position_value;
inline constexpr Number<speed_value_car_object, "Position unit #"> speed_value;
inline constexpr Number<acceleration_value_car_object, "Position unit #"> acceleration_value;
inline constexpr Number<preset_value_object, "Position unit #"> preset_value;
inline constexpr Number<units_per_revolution_object, "Position unit #"> units_per_revolution;
inline constexpr Number<operating_parameter_object, "Position unit #"> operating_parameter;
inline constexpr Flag<operating_parameter_object, "Position unit #", "Code sequence"> code_sequence;
inline constexpr Flag<operating_parameter_object, "Position unit #",
                      "Commissioning diagnostic control">
    commissioning_diagnostic_control;
inline constexpr Flag<operating_parameter_object, "Position unit #", "Scaling function control">
    scaling_function_control;
inline constexpr Flag<operating_parameter_object, "Position unit #", "Measuring direction">
    measuring_direction;

/// Eight cams of a channel as a bit mask, and cams 1 to 8 of them.
inline constexpr Number<cam_state_object, "CAM state channel #"> cam_state;
inline constexpr Number<cam_enable_object, "CAM enable channel #"> cam_enable;
inline constexpr Number<cam_polarity_object, "CAM polarity channel #"> cam_polarity;
template <unsigned cam>
inline constexpr Flag<cam_state_object, "CAM state channel #", numbered("Cam ", cam)> is_on_cam;
template <unsigned cam>
inline constexpr Flag<cam_enable_object, "CAM enable channel #", numbered("Cam ", cam)>
    is_cam_enabled;
template <unsigned cam>
inline constexpr Flag<cam_polarity_object, "CAM polarity channel #", numbered("Cam ", cam)>
    is_cam_inverted;

/// States of a position unit and a channel.
inline constexpr Flag<area_state_object, "Work area state channel #", "Out of range"> out_of_range;
inline constexpr Flag<area_state_object, "Work area state channel #", "Range overflow">
    range_overflow;
inline constexpr Flag<area_state_object, "Work area state channel #", "Range underflow">
    range_underflow;
/// Lower limit of a work area of a position unit; both count from 1.
constexpr auto work_area_low_limit(unsigned unit, unsigned channel) {
  return Number<work_area_low_limit_1_object, "Work area lowlimit channel #">{}(channel).shifted(
      unit - 1);
}
/// Upper limit of a work area of a position unit; both count from 1.
constexpr auto work_area_high_limit(unsigned unit, unsigned channel) {
  return Number<work_area_high_limit_1_object, "Work area highlimit channel #">{}(channel).shifted(
      unit - 1);
}

inline constexpr Number<operating_status_object, "Position unit #"> operating_status;
inline constexpr Number<single_turn_resolution_object, "Position unit #"> single_turn_resolution;
inline constexpr Number<distinguishable_revolutions_object, "Position unit #">
    distinguishable_revolutions;
inline constexpr Number<supported_warnings_object, "Position unit #"> supported_warnings;
inline constexpr Number<warnings_object, "Position unit #"> warnings;
inline constexpr Number<supported_alarms_object, "Position unit #"> supported_alarms;
inline constexpr Number<alarms_object, "Position unit #"> alarms;
inline constexpr Flag<warnings_object, "Position unit #", "Frequency exceeded"> frequency_exceeded;
inline constexpr Flag<warnings_object, "Position unit #", "Light control reserve">
    light_control_reserve;
inline constexpr Flag<warnings_object, "Position unit #", "CPU watchdog status"> cpu_watchdog;
inline constexpr Flag<warnings_object, "Position unit #", "Operating time limit">
    operating_time_limit;
inline constexpr Flag<warnings_object, "Position unit #", "Battery charge"> battery_charge;
inline constexpr Flag<warnings_object, "Position unit #", "Reference point"> reference_point;
inline constexpr Flag<alarms_object, "Position unit #", "Position error"> position_error;
inline constexpr Flag<alarms_object, "Position unit #", "Commissioning diagnostics">
    commissioning_diagnostics;
inline constexpr Quantity<operating_time_object, "Position unit #"> operating_time;
inline constexpr Number<offset_value_object, "Position unit #"> offset_value;
/// Offset value of the maker, of position unit 1 to 4.
constexpr auto manufacturer_offset(unsigned unit) {
  return Number<module_identification_1_object, "Manufacturer offset value">{}.shifted(unit - 1);
}
/// Lowest position that the maker's encoder has.
constexpr auto manufacturer_minimum(unsigned unit) {
  return Number<module_identification_1_object, "Manufacturer minimum position value">{}.shifted(
      unit - 1);
}
/// Highest position that the maker's encoder has.
constexpr auto manufacturer_maximum(unsigned unit) {
  return Number<module_identification_1_object, "Manufacturer maximum position value">{}.shifted(
      unit - 1);
}

}  // namespace canvoy::cia417
