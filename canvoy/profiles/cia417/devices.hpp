// The virtual devices of a lift and the objects of each. The section of CiA 417-4 that contains an
// object names its provider; the consumers follow from the PDOs. CiA 417-2 defines which objects
// are mandatory; here that is known of 6000h and 6001h only.
//
//     cia417::virtual_devices[6].name  // "car position unit"
#pragma once

#include "canvoy/profiles/cia417/objects.hpp"

namespace canvoy::cia417 {

/// A mandatory object.
constexpr DeviceObject must_have(const ObjectInfo& object) {
  return {.index = object.index};
}
/// All objects of one shape.
constexpr DeviceObject may_have(const ObjectInfo& object, std::string_view condition = see_part_2) {
  DeviceObject made{
      .index = object.index, .category = Category::conditional, .condition = condition};
  if (object.count > 1) made.last = static_cast<std::uint16_t>(object.index + object.count - 1);
  if (object.category == Category::optional) {
    made.category = Category::optional;
    made.condition = {};
  }
  return made;
}
/// An object of another device that it takes by PDO or SDO.
constexpr DeviceObject consumes(const ObjectInfo& object) {
  DeviceObject made = may_have(object);
  made.consumed = true;
  return made;
}

inline constexpr DeviceObject objects_of_several[] = {
    must_have(supported_virtual_device_types_object), may_have(object_creation_object)};

inline constexpr DeviceObject objects_of_call_controller[] = {
    must_have(lift_number_object),
    consumes(virtual_input_mapping_object),
    may_have(virtual_output_mapping_object),
    may_have(object_creation_object),
    consumes(input_group_object),
    may_have(output_group_object),
    consumes(position_value_object),
    consumes(load_signaling_object)};

inline constexpr DeviceObject objects_of_input_panel_unit[] = {
    may_have(virtual_input_mapping_object, virtual_input_mapping_object.condition),
    may_have(object_creation_object),
    may_have(input_group_object),
    may_have(input_parameter_1_object),
    may_have(input_parameter_2_object),
    may_have(input_parameter_3_object),
    may_have(input_parameter_4_object)};

inline constexpr DeviceObject objects_of_output_panel_unit[] = {
    consumes(virtual_output_mapping_object), may_have(object_creation_object),
    consumes(output_group_object),           may_have(output_parameter_1_object),
    may_have(output_parameter_2_object),     may_have(output_parameter_3_object),
    may_have(output_parameter_4_object)};

inline constexpr DeviceObject objects_of_car_door_controller[] = {
    must_have(lift_number_object),     may_have(object_creation_object),
    may_have(door_controlword_object), consumes(door_statusword_object),
    consumes(door_position_object),    consumes(light_barrier_status_object)};

/// Light barriers report to the controller. A door that re-opens by itself (6304h:04h) needs their
/// state, too, where they are not wired to it.
inline constexpr DeviceObject objects_of_car_door_unit[] = {
    must_have(lift_number_object),        may_have(object_creation_object),
    consumes(door_controlword_object),    may_have(door_statusword_object),
    may_have(door_position_object),       may_have(door_configuration_object),
    consumes(light_barrier_status_object)};

/// The position CAM unit (4.10) has no code of its own.
inline constexpr std::string_view with_cams = "if it is a position CAM unit, too";
inline constexpr DeviceObject objects_of_car_position_unit[] = {
    must_have(lift_number_object),
    may_have(object_creation_object),
    may_have(operating_parameter_object),
    may_have(units_per_revolution_object),
    may_have(preset_value_object),
    may_have(position_value_object),
    may_have(measuring_step_settings_object),
    may_have(speed_value_car_object),
    may_have(acceleration_value_car_object),
    may_have(cam_state_object, with_cams),
    may_have(cam_enable_object, with_cams),
    may_have(cam_polarity_object, with_cams),
    may_have(area_state_object),
    may_have(work_area_low_limit_1_object),
    may_have(work_area_low_limit_2_object),
    may_have(work_area_low_limit_3_object),
    may_have(work_area_low_limit_4_object),
    may_have(work_area_high_limit_1_object),
    may_have(work_area_high_limit_2_object),
    may_have(work_area_high_limit_3_object),
    may_have(work_area_high_limit_4_object),
    may_have(operating_status_object),
    may_have(single_turn_resolution_object),
    may_have(distinguishable_revolutions_object),
    may_have(supported_warnings_object),
    may_have(warnings_object),
    may_have(supported_alarms_object),
    may_have(alarms_object),
    may_have(operating_time_object),
    may_have(offset_value_object),
    may_have(module_identification_1_object),
    may_have(module_identification_2_object),
    may_have(module_identification_3_object),
    may_have(module_identification_4_object)};

inline constexpr DeviceObject objects_of_light_barrier_unit[] = {
    must_have(lift_number_object), may_have(object_creation_object),
    may_have(light_barrier_status_object)};

inline constexpr DeviceObject objects_of_car_drive_controller[] = {
    must_have(lift_number_object),
    may_have(object_creation_object),
    consumes(position_value_object),
    may_have(controlword_object),
    consumes(statusword_object),
    may_have(modes_of_operation_object),
    consumes(modes_of_operation_display_object),
    consumes(control_effort_object),
    may_have(target_position_object),
    may_have(target_velocity_object),
    consumes(velocity_sensor_actual_value_object),
    consumes(velocity_demand_value_object),
    consumes(velocity_actual_value_object),
    consumes(load_signaling_object)};

inline constexpr DeviceObject objects_of_car_drive_unit[] = {
    must_have(lift_number_object),
    may_have(object_creation_object),
    consumes(controlword_object),
    may_have(statusword_object),
    may_have(control_option_codes_object),
    consumes(modes_of_operation_object),
    may_have(modes_of_operation_display_object),
    may_have(motion_profile_type_object),
    may_have(control_effort_object),
    may_have(max_velocity_object),
    may_have(max_acceleration_object),
    may_have(quick_stop_deceleration_object),
    may_have(profile_acceleration_object),
    may_have(profile_jerk_use_object),
    may_have(profile_jerk_object),
    may_have(motor_data_object),
    may_have(position_dimension_object),
    may_have(velocity_dimension_object),
    may_have(acceleration_dimension_object),
    may_have(jerk_dimension_object),
    may_have(position_encoder_resolution_object),
    may_have(velocity_encoder_resolution_object),
    may_have(gear_ratio_object),
    may_have(feed_constant_object),
    may_have(position_factor_object),
    may_have(velocity_encoder_factor_object),
    may_have(velocity_factor_1_object),
    may_have(velocity_factor_2_object),
    may_have(acceleration_factor_object),
    may_have(jerk_factor_object),
    may_have(polarity_object),
    consumes(target_position_object),
    may_have(position_range_limit_object),
    may_have(software_position_limit_object),
    may_have(profile_velocity_object),
    may_have(end_velocity_object),
    may_have(home_offset_object),
    consumes(target_velocity_object),
    may_have(velocity_sensor_actual_value_object),
    may_have(velocity_demand_value_object),
    may_have(velocity_actual_value_object),
    may_have(sensor_selection_code_object),
    may_have(velocity_window_object),
    may_have(velocity_threshold_object),
    may_have(max_slippage_object),
    may_have(velocity_control_parameter_set_object)};

inline constexpr DeviceObject objects_of_load_measuring_unit[] = {
    must_have(lift_number_object),   may_have(object_creation_object),
    may_have(load_value_object),     may_have(load_limits_object),
    may_have(load_signaling_object), may_have(load_signaling_limits_object),
    may_have(rope_load_object),      may_have(load_system_configuration_object)};

inline constexpr DeviceObject objects_of_sensor_unit[] = {
    may_have(virtual_sensor_mapping_object, virtual_sensor_mapping_object.condition),
    may_have(object_creation_object),
    may_have(sensor_group_object),
    may_have(sensor_parameter_1_object),
    may_have(sensor_parameter_2_object),
    may_have(sensor_parameter_3_object)};

/// A virtual device with its code of part 1.
constexpr VirtualDeviceInfo virtual_device_of(VirtualDevice device, std::string_view clause,
                                              Items<DeviceObject> device_objects,
                                              std::string_view description,
                                              std::string_view errata = {}) {
  return {.code = static_cast<std::uint8_t>(device),
          .name = find_name(virtual_device_code, static_cast<std::int64_t>(device), 8, false)->name,
          .objects = device_objects,
          .clause = clause,
          .errata = errata,
          .description = description};
}

inline constexpr VirtualDeviceInfo virtual_devices[] = {
    virtual_device_of(VirtualDevice::several, "4.2.1", objects_of_several,
                      "A device that is several of the others."),
    virtual_device_of(VirtualDevice::call_controller, "4.4", objects_of_call_controller,
                      "Takes calls and lights lamps."),
    virtual_device_of(VirtualDevice::input_panel_unit, "4.3", objects_of_input_panel_unit,
                      "Buttons and keys of a landing or a car."),
    virtual_device_of(VirtualDevice::output_panel_unit, "4.5", objects_of_output_panel_unit,
                      "Lamps and displays of a landing or a car."),
    virtual_device_of(VirtualDevice::car_door_controller, "4.6", objects_of_car_door_controller,
                      "Opens and closes the doors."),
    virtual_device_of(VirtualDevice::car_door_unit, "4.7", objects_of_car_door_unit,
                      "Moves a door."),
    virtual_device_of(VirtualDevice::car_position_unit, "4.9, 4.10", objects_of_car_position_unit,
                      "Measures where the car is.", "B17, B29"),
    virtual_device_of(VirtualDevice::light_barrier_unit, "4.8", objects_of_light_barrier_unit,
                      "Watches a door."),
    virtual_device_of(VirtualDevice::car_drive_controller, "4.11", objects_of_car_drive_controller,
                      "Sends the car to a floor."),
    virtual_device_of(VirtualDevice::car_drive_unit, "4.11", objects_of_car_drive_unit,
                      "Moves the car."),
    virtual_device_of(VirtualDevice::load_measuring_unit, "4.12", objects_of_load_measuring_unit,
                      "Weighs the car."),
    virtual_device_of(VirtualDevice::sensor_unit, "4.13", objects_of_sensor_unit,
                      "Glass, smoke, pressure and other sensors."),
};

}  // namespace canvoy::cia417
