// CiA 447-3, clauses 4.2.10 and 4.2.11: GPS and navigation system.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// Latitude and longitude: degrees north and east from 0 upward, then degrees south and west, which
// start again at 0 where the former end. This is neither a two's complement nor a modulo of the
// circle (errata Z36).

inline constexpr std::int64_t steps_per_degree = 10'000'000;
inline constexpr std::int64_t quarter = 90 * steps_per_degree;       // 35A4 E900h
inline constexpr std::int64_t half = 180 * steps_per_degree;         // 6B49 D200h
inline constexpr std::int64_t full_circle = 360 * steps_per_degree;  // D693 A400h
/// Codes of a degree each 10,000,000: they grow with it.
constexpr Scale upward() {
  return {.denominator = steps_per_degree};
}
/// Codes that grow while the degrees fall below 0, which is at `end`.
constexpr Scale downward_from(std::int64_t end) {
  return {.numerator = -1, .denominator = steps_per_degree, .offset = end};
}
inline constexpr Piece latitude_pieces[] = {
    {.first = 0, .last = quarter, .scale = upward(), .name = "north"},
    {.first = quarter + 1, .last = half, .scale = downward_from(quarter), .name = "south"}};
inline constexpr Piece longitude_pieces[] = {
    {.first = 0, .last = half, .scale = upward(), .name = "east"},
    {.first = half + 1, .last = full_circle, .scale = downward_from(half), .name = "west"}};

// Only the highest code of a requested coordinate is a sentinel (errata Z35).
inline constexpr NamedValue wanted_latitude_names[] = {command_sentinels<32>.highest,
                                                       reserved_codes(half + 1, 0xFFFF'FFFE)};
inline constexpr NamedValue wanted_longitude_names[] = {
    command_sentinels<32>.highest, reserved_codes(full_circle + 1, 0xFFFF'FFFE)};
inline constexpr ValueInfo measured_latitude = {.unit = Unit::degree,
                                                .limits = within(0, half),
                                                .names = measured_names<32, half>,
                                                .pieces = latitude_pieces};
inline constexpr ValueInfo measured_longitude = {.unit = Unit::degree,
                                                 .limits = within(0, full_circle),
                                                 .names = measured_names<32, full_circle>,
                                                 .pieces = longitude_pieces};
inline constexpr ValueInfo wanted_latitude = {.unit = Unit::degree,
                                              .limits = within(0, half),
                                              .names = wanted_latitude_names,
                                              .pieces = latitude_pieces};
inline constexpr ValueInfo wanted_longitude = {.unit = Unit::degree,
                                               .limits = within(0, full_circle),
                                               .names = wanted_longitude_names,
                                               .pieces = longitude_pieces};

// 4.2.10.1 to 4.2.10.3: position and its quality.

inline constexpr EntryInfo gps_current_position_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Position latitude",
       status(DataType::unsigned32, Mapping::by_default, measured_latitude)),
    at(2, "Position longitude",
       status(DataType::unsigned32, Mapping::by_default, measured_longitude))};
inline constexpr auto gps_current_position_object =
    array_object(0x60B0, "GPS current position", "4.2.10.1", "Where the car is.",
                 gps_current_position_entries, {.errata = "Z36"});

inline constexpr auto gps_satellites_fields =
    side_by_side(field(4, "visible satellites", "satellites above the horizon", measured<4>()),
                 field(4, "tracked satellites", "satellites that are received", measured<4>()));
inline constexpr auto gps_satellites_object =
    variable_object(0x60B1, "GPS satellites", "4.2.10.2", "How many satellites there are.",
                    status(DataType::unsigned8, Mapping::no, gps_satellites_fields));

// Neither unit nor resolution of the dilutions is printed: they are whole steps (errata Z27).
inline constexpr auto gps_fixes = status_values<4>("No fix", "2D fix", "3D fix");
inline constexpr auto gps_status_fields =
    side_by_side(field(8, "GPS vdop", "vertical dilution of precision", measured<8, 0x50>()),
                 field(8, "GPS hdop", "horizontal dilution of precision", measured<8, 0x50>()),
                 field(8, "GPS pdop", "position dilution of precision", measured<8, 0x50>()),
                 field(4, "GPS fix", "what the position is good for", gps_fixes), reserved<4>());
inline constexpr auto gps_status_object = variable_object(
    0x60B2, "GPS status", "4.2.10.3", "How good the position is.",
    status(DataType::unsigned32, Mapping::no, gps_status_fields), {.errata = "Z27"});

// 4.2.10.4 and 4.2.10.5: date and time.

/// From 1 to `high`: 0 is reserved.
template <unsigned bits, std::int64_t high>
inline constexpr NamedValue counted_names[] = {status_sentinels<bits>.second_highest,
                                               status_sentinels<bits>.highest, reserved_codes(0, 0),
                                               reserved_codes(high + 1, all_ones(bits) - 2)};
/// A number from 1 to `high`.
template <unsigned bits, std::int64_t high>
constexpr ValueInfo counted(Unit unit) {
  return {.unit = unit, .limits = within(1, high), .names = counted_names<bits, high>};
}
inline constexpr auto gps_date_fields =
    side_by_side(field(16, "GPS date year", "", measured<16>(Unit::year)),
                 field(4, "GPS date month", "", counted<4, 12>(Unit::month)),
                 field(6, "GPS date day", "", counted<6, 31>(Unit::day)), reserved<6>());
inline constexpr auto gps_date_object =
    variable_object(0x60B3, "GPS date", "4.2.10.4", "The date that the satellites tell.",
                    status(DataType::unsigned32, Mapping::no, gps_date_fields));
inline constexpr auto gps_utc_time_fields = side_by_side(
    field(5, "GPS UTC hour", "", measured<5, 23>(Unit::hour)),
    field(6, "GPS UTC minute", "", measured<6, 59>(Unit::minute)),
    field(13, "GPS UTC second", "", measured<13, 5999>(Unit::second, {.denominator = 100})));
inline constexpr auto gps_utc_time_object =
    variable_object(0x60B4, "GPS UTC time", "4.2.10.5", "The time that the satellites tell.",
                    status(DataType::unsigned24, Mapping::no, gps_utc_time_fields));

// 4.2.10.6 and 4.2.10.7: movement and height.

inline constexpr EntryInfo gps_velocity_and_heading_entries[] = {
    highest_sub_index(1, 2),
    at(1, "GPS velocity",
       status(DataType::unsigned16, Mapping::no,
              measured<16>(Unit::metre_per_second, {.denominator = 100}))),
    at(2, "GPS heading",
       status(DataType::unsigned16, Mapping::no,
              measured<16, 3599>(Unit::degree, {.denominator = 10})),
       Category::optional)};
inline constexpr auto gps_velocity_and_heading_object =
    array_object(0x60B5, "GPS velocity and heading", "4.2.10.6", "How fast, and where to.",
                 gps_velocity_and_heading_entries, {.errata = "Z20"});

/// From -1000 m. The printed end of 2599 m is probably a slip (errata Z26): higher codes are not
/// refused, and are read in the same way.
inline constexpr ValueInfo altitude = {.unit = Unit::metre,
                                       .scale = {.offset = -1000},
                                       .limits = at_least(0, 0x0E0F),
                                       .names = measured_names<16, 0xFFFD>};
inline constexpr auto gps_altitude_object =
    variable_object(0x60B6, "GPS altitude", "4.2.10.7", "Height above the sea.",
                    status(DataType::unsigned16, Mapping::no, altitude), {.errata = "Z26"});

// 4.2.11: navigation system.

inline constexpr NamedValue distance_names[] = {
    {0xFFFE, "Failure", Meaning::failure},
    {0xFFFF, "Signal not available", Meaning::invalid},
    {0xFFFD, "No destination selected", Meaning::invalid}};
inline constexpr ValueInfo distance_to_destination = {.unit = Unit::kilometre,
                                                      .scale = {.denominator = 10},
                                                      .limits = within(0, 0xFFFC),
                                                      .names = distance_names};
inline constexpr auto distance_to_selected_destination_object =
    variable_object(0x60C0, "Distance to selected destination", "4.2.11.1",
                    "How far it is to where the route guidance leads.",
                    status(DataType::unsigned16, Mapping::no, distance_to_destination));

inline constexpr EntryInfo position_description_request_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Position latitude", command(DataType::unsigned32, wanted_latitude)),
    at(2, "Position longitude", command(DataType::unsigned32, wanted_longitude))};
inline constexpr auto position_description_request_object = array_object(
    0x60C1, "Position description request", "4.2.11.2", "The position that 60C2h is to describe.",
    position_description_request_entries, {.errata = "Z35, Z36"});

/// Names of cities, streets and countries. Part 1 may limit them; this capacity is our choice.
inline constexpr std::uint16_t place_name_capacity = 64;
inline constexpr EntryInfo place_entries[] = {
    highest_sub_index(2, 3), at(1, "City", status_text(place_name_capacity)),
    at(2, "Street", status_text(place_name_capacity)),
    at(3, "Country", status_text(place_name_capacity), Category::optional)};
inline constexpr auto position_description_object =
    array_object(0x60C2, "Position description", "4.2.11.3", "The position of 60C1h in words.",
                 place_entries, {.category = Category::optional, .errata = "Z20, Z22"});

// The types of this record are in part 1; they follow from the values and defaults (errata Z34).
inline constexpr NamedValue guidance_commands[] = {
    {0x00, "Start route guidance without interrupting currently active guidance"},
    {0x01, "Start route guidance with interrupting currently active guidance"},
    reserved_codes(0x02, 0xFE),
    command_sentinels<8>.highest};
inline constexpr EntryInfo start_route_guidance_entries[] = {
    highest_sub_index(3, 3),
    at(1, "Position latitude", command(DataType::unsigned32, wanted_latitude)),
    at(2, "Position longitude", command(DataType::unsigned32, wanted_longitude)),
    at(3, "Start guidance", command(DataType::unsigned8, ValueInfo{.names = guidance_commands}))};
inline constexpr auto start_route_guidance_object = structured_object(
    ObjectCode::record, 0x60C3, "Start route guidance", "4.2.11.4",
    "Leads from here to a position: 00h or 01h written to sub-index 03h starts it.",
    start_route_guidance_entries, {.errata = "Z31, Z34, Z35, Z36"});

// 0 requests, 1 has no preference (errata Z38).
inline constexpr NamedValue position_requests[] = {
    {0, "Read current position country, city and street"},
    {1, "Don't care, take no action", Meaning::do_not_care}};
inline constexpr auto current_position_request_fields =
    side_by_side(field(1, "rcp", "read current position", position_requests), reserved<1, 7>());
inline constexpr auto current_position_request_object = variable_object(
    0x60C4, "Current position request", "4.2.11.5", "Asks for the position in words.",
    command(DataType::unsigned8, current_position_request_fields), {.errata = "Z35, Z38, Z45"});
inline constexpr auto current_position_object =
    array_object(0x60C5, "Current position", "4.2.11.6", "The position of the car in words.",
                 place_entries, {.category = Category::optional, .errata = "Z20, Z22"});

}  // namespace canvoy::cia447
