// Objects that the main on-board computer of CiA 407 provides: 6100h to 6123h (9.2.6).
//
//     cia407::stop_point_id_object.index  // 6109h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

// Identity of the vehicle.

inline constexpr auto vehicle_id_object =
    variable(0x6100, "vehicle_ID", "9.2.6.1", "Identifies the vehicle; 611Ch is its text.",
             entry(unsigned32, ro, no, 0));
inline constexpr auto body_id_object =
    variable(0x6101, "body_ID", "9.2.6.2", "Identifies the body of the vehicle; 611Dh is its text.",
             entry(unsigned16, ro, no, 0));
inline constexpr auto garage_id_object =
    variable(0x6102, "garage_ID", "9.2.6.3",
             "Identifies the garage where the vehicle is parked; 611Eh is its text.",
             entry(unsigned16, ro, no, 0), {.errata = "8, 9, 69"});
inline constexpr auto radio_id_object =
    variable(0x6103, "radio_ID", "9.2.6.4",
             "Identifies the radio unit, for selective calls; 611Fh is its text.",
             entry(unsigned32, ro, no, 0), {.errata = "8, 9"});

/// Class of the vehicle (6104h).
enum class VehicleClass : std::uint8_t {
  not_used = 0,
  bus = 1,
  tram = 2,
  light_railway = 3,
  trolley_bus = 4,
};
inline constexpr NamedValue vehicle_classes[] = {
    {VehicleClass::not_used, "not used"},
    {VehicleClass::bus, "bus"},
    {VehicleClass::tram, "tram"},
    {VehicleClass::light_railway, "light railway"},
    {VehicleClass::trolley_bus, "trolley bus"},
    {0x05, 0xFE, "application-specific", Meaning::state},
    {0xFF, 0xFF, "reserved", Meaning::reserved},
};
inline constexpr auto vehicle_class_object =
    variable(0x6104, "vehicle_class", "9.2.6.5", "Bus, tram, railway.",
             entry(unsigned8, ro, no, {}, vehicle_classes), {.errata = "30, 70"});
inline constexpr auto number_of_vehicle_units_object =
    variable(0x6105, "number_of_vehicle_units", "9.2.6.6",
             "How many coaches the train has, the engine included.",
             entry(unsigned8, ro, no, 1, {.counting = Counting::counts}));

// Present operation.

inline constexpr NamedValue driver_schedule_numbers[] = {{0, "no driver schedule assigned"}};
inline constexpr NamedValue route_destination_ids[] = {{0, "no route destination assigned"}};
inline constexpr auto driver_schedule_number_object =
    variable(0x6106, "driver_schedule_number", "9.2.6.7",
             "The driver's work of the day; 0: none assigned. 6122h is its text.",
             entry(unsigned32, ro, no, 0,
                   {.names = driver_schedule_numbers, .counting = Counting::identifies}));
inline constexpr auto route_destination_id_object =
    variable(0x6107, "route_destination_ID", "9.2.6.8",
             "Identifies route and line, to set switches; 0: none assigned. 6121h is its text.",
             entry(unsigned32, ro, no, 0,
                   {.names = route_destination_ids, .counting = Counting::identifies}));

/// Direction of the journey on its line (6108h).
enum class JourneyDirection : std::uint8_t { not_specified = 0, forward = 1, backward = 2 };
inline constexpr NamedValue journey_directions[] = {
    {JourneyDirection::not_specified, "no direction specified"},
    {JourneyDirection::forward, "forward"},
    {JourneyDirection::backward, "backward"},
    {0x03, 0x7F, "reserved", Meaning::reserved},
    {0x80, 0xFF, "manufacturer-specific", Meaning::manufacturer},
};
inline constexpr auto journey_direction_object =
    variable(0x6108, "journey_direction", "9.2.6.9", "Which way the journey goes.",
             entry(unsigned8, ro, by_default, 1, journey_directions));
inline constexpr auto stop_point_id_object =
    variable(0x6109, "stop_point_ID", "9.2.6.10",
             "Identifies the stop point, and triggers its announcement; 6120h is its text.",
             entry(unsigned32, ro, by_default, 0));
inline constexpr auto number_of_running_in_route_representation_object =
    variable(0x610A, "number_of_running_in_route_representation", "9.2.6.11",
             "The number of the stop point within the route.",
             entry(unsigned8, ro, by_default, 1, {.limits = within(1, 255)}), {.errata = "36"});

inline constexpr auto short_representation_entries = one_or_more(
    entries_within(1, 8, "number_of_characters"),
    by_device(sub_index(0, "character_#", entry(unsigned8, ro, by_default, 0, character))), 8);
inline constexpr auto line_short_representation_object =
    array(0x610B, "line_short_representation", "9.2.6.12",
          "A short name of the line, as the driver chooses it and passengers read it.",
          short_representation_entries);

/// Sub-index 00h of the plain texts, with the access of the virtual device.
inline constexpr EntryInfo number_of_texts = by_device(entries_within(1, 254));
/// One or more texts of up to 128 octets (errata 106).
constexpr std::array<EntryInfo, 3> plain_texts(std::string_view name) {
  EntryInfo text = by_device(plain_text);
  text.name = name;
  return one_or_more(number_of_texts, text, 254);
}
inline constexpr auto text_line_route_description_entries =
    plain_texts("text_line/route_description_#");
inline constexpr auto text_line_route_description_object =
    array(0x610C, "text_line/route_description", "9.2.6.13",
          "Texts that describe lines or routes; shown when 6203h says so.",
          text_line_route_description_entries, "45, 51, 106");
inline constexpr auto text_of_destination_entries = plain_texts("text_of_destination_#");
inline constexpr auto text_of_destination_object =
    array(0x610D, "text_of_destination", "9.2.6.14",
          "Texts that describe destinations; shown when 6203h says so.",
          text_of_destination_entries, "46, 51, 106");

// Times.

inline constexpr NamedValue no_time[] = {{0xFF, "invalid", Meaning::invalid}};
/// Sub-index 00h, and six entries from the year to the second.
constexpr std::array<EntryInfo, 7> date_and_time_array(const EntryInfo& shape) {
  std::array<EntryInfo, 7> entries{};
  entries[0] = entries_always(6);
  const auto parts = date_and_time(1, shape);
  for (std::size_t i = 0; i < parts.size(); ++i) entries[i + 1] = parts[i];
  return entries;
}
inline constexpr auto local_time_and_date_entries =
    date_and_time_array(by_device(entry(unsigned8, ro, by_default, 0xFF, no_time)));
inline constexpr auto local_time_and_date_object =
    array(0x610E, "local_time_and_date", "9.2.6.15", "The local time and date.",
          local_time_and_date_entries, "43, 52, 54, 56");
inline constexpr auto time_standby_object = variable(
    0x610F, "time_standby", "9.2.6.16", "How long after ignition off the device is switched off.",
    entry(unsigned8, ro, optional, 10, {.unit = Unit::minute, .limits = within(0, 15)}));

// Fares and stops.

inline constexpr auto route_segment_number_object =
    variable(0x6110, "route_segment_number", "9.2.6.17",
             "A set of links of the route in one fare zone, to collect fares.",
             entry(unsigned16, ro, by_default, 0));
inline constexpr auto fare_zone_object = variable(
    0x6111, "fare_zone", "9.2.6.18", "The present fare zone.", entry(unsigned8, ro, by_default, 0));
inline constexpr auto text_of_stop_point_entries = plain_texts("text_of_stop_point_#");
inline constexpr auto text_of_stop_point_object =
    array(0x6112, "text_of_stop_point", "9.2.6.19",
          "Names of the present or next stop points; shown when 6203h says so.",
          text_of_stop_point_entries, "38, 47, 106");
inline constexpr auto previous_route_segment_object =
    variable(0x6113, "previous_route_segment", "9.2.6.20",
             "The route segment before that of 6110h.", entry(unsigned16, ro));
inline constexpr auto previous_fare_zone_object =
    variable(0x6114, "previous_fare_zone", "9.2.6.21", "The fare zone before that of 6111h.",
             entry(unsigned8, ro, no, 0));
inline constexpr auto scheduled_time_and_date_entries =
    date_and_time_array(by_device(entry(unsigned8, ro, optional)));
inline constexpr auto scheduled_time_and_date_object =
    array(0x6115, "scheduled_time_and_date", "9.2.6.22",
          "The local time and date at which the vehicle should be where it is.",
          scheduled_time_and_date_entries, "52, 55, 56");

/// State that cancellers and printers have to take (6116h).
enum class TicketValidator : std::uint8_t { in_operation = 0, blocked = 1 };
inline constexpr NamedValue ticket_validator_states[] = {
    {TicketValidator::in_operation, "ticket validator in operation"},
    {TicketValidator::blocked, "ticket validator blocked"}};
inline constexpr FieldInfo blocking_fields[] = {
    reserved<7>(0),
    field(7, 1, "tv", ticket_validator_states),
};
inline constexpr auto blocking_of_ticket_canceller_object = variable(
    0x6116, "blocking_of_ticket_canceller", "9.2.6.23", "Blocks the ticket canceller for a time.",
    entry(unsigned8, ro, by_default, 0, blocking_fields), {.errata = "11"});

inline constexpr NamedValue priority_levels[] = {
    {0x00, 0xFE, "application-specific priority level", Meaning::state},
    {0xFF, "no or lowest priority level"}};
inline constexpr auto traffic_light_priority_request_object = variable(
    0x6117, "traffic_light_priority_request", "9.2.6.24", "Asks traffic lights to let pass.",
    entry(unsigned8, ro, optional, 0xFF, priority_levels), {.errata = "37"});
inline constexpr auto stop_point_short_representation_object =
    array(0x6118, "stop_point_short_representation", "9.2.6.25", "A short name of the stop point.",
          short_representation_entries, "103");

// Measured values.

inline constexpr auto inside_temperature_object =
    variable(0x6119, "inside_temperature", "9.2.6.26", "The temperature in the cabin.",
             entry(integer16, ro, optional, {},
                   {.unit = Unit::degree_celsius,
                    .scale = {.denominator = 10},
                    .limits = within(-1000, 1000)}));
inline constexpr auto car_mileage_object =
    variable(0x611A, "car_mileage", "9.2.6.27", "The distance that the vehicle has gone in all.",
             entry(unsigned32, ro, optional, 0, distance), {.errata = "71"});
inline constexpr auto car_mileage_calibration_information_object =
    variable(0x611B, "car_mileage_calibration_information", "9.2.6.28", "How exact 611Ah is.",
             entry(unsigned16, ro, no, 0xFFFF, distance_precision),
             {.condition = "if object 611Ah is implemented", .errata = "104"});

// Texts for the numbers above.

inline constexpr auto vehicle_id_text_object =
    variable(0x611C, "vehicle_ID_text", "9.2.6.29", "The text to 6100h.", visible_text);
inline constexpr auto body_id_text_object =
    variable(0x611D, "body_ID_text", "9.2.6.30", "The text to 6101h.", visible_text);
inline constexpr auto garage_id_text_object = variable(
    0x611E, "garage_ID_text", "9.2.6.31", "The text to 6102h.", visible_text, {.errata = "8, 9"});
inline constexpr auto radio_id_text_object = variable(
    0x611F, "radio_ID_text", "9.2.6.32", "The text to 6103h.", visible_text, {.errata = "8, 9"});
inline constexpr auto stop_point_id_text_object =
    variable(0x6120, "stop_point_ID_text", "9.2.6.33", "The text to 6109h.", visible_text);
inline constexpr auto route_destination_id_text_object =
    variable(0x6121, "route_destination_ID_text", "9.2.6.34", "The text to 6107h.", visible_text);
inline constexpr auto driver_schedule_number_text_object =
    variable(0x6122, "driver_schedule_number_text", "9.2.6.35", "The text to 6106h.", visible_text);

inline constexpr auto vehicle_speed_object =
    variable(0x6123, "vehicle_speed", "9.2.6.36",
             "The speed, forward or backward, from one or several of 6481h, 6520h and 6662h.",
             entry(unsigned16, ro, optional, {},
                   {.unit = Unit::kilometre_per_hour, .scale = {.denominator = 256}}),
             {.errata = "12"});

}  // namespace canvoy::cia407
