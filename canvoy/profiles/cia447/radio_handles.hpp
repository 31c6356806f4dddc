// CiA 447-3: handles for application code, of tariff display, taxi alarm, radio, audio switch and
// hand-free conversation (4.2.16 to 4.2.19, 4.2.23).
//
//     Values display(node.dictionary());
//     display[cia447::tariff_display_lamp_command<9>] = cia447::Lamp::blinking;
#pragma once

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/numbered_handles.hpp"
#include "canvoy/profiles/cia447/radio.hpp"
#include "canvoy/profiles/cia447/tariff_display.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.16.

inline constexpr State<Signal, tariff_display_information_and_status_object, "", "power down">
    tariff_display_information_and_status_power_down;
inline constexpr State<LampInput, tariff_display_information_and_status_object, "", "input">
    tariff_display_information_and_status_input;
inline constexpr State<Signal, tariff_display_information_and_status_object, "", "dldi">
    tariff_display_information_and_status_lamp_driver_input;
inline constexpr Number<tariff_display_information_and_status_object, "", "number of lamps/lights">
    tariff_display_information_and_status_lamps;
inline constexpr Number<tariff_display_information_and_status_object, "", "tlc">
    tariff_display_information_and_status_level_characters;

inline constexpr State<LampFailure, tariff_display_lamp_failures_1_object, "", "taxi light">
    tariff_display_lamp_failures_1_taxi_light;
inline constexpr State<LampFailure, tariff_display_lamp_failures_1_object, "", "vacant light">
    tariff_display_lamp_failures_1_vacant_light;
inline constexpr State<LampFailure, tariff_display_lamp_failures_1_object, "", "emcy light">
    tariff_display_lamp_failures_1_emcy_light;

inline constexpr State<Lamp, tariff_display_lamps_status_1_object, "", "taxi light">
    tariff_display_lamps_status_1_taxi_light;
inline constexpr State<Lamp, tariff_display_lamps_status_1_object, "", "vacant light">
    tariff_display_lamps_status_1_vacant_light;
inline constexpr State<Lamp, tariff_display_lamps_status_1_object, "", "emcy light">
    tariff_display_lamps_status_1_emcy_light;

inline constexpr State<Lamp, tariff_display_lamps_command_1_object, "", "taxi light">
    tariff_display_lamps_command_1_taxi_light;
inline constexpr State<Lamp, tariff_display_lamps_command_1_object, "", "vacant light">
    tariff_display_lamps_command_1_vacant_light;
inline constexpr State<Lamp, tariff_display_lamps_command_1_object, "", "emcy light">
    tariff_display_lamps_command_1_emcy_light;

inline constexpr State<Order, tariff_display_configuration_object, "", "epdm">
    tariff_display_configuration_enter_power_down_mode;
inline constexpr State<DisplayConfiguration, tariff_display_configuration_object, "", "configure">
    tariff_display_configuration_configure;

inline constexpr Number<tariff_display_tariff_level_object, "", "tariff level character 1">
    tariff_display_tariff_level_character_1;
inline constexpr Number<tariff_display_tariff_level_object, "", "tariff level character 2">
    tariff_display_tariff_level_character_2;

// 4.2.17.

inline constexpr State<Signal, taxi_alarm_system_status_object, "", "saa">
    taxi_alarm_system_status_silent_activated;
inline constexpr State<Signal, taxi_alarm_system_status_object, "", "faa">
    taxi_alarm_system_status_full_activated;
inline constexpr State<Signal, taxi_alarm_system_status_object, "", "akp">
    taxi_alarm_system_status_key_pressed;
inline constexpr State<Signal, taxi_alarm_system_status_object, "", "rakp">
    taxi_alarm_system_status_remote_key_pressed;
inline constexpr State<Signal, taxi_alarm_system_status_object, "", "recr">
    taxi_alarm_system_status_radio_emergency_call_requested;

// 4.2.18.

inline constexpr State<Signal, radio_status_object, "", "rerr1"> radio_status_error_1;
inline constexpr State<Signal, radio_status_object, "", "rpod"> radio_status_power_off_detected;

inline constexpr State<Order, radio_device_command_object, "", "rp"> radio_device_command_power;
inline constexpr State<Order, radio_device_command_object, "", "ptt">
    radio_device_command_push_to_talk;

inline constexpr State<Signal, radio_device_status_object, "", "rp"> radio_device_status_power;
inline constexpr State<Signal, radio_device_status_object, "", "tx-ptt">
    radio_device_status_transmit_push_to_talk;

// 4.2.19.

inline constexpr Number<audio_switch_command_object, "", "audio input channel">
    audio_switch_command_input_channel;
inline constexpr Number<audio_switch_command_object, "", "audio output channel">
    audio_switch_command_output_channel;
inline constexpr Number<audio_switch_command_object, "", "gain"> audio_switch_command_gain;

inline constexpr Number<audio_switch_status_request_object, "", "audio input channel">
    audio_switch_status_request_input_channel;
inline constexpr Number<audio_switch_status_request_object, "", "audio output channel">
    audio_switch_status_request_output_channel;
inline constexpr Number<audio_switch_status_response_object> audio_switch_status_response;

// 4.2.23.

inline constexpr State<Signal, radio_hand_free_status_object, "", "radio hand-free key">
    radio_hand_free_status_key;

inline constexpr State<Order, radio_hand_free_command_object, "", "indication LED">
    radio_hand_free_command_indication_led;
inline constexpr State<Order, radio_hand_free_command_object, "", "audio mute">
    radio_hand_free_command_audio_mute;

// Lamps 4 to 16 and the inputs are numbered.

template <unsigned lamp>
  requires(lamp >= 4 && lamp <= 16)
inline constexpr State<LampFailure,
                       (lamp <= 8 ? tariff_display_lamp_failures_1_object
                                  : tariff_display_lamp_failures_2_object),
                       "", numbered_name<"fl", lamp>>
    tariff_display_lamp_failure;
template <unsigned lamp>
  requires(lamp >= 4 && lamp <= 16)
inline constexpr State<
    Lamp, (lamp <= 8 ? tariff_display_lamps_status_1_object : tariff_display_lamps_status_2_object),
    "", numbered_name<"l", lamp>>
    tariff_display_lamp_status;
template <unsigned lamp>
  requires(lamp >= 4 && lamp <= 16)
inline constexpr State<Lamp,
                       (lamp <= 8 ? tariff_display_lamps_command_1_object
                                  : tariff_display_lamps_command_2_object),
                       "", numbered_name<"l", lamp>>
    tariff_display_lamp_command;
template <unsigned input>
  requires(input >= 1 && input <= 16)
inline constexpr State<Signal, tariff_display_inputs_status_object, "", numbered_name<"i", input>>
    tariff_display_input;

}  // namespace canvoy::cia447
