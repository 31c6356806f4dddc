// CiA 417-4 version 1.0.1: lift control, up to 8 lifts of 254 floors. Where the text contradicts
// itself, `errata` gives the number of the finding that decided. Facts from other parts of CiA 417
// (device codes, PDOs, error codes) are from public sources.
//
//     find_object(cia417::profile, 0x6C82)  // 6482h, Load signaling, of lift 2
//
// canvoy/profiles/cia417/handles.hpp has the handles for application code.
#pragma once

#include "canvoy/profiles/cia417/devices.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/cia417/objects.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/profiles/cia417/provisions.hpp"

namespace canvoy::cia417 {

inline constexpr std::string_view error_clause = "CiA 417-1, 8.4";
inline constexpr ErrorCodeInfo error_codes[] = {
    {emergency_code::can_warning_level, "CAN warning level reached", error_clause},
    {0x3111, "mains over-voltage", error_clause},
    {0x3121, "mains under-voltage", error_clause},
    {0x3211, "over-voltage inside the device", error_clause},
    {0x3221, "under-voltage inside the device", error_clause},
    {emergency_code::light_barrier_defect, "light barrier defect", error_clause},
    {emergency_code::finger_protector_defect, "finger protector defect", error_clause},
    {emergency_code::motion_detection_defect, "motion detection defect", error_clause},
    {emergency_code::application_error, "application error", error_clause},
    {emergency_code::overspeed, "overspeed", error_clause, "The car drive unit makes a fast stop."},
    {emergency_code::unintended_car_movement, "unintended car movement", error_clause,
     "The car drive unit makes a fast stop."},
};

inline constexpr RecordTypeInfo record_types[] = {{.index = dimension_record_index,
                                                   .name = "Dimension record",
                                                   .clause = "4.1.3.1",
                                                   .members = dimension_record_members}};

/// 1000h of one virtual device, as the model asks for it.
constexpr std::uint32_t device_type_of(const VirtualDeviceInfo& device) {
  return device_type(static_cast<VirtualDevice>(device.code));
}

inline constexpr Profile profile = {
    .number = profile_number,
    .name = "CiA 417-4",
    .title = "Application profile for lift control systems: objects",
    .objects = objects,
    .block_count = lift_count,
    .block_pitch = block_pitch,
    .device_type = device_type_fields,
    .virtual_devices = virtual_devices,
    .device_type_of = device_type_of,
    .pdos = pdos,
    .error_codes = error_codes,
    .record_types = record_types,
    .provisions = &provisions,
};

}  // namespace canvoy::cia417
