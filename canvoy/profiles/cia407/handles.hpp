// CiA 407: handles for application code. Entries of arrays are numbered from 1. The door number has
// to be known at compile time. Files (domains) are no values and have no handles.
//
//     Values bus(node.dictionary());
//     if (bus[cia407::bus_stop_request].is(cia407::BusStop::requested)) ...
//     bus[cia407::door<6>] = cia407::Door::open;
//     bus[cia407::text_of_destination(1)] = "Airport";
//     bus[cia407::inside_temperature] = 21.5;  // degrees Celsius
#pragma once

#include "canvoy/profiles/cia407/counting.hpp"
#include "canvoy/profiles/cia407/diagnostics.hpp"
#include "canvoy/profiles/cia407/events.hpp"
#include "canvoy/profiles/cia407/generic_io.hpp"
#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/profiles/cia407/passenger_information.hpp"
#include "canvoy/profiles/cia407/position.hpp"
#include "canvoy/profiles/cia407/vehicle.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia407 {

// Virtual devices and their events (9.2.3 to 9.2.5).

inline constexpr State<DeviceCode, supported_virtual_device_types_object, "virtual_device_type_#",
                       "device code">
    supported_virtual_device;
inline constexpr Number<supported_virtual_device_types_object, "virtual_device_type_#", "class">
    supported_virtual_device_class;
inline constexpr Number<supported_virtual_device_types_object, "virtual_device_type_#", "sub-class">
    supported_virtual_device_subclass;

/// Bit b: the entry of virtual device b + 1 is not zero.
inline constexpr Number<events_from_virtual_devices_object, "event_at_sub"> event_at_sub;

/// An event, or the whole entry, of the n-th virtual device. The name of a flag holds where
/// `event_from_code` is the code of the virtual device that has this flag in its table.
template <Name flag>
inline constexpr State<Event, events_from_virtual_devices_object, "events_from_1st_virtual_device",
                       flag>
    event_from;
template <Name flag>
inline constexpr State<Event, events_for_virtual_devices_object, "events_for_1st_virtual_device",
                       flag>
    event_for;
inline constexpr State<DeviceCode, events_from_virtual_devices_object,
                       "events_from_1st_virtual_device", "code of virtual device">
    event_from_code;
inline constexpr State<DeviceCode, events_for_virtual_devices_object,
                       "events_for_1st_virtual_device", "code of virtual device">
    event_for_code;
inline constexpr Number<events_from_virtual_devices_object, "events_from_1st_virtual_device",
                        "manufacturer-specific information">
    event_from_manufacturer;
inline constexpr Number<events_for_virtual_devices_object, "events_for_1st_virtual_device",
                        "manufacturer-specific information">
    event_for_manufacturer;
/// All eight flags.
inline constexpr Number<events_from_virtual_devices_object, "events_from_1st_virtual_device",
                        "event flags">
    event_flags_from;
inline constexpr Number<events_for_virtual_devices_object, "events_for_1st_virtual_device",
                        "event flags">
    event_flags_for;

// Passenger information; also acoustic announcer and ticket canceller where they have the same
// events.
inline constexpr auto state_information = event_from<"state information">;
inline constexpr auto display_in_test_mode = event_from<"display in test mode">;
inline constexpr auto information_cannot_be_displayed =
    event_from<"mapped information cannot be displayed">;
inline constexpr auto send_state_information = event_for<"send state information">;
inline constexpr auto enter_test_mode = event_for<"enter testmode">;
// Acoustic control manager: as states and as commands.
inline constexpr auto driver_to_indoor_loudspeakers =
    event_from<"driver microphone to indoor loudspeakers">;
inline constexpr auto driver_to_outdoor_loudspeakers =
    event_from<"driver microphone to outdoor loudspeakers">;
inline constexpr auto driver_to_voice_radio = event_from<"driver microphone to VRCC">;
inline constexpr auto attendant_to_indoor_loudspeakers =
    event_from<"travel attendant microphone to indoor loudspeakers">;
inline constexpr auto voice_radio_to_indoor_loudspeakers =
    event_from<"VRCC to indoor loudspeakers">;
inline constexpr auto acoustic_state_information =
    event_from<"state information of the acoustic control manager">;
inline constexpr auto switch_driver_to_indoor_loudspeakers =
    event_for<"driver microphone to indoor loudspeakers">;
inline constexpr auto switch_driver_to_outdoor_loudspeakers =
    event_for<"driver microphone to outdoor loudspeakers">;
inline constexpr auto switch_driver_to_voice_radio = event_for<"driver microphone to VRCC">;
inline constexpr auto switch_attendant_to_indoor_loudspeakers =
    event_for<"travel attendant microphone to indoor loudspeakers">;
inline constexpr auto switch_voice_radio_to_indoor_loudspeakers =
    event_for<"VRCC to indoor loudspeakers">;
inline constexpr auto send_acoustic_state_information =
    event_for<"state information of the acoustic control manager">;
// Passenger counter and passenger counting manager.
inline constexpr auto many_passengers_counted =
    event_from<"more than 200 incoming or outgoing passengers">;
inline constexpr auto close_to_passenger_capacity = event_from<"close to passenger capacity limit">;
inline constexpr auto passenger_capacity_warning = event_from<"passenger capacity warning limit">;
// Diagnostics.
inline constexpr auto many_short_errors = event_from<"more than 200 entries in object 6740h">;
inline constexpr auto short_errors_close_to_capacity =
    event_from<"object 6740h close to capacity limit">;
inline constexpr auto many_class_1_messages = event_from<"more than 200 entries in object 6742h">;
inline constexpr auto many_class_2_messages = event_from<"more than 200 entries in object 6743h">;
inline constexpr auto many_class_3_messages = event_from<"more than 200 entries in object 6744h">;
// Tachograph.
inline constexpr auto reset_trip_distance = event_for<"reset tachograph trip distance">;
inline constexpr auto adjust_local_hour = event_for<"adjust local hour offset">;
inline constexpr auto adjust_local_minute = event_for<"adjust local minute offset">;

// Main on-board computer (9.2.6).

inline constexpr Number<vehicle_id_object> vehicle_id;
inline constexpr Number<body_id_object> body_id;
inline constexpr Number<garage_id_object> garage_id;
inline constexpr Number<radio_id_object> radio_id;
inline constexpr State<VehicleClass, vehicle_class_object> vehicle_class;
inline constexpr Number<number_of_vehicle_units_object> number_of_vehicle_units;
inline constexpr Number<driver_schedule_number_object> driver_schedule_number;
inline constexpr Number<route_destination_id_object> route_destination_id;
inline constexpr State<JourneyDirection, journey_direction_object> journey_direction;
inline constexpr Number<stop_point_id_object> stop_point_id;
inline constexpr Number<number_of_running_in_route_representation_object>
    number_of_running_in_route_representation;
inline constexpr PackedText<line_short_representation_object, "character_#">
    line_short_representation;
inline constexpr Text<text_line_route_description_object, "text_line/route_description_#">
    text_line_route_description;
inline constexpr Text<text_of_destination_object, "text_of_destination_#"> text_of_destination;
inline constexpr Quantity<local_time_and_date_object, "year"> local_year;
inline constexpr Quantity<local_time_and_date_object, "day"> local_day;
inline constexpr Number<local_time_and_date_object, "month"> local_month;
inline constexpr Quantity<local_time_and_date_object, "hour"> local_hour;
inline constexpr Quantity<local_time_and_date_object, "minute"> local_minute;
inline constexpr Quantity<local_time_and_date_object, "second"> local_second;
inline constexpr Quantity<time_standby_object> time_standby;
inline constexpr Number<route_segment_number_object> route_segment_number;
inline constexpr Number<fare_zone_object> fare_zone;
inline constexpr Text<text_of_stop_point_object, "text_of_stop_point_#"> text_of_stop_point;
inline constexpr Number<previous_route_segment_object> previous_route_segment;
inline constexpr Number<previous_fare_zone_object> previous_fare_zone;
inline constexpr Quantity<scheduled_time_and_date_object, "year"> scheduled_year;
inline constexpr Quantity<scheduled_time_and_date_object, "day"> scheduled_day;
inline constexpr Number<scheduled_time_and_date_object, "month"> scheduled_month;
inline constexpr Quantity<scheduled_time_and_date_object, "hour"> scheduled_hour;
inline constexpr Quantity<scheduled_time_and_date_object, "minute"> scheduled_minute;
inline constexpr Quantity<scheduled_time_and_date_object, "second"> scheduled_second;
inline constexpr State<TicketValidator, blocking_of_ticket_canceller_object, "", "tv">
    blocking_of_ticket_canceller;
inline constexpr Number<traffic_light_priority_request_object> traffic_light_priority_request;
inline constexpr PackedText<stop_point_short_representation_object, "character_#">
    stop_point_short_representation;
inline constexpr Quantity<inside_temperature_object> inside_temperature;
inline constexpr Quantity<car_mileage_object> car_mileage;
inline constexpr Quantity<car_mileage_calibration_information_object>
    car_mileage_calibration_information;
inline constexpr Text<vehicle_id_text_object> vehicle_id_text;
inline constexpr Text<body_id_text_object> body_id_text;
inline constexpr Text<garage_id_text_object> garage_id_text;
inline constexpr Text<radio_id_text_object> radio_id_text;
inline constexpr Text<stop_point_id_text_object> stop_point_id_text;
inline constexpr Text<route_destination_id_text_object> route_destination_id_text;
inline constexpr Text<driver_schedule_number_text_object> driver_schedule_number_text;
inline constexpr Quantity<vehicle_speed_object> vehicle_speed;

// Identification (9.2.7).

inline constexpr Number<driver_id_object> driver_id;
inline constexpr Number<destination_number_object> destination_number;
inline constexpr Number<line_id_object> line_id;
inline constexpr Number<route_number_object> route_number;
inline constexpr Number<block_id_object> block_id;
inline constexpr Number<journey_number_object> journey_number;
inline constexpr Text<line_id_text_object> line_id_text;
inline constexpr Text<block_id_text_object> block_id_text;
inline constexpr Text<driver_id_text_object> driver_id_text;

// Passenger information (9.2.8).

inline constexpr Text<xml_text_object, "XML_file_#"> xml_file;
/// Number of objects shown. Writing it shows them.
inline constexpr Number<display_mapping_object, "display_update", "number of mapped objects">
    display_update;
inline constexpr Number<display_mapping_object, "display_update", "manufacturer-specific">
    display_update_manufacturer;
/// The object shown and its format, as one number, then its parts.
inline constexpr Number<display_mapping_object, "mapped_object_#"> mapped_object;
inline constexpr Number<display_mapping_object, "mapped_object_#", "Index-MSB"> mapped_index_msb;
inline constexpr Number<display_mapping_object, "mapped_object_#", "Index-LSB"> mapped_index_lsb;
inline constexpr Number<display_mapping_object, "mapped_object_#", "Sub-Index"> mapped_sub_index;
inline constexpr State<FlashSpeed, display_mapping_object, "mapped_object_#", "flash speed">
    flash_speed;
inline constexpr State<FontStyle, display_mapping_object, "mapped_object_#", "font style">
    font_style;
inline constexpr State<Alignment, display_mapping_object, "mapped_object_#", "alignment"> alignment;
inline constexpr State<FontSize, display_mapping_object, "mapped_object_#", "font size"> font_size;
inline constexpr State<BusStop, bus_stop_request_object> bus_stop_request;
inline constexpr Number<character_set_object, "selected_character_set"> selected_character_set;
inline constexpr Number<character_set_object, "1st additional available character set">
    available_character_set;

// Vehicle gateway (9.2.15).

inline constexpr Quantity<wheel_based_vehicle_speed_object> wheel_based_vehicle_speed;
inline constexpr Quantity<vehicle_mileage_object> vehicle_mileage;
inline constexpr Quantity<vehicle_mileage_precision_object> vehicle_mileage_precision;
inline constexpr State<Direction, drive_flag_and_direction_flag_object, "", "direction indicator">
    direction_flag;
inline constexpr State<Motion, drive_flag_and_direction_flag_object, "", "drive recognition">
    drive_flag;
inline constexpr Quantity<compass_bearing_object> compass_bearing;
inline constexpr Quantity<compass_bearing_precision_object> compass_bearing_precision;
inline constexpr State<Doors, state_of_doors_object, "general_state", "all doors"> all_doors;
inline constexpr State<Release, state_of_doors_object, "general_state", "left side doors">
    left_side_doors;
inline constexpr State<Release, state_of_doors_object, "general_state", "right side doors">
    right_side_doors;

/// Four doors in each sub-index from 02h on.
inline constexpr unsigned doors_max = 1012;
/// Sub-index of door 1 to 1012.
constexpr unsigned door_sub(unsigned number) {
  return (number - 1) / 4 + 2;
}
/// Name of the field of a door in its sub-index.
template <unsigned number>
constexpr auto door_field() {
  constexpr char digits[] = {'0', '1', '2', '3'};
  constexpr unsigned offset = (number - 1) % 4;
  if constexpr (offset == 0) {
    return Name("door N");
  } else {
    return Name<9>({'d', 'o', 'o', 'r', ' ', 'N', '+', digits[offset], '\0'});
  }
}
/// Name of the field that says whether that of the door is valid.
template <unsigned number>
constexpr auto door_valid_field() {
  constexpr char digits[] = {'0', '1', '2', '3'};
  constexpr unsigned offset = (number - 1) % 4;
  if constexpr (offset == 0) {
    return Name("door N valid");
  } else {
    return Name<15>(
        {'d', 'o', 'o', 'r', ' ', 'N', '+', digits[offset], ' ', 'v', 'a', 'l', 'i', 'd', '\0'});
  }
}
template <unsigned number>
  requires(number >= 1 && number <= doors_max)
inline constexpr auto door = State<Door, state_of_doors_object, "specific_state_1_to_4",
                                   door_field<number>()>{}[door_sub(number)];
template <unsigned number>
  requires(number >= 1 && number <= doors_max)
inline constexpr auto door_validity =
    State<Validity, state_of_doors_object, "specific_state_1_to_4",
          door_valid_field<number>()>{}[door_sub(number)];

inline constexpr Quantity<ambient_air_temperature_object> ambient_air_temperature;
inline constexpr Quantity<fuel_economy_object, "fuel_rate"> fuel_rate;
inline constexpr Quantity<fuel_economy_object, "instantaneous_fuel_economy">
    instantaneous_fuel_economy;
inline constexpr Quantity<fuel_economy_object, "average_fuel_economy"> average_fuel_economy;
inline constexpr Quantity<fuel_economy_object, "total_fuel_used"> total_fuel_used;
inline constexpr Quantity<fuel_economy_object, "trip_fuel"> trip_fuel;
inline constexpr Quantity<fuel_economy_object, "total_idle_fuel_used"> total_idle_fuel_used;
inline constexpr State<BrakePedal, brake_switch_object, "", "brake pedal"> brake_switch;
inline constexpr Quantity<engine_coolant_temperature_object> engine_coolant_temperature;
inline constexpr Quantity<operation_times_object, "total_idle_hours"> total_idle_hours;
inline constexpr Quantity<operation_times_object, "total_vehicle_hours"> total_vehicle_hours;
inline constexpr Quantity<operation_times_object, "total_engine_hours"> total_engine_hours;
inline constexpr Quantity<operation_times_object, "total_power_takeoff_hours">
    total_power_takeoff_hours;

// Tachograph (9.2.17).

inline constexpr Quantity<tachograph_speed_object> tachograph_speed;
inline constexpr State<Direction, drive_recognition_and_direction_indication_object, "",
                       "direction indicator">
    direction_indication;
inline constexpr State<Motion, drive_recognition_and_direction_indication_object, "",
                       "drive recognition">
    drive_recognition;
inline constexpr Quantity<high_resolution_vehicle_distance_object, "total_vehicle_distance">
    total_vehicle_distance;
inline constexpr Quantity<high_resolution_vehicle_distance_object, "trip_distance"> trip_distance;
inline constexpr Quantity<tachograph_time_and_date_object, "local_hour"> tachograph_local_hour;
inline constexpr Quantity<tachograph_time_and_date_object, "local_minute"> tachograph_local_minute;
inline constexpr Quantity<tachograph_time_and_date_object, "year"> tachograph_year;
inline constexpr Quantity<tachograph_time_and_date_object, "day"> tachograph_day;
inline constexpr Number<tachograph_time_and_date_object, "month"> tachograph_month;
inline constexpr Quantity<tachograph_time_and_date_object, "hour"> tachograph_hour;
inline constexpr Quantity<tachograph_time_and_date_object, "minute"> tachograph_minute;
inline constexpr Quantity<tachograph_time_and_date_object, "second"> tachograph_second;
inline constexpr Text<tachograph_driver_id_object, "driver_1"> driver_1_card;
inline constexpr Text<tachograph_driver_id_object, "driver_2"> driver_2_card;
inline constexpr Quantity<continuous_driving_time_object, "driver_1"> driver_1_driving_time;
inline constexpr Quantity<continuous_driving_time_object, "driver_2"> driver_2_driving_time;

// Geographical positioning, time fixing, driver's console keyboard (9.2.21 to 9.2.24).

inline constexpr Quantity<position_object, "latitude"> latitude;
inline constexpr Quantity<position_object, "longitude"> longitude;
inline constexpr Quantity<position_precision_object> position_precision;
inline constexpr Quantity<gps_based_speed_object> gps_based_speed;
inline constexpr Quantity<gps_based_heading_object> gps_based_heading;
inline constexpr Quantity<gps_mileage_object> gps_mileage;
inline constexpr Quantity<gps_mileage_precision_object> gps_mileage_precision;
inline constexpr Quantity<time_universal_reference_object, "local_hour"> universal_local_hour;
inline constexpr Quantity<time_universal_reference_object, "local_minute"> universal_local_minute;
inline constexpr Quantity<time_universal_reference_object, "year"> universal_year;
inline constexpr Quantity<time_universal_reference_object, "day"> universal_day;
inline constexpr Number<time_universal_reference_object, "month"> universal_month;
inline constexpr Quantity<time_universal_reference_object, "hour"> universal_hour;
inline constexpr Quantity<time_universal_reference_object, "minute"> universal_minute;
inline constexpr Quantity<time_universal_reference_object, "second"> universal_second;
inline constexpr State<ReverseGear, flag_direction_forward_selection_object>
    flag_direction_forward_selection;

// Passenger counter and passenger counting manager (9.2.25, 9.2.26).

inline constexpr Number<passenger_counting_in_and_out_per_door_object, "",
                        "number of incoming passengers">
    incoming_passengers_of_door;
inline constexpr Number<passenger_counting_in_and_out_per_door_object, "",
                        "number of outgoing passengers">
    outgoing_passengers_of_door;
inline constexpr Number<total_in_out_passenger_counting_value_object, "number_incoming_passengers">
    total_incoming_passengers;
inline constexpr Number<total_in_out_passenger_counting_value_object, "number_outgoing_passengers">
    total_outgoing_passengers;
inline constexpr Number<counter_passenger_sum_object> counter_passenger_sum;
inline constexpr Quantity<passenger_capacity_usage_object> passenger_capacity_usage;

// Diagnostics (9.2.27).

inline constexpr Number<short_diagnostic_error_field_object, "number_of_errors"> number_of_errors;
inline constexpr Number<short_diagnostic_error_field_object, "short_error_field_#", "error code">
    short_error_code;
inline constexpr Number<short_diagnostic_error_field_object, "short_error_field_#", "device code">
    short_error_device;
inline constexpr Number<error_class_1_messages_object, "number_of_messages">
    number_of_class_1_messages;
inline constexpr Number<error_class_2_messages_object, "number_of_messages">
    number_of_class_2_messages;
inline constexpr Number<error_class_3_messages_object, "number_of_messages">
    number_of_class_3_messages;
inline constexpr Text<error_class_1_messages_object, "message_#"> class_1_message;
inline constexpr Text<error_class_2_messages_object, "message_#"> class_2_message;
inline constexpr Text<error_class_3_messages_object, "message_#"> class_3_message;

// Generic I/O (9.2.28).

inline constexpr Number<digital_input_object> digital_inputs;
inline constexpr Number<digital_output_object> digital_outputs;
inline constexpr Number<analogue_input_object, "input_group_#", "channel 1"> analogue_input_1;
inline constexpr Number<analogue_input_object, "input_group_#", "channel 2"> analogue_input_2;
inline constexpr Number<analogue_output_object, "output_group_#", "channel 1"> analogue_output_1;
inline constexpr Number<analogue_output_object, "output_group_#", "channel 2"> analogue_output_2;

// Several logical devices in one (9.2.30.1): 1000h of the first.

inline constexpr Number<device_type_object> first_device_type;
inline constexpr Number<device_type_object, "", "number of device profile">
    first_device_type_profile;
inline constexpr Number<device_type_object, "", "sub-class"> first_device_type_subclass;
inline constexpr Number<device_type_object, "", "class"> first_device_type_class;
inline constexpr State<DeviceCode, device_type_object, "", "device code"> first_device_type_code;

}  // namespace canvoy::cia407
