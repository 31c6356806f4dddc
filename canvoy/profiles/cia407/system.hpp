// Objects of CiA 407 that belong to no virtual device: 1001h and 1029h (8.1), the supported virtual
// devices 6000h, the device type 67FFh, and the fields of 1000h.
//
//     cia407::device_type_fields  // code, class and subclass of a virtual device; 407
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

inline constexpr std::uint16_t profile_number = 407;

/// Information class of a passenger information device or a driver indicator (6.4, 6.12).
enum class InformationClass : std::uint8_t { destination = 1, next_stop = 2, information = 3 };
/// Class of a vehicle driver indicator (6.12).
enum class IndicatorClass : std::uint8_t { display = 1, display_with_keyboard = 2 };
/// Kind of display of a passenger information device (6.4).
enum class InformationSubclass : std::uint8_t { simple = 1, text = 2, graphics = 3, extended = 4 };

// Names as in clause 6 (errata 49).
inline constexpr NamedValue device_codes[] = {
    {DeviceCode::multiple, "Multiple virtual device"},
    {DeviceCode::main_on_board_computer, "Main on-board computer"},
    {DeviceCode::identification, "Identification"},
    {DeviceCode::passenger_information, "Passenger information"},
    {DeviceCode::ticket_canceller, "Ticket canceller"},
    {DeviceCode::ticket_printer, "Ticket printer"},
    {DeviceCode::ticket_reader, "Ticket/card reader/validator"},
    {DeviceCode::acoustic_announcer, "Acoustic announcer"},
    {DeviceCode::acoustic_control_manager, "Acoustic control manager"},
    {DeviceCode::train_bus_gateway, "Train bus gateway"},
    {DeviceCode::vehicle_gateway, "Vehicle gateway"},
    {DeviceCode::vehicle_driver_indicator, "Vehicle driver indicator"},
    {DeviceCode::tachograph, "Tachograph"},
    {DeviceCode::data_radio, "Data radio communication controller (DRCC)"},
    {DeviceCode::voice_radio, "Voice radio communication controller (VRCC)"},
    {DeviceCode::short_range_communication, "Dedicated Short Range Communication (DSRC) device"},
    {DeviceCode::geographical_positioning, "Geographical positioning device"},
    {DeviceCode::time_fixing, "Time fixing device"},
    {DeviceCode::drivers_console_display, "Driver's console display"},
    {DeviceCode::drivers_console_keyboard, "Driver's console keyboard"},
    {DeviceCode::passenger_counter, "Passenger counter"},
    {DeviceCode::passenger_counting_manager, "Passenger counting manager"},
    {DeviceCode::diagnostics, "Diagnostics device"},
    {DeviceCode::generic_io, "Generic I/O device"},
    {DeviceCode::power_supply, "Power supply"},
    {0x19, 0xFF, "reserved", Meaning::reserved},
};
/// Name of a virtual device in the table of codes.
constexpr std::string_view name_of(DeviceCode code) {
  return device_codes[code_of(code)].name;
}

inline constexpr NamedValue no_class[] = {{0, "not used"}, {1, 15, "reserved", Meaning::reserved}};
inline constexpr NamedValue information_classes[] = {
    {0, 0, "reserved", Meaning::reserved},
    {InformationClass::destination, "destination indicator"},
    {InformationClass::next_stop, "next stop indicator"},
    {InformationClass::information, "information indicator"},
    {4, 15, "reserved", Meaning::reserved}};
inline constexpr NamedValue information_subclasses[] = {
    {0, 0, "reserved", Meaning::reserved},       {InformationSubclass::simple, "simple"},
    {InformationSubclass::text, "text"},         {InformationSubclass::graphics, "graphics"},
    {InformationSubclass::extended, "extended"}, {5, 15, "reserved", Meaning::reserved}};
inline constexpr NamedValue indicator_classes[] = {
    {0, 0, "reserved", Meaning::reserved},
    {IndicatorClass::display, "display only"},
    {IndicatorClass::display_with_keyboard, "display with keyboard"},
    {3, 15, "reserved", Meaning::reserved}};

inline constexpr std::string_view device_code_field = "device code";
/// Condition that the device code is one of these.
constexpr FieldCondition where_code(DeviceCode first, DeviceCode last) {
  return {device_code_field, code_of(first), code_of(last)};
}
inline constexpr FieldCondition is_information[] = {
    where_code(DeviceCode::passenger_information, DeviceCode::passenger_information)};
inline constexpr FieldCondition is_indicator[] = {
    where_code(DeviceCode::vehicle_driver_indicator, DeviceCode::vehicle_driver_indicator)};
inline constexpr FieldCondition has_no_subclass[] = {
    where_code(DeviceCode::multiple, DeviceCode::identification),
    {device_code_field, code_of(DeviceCode::ticket_canceller), 0xFF}};
inline constexpr FieldCondition has_no_class[] = {
    where_code(DeviceCode::multiple, DeviceCode::identification),
    where_code(DeviceCode::ticket_canceller, DeviceCode::vehicle_gateway),
    {device_code_field, code_of(DeviceCode::tachograph), 0xFF}};

/// Subclass, class and code of a virtual device, from bit `first` on (8.1.1; errata 14 to 18).
constexpr std::array<FieldInfo, 6> additional_information(std::uint8_t first) {
  const auto nibble = [first](unsigned offset, std::string_view name,
                              const Items<NamedValue>& names, const Items<FieldCondition>& when) {
    return FieldInfo{.first_bit = static_cast<std::uint8_t>(first + offset),
                     .bits = 4,
                     .name = name,
                     .value = {.names = names},
                     .when = when};
  };
  return {nibble(0, "sub-class", information_subclasses, is_information),
          nibble(0, "sub-class", no_class, has_no_subclass),
          nibble(4, "class", information_classes, is_information),
          nibble(4, "class", indicator_classes, is_indicator),
          nibble(4, "class", no_class, has_no_class),
          field(static_cast<std::uint8_t>(first + 8), 8, device_code_field, device_codes)};
}

inline constexpr NamedValue profile_numbers[] = {{profile_number, "CiA 407"}};
/// Profile number, then the fields of a virtual device.
constexpr std::array<FieldInfo, 7> make_device_type_fields() {
  std::array<FieldInfo, 7> fields{};
  fields[0] = field(0, 16, "number of device profile", profile_numbers);
  const auto additional = additional_information(16);
  for (std::size_t i = 0; i < additional.size(); ++i) fields[i + 1] = additional[i];
  return fields;
}
/// Fields of 1000h. Code 00h says that there are several virtual devices, which 6000h lists.
inline constexpr auto device_type_fields = make_device_type_fields();

/// 1000h of a device that consists of one virtual device.
constexpr std::uint32_t device_type(const VirtualDeviceInfo& device) {
  return std::uint32_t{device.code} << 24 | std::uint32_t{device.device_class} << 20 |
         std::uint32_t{device.subclass} << 16 | profile_number;
}
/// 1000h of a device that consists of several virtual devices.
inline constexpr std::uint32_t multiple_device_type = profile_number;

inline constexpr FieldInfo error_register_bits[] = {
    cia301::error_register_bits[0], cia301::error_register_bits[1], cia301::error_register_bits[2],
    cia301::error_register_bits[3], cia301::error_register_bits[4], reserved<2>(5),
    cia301::error_register_bits[6]};
/// 1001h with the bit of the device profile reserved.
constexpr ObjectInfo make_error_register() {
  ObjectInfo object = cia301::error_register_object;
  object.clause = "8.1.2";
  object.description = "One bit for each kind of error; that of the device profile is reserved.";
  object.entry.fields = error_register_bits;
  return object;
}
inline constexpr ObjectInfo error_register_object = make_error_register();

inline constexpr EntryInfo error_behavior_entries[] = {
    cia301::highest_sub_index,
    cia301::error_behavior_entries[1],
    sub_index(
        2, "Internal_Device_Error",
        entry(unsigned8, rw, no, 0, {.limits = within(0, 2), .names = cia301::error_behaviors}),
        {.category = Category::optional,
         .description = "What the device does when it finds an error within itself."}),
};
inline constexpr auto error_behavior_object = array_object(
    0x1029, "Error behavior", "8.1.3", "The NMT state that a device enters when an error comes.",
    error_behavior_entries, {.category = Category::optional});

inline constexpr auto virtual_device_type_fields = additional_information(0);
inline constexpr EntryInfo virtual_device_type = sub_index(
    0, "virtual_device_type_#",
    entry(unsigned16, ro, no, {}, {.notation = Notation::hexadecimal}, virtual_device_type_fields));
/// The third virtual device and those after it.
constexpr EntryInfo more_virtual_device_types() {
  EntryInfo more = optional_at(3, 254, virtual_device_type);
  more.first_number = 3;
  return more;
}
inline constexpr EntryInfo supported_virtual_device_types_entries[] = {
    entries_within(2, 254, "number_of_supported_virtual_devices"), at(1, 2, virtual_device_type),
    more_virtual_device_types()};
inline constexpr auto supported_virtual_device_types_object =
    array_object(0x6000, "supported_virtual_device_types", "9.2.3.1",
                 "The virtual devices in this device, each as the high word of 1000h would be.",
                 supported_virtual_device_types_entries,
                 {.condition = "if the device is several virtual devices", .errata = "79"});

/// The specification has no object description; type and access are those of 1000h.
inline constexpr auto device_type_object =
    var_object(0x67FF, "device_type", "9.2.30.1",
               "1000h of the first logical device of a multiple device module.",
               entry(unsigned32, ro, no, multiple_device_type, {.notation = Notation::hexadecimal},
                     device_type_fields),
               {.condition = "if the device is a multiple device module"});

}  // namespace canvoy::cia407
