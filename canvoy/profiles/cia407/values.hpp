// Common elements of the objects of CiA 407: codes of virtual devices, shapes of objects, and
// codings of quantities.
//
//     inline constexpr auto fare_zone_object =
//         variable(0x6111, "fare_zone", "9.2.6.18", "The present fare zone.",
//                  entry(unsigned8, ro, by_default, 0));
#pragma once

#include <array>

#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia407 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Codes of virtual devices in 1000h, 6000h, 6001h and 6002h (8.1.1).
enum class DeviceCode : std::uint8_t {
  multiple = 0x00,
  main_on_board_computer = 0x01,
  identification = 0x02,
  passenger_information = 0x03,
  ticket_canceller = 0x04,
  ticket_printer = 0x05,
  ticket_reader = 0x06,
  acoustic_announcer = 0x07,
  acoustic_control_manager = 0x08,
  train_bus_gateway = 0x09,
  vehicle_gateway = 0x0A,
  vehicle_driver_indicator = 0x0B,
  tachograph = 0x0C,
  data_radio = 0x0D,
  voice_radio = 0x0E,
  short_range_communication = 0x0F,
  geographical_positioning = 0x10,
  time_fixing = 0x11,
  drivers_console_display = 0x12,
  drivers_console_keyboard = 0x13,
  passenger_counter = 0x14,
  passenger_counting_manager = 0x15,
  diagnostics = 0x16,
  generic_io = 0x17,
  power_supply = 0x18,
};
/// The code as an object has it.
constexpr std::uint8_t code_of(DeviceCode code) {
  return static_cast<std::uint8_t>(code);
}

// Entries and objects.

/// Clause 6 defines for each virtual device whether it has the object.
inline constexpr std::string_view by_virtual_device = "as the virtual device says (clause 6)";

/// An entry with the access that clause 6 gives the virtual device. As a rule, an object can be
/// read in its provider and written in its consumers.
constexpr EntryInfo by_device(EntryInfo entry) {
  entry.access_by_device = true;
  if (entry.consumer_access == Access::none) entry.consumer_access = Access::wo;
  return entry;
}
/// Remarks of an object that exists according to clause 6, where `remarks` give no other condition.
constexpr ObjectRemarks of_device(ObjectRemarks remarks) {
  if (remarks.condition.empty()) remarks.condition = by_virtual_device;
  return remarks;
}
/// A variable that clause 6 gives to virtual devices.
constexpr ObjectInfo variable(std::uint16_t index, std::string_view name, std::string_view clause,
                              std::string_view description, const EntryInfo& entry,
                              const ObjectRemarks& remarks = {}) {
  return var_object(index, name, clause, description, by_device(entry), of_device(remarks));
}
/// An array that clause 6 gives to virtual devices.
constexpr ObjectInfo array(std::uint16_t index, std::string_view name, std::string_view clause,
                           std::string_view description, Items<EntryInfo> subs,
                           std::string_view errata = {}) {
  return array_object(index, name, clause, description, subs, of_device({.errata = errata}));
}
/// A record that clause 6 gives to virtual devices.
constexpr ObjectInfo record(std::uint16_t index, std::string_view name, std::string_view clause,
                            std::string_view description, Items<EntryInfo> subs,
                            std::string_view errata = {}) {
  return record_object(index, name, clause, description, subs, of_device({.errata = errata}));
}

/// Sub-index 00h where the device defines the number of entries.
constexpr EntryInfo entries_within(std::uint8_t low, std::uint8_t high,
                                   std::string_view name = "number_of_entries") {
  return sub_index(0, name, entry(unsigned8, ro, no, highest_sub(), {.limits = within(low, high)}));
}
/// Sub-index 00h where each device has the same number of entries.
constexpr EntryInfo entries_always(std::uint8_t count) {
  return sub_index(0, "number_of_entries",
                   entry(unsigned8, ro, no, highest_sub(count), {.limits = within(count, count)}));
}
/// Entries of one shape at the sub-indices from `first` to `last`.
constexpr EntryInfo at(std::uint8_t first, std::uint8_t last, EntryInfo shape) {
  shape.sub_first = first;
  shape.sub_last = last;
  return shape;
}
/// An entry at one sub-index.
constexpr EntryInfo at(std::uint8_t sub, const EntryInfo& shape) {
  return at(sub, sub, shape);
}
/// Entries of one shape at the sub-indices from `first` to `last` that are optional.
constexpr EntryInfo optional_at(std::uint8_t first, std::uint8_t last, EntryInfo shape) {
  shape.category = Category::optional;
  return at(first, last, shape);
}
/// Sub-index 00h, a mandatory entry, and optional ones up to `last`, numbered from 1.
constexpr std::array<EntryInfo, 3> one_or_more(const EntryInfo& number, const EntryInfo& shape,
                                               std::uint8_t last) {
  EntryInfo more = optional_at(2, last, shape);
  more.first_number = 2;
  return {number, at(1, shape), more};
}

// Fields.

template <unsigned bits>
inline constexpr NamedValue padding[] = {{0, (1 << bits) - 1, "reserved", Meaning::padding}};
/// Bits without a meaning, which may have any value.
template <unsigned bits>
constexpr FieldInfo reserved(std::uint8_t first_bit) {
  return field(first_bit, bits, "reserved", {.names = padding<bits>});
}

// Texts. The profile gives no length for them: these are our choice, and a device may have less or
// more.

inline constexpr std::uint16_t text_capacity = 64;
inline constexpr std::uint16_t xml_capacity = 1024;
inline constexpr EntryInfo visible_text = string_entry(visible_string, ro, text_capacity);
/// Plain texts of 128 octets (errata 106).
inline constexpr EntryInfo plain_text = {
    .type = DataType::octet_string, .capacity = 128, .capacity_is_printed = true};

/// Names for a character in arrays that hold a short text; 0: no character.
inline constexpr NamedValue characters[] = {{0, "unused"}};
inline constexpr ValueInfo character = {.names = characters, .notation = Notation::characters};

// Quantities coded as in SAE J1939/71 and ISO 16844-7, to which the profile refers. Values above
// the valid ones stand for errors and missing values.

inline constexpr NamedValue not_values_8[] = {{0xFF, "not available", Meaning::invalid},
                                              {0xFE, "error", Meaning::failure},
                                              {0xFB, 0xFD, "reserved", Meaning::reserved}};
inline constexpr NamedValue not_values_16[] = {{0xFFFF, "not available", Meaning::invalid},
                                               {0xFF00, 0xFFFE, "not available", Meaning::invalid},
                                               {0xFE00, 0xFEFF, "error", Meaning::failure},
                                               {0xFB00, 0xFDFF, "reserved", Meaning::reserved}};
inline constexpr NamedValue not_values_32[] = {
    {0xFFFF'FFFF, "not available", Meaning::invalid},
    {0xFF00'0000, 0xFFFF'FFFE, "not available", Meaning::invalid},
    {0xFE00'0000, 0xFEFF'FFFF, "error", Meaning::failure},
    {0xFB00'0000, 0xFDFF'FFFF, "reserved", Meaning::reserved}};

/// A quantity of eight bits; FBh and above are no values.
constexpr ValueInfo coded_8(Unit unit, const Scale& scale) {
  return {.unit = unit, .scale = scale, .limits = within(0, 0xFA), .names = not_values_8};
}
/// A quantity of 16 bits; FB00h and above are no values.
constexpr ValueInfo coded_16(Unit unit, const Scale& scale) {
  return {.unit = unit, .scale = scale, .limits = within(0, 0xFAFF), .names = not_values_16};
}
/// A quantity of 32 bits; FB00 0000h and above are no values.
constexpr ValueInfo coded_32(Unit unit, const Scale& scale) {
  return {.unit = unit, .scale = scale, .limits = within(0, 0xFAFF'FFFF), .names = not_values_32};
}

/// 0 to 250.996 km/h (errata 61).
inline constexpr ValueInfo speed = coded_16(Unit::kilometre_per_hour, {.denominator = 256});
/// 0 to 21,055,406 km.
inline constexpr ValueInfo distance = coded_32(Unit::metre, {.numerator = 5});
/// 0 to 501.99 degrees (errata 62, 63).
inline constexpr ValueInfo heading = coded_16(Unit::degree, {.denominator = 128});

inline constexpr NamedValue precision_unknown_8[] = {{0xFF, "unknown", Meaning::invalid}};
inline constexpr NamedValue precision_unknown_16[] = {{0xFFFF, "unknown", Meaning::invalid}};
/// Precision of a distance, in the steps of the distance.
inline constexpr ValueInfo distance_precision = {
    .unit = Unit::metre, .scale = {.numerator = 5}, .names = precision_unknown_16};

// Time and date, as SAE J1939 has them (errata 52, 56).

inline constexpr ValueInfo offset_hours = {.unit = Unit::hour, .limits = within(-23, 23)};
inline constexpr ValueInfo offset_minutes = {.unit = Unit::minute, .limits = within(-59, 59)};
inline constexpr ValueInfo calendar_year = {
    .unit = Unit::year, .scale = {.offset = 1985}, .limits = within(0, 250)};
inline constexpr ValueInfo day_of_month = {
    .unit = Unit::day, .scale = {.denominator = 4}, .limits = within(1, 127)};
inline constexpr ValueInfo month_of_year = {.unit = Unit::month, .limits = within(1, 12)};
inline constexpr ValueInfo hour_of_day = {.unit = Unit::hour, .limits = within(0, 23)};
inline constexpr ValueInfo minute_of_hour = {.unit = Unit::minute, .limits = within(0, 59)};
inline constexpr ValueInfo second_of_minute = {
    .unit = Unit::second, .scale = {.denominator = 4}, .limits = within(0, 239)};

/// Year to second at the sub-indices from `first` on, each in the shape of `entry`.
constexpr std::array<EntryInfo, 6> date_and_time(std::uint8_t first, const EntryInfo& entry) {
  constexpr struct {
    std::string_view name;
    ValueInfo value;
  } parts[] = {{"year", calendar_year}, {"day", day_of_month},      {"month", month_of_year},
               {"hour", hour_of_day},   {"minute", minute_of_hour}, {"second", second_of_minute}};
  std::array<EntryInfo, 6> made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    made[i] = at(static_cast<std::uint8_t>(first + i), entry);
    made[i].name = parts[i].name;
    made[i].value = parts[i].value;
    made[i].value.names = entry.value.names;
  }
  return made;
}

}  // namespace canvoy::cia407
