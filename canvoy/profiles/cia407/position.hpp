// Objects of CiA 407 that geographical positioning provides, 6660h to 6665h (9.2.21), time fixing,
// 6680h (9.2.22), and the driver's console keyboard, 66C0h (9.2.24).
//
//     cia407::position_object.index  // 6660h
#pragma once

#include "canvoy/profiles/cia407/vehicle.hpp"

namespace canvoy::cia407 {

/// Ten-millionths of a degree, from -210 degrees on (errata 57, 59).
inline constexpr ValueInfo coordinate =
    coded_32(Unit::degree, {.denominator = 10'000'000, .offset = -2'100'000'000});
/// A latitude or longitude.
constexpr EntryInfo coordinate_at(std::uint8_t sub, std::string_view name,
                                  std::string_view description) {
  return by_device(sub_index(sub, name, entry(unsigned32, ro, optional, {}, coordinate),
                             {.errata = "57, 58, 59", .description = description}));
}
inline constexpr EntryInfo position_entries[] = {
    entries_always(2), coordinate_at(1, "latitude", "North of the equator; south is negative."),
    coordinate_at(2, "longitude", "East of Greenwich; west is negative.")};
inline constexpr auto position_object = array(
    0x6660, "position", "9.2.21.1", "Where the vehicle is.", position_entries, "50, 57, 58, 59");
inline constexpr auto position_precision_object =
    variable(0x6661, "position_precision", "9.2.21.2", "How exact 6660h is.",
             entry(unsigned8, ro, no, 0xFF, {.unit = Unit::metre, .names = precision_unknown_8}),
             {.condition = "if object 6660h is implemented", .errata = "1, 104"});
inline constexpr auto gps_based_speed_object =
    variable(0x6662, "GPS_based_speed", "9.2.21.3", "The speed by GPS.",
             entry(unsigned16, ro, optional, {},
                   {.unit = Unit::metre_per_second, .scale = {.denominator = 10}}),
             {.errata = "12"});
inline constexpr auto gps_based_heading_object =
    variable(0x6663, "GPS_based_heading", "9.2.21.4", "Where the vehicle heads to, by GPS.",
             entry(unsigned16, ro, no, {}, heading), {.errata = "62, 64"});
inline constexpr auto gps_mileage_object =
    variable(0x6664, "GPS_mileage", "9.2.21.5", "The distance that the vehicle has gone, by GPS.",
             entry(unsigned32, ro, optional, 0, distance));
inline constexpr auto gps_mileage_precision_object = variable(
    0x6665, "GPS_mileage_precision", "9.2.21.6", "How exact 6664h is.",
    entry(unsigned16, ro, no, 0xFFFF, {.unit = Unit::metre, .names = precision_unknown_16}),
    {.condition = "if object 6664h is implemented", .errata = "2, 68, 104"});

/// Unlike for 6523h, the clause refers to no standard with codes for unavailable values.
inline constexpr auto time_universal_reference_entries =
    time_members(entries_always(8), by_device(entry(unsigned8, ro, optional)));
inline constexpr auto time_universal_reference_object =
    record(0x6680, "time_universal_reference", "9.2.22.1",
           "Time and date in UTC, of the measured position (record type 0081h).",
           time_universal_reference_entries, "48, 52, 53, 56, 105");

/// State of the reverse gear (66C0h).
enum class ReverseGear : std::uint8_t { engaged = 0, not_engaged = 1 };
inline constexpr NamedValue reverse_gear_states[] = {
    {ReverseGear::engaged, "reverse gear engaged"},
    {ReverseGear::not_engaged, "reverse gear not engaged"}};
inline constexpr auto flag_direction_forward_selection_object = variable(
    0x66C0, "flag_direction_forward_selection", "9.2.24.1", "Which way the driver wants to go.",
    entry(boolean, ro, optional, 1, reverse_gear_states));

}  // namespace canvoy::cia407
