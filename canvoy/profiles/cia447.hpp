// CiA 447-3: application objects of special-purpose cars (taxis, police cars, ambulances) and of
// their add-on devices: taximeter, roof bar, radio, printer, terminal.
//
// Where the text contradicts itself, `errata` gives the number of the finding that decided: A and B
// (lost figures), C and D for 6005h to 60A0h, Z for 60A1h to 6151h.
//
//     constexpr const ObjectInfo& doors = cia447::door_status_object;     // cia447/car_body.hpp
//     constexpr std::uint32_t can_id = cia447::sdo_request(2, 7);         // cia447/network.hpp
//
// Parts 1, 2 and 4 are not at hand. Not known are the codes of virtual devices, their mandatory
// objects, the CAN-IDs of PDOs, and the bits of 1000h above the profile's number.
#pragma once

#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/cia447/pdos.hpp"
#include "canvoy/profiles/cia447/provisions.hpp"

namespace canvoy::cia447 {

/// 1000h: the profile's number. The bits above it are defined in CiA 447-1 and not known.
inline constexpr std::uint32_t device_type = 447;
inline constexpr NamedValue profile_numbers[] = {{device_type, "CiA 447"}};
inline constexpr FieldInfo device_type_fields[] = {
    {.bits = 16, .name = "device profile number", .value = {.names = profile_numbers}},
    {.first_bit = 16,
     .bits = 16,
     .name = "additional information",
     .value = {.notation = Notation::hexadecimal},
     .description = "as CiA 447-1 says"}};

/// Record types. Their indices are in CiA 447-1 and not known.
inline constexpr RecordTypeInfo record_types[] = {{.name = "Start route guidance record",
                                                   .clause = "4.2.11.4",
                                                   .members = start_route_guidance_entries},
                                                  {.name = "Taximeter configuration record",
                                                   .clause = "4.2.12.8",
                                                   .members = taximeter_configuration_entries}};

inline constexpr auto objects_with_month_above_day =
    rows::objects_of(rtc_date_month_above_object, set_rtc_date_month_above_object);
inline constexpr auto objects_with_warnings_from_bit_1 =
    rows::objects_of(functional_warnings_from_bit_1_object);
inline constexpr ReadingInfo readings[] = {
    {.name = "month-above-day",
     .description = "60F0h and 60F1h: month in bits 27 to 24, day in bits 23 to 16",
     .errata = "Z02",
     .objects = objects_with_month_above_day},
    {.name = "warnings-from-bit-1",
     .description = "60A1h: fields from bit 1 upward, bit 0 not used",
     .errata = "Z01",
     .objects = objects_with_warnings_from_bit_1}};

inline constexpr Profile profile = {
    .number = device_type,
    .name = "CiA 447-3",
    .title = "Application profile for special-purpose car add-on devices: process data",
    .objects = objects,
    .device_type = device_type_fields,
    .virtual_devices = virtual_devices,
    .pdos = pdos,
    .record_types = record_types,
    .readings = readings,
    .provisions = &provisions};

}  // namespace canvoy::cia447
