// CiA 447-3: handles for application code, of GPS, navigation system and taximeter (4.2.10 to
// 4.2.12).
//
//     Values taxi(node.dictionary());
//     taxi[cia447::gps_current_position_latitude] = 48.1234567;  // degrees, south below 0
//     if (taxi[cia447::taximeter_status].is(cia447::Taximeter::for_hire)) ...
#pragma once

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/positioning.hpp"
#include "canvoy/profiles/cia447/taximeter.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.10.

inline constexpr Quantity<gps_current_position_object, "Position latitude">
    gps_current_position_latitude;
inline constexpr Quantity<gps_current_position_object, "Position longitude">
    gps_current_position_longitude;

inline constexpr Number<gps_satellites_object, "", "visible satellites"> gps_satellites_visible;
inline constexpr Number<gps_satellites_object, "", "tracked satellites"> gps_satellites_tracked;

inline constexpr Number<gps_status_object, "", "GPS vdop"> gps_status_vdop;
inline constexpr Number<gps_status_object, "", "GPS hdop"> gps_status_hdop;
inline constexpr Number<gps_status_object, "", "GPS pdop"> gps_status_pdop;
inline constexpr State<GpsFix, gps_status_object, "", "GPS fix"> gps_status_fix;

inline constexpr Quantity<gps_date_object, "", "GPS date year"> gps_date_year;
inline constexpr Quantity<gps_date_object, "", "GPS date month"> gps_date_month;
inline constexpr Quantity<gps_date_object, "", "GPS date day"> gps_date_day;

inline constexpr Quantity<gps_utc_time_object, "", "GPS UTC hour"> gps_utc_time_hour;
inline constexpr Quantity<gps_utc_time_object, "", "GPS UTC minute"> gps_utc_time_minute;
inline constexpr Quantity<gps_utc_time_object, "", "GPS UTC second"> gps_utc_time_second;

inline constexpr Quantity<gps_velocity_and_heading_object, "GPS velocity"> gps_velocity;
inline constexpr Quantity<gps_velocity_and_heading_object, "GPS heading"> gps_heading;
inline constexpr Quantity<gps_altitude_object> gps_altitude;

// 4.2.11.

inline constexpr Quantity<distance_to_selected_destination_object> distance_to_selected_destination;

inline constexpr Quantity<position_description_request_object, "Position latitude">
    position_description_request_latitude;
inline constexpr Quantity<position_description_request_object, "Position longitude">
    position_description_request_longitude;

inline constexpr Text<position_description_object, "City"> position_description_city;
inline constexpr Text<position_description_object, "Street"> position_description_street;
inline constexpr Text<position_description_object, "Country"> position_description_country;

inline constexpr Quantity<start_route_guidance_object, "Position latitude">
    start_route_guidance_position_latitude;
inline constexpr Quantity<start_route_guidance_object, "Position longitude">
    start_route_guidance_position_longitude;
inline constexpr State<StartGuidance, start_route_guidance_object, "Start guidance">
    start_route_guidance_start;
inline constexpr State<PositionRequest, current_position_request_object, "", "rcp">
    current_position_request;

inline constexpr Text<current_position_object, "City"> current_position_city;
inline constexpr Text<current_position_object, "Street"> current_position_street;
inline constexpr Text<current_position_object, "Country"> current_position_country;

// 4.2.12.

inline constexpr Quantity<taxi_trip_payment_object, "Trip fare"> taxi_trip_payment_fare;
inline constexpr Quantity<taxi_trip_payment_object, "Trip supplement charge">
    taxi_trip_payment_supplement_charge;
inline constexpr Quantity<taxi_trip_payment_object, "Total charged">
    taxi_trip_payment_total_charged;
inline constexpr State<FareMode, taxi_trip_payment_object, "Trip fare calculation mode">
    taxi_trip_payment_fare_calculation_mode;
inline constexpr Quantity<taxi_trip_payment_object, "Trip minimum fare">
    taxi_trip_payment_minimum_fare;
inline constexpr Quantity<taxi_trip_payment_object, "Trip initial fare">
    taxi_trip_payment_initial_fare;
inline constexpr Quantity<taxi_trip_distance_travelled_object> taxi_trip_distance_travelled;

inline constexpr Quantity<taxi_trip_time_information_object, "Trip duration">
    taxi_trip_time_information_duration;
inline constexpr Quantity<taxi_trip_time_information_object, "Fare relevant waiting time">
    taxi_trip_time_information_fare_relevant_waiting;
inline constexpr Quantity<taxi_trip_time_information_object, "Trip start time">
    taxi_trip_time_information_start;
inline constexpr Quantity<taxi_trip_time_information_object, "Trip finish time">
    taxi_trip_time_information_finish;

inline constexpr Number<taxi_trip_tariff_level_object, "", "tariff level character 1">
    taxi_trip_tariff_level_character_1;
inline constexpr Number<taxi_trip_tariff_level_object, "", "tariff level character 2">
    taxi_trip_tariff_level_character_2;

inline constexpr Quantity<taxi_trip_tariff_value_object, "Time tariff value">
    taxi_trip_tariff_value_time;
inline constexpr Quantity<taxi_trip_tariff_value_object, "Distance tariff value">
    taxi_trip_tariff_value_distance;

inline constexpr State<Taximeter, taximeter_status_object, "", "taximeter status"> taximeter_status;
inline constexpr State<Signal, taximeter_status_object, "", "ticof">
    taximeter_status_changing_to_off;

inline constexpr Quantity<taximeter_totalizers_object, "Total distance travelled">
    taximeter_totalizers_total_distance_travelled;
inline constexpr Quantity<taximeter_totalizers_object, "Shift distance travelled">
    taximeter_totalizers_shift_distance_travelled;
inline constexpr Quantity<taximeter_totalizers_object, "Total distance when hired">
    taximeter_totalizers_total_distance_when_hired;
inline constexpr Quantity<taximeter_totalizers_object, "Shift distance when hired">
    taximeter_totalizers_shift_distance_when_hired;
inline constexpr Quantity<taximeter_totalizers_object, "Total income">
    taximeter_totalizers_total_income;
inline constexpr Quantity<taximeter_totalizers_object, "Shift income">
    taximeter_totalizers_shift_income;
inline constexpr Number<taximeter_totalizers_object, "Total number of hirings">
    taximeter_totalizers_total_number_of_hirings;
inline constexpr Number<taximeter_totalizers_object, "Shift number of hirings">
    taximeter_totalizers_shift_number_of_hirings;
inline constexpr Quantity<taximeter_totalizers_object, "Total supplements">
    taximeter_totalizers_total_supplements;
inline constexpr Quantity<taximeter_totalizers_object, "Shift supplements">
    taximeter_totalizers_shift_supplements;
inline constexpr Quantity<taximeter_totalizers_object, "Total fare">
    taximeter_totalizers_total_fare;
inline constexpr Quantity<taximeter_totalizers_object, "Shift fare">
    taximeter_totalizers_shift_fare;

inline constexpr Quantity<taximeter_configuration_object,
                          "Constant of the distance signal generator (k value)">
    taximeter_configuration_k_value;
inline constexpr State<TaximeterMode, taximeter_configuration_object, "Taximeter mode">
    taximeter_configuration_mode;
inline constexpr Number<taximeter_configuration_object, "Identification of the tariff">
    taximeter_configuration_tariff;
inline constexpr Text<taximeter_configuration_object, "Taxi identifier">
    taximeter_configuration_taxi_identifier;
inline constexpr Text<taximeter_configuration_object, "Calculation of fare">
    taximeter_configuration_calculation_of_fare;
inline constexpr Quantity<taximeter_configuration_object, "Date of securing">
    taximeter_configuration_date_of_securing;
inline constexpr Number<taximeter_configuration_object, "Identification of future tariff">
    taximeter_configuration_future_tariff;
inline constexpr Text<taximeter_configuration_object, "Actual currency">
    taximeter_configuration_actual_currency;
inline constexpr Text<taximeter_configuration_object, "Actual local distance unit">
    taximeter_configuration_actual_local_distance_unit;
inline constexpr Number<taxi_trip_data_sequence_counter_object, "",
                        "taxi trip data sequence counter">
    taxi_trip_data_sequence_counter;

}  // namespace canvoy::cia447
