// CiA 406: encoders, in the parts to which CiA 417 refers.
//
// The text of CiA 406 is not at hand. Indices and types are those of CiA's conformance test. Names,
// access, mapping, the bits of alarms, warnings and operating parameters, and the kinds of encoders
// in 1000h are common practice.
//
//     cia406::profile.objects.size()
#pragma once

#include "canvoy/profiles/cia406/objects.hpp"

namespace canvoy::cia406 {

inline constexpr std::uint16_t profile_number = 406;

inline constexpr NamedValue profile_names[] = {{profile_number, "CiA 406"}};
inline constexpr FieldInfo device_type_fields[] = {
    field(0, 16, "Device profile number", profile_names),
    field(16, 16, "Encoder type", encoder_types),
};

inline constexpr auto objects = objects_of(
    operating_parameters_object, measuring_units_per_revolution_object,
    total_measuring_range_in_measuring_units_object, preset_value_object, position_value_object,
    linear_encoder_measuring_step_settings_object, preset_values_for_multi_sensor_devices_object,
    position_values_for_multi_sensor_devices_object, speed_value_object, acceleration_value_object,
    cyclic_timer_object, cam_state_register_object, cam_enable_register_object,
    cam_polarity_register_object, cam_low_limit_object, cam_high_limit_object,
    cam_hysteresis_object, area_state_register_object, work_area_low_limit_object,
    work_area_high_limit_object, operating_status_object, single_turn_resolution_object,
    number_of_distinguishable_revolutions_object, alarms_object, supported_alarms_object,
    warnings_object, supported_warnings_object, profile_and_software_version_object,
    operating_time_object, offset_value_object, module_identification_object, serial_number_object,
    offset_values_for_multi_sensor_devices_object);
/// With several logical devices in a node, the objects of each are 800h above those of the one
/// before (CiA 301).
inline constexpr Profile profile = {.number = profile_number,
                                    .name = "CiA 406",
                                    .title = "Device profile for encoders",
                                    .objects = objects,
                                    .block_count = 8,
                                    .device_type = device_type_fields};

}  // namespace canvoy::cia406
