// CiA 407: passenger information in buses, trams and trains (IBIS on CANopen). Where the text
// contradicts itself, `errata` gives the number of the finding that decided.
//
//     const ObjectInfo* doors = find_object(cia407::profile, 0x6488);
//
// canvoy/profiles/cia407/handles.hpp has typed access to the values.
#pragma once

#include "canvoy/profiles/cia407/counting.hpp"
#include "canvoy/profiles/cia407/devices.hpp"
#include "canvoy/profiles/cia407/diagnostics.hpp"
#include "canvoy/profiles/cia407/events.hpp"
#include "canvoy/profiles/cia407/generic_io.hpp"
#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/profiles/cia407/passenger_information.hpp"
#include "canvoy/profiles/cia407/pdos.hpp"
#include "canvoy/profiles/cia407/position.hpp"
#include "canvoy/profiles/cia407/provisions.hpp"
#include "canvoy/profiles/cia407/system.hpp"
#include "canvoy/profiles/cia407/vehicle.hpp"

namespace canvoy::cia407 {

inline constexpr auto objects = objects_of(
    error_register_object, error_behavior_object, supported_virtual_device_types_object,
    events_from_virtual_devices_object, events_for_virtual_devices_object, vehicle_id_object,
    body_id_object, garage_id_object, radio_id_object, vehicle_class_object,
    number_of_vehicle_units_object, driver_schedule_number_object, route_destination_id_object,
    journey_direction_object, stop_point_id_object,
    number_of_running_in_route_representation_object, line_short_representation_object,
    text_line_route_description_object, text_of_destination_object, local_time_and_date_object,
    time_standby_object, route_segment_number_object, fare_zone_object, text_of_stop_point_object,
    previous_route_segment_object, previous_fare_zone_object, scheduled_time_and_date_object,
    blocking_of_ticket_canceller_object, traffic_light_priority_request_object,
    stop_point_short_representation_object, inside_temperature_object, car_mileage_object,
    car_mileage_calibration_information_object, vehicle_id_text_object, body_id_text_object,
    garage_id_text_object, radio_id_text_object, stop_point_id_text_object,
    route_destination_id_text_object, driver_schedule_number_text_object, vehicle_speed_object,
    driver_id_object, destination_number_object, line_id_object, route_number_object,
    block_id_object, journey_number_object, line_id_text_object, block_id_text_object,
    driver_id_text_object, xml_text_object, special_character_files_object,
    referenced_files_for_xml_files_object, display_mapping_object, bus_stop_request_object,
    character_set_object, wheel_based_vehicle_speed_object, vehicle_mileage_object,
    vehicle_mileage_precision_object, drive_flag_and_direction_flag_object, compass_bearing_object,
    compass_bearing_precision_object, state_of_doors_object, ambient_air_temperature_object,
    fuel_economy_object, brake_switch_object, engine_coolant_temperature_object,
    operation_times_object, tachograph_speed_object,
    drive_recognition_and_direction_indication_object, high_resolution_vehicle_distance_object,
    tachograph_time_and_date_object, tachograph_driver_id_object, continuous_driving_time_object,
    position_object, position_precision_object, gps_based_speed_object, gps_based_heading_object,
    gps_mileage_object, gps_mileage_precision_object, time_universal_reference_object,
    flag_direction_forward_selection_object, passenger_counting_in_and_out_per_door_object,
    passenger_counting_manager_data_object, total_in_out_passenger_counting_value_object,
    counter_passenger_sum_object, passenger_capacity_usage_object,
    short_diagnostic_error_field_object, extended_diagnostic_message_file_object,
    error_class_1_messages_object, error_class_2_messages_object, error_class_3_messages_object,
    digital_input_object, digital_output_object, analogue_input_object, analogue_output_object,
    device_type_object);

inline constexpr ErrorCodeInfo error_codes[] = {
    {0x2110, "Short circuit", "7.3", {}},
    {0x2310, "Current at outputs too high (overload)", "7.3", {}},
    {0x2320, "Short circuit at outputs", "7.3", {}},
    {0x2330, "Load dump at outputs", "7.3", {}},
    {0x3110, "Supply voltage too high", "7.3", {}},
    {0x3120, "Supply voltage too low", "7.3", {}},
    {0x3210, "Internal voltage too high", "7.3", {}},
    {0x3220, "Internal voltage too low", "7.3", {}},
    {0x3310, "Output voltage too high", "7.3", {}},
    {0x3320, "Output voltage too low", "7.3", {}},
    {0x3330, "Output voltage missing", "7.3", {}},
    {0xFF01, "Out of paper", "7.3", "Ticket printer."},
    {0xFF02, "No signal", "7.3", "GPS, time fixing."},
    {0xFF03, "No radio connection", "7.3", "DRCC, VRCC and DSRC."},
    {0xFF04, "Requested display mapping format not supported", "7.3",
     "Display and ticket printer."},
    {0xFF05, "No announcements available", "7.3", "Acoustic announcer."},
};

// Record types: like the objects that have them, but provided by no device.

inline constexpr EntryInfo number_of_members = {.name = "number_of_entries"};
inline constexpr auto fuel_consumption_members = fuel_members(number_of_members, {});
inline constexpr auto time_and_date_members = time_members(number_of_members, {});
inline constexpr RecordTypeInfo record_types[] = {
    {.index = 0x0080,
     .name = "fuel_consumption_record",
     .clause = "9.2.2.1",
     .members = fuel_consumption_members},
    {.index = 0x0081,
     .name = "time_and_date_record",
     .clause = "9.2.2.2",
     .members = time_and_date_members},
};

inline constexpr auto byte_order_objects = objects_of(display_mapping_object_reversed);
inline constexpr ReadingInfo readings[] = {
    {.name = "byte-order",
     .description = "The figure of 6203h shows the bytes in the order on the wire: format first.",
     .errata = "74",
     .objects = byte_order_objects},
};

inline constexpr Profile profile = {.number = profile_number,
                                    .name = "CiA 407",
                                    .title = "Application profile for passenger information",
                                    .objects = objects,
                                    .device_type = device_type_fields,
                                    .virtual_devices = virtual_devices,
                                    .device_type_of = device_type,
                                    .pdos = pdos,
                                    .error_codes = error_codes,
                                    .record_types = record_types,
                                    .readings = readings,
                                    .provisions = &provisions};

}  // namespace canvoy::cia407
