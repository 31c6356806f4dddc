// The virtual devices of CiA 447-3, each with the objects that it provides, namely those of its
// clause.
//
// Their codes are in CiA 447-2, which is not at hand: here they are 0. Part 2 also defines which
// objects a virtual device must have, and which it consumes.
#pragma once

#include "canvoy/profiles/cia447/car_body.hpp"
#include "canvoy/profiles/cia447/clock.hpp"
#include "canvoy/profiles/cia447/light.hpp"
#include "canvoy/profiles/cia447/positioning.hpp"
#include "canvoy/profiles/cia447/power_train.hpp"
#include "canvoy/profiles/cia447/printer.hpp"
#include "canvoy/profiles/cia447/radio.hpp"
#include "canvoy/profiles/cia447/roof_bar.hpp"
#include "canvoy/profiles/cia447/tariff_display.hpp"
#include "canvoy/profiles/cia447/taximeter.hpp"
#include "canvoy/profiles/cia447/terminal.hpp"
#include "canvoy/profiles/cia447/vehicle_systems.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia447 {

/// Objects of the profile; they live as long as the program.
template <std::size_t count>
using ObjectList = std::array<const ObjectInfo*, count>;

/// The objects with their own categories.
template <std::size_t count>
constexpr std::array<DeviceObject, count> provided(const ObjectList<count>& objects) {
  std::array<DeviceObject, count> all{};
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = {.index = objects[i]->index,
              .category = objects[i]->category,
              .condition = objects[i]->condition};
  }
  return all;
}
/// The lists one after another.
template <std::size_t... counts>
constexpr auto joined(const ObjectList<counts>&... lists) {
  ObjectList<(counts + ...)> all{};
  std::size_t position = 0;
  const auto append = [&](const auto& one) {
    for (const ObjectInfo* object : one) all[position++] = object;
  };
  (append(lists), ...);
  return all;
}

inline constexpr auto car_body_list = rows::objects_of(
    switch_illumination_level_status_object, switch_illumination_level_command_object,
    ignition_switch_status_object, central_locking_system_status_object,
    central_locking_system_command_object, window_status_object, window_command_object,
    door_status_object, door_command_object, car_flap_status_object, car_flap_command_object,
    seat_adjustment_command_object, seat_adjustment_status_object, wiper_system_status_object,
    wiper_system_command_object, steering_wheel_angle_object, turn_indicator_reset_status_object,
    displayed_outside_air_temperature_object, displayed_inside_air_temperature_object,
    heating_and_air_conditioner_command_object, heating_and_air_conditioner_status_object,
    occupant_classification_status_object, buckle_switch_status_object, vin_data_object,
    user_selected_language_command_object, user_selected_language_status_object,
    day_night_detection_object, environment_light_intensity_object, accident_detection_object,
    tester_present_object);
inline constexpr auto light_list = rows::objects_of(
    car_light_status_object, car_light_command_object, car_interior_light_status_object,
    car_interior_light_command_object, anti_theft_warning_system_status_object,
    anti_theft_warning_system_command_object, mirror_anti_dazzle_position_object,
    horn_status_object, horn_command_object, flashing_light_command_object,
    flashing_light_status_object);
inline constexpr auto power_train_list = rows::objects_of(
    actual_engine_revolutions_object, engine_status_object,
    transmission_selector_lever_position_object, wheel_rpm_object, wheel_signal_source_object,
    wheel_pulse_counter_object, wheel_pulse_counter_overrun_value_object,
    pulses_per_wheel_rotation_object, displayed_vehicle_speed_object, odometer_object,
    tank_status_object, current_average_fuel_consumption_object, cruise_control_command_object,
    cruise_control_status_object, four_wheel_drive_command_object, four_wheel_drive_status_object);
inline constexpr auto ivn_gateway_list = joined(car_body_list, light_list, power_train_list);
inline constexpr auto fire_extinguishing_system_list =
    rows::objects_of(fire_extinguishing_system_status_object);
inline constexpr auto emergency_fresh_air_system_list =
    rows::objects_of(emergency_fresh_air_system_status_object);
inline constexpr auto power_supply_list =
    rows::objects_of(radio_power_supply_status_object, radio_power_supply_command_object,
                     periphery_power_supply_status_object, periphery_power_supply_command_object);
inline constexpr auto discrete_inputs_list = rows::objects_of(discrete_inputs_status_object);
inline constexpr auto terminal_list = rows::objects_of(
    number_pad_status_object, number_pad_command_object, number_pad_user_interaction_object,
    function_keys_status_object, function_keys_command_object,
    function_keys_user_interaction_object, control_keys_status_object, control_keys_command_object,
    control_keys_user_interaction_object, steering_wheel_switch_pad_status_object,
    steering_wheel_switch_pad_command_object, steering_wheel_switch_pad_user_interaction_object,
    emergency_key_status_object, emergency_key_command_object,
    emergency_key_user_interaction_object, display_1_parameters_object, display_1_status_object,
    display_1_command_object, display_1_text_object, display_1_title_object,
    display_2_parameters_object, display_2_status_object, display_2_command_object,
    display_2_text_object, buzzer_command_object, functional_warnings_status_object,
    functional_warnings_command_object, icon_display_1_command_object, icon_display_1_status_object,
    icon_display_2_command_object, icon_display_2_status_object);
inline constexpr auto gps_list = rows::objects_of(
    gps_current_position_object, gps_satellites_object, gps_status_object, gps_date_object,
    gps_utc_time_object, gps_velocity_and_heading_object, gps_altitude_object);
inline constexpr auto navigation_system_list =
    rows::objects_of(distance_to_selected_destination_object, position_description_request_object,
                     position_description_object, start_route_guidance_object,
                     current_position_request_object, current_position_object);
inline constexpr auto taximeter_list = rows::objects_of(
    taxi_trip_payment_object, taxi_trip_distance_travelled_object,
    taxi_trip_time_information_object, taxi_trip_tariff_level_object, taxi_trip_tariff_value_object,
    taximeter_status_object, taximeter_totalizers_object, taximeter_configuration_object,
    taxi_trip_data_sequence_counter_object);
inline constexpr auto printer_list = rows::objects_of(
    printer_status_object, printer_errors_object, printer_features_object,
    printer_text_status_object, printer_graphics_status_object,
    printer_configuration_command_object, printer_configuration_status_object,
    printer_mode_command_object, printer_mode_status_object, printer_transport_object);
inline constexpr auto real_time_clock_list =
    rows::objects_of(rtc_date_object, set_rtc_date_object, rtc_time_object, set_rtc_time_object,
                     rtc_type_and_status_object, rtc_time_zone_object);
inline constexpr auto driver_identification_list =
    rows::objects_of(unique_driver_id_object, driver_id_status_object, drivers_name_object,
                     driver_login_and_logout_time_object);
inline constexpr auto tariff_display_list = rows::objects_of(
    tariff_display_information_and_status_object, tariff_display_lamp_failures_1_object,
    tariff_display_lamp_failures_2_object, tariff_display_inputs_status_object,
    tariff_display_lamps_status_1_object, tariff_display_lamps_status_2_object,
    tariff_display_lamps_command_1_object, tariff_display_lamps_command_2_object,
    tariff_display_configuration_object, tariff_display_tariff_level_object);
inline constexpr auto taxi_alarm_system_list = rows::objects_of(taxi_alarm_system_status_object);
inline constexpr auto radio_list =
    rows::objects_of(radio_status_object, radio_device_command_object, radio_device_status_object);
inline constexpr auto audio_switch_list =
    rows::objects_of(audio_switch_command_object, audio_switch_status_request_object,
                     audio_switch_status_response_object);
inline constexpr auto roof_bar_light_list =
    rows::objects_of(light_commands_roof_bar_object, light_status_roof_bar_object);
inline constexpr auto roof_bar_sound_list =
    rows::objects_of(country_specific_sound_command_object, country_specific_sound_status_object,
                     sound_command_roof_bar_object, sound_status_roof_bar_object);
inline constexpr auto blue_light_flasher_module_list =
    rows::objects_of(blue_light_flasher_command_object, blue_light_flasher_status_object);
inline constexpr auto radio_hand_free_conversation_list =
    rows::objects_of(radio_hand_free_status_object, radio_hand_free_command_object);

inline constexpr auto objects = joined(
    ivn_gateway_list, fire_extinguishing_system_list, emergency_fresh_air_system_list,
    power_supply_list, discrete_inputs_list, terminal_list, gps_list, navigation_system_list,
    taximeter_list, printer_list, real_time_clock_list, driver_identification_list,
    tariff_display_list, taxi_alarm_system_list, radio_list, audio_switch_list, roof_bar_light_list,
    roof_bar_sound_list, blue_light_flasher_module_list, radio_hand_free_conversation_list);

/// Objects that the device provides; they live as long as the program.
template <const auto& objects_of_it>
inline constexpr auto provided_objects = provided(objects_of_it);
/// A virtual device that provides the objects of the list.
template <const auto& objects_of_it>
constexpr VirtualDeviceInfo device_of(std::string_view name, std::string_view clause,
                                      std::string_view description) {
  return {.name = name,
          .objects = provided_objects<objects_of_it>,
          .clause = clause,
          .description = description};
}
inline constexpr VirtualDeviceInfo ivn_gateway_device = device_of<ivn_gateway_list>(
    "IVN gateway", "4.2.2 to 4.2.4",
    "The car's own networks: car body electronics, light and signaling, power train.");
inline constexpr VirtualDeviceInfo fire_extinguishing_system_device =
    device_of<fire_extinguishing_system_list>("Fire extinguishing system", "4.2.5",
                                              "Puts out fires.");
inline constexpr VirtualDeviceInfo emergency_fresh_air_system_device =
    device_of<emergency_fresh_air_system_list>("Emergency fresh-air system", "4.2.6",
                                               "Keeps the air in the car fit to breathe.");
inline constexpr VirtualDeviceInfo power_supply_device =
    device_of<power_supply_list>("Power supply", "4.2.7", "Power of radio and periphery.");
inline constexpr VirtualDeviceInfo discrete_inputs_device =
    device_of<discrete_inputs_list>("Discrete inputs", "4.2.8", "Switches and contacts.");
inline constexpr VirtualDeviceInfo terminal_device =
    device_of<terminal_list>("Terminal", "4.2.9", "Keys, displays, buzzer and warnings.");
inline constexpr VirtualDeviceInfo gps_device =
    device_of<gps_list>("GPS", "4.2.10", "Position and time by satellite.");
inline constexpr VirtualDeviceInfo navigation_system_device =
    device_of<navigation_system_list>("Navigation system", "4.2.11", "Leads the way.");
inline constexpr VirtualDeviceInfo taximeter_device =
    device_of<taximeter_list>("Taximeter", "4.2.12", "Fares, totals and tariffs.");
inline constexpr VirtualDeviceInfo printer_device =
    device_of<printer_list>("Printer", "4.2.13", "Prints text, graphics and logos.");
inline constexpr VirtualDeviceInfo real_time_clock_device =
    device_of<real_time_clock_list>("Real time clock (RTC)", "4.2.14", "Date and time.");
inline constexpr VirtualDeviceInfo driver_identification_device =
    device_of<driver_identification_list>("Driver identification", "4.2.15",
                                          "Who drives, and since when.");
inline constexpr VirtualDeviceInfo tariff_display_device =
    device_of<tariff_display_list>("Tariff display", "4.2.16", "Tariff and lamps on the roof.");
inline constexpr VirtualDeviceInfo taxi_alarm_system_device =
    device_of<taxi_alarm_system_list>("Taxi alarm system", "4.2.17", "Silent and full alarm.");
inline constexpr VirtualDeviceInfo radio_device =
    device_of<radio_list>("Radio", "4.2.18", "Talks to the control room.");
inline constexpr VirtualDeviceInfo audio_switch_device = device_of<audio_switch_list>(
    "Audio switch", "4.2.19", "Connects what speaks with what is heard.");
inline constexpr VirtualDeviceInfo roof_bar_light_device =
    device_of<roof_bar_light_list>("Roof bar light", "4.2.20", "Beacons, flashers, lamps.");
inline constexpr VirtualDeviceInfo roof_bar_sound_device =
    device_of<roof_bar_sound_list>("Roof bar sound", "4.2.21", "Signals to be heard.");
inline constexpr VirtualDeviceInfo blue_light_flasher_module_device =
    device_of<blue_light_flasher_module_list>("Vehicle \"blue\" light flasher module", "4.2.22",
                                              "Flashers of the car itself.");
inline constexpr VirtualDeviceInfo radio_hand_free_conversation_device =
    device_of<radio_hand_free_conversation_list>("Radio hand-free conversation", "4.2.23",
                                                 "Key and LED of the radio in the car.");
inline constexpr VirtualDeviceInfo virtual_devices[] = {ivn_gateway_device,
                                                        fire_extinguishing_system_device,
                                                        emergency_fresh_air_system_device,
                                                        power_supply_device,
                                                        discrete_inputs_device,
                                                        terminal_device,
                                                        gps_device,
                                                        navigation_system_device,
                                                        taximeter_device,
                                                        printer_device,
                                                        real_time_clock_device,
                                                        driver_identification_device,
                                                        tariff_display_device,
                                                        taxi_alarm_system_device,
                                                        radio_device,
                                                        audio_switch_device,
                                                        roof_bar_light_device,
                                                        roof_bar_sound_device,
                                                        blue_light_flasher_module_device,
                                                        radio_hand_free_conversation_device};

}  // namespace canvoy::cia447
