// CiA 447-3: each object and each field has one handle.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/testing/clause_table.hpp"

namespace canvoy::cia447_handles_test {
namespace {

/// Index, sub-index, lowest bit: number of handles that refer to them.
using Places = std::map<std::tuple<unsigned, unsigned, unsigned>, unsigned>;

/// The two highest codes of an enumeration, where it has them, are those of its field.
template <class Place, class Enumeration>
void expect_sentinels(const StateReference<Place, Enumeration>* /*kind*/) {
  constexpr auto code = [](Enumeration state) { return static_cast<std::int64_t>(state); };
  constexpr std::int64_t highest = (std::int64_t{1} << Place::bits.bits) - 1;
  SCOPED_TRACE(testing::Message() << std::hex << Place::object.index << " " << Place::bits.first);
  if constexpr (requires { Enumeration::not_available; }) {
    EXPECT_EQ(code(Enumeration::not_available), highest);
  }
  if constexpr (requires { Enumeration::do_not_care; }) {
    EXPECT_EQ(code(Enumeration::do_not_care), highest);
  }
  if constexpr (requires { Enumeration::failure; }) {
    EXPECT_EQ(code(Enumeration::failure), highest - 1);
  }
  if constexpr (requires { Enumeration::not_implemented; }) {
    EXPECT_EQ(code(Enumeration::not_implemented), highest - 1);
  }
}
void expect_sentinels(const void* /*no state*/) {}

/// An enumeration, and the names of its enumerators by their codes.
struct States {
  std::string enumeration;
  std::map<std::int64_t, std::string> enumerators;
};
/// `canvoy::cia447::Opening::closed`; a cast for a code without an enumerator.
template <auto state>
std::string_view spelling() {
  std::string_view text = __PRETTY_FUNCTION__;
  text.remove_prefix(text.find("state = ") + 8);
  return text.substr(0, text.find_first_of(";]"));
}
/// Names of the codes from `first` on.
template <class Enumeration, int first, int... code>
void add_states(States& states, std::integer_sequence<int, code...> /*codes*/) {
  const auto add = [&states](int number, std::string_view text) {
    if (text.find(')') != std::string_view::npos) return;
    const std::size_t end = text.rfind("::");
    const std::size_t begin = text.rfind("::", end - 1) + 2;
    states.enumeration = text.substr(begin, end - begin);
    states.enumerators[number] = text.substr(end + 2);
  };
  (add(first + code, spelling<static_cast<Enumeration>(first + code)>()), ...);
}
using StatesByPlace = std::map<Places::key_type, States>;
template <class Place, class Enumeration>
void note_states(StatesByPlace& all, const Places::key_type& place,
                 const StateReference<Place, Enumeration>* /*kind*/) {
  constexpr auto codes =
      std::make_integer_sequence<int, 1 << std::min<unsigned>(Place::bits.bits, 5)>();
  States& states = all[place];
  add_states<Enumeration, 0>(states, codes);
  if constexpr (Place::bits.bits == 16) add_states<Enumeration, 0x8000>(states, codes);
}
void note_states(StatesByPlace& /*all*/, const Places::key_type& /*place*/, const void* /*no*/) {}
StatesByPlace& states_by_place() {
  static StatesByPlace all;
  return all;
}

template <class... Handle>
void count(Places& places, const Handle&... handles) {
  const auto one = [&places](const auto& handle) {
    using Place = typename std::remove_cvref_t<decltype(handle)>::Place;
    const Places::key_type place = {handle.index(), handle.sub(), Place::bits.first};
    ++places[place];
    using Reference = typename std::remove_cvref_t<decltype(handle)>::Reference;
    expect_sentinels(static_cast<const Reference*>(nullptr));
    note_states(states_by_place(), place, static_cast<const Reference*>(nullptr));
  };
  (one(handles), ...);
}

void count_car(Places& places) {
  using namespace cia447;
  count(
      places, switch_illumination_level_status, switch_illumination_level_command,
      ignition_switch_status_lock, ignition_switch_status_accessory, ignition_switch_status_on,
      ignition_switch_status_start, central_locking_system_status, central_locking_system_command,
      window_status_driver, window_status_front_passenger, window_status_rear_right,
      window_status_rear_left, window_status_3rd_row_right, window_status_3rd_row_left,
      window_command_driver, window_command_front_passenger, window_command_rear_right,
      window_command_rear_left, window_command_3rd_row_right, window_command_3rd_row_left,
      door_status_driver, door_status_front_passenger, door_status_rear_right,
      door_status_rear_left, door_command_driver, door_command_front_passenger,
      door_command_rear_right, door_command_rear_left, car_flap_status_engine_hood,
      car_flap_status_fuel_door, car_flap_status_boot_lid, car_flap_status_convertible_top,
      car_flap_status_back_door, car_flap_status_boot_lid_window, car_flap_status_sliding_roof,
      car_flap_command_engine_hood, car_flap_command_fuel_door, car_flap_command_boot_lid,
      car_flap_command_convertible_top, car_flap_command_back_door,
      car_flap_command_boot_lid_window, car_flap_command_sliding_roof,
      seat_adjustment_command_forward_backward, seat_adjustment_command_up_down,
      seat_adjustment_command_angle_lift_sink,
      seat_adjustment_command_tight_support_forward_backward,
      seat_adjustment_command_back_forward_backward, seat_adjustment_command_headrest_up_down,
      seat_adjustment_command_recall_memory, seat_adjustment_command_store_memory,
      seat_adjustment_status_forward_backward, seat_adjustment_status_up_down,
      seat_adjustment_status_angle_lift_sink, seat_adjustment_status_tight_support_forward_backward,
      seat_adjustment_status_back_forward_backward, seat_adjustment_status_headrest_up_down,
      seat_adjustment_status_recall_memory, seat_adjustment_status_store_memory,
      wiper_system_status_front, wiper_system_status_washer_front,
      wiper_system_status_switch_position_front, wiper_system_status_rear,
      wiper_system_status_washer_rear, wiper_system_command_front,
      wiper_system_command_washer_front, wiper_system_command_switch_position_front,
      wiper_system_command_rear, wiper_system_command_washer_rear, steering_wheel_angle,
      steering_wheel_angle_side, turn_indicator_reset_status_right,
      turn_indicator_reset_status_left, displayed_outside_air_temperature,
      displayed_inside_air_temperature, heating_and_air_conditioner_command_heat_front_window,
      heating_and_air_conditioner_command_heat_rear_window,
      heating_and_air_conditioner_command_automatic_control,
      heating_and_air_conditioner_command_defrost_front_window,
      heating_and_air_conditioner_command_temperature,
      heating_and_air_conditioner_command_recirculation,
      heating_and_air_conditioner_status_heat_front_window,
      heating_and_air_conditioner_status_heat_rear_window,
      heating_and_air_conditioner_status_automatic_control,
      heating_and_air_conditioner_status_defrost_front_window,
      heating_and_air_conditioner_status_temperature,
      heating_and_air_conditioner_status_recirculation, occupant_classification_status_driver,
      occupant_classification_status_front_passenger,
      occupant_classification_status_rear_right_passenger,
      occupant_classification_status_rear_left_passenger,
      occupant_classification_status_rear_middle_passenger,
      occupant_classification_status_3rd_row_right_passenger,
      occupant_classification_status_3rd_row_left_passenger,
      occupant_classification_status_3rd_row_middle_passenger, buckle_switch_status_driver,
      buckle_switch_status_front_passenger, buckle_switch_status_rear_right,
      buckle_switch_status_rear_left, buckle_switch_status_rear_middle,
      buckle_switch_status_3rd_row_right, buckle_switch_status_3rd_row_left,
      buckle_switch_status_3rd_row_middle, vin_data, user_selected_language_command,
      user_selected_language_status, day_night_detection, environment_light_intensity,
      accident_detection_airbag_released,
      accident_detection_presafe_acceleration_threshold_exceeded, accident_detection_motor_stop,
      accident_detection, tester_present_uds_diagnose_session, car_light_status_day_time_running,
      car_light_status_brake, car_light_status_reverse_driving, car_light_status_high_beam,
      car_light_status_low_beam, car_light_status_fog_lamps_front, car_light_status_fog_lamps_rear,
      car_light_status_turn_indication_right, car_light_status_turn_indication_left,
      car_light_status_tip_turn_indication_right, car_light_status_tip_turn_indication_left,
      car_light_status_emergency_flasher, car_light_status_flashing_light,
      car_light_status_position_lamps, car_light_status_parking_lamps_right,
      car_light_status_parking_lamps_left, car_light_command_day_time_running,
      car_light_command_brake, car_light_command_reverse_driving, car_light_command_high_beam,
      car_light_command_low_beam, car_light_command_fog_lamps_front,
      car_light_command_fog_lamps_rear, car_light_command_turn_indication_right,
      car_light_command_turn_indication_left, car_light_command_tip_turn_indication_right,
      car_light_command_tip_turn_indication_left, car_light_command_emergency_flasher,
      car_light_command_flashing_light, car_light_command_position_lamps,
      car_light_command_parking_lamps_right, car_light_command_parking_lamps_left,
      car_interior_light_status_illumination,
      car_interior_light_status_leg_room_illumination_driver,
      car_interior_light_status_leg_room_illumination_front_passenger,
      car_interior_light_status_leg_room_illumination_rear_right,
      car_interior_light_status_leg_room_illumination_rear_left,
      car_interior_light_status_boot_lid_illumination, car_interior_light_command_illumination,
      car_interior_light_command_leg_room_illumination_driver,
      car_interior_light_command_leg_room_illumination_front_passenger,
      car_interior_light_command_leg_room_illumination_rear_right,
      car_interior_light_command_leg_room_illumination_rear_left,
      car_interior_light_command_boot_lid_illumination, anti_theft_warning_system_status,
      anti_theft_warning_system_command, mirror_anti_dazzle_position, horn_status, horn_command,
      flashing_light_command_gateway_coded_functions, flashing_light_command_fog_lamps_day,
      flashing_light_command_fog_lamps_night, flashing_light_command_high_beam_day,
      flashing_light_command_high_beam_night, flashing_light_command_low_beam_day,
      flashing_light_command_low_beam_night, flashing_light_command_day_time_running_day,
      flashing_light_command_day_time_running_night, flashing_light_status_gateway_coded_functions,
      flashing_light_status_fog_lamps_day, flashing_light_status_fog_lamps_night,
      flashing_light_status_high_beam_day, flashing_light_status_high_beam_night,
      flashing_light_status_low_beam_day, flashing_light_status_low_beam_night,
      flashing_light_status_day_time_running_day, flashing_light_status_day_time_running_night,
      actual_engine_revolutions, actual_engine_revolutions_terminal_61, engine_status,
      transmission_selector_lever_position, automatic_gear_mode, parking_brake, coupling_switch,
      engaged_gear, wheel_rpm, wheel_signal_source, wheel_pulse_counter, wheel_pulse_counter_valid,
      wheel_pulse_counter_overrun_value, wheel_pulse_counter_overrun_value_valid,
      pulses_per_wheel_rotation, displayed_vehicle_speed, odometer, tank_level, tank_level_minimum,
      current_average_fuel_consumption, current_average_fuel_consumption_overflow,
      current_average_fuel_consumption_unit, cruise_control_command_automatic,
      cruise_control_command_accelerate_decelerate, cruise_control_command_store,
      cruise_control_command_distance_system, cruise_control_status_automatic,
      cruise_control_status_accelerate_decelerate, cruise_control_status_store,
      cruise_control_status_distance_system, four_wheel_drive_command, four_wheel_drive_status);
}
void count_terminal(Places& places) {
  using namespace cia447;
  count(places, fire_extinguishing_system_status, emergency_fresh_air_system_status,
        radio_power_supply_status_on, radio_power_supply_status_after_run_active,
        radio_power_supply_status_cut_off_in_5_minutes, radio_power_supply_status_overload,
        radio_power_supply_command_off, periphery_power_supply_status_on,
        periphery_power_supply_status_after_run_active,
        periphery_power_supply_status_cut_off_in_5_minutes, periphery_power_supply_status_overload,
        periphery_power_supply_command_off, discrete_inputs_status_taximeter_di,
        discrete_inputs_status_ptt_di, discrete_inputs_status_occupdet_di,
        discrete_inputs_status_roof_sign_di, discrete_inputs_status_beacon_sdi,
        number_pad_status_access, number_pad_command, number_pad_user_interaction,
        function_keys_status_key_access, function_keys_command_key,
        function_keys_user_interaction_key, control_keys_status_key_access, control_keys_command,
        control_keys_user_interaction_key, steering_wheel_switch_pad_status_access,
        steering_wheel_switch_pad_command_access, steering_wheel_switch_pad_user_interaction,
        emergency_key_status_access, emergency_key_command_access, emergency_key_user_interaction,
        display_1_parameters_line_number, display_1_parameters_column_number,
        display_1_parameters_maximal_character_number, display_1_status, display_1_command,
        display_1_text, display_1_title, display_2_parameters_line_number,
        display_2_parameters_column_number, display_2_parameters_maximal_character_number,
        display_2_status, display_2_command, display_2_text, buzzer_command,
        functional_warnings_status_fire_extinguishing_system_cartridge_empty,
        functional_warnings_status_fire_extinguishing_system_active,
        functional_warnings_status_fire_extinguishing_system_on,
        functional_warnings_status_fire_extinguishing_system_fault,
        functional_warnings_status_fresh_air_system_cylinder_empty,
        functional_warnings_status_fresh_air_system_active,
        functional_warnings_status_fresh_air_system_inactive, functional_warnings_command,
        icon_display_1_command, icon_display_1_command_content, icon_display_1_command_format,
        icon_display_1_status, icon_display_1_status_content, icon_display_1_status_format,
        icon_display_2_command, icon_display_2_command_content, icon_display_2_command_format,
        icon_display_2_status, icon_display_2_status_content, icon_display_2_status_format);
}
void count_taxi(Places& places) {
  using namespace cia447;
  count(places, gps_current_position_latitude, gps_current_position_longitude,
        gps_satellites_visible, gps_satellites_tracked, gps_status_vdop, gps_status_hdop,
        gps_status_pdop, gps_status_fix, gps_date_year, gps_date_month, gps_date_day,
        gps_utc_time_hour, gps_utc_time_minute, gps_utc_time_second, gps_velocity, gps_heading,
        gps_altitude, distance_to_selected_destination, position_description_request_latitude,
        position_description_request_longitude, position_description_city,
        position_description_street, position_description_country,
        start_route_guidance_position_latitude, start_route_guidance_position_longitude,
        start_route_guidance_start, current_position_request, current_position_city,
        current_position_street, current_position_country, taxi_trip_payment_fare,
        taxi_trip_payment_supplement_charge, taxi_trip_payment_total_charged,
        taxi_trip_payment_fare_calculation_mode, taxi_trip_payment_minimum_fare,
        taxi_trip_payment_initial_fare, taxi_trip_distance_travelled,
        taxi_trip_time_information_duration, taxi_trip_time_information_fare_relevant_waiting,
        taxi_trip_time_information_start, taxi_trip_time_information_finish,
        taxi_trip_tariff_level_character_1, taxi_trip_tariff_level_character_2,
        taxi_trip_tariff_value_time, taxi_trip_tariff_value_distance, taximeter_status,
        taximeter_status_changing_to_off, taximeter_totalizers_total_distance_travelled,
        taximeter_totalizers_shift_distance_travelled,
        taximeter_totalizers_total_distance_when_hired,
        taximeter_totalizers_shift_distance_when_hired, taximeter_totalizers_total_income,
        taximeter_totalizers_shift_income, taximeter_totalizers_total_number_of_hirings,
        taximeter_totalizers_shift_number_of_hirings, taximeter_totalizers_total_supplements,
        taximeter_totalizers_shift_supplements, taximeter_totalizers_total_fare,
        taximeter_totalizers_shift_fare, taximeter_configuration_k_value,
        taximeter_configuration_mode, taximeter_configuration_tariff,
        taximeter_configuration_taxi_identifier, taximeter_configuration_calculation_of_fare,
        taximeter_configuration_date_of_securing, taximeter_configuration_future_tariff,
        taximeter_configuration_actual_currency, taximeter_configuration_actual_local_distance_unit,
        taxi_trip_data_sequence_counter);
}
void count_equipment(Places& places) {
  using namespace cia447;
  count(places, printer_status, printer_status_buffer_empty, printer_errors_no_paper,
        printer_features_able_to_print_text, printer_features_able_to_print_bold,
        printer_features_able_to_print_cursive, printer_features_able_to_scale_text,
        printer_features_variable_width_supported, printer_features_fixed_width_supported,
        printer_features_able_to_print_graphics, printer_features_able_to_print_black_white,
        printer_features_able_to_print_gray, printer_features_able_to_print_rgb,
        printer_features_able_to_print_cmyk, printer_features_logo_number,
        printer_features_able_to_cut_paper, printer_features_lines_to_form_feed,
        printer_text_status_maximum_number_of_characters_per_full_line,
        printer_text_status_minimum_number_of_characters_per_full_line,
        printer_text_status_current_number_of_characters_per_full_line,
        printer_text_status_maximum_height, printer_text_status_minimum_height,
        printer_text_status_current_height, printer_text_status_maximum_width,
        printer_text_status_minimum_width, printer_text_status_current_width,
        printer_graphics_status_number_of_dots_per_line,
        printer_graphics_status_number_of_grayscales,
        printer_graphics_status_number_of_bits_per_colour_channel,
        printer_configuration_command_print_bold, printer_configuration_command_print_cursive,
        printer_configuration_command_use_variable_width_font,
        printer_configuration_command_use_certain_color_space,
        printer_configuration_command_height_of_used_font,
        printer_configuration_command_width_of_used_font,
        printer_configuration_command_number_of_chars_per_line,
        printer_configuration_status_text_bold, printer_configuration_status_text_cursive,
        printer_configuration_status_variable_width_font, printer_configuration_status_color_space,
        printer_configuration_status_height_of_used_font,
        printer_configuration_status_width_of_used_font,
        printer_configuration_status_number_of_chars_per_line, printer_mode_command,
        printer_mode_status, rtc_date_year, rtc_date_month, rtc_date_day, set_rtc_date_year,
        set_rtc_date_month, set_rtc_date_day, rtc_time_hour, rtc_time_minute, rtc_time_second,
        set_rtc_time_hour, set_rtc_time_minute, set_rtc_time_second, rtc_type_and_status_source,
        rtc_type_and_status_trustability, rtc_type_and_status_valid,
        rtc_type_and_status_dst_supported, rtc_type_and_status_dst_active,
        rtc_type_and_status_utc_offset, rtc_time_zone, unique_driver_id, driver_id_status_logged_in,
        driver_id_status_data_state, driver_id_status_system_failure, drivers_name,
        driver_login_time, driver_logout_time);
}
void count_radio(Places& places) {
  using namespace cia447;
  count(places, tariff_display_information_and_status_power_down,
        tariff_display_information_and_status_input,
        tariff_display_information_and_status_lamp_driver_input,
        tariff_display_information_and_status_lamps,
        tariff_display_information_and_status_level_characters,
        tariff_display_lamp_failures_1_taxi_light, tariff_display_lamp_failures_1_vacant_light,
        tariff_display_lamp_failures_1_emcy_light, tariff_display_lamps_status_1_taxi_light,
        tariff_display_lamps_status_1_vacant_light, tariff_display_lamps_status_1_emcy_light,
        tariff_display_lamps_command_1_taxi_light, tariff_display_lamps_command_1_vacant_light,
        tariff_display_lamps_command_1_emcy_light,
        tariff_display_configuration_enter_power_down_mode, tariff_display_configuration_configure,
        tariff_display_tariff_level_character_1, tariff_display_tariff_level_character_2,
        taxi_alarm_system_status_silent_activated, taxi_alarm_system_status_full_activated,
        taxi_alarm_system_status_key_pressed, taxi_alarm_system_status_remote_key_pressed,
        taxi_alarm_system_status_radio_emergency_call_requested, radio_status_error_1,
        radio_status_power_off_detected, radio_device_command_power,
        radio_device_command_push_to_talk, radio_device_status_power,
        radio_device_status_transmit_push_to_talk, audio_switch_command_input_channel,
        audio_switch_command_output_channel, audio_switch_command_gain,
        audio_switch_status_request_input_channel, audio_switch_status_request_output_channel,
        audio_switch_status_response, radio_hand_free_status_key,
        radio_hand_free_command_indication_led, radio_hand_free_command_audio_mute);
}
void count_roof_bar(Places& places) {
  using namespace cia447;
  count(places, light_commands_roof_bar_search_lamp,
        light_commands_roof_bar_swing_search_lamp_right_left,
        light_commands_roof_bar_swing_search_lamp_up_down,
        light_commands_roof_bar_search_lamp_position, light_status_roof_bar_search_lamp,
        light_status_roof_bar_swing_search_lamp_right_left,
        light_status_roof_bar_swing_search_lamp_up_down, light_status_roof_bar_search_lamp_position,
        light_status_roof_bar_local_voltage, country_specific_sound_command,
        country_specific_sound_status, sound_command_roof_bar_additional_sound,
        sound_command_roof_bar_speed, sound_command_roof_bar_city_land,
        sound_command_roof_bar_order_readiness, sound_command_roof_bar_acoustic_test_operation,
        sound_command_roof_bar_volume_day_night, sound_command_roof_bar_volume,
        sound_command_roof_bar_velocity_dependent_volume_adjustment,
        sound_command_roof_bar_audio_active, sound_status_roof_bar_additional_sound,
        sound_status_roof_bar_speed, sound_status_roof_bar_city_land,
        sound_status_roof_bar_order_readiness, sound_status_roof_bar_acoustic_test_operation,
        sound_status_roof_bar_volume_day_night, sound_status_roof_bar_volume,
        sound_status_roof_bar_velocity_dependent_volume_adjustment,
        sound_status_roof_bar_audio_active, sound_status_roof_bar_speaker,
        sound_status_roof_bar_local_voltage, blue_light_flasher_command_front_right,
        blue_light_flasher_command_front_left, blue_light_flasher_command_rear_right,
        blue_light_flasher_command_rear_left, blue_light_flasher_command_side_right,
        blue_light_flasher_command_side_left, blue_light_flasher_command_trunk_lid_right,
        blue_light_flasher_command_trunk_lid_left, blue_light_flasher_command_mirror_right,
        blue_light_flasher_command_mirror_left, blue_light_flasher_status_front_right,
        blue_light_flasher_status_front_left, blue_light_flasher_status_rear_right,
        blue_light_flasher_status_rear_left, blue_light_flasher_status_side_right,
        blue_light_flasher_status_side_left, blue_light_flasher_status_trunk_lid_right,
        blue_light_flasher_status_trunk_lid_left, blue_light_flasher_status_mirror_right,
        blue_light_flasher_status_mirror_left);
}

template <unsigned... n>
void count_lamps(Places& places, std::integer_sequence<unsigned, n...> /*thirteen*/) {
  count(places, cia447::tariff_display_lamp_failure<n + 4>...);
  count(places, cia447::tariff_display_lamp_status<n + 4>...);
  count(places, cia447::tariff_display_lamp_command<n + 4>...);
}
template <Name prefix, unsigned... n>
void count_lights(Places& places, std::integer_sequence<unsigned, n...> /*numbers*/) {
  count(places, cia447::roof_bar_light_command<cia447::numbered_name<prefix, n + 1>>...);
  count(places, cia447::roof_bar_light_status<cia447::numbered_name<prefix, n + 1>>...);
}
template <unsigned... n>
void count_inputs(Places& places, std::integer_sequence<unsigned, n...> /*sixteen*/) {
  count(places, cia447::tariff_display_input<n + 1>...);
}
void count_numbered(Places& places) {
  count_lamps(places, std::make_integer_sequence<unsigned, 13>());
  count_inputs(places, std::make_integer_sequence<unsigned, 16>());
  count_lights<"mlb">(places, std::make_integer_sequence<unsigned, 4>());
  count_lights<"alb">(places, std::make_integer_sequence<unsigned, 16>());
  count_lights<"hdf">(places, std::make_integer_sequence<unsigned, 4>());
  count_lights<"ff">(places, std::make_integer_sequence<unsigned, 4>());
  count_lights<"alr">(places, std::make_integer_sequence<unsigned, 2>());
  count_lights<"all">(places, std::make_integer_sequence<unsigned, 2>());
  count_lights<"wlf">(places, std::make_integer_sequence<unsigned, 2>());
  count_lights<"wlr">(places, std::make_integer_sequence<unsigned, 2>());
  count_lights<"rf">(places, std::make_integer_sequence<unsigned, 4>());
  count_lights<"di">(places, std::make_integer_sequence<unsigned, 4>());
  count_lights<"rwf">(places, std::make_integer_sequence<unsigned, 8>());
  count_lights<"rl">(places, std::make_integer_sequence<unsigned, 7>());
  count_lights<"af">(places, std::make_integer_sequence<unsigned, 16>());
}

Places all_places() {
  Places places;
  count_car(places);
  count_terminal(places);
  count_taxi(places);
  count_equipment(places);
  count_radio(places);
  count_roof_bar(places);
  count_numbered(places);
  return places;
}

/// Entries of one shape, where handles refer to the first.
bool is_like_the_one_before(const ObjectInfo& object, const EntryInfo& entry) {
  if (entry.fields.empty() || entry.sub_first < 2) return false;
  return object.subs[entry.sub_first - 1U].fields.begin() == entry.fields.begin();
}

TEST(Cia447Handles, ThereIsOneForEachValue) {
  Places expected;
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      if (entry.sub_first == 0 && !object->subs.empty()) continue;
      if (entry.type == DataType::domain || is_like_the_one_before(*object, entry)) continue;
      if (entry.fields.empty()) expected[{object->index, entry.sub_first, 0}] = 1;
      for (const FieldInfo& field : entry.fields) {
        if (field.name == "r") continue;
        expected[{object->index, entry.sub_first, field.first_bit}] = 1;
      }
    }
  }
  EXPECT_EQ(all_places(), expected);
}

unsigned first_bit_of(const clauses::EntryRow& row, const std::string& field) {
  for (const clauses::Field& one : row.fields) {
    if (one.name == field) return one.first_bit;
  }
  return 0;
}
TEST(Cia447Handles, StatesHaveTheEnumerationsOfTheTable) {
  all_places();
  for (const clauses::ObjectRow& object : clauses::read_table("447-3").objects) {
    for (const clauses::EntryRow& row : object.entries) {
      for (const clauses::Values& values : row.values) {
        if (values.enumeration.empty()) continue;
        const Places::key_type place = {object.first, row.first, first_bit_of(row, values.field)};
        EXPECT_EQ(states_by_place()[place].enumeration, values.enumeration)
            << "line " << row.line << ", " << values.field;
      }
    }
  }
}

TEST(Cia447Handles, EnumeratorsHaveTheCodesOfTheTable) {
  static_assert(cia447::TerminalAccess::off == cia447::TerminalAccess::none);
  all_places();
  for (const clauses::Enumeration& expected : clauses::read_table("447-3").enumerations) {
    const auto found = std::ranges::find_if(states_by_place(), [&](const auto& states) {
      return states.second.enumeration == expected.name;
    });
    ASSERT_NE(found, states_by_place().end()) << expected.name;
    for (const clauses::Value& value : expected.values) {
      const auto name = found->second.enumerators.find(value.first);
      EXPECT_TRUE(name != found->second.enumerators.end() && name->second == value.text)
          << expected.name << " " << value.first;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia447_handles_test
