// Identification of a physical device: its virtual devices and lifts (CiA 417-4, 4.2.1, 4.2.2 and
// 4.2.6; codes of the virtual devices from CiA 417-2).
//
//     cia417::device_type(cia417::VirtualDevice::car_position_unit)  // 060001A1h
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

/// The high byte of 1000h and of the words in 6000h. Version 1 of the profile has codes up to 0Bh,
/// the sensor unit; version 2 has the others, and gives 0Bh to another device.
enum class VirtualDevice : std::uint8_t {
  several = 0x00,  ///< those that 6000h lists
  call_controller = 0x01,
  input_panel_unit = 0x02,
  output_panel_unit = 0x03,
  car_door_controller = 0x04,
  car_door_unit = 0x05,
  car_position_unit = 0x06,
  light_barrier_unit = 0x07,
  car_drive_controller = 0x08,
  car_drive_unit = 0x09,
  load_measuring_unit = 0x0A,
  sensor_unit = 0x0B,
  power_measuring_unit = 0x0C,
  access_request_unit = 0x0D,
  emergency_phone = 0x0E,
  position_supervisor_unit = 0x0F,
  monitoring_unit = 0x10,
  energy_recovery_system = 0x11,
  bootloader = 0xFE,
};
inline constexpr NamedValue virtual_device_names[] = {
    {VirtualDevice::several, "several virtual devices"},
    {VirtualDevice::call_controller, "call controller"},
    {VirtualDevice::input_panel_unit, "input panel unit"},
    {VirtualDevice::output_panel_unit, "output panel unit"},
    {VirtualDevice::car_door_controller, "car door controller"},
    {VirtualDevice::car_door_unit, "car door unit"},
    {VirtualDevice::car_position_unit, "car position unit"},
    {VirtualDevice::light_barrier_unit, "light barrier unit"},
    {VirtualDevice::car_drive_controller, "car drive controller"},
    {VirtualDevice::car_drive_unit, "car drive unit"},
    {VirtualDevice::load_measuring_unit, "load measuring unit"},
    {VirtualDevice::sensor_unit, "sensor unit; from version 2 on remote data transmission unit"},
    {VirtualDevice::power_measuring_unit, "power measuring unit"},
    {VirtualDevice::access_request_unit, "access request unit"},
    {VirtualDevice::emergency_phone, "emergency phone"},
    {VirtualDevice::position_supervisor_unit, "position supervisor unit"},
    {VirtualDevice::monitoring_unit, "monitoring unit"},
    {VirtualDevice::energy_recovery_system, "energy recovery system"},
    {0x12, 0xFD, "reserved", Meaning::reserved},
    {VirtualDevice::bootloader, "bootloader"},
    {0xFF, "reserved", Meaning::reserved},
};
inline constexpr ValueInfo virtual_device_code = {.names = virtual_device_names,
                                                  .notation = Notation::hexadecimal};

inline constexpr std::uint16_t profile_number = 417;
inline constexpr unsigned virtual_device_bit = 24;

/// 1000h.
inline constexpr NamedValue profile_number_names[] = {{profile_number, "CiA 417"}};
inline constexpr FieldInfo device_type_fields[] = {
    field(0, 16, "Device profile number", profile_number_names), reserved_bits<8>(16),
    field(virtual_device_bit, 8, "Virtual device", virtual_device_code)};

/// Value of 1000h: the code of the virtual device in bits 24 to 31, and 417.
constexpr std::uint32_t device_type(VirtualDevice device) {
  return static_cast<std::uint32_t>(device) << virtual_device_bit | profile_number;
}

// 6000h

inline constexpr FieldInfo virtual_device_type_fields[] = {
    reserved_bits<8>(0), field(8, 8, "Virtual device", virtual_device_code)};
inline constexpr EntryInfo virtual_device_type =
    sub_index(0, "Virtual device type #",
              entry(unsigned16, ro, no, {}, hexadecimal, virtual_device_type_fields));
inline constexpr EntryInfo supported_virtual_device_types_entries[] = {
    count_entry("Number of supported virtual devices", 0x01, last_of_many),
    at(1, virtual_device_type), at(2, virtual_device_type),
    optional_at(3, last_of_many, virtual_device_type)};
inline constexpr auto supported_virtual_device_types_object = array_object(
    0x6000, "Supported virtual device types", "4.2.1",
    "The virtual devices in this device, as the high word of 1000h would name each.",
    supported_virtual_device_types_entries,
    {.condition = "if the device is several virtual devices", .errata = "B16, B32", .once = true});

// 6001h

inline constexpr NamedValue lift_number_names[] = {{0x00, "reserved", Meaning::reserved}};
inline constexpr auto lift_number_fields = lift_bits(0, "Lift #");
inline constexpr auto lift_number_object = var_object(
    0x6001, "Lift number", "4.2.2",
    "The lifts that the device belongs to; only gateways and the like have several.",
    entry(
        unsigned8, rw, no, 0x01,
        {.limits = within(0x01, 0xFF), .names = lift_number_names, .notation = Notation::bit_mask},
        lift_number_fields),
    {.condition = "if the device is a call, car door or car drive controller, a car door, light "
                  "barrier, car position, car drive or load measuring unit",
     .errata = "A23, B17, B18, B32",
     .once = true});

// 6020h

/// What a write to 6020h does.
enum class Creation : std::uint8_t { create = 1, destroy = 2 };
/// Access that a created entry gets (6020h).
enum class CreatedAccess : std::uint8_t { as_specified = 0, ro = 1, wo = 2, rw = 3 };
inline constexpr NamedValue creation_names[] = {{0, "reserved", Meaning::reserved},
                                                {Creation::create, "create"},
                                                {Creation::destroy, "destroy"},
                                                {3, "reserved", Meaning::reserved}};
inline constexpr NamedValue created_access_names[] = {{CreatedAccess::as_specified, "as specified"},
                                                      {CreatedAccess::ro, "ro"},
                                                      {CreatedAccess::wo, "wo"},
                                                      {CreatedAccess::rw, "rw"}};
inline constexpr FieldInfo object_creation_fields[] = {
    field(0, 2, "Action", creation_names), reserved_bits<4>(2),
    field(6, 2, "Access", created_access_names), field(8, 8, "Sub-index", hexadecimal),
    field(16, 16, "Index", hexadecimal)};
inline constexpr auto object_creation_object = var_object(
    0x6020, "Object creation", "4.2.6",
    "Writing creates or destroys an object: 0609 0030h or 0800 0000h where the device does not "
    "support it, 0504 0005h or 0800 0000h without room. Reading gives the last one created.",
    entry(unsigned32, rw, no, {}, hexadecimal, object_creation_fields),
    {.category = Category::optional, .errata = "A20, B32"});

}  // namespace canvoy::cia417
