// CiA 447-3: handles for application code, of roof bar and "blue" light flashers (4.2.20 to
// 4.2.22). The lights of the roof bar have their printed names.
//
//     Values roof_bar(node.dictionary());
//     roof_bar[cia447::roof_bar_light_command<"mlb1">] = cia447::Order::on;
//     if (roof_bar[cia447::roof_bar_light_status<"rwf8">].is(cia447::Signal::on)) ...
#pragma once

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/numbered_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.20.

inline constexpr State<Order, light_commands_roof_bar_object, "Light command 3", "sl">
    light_commands_roof_bar_search_lamp;
inline constexpr State<SearchLampTurn, light_commands_roof_bar_object, "Light command 3", "sslrl">
    light_commands_roof_bar_swing_search_lamp_right_left;
inline constexpr State<SearchLampTilt, light_commands_roof_bar_object, "Light command 3", "sslud">
    light_commands_roof_bar_swing_search_lamp_up_down;
inline constexpr State<SearchLampPosition, light_commands_roof_bar_object, "Light command 3", "slp">
    light_commands_roof_bar_search_lamp_position;

inline constexpr State<Signal, light_status_roof_bar_object, "Light status 3", "sl">
    light_status_roof_bar_search_lamp;
inline constexpr State<SearchLampTurn, light_status_roof_bar_object, "Light status 3", "sslrl">
    light_status_roof_bar_swing_search_lamp_right_left;
inline constexpr State<SearchLampTilt, light_status_roof_bar_object, "Light status 3", "sslud">
    light_status_roof_bar_swing_search_lamp_up_down;
inline constexpr State<SearchLampPosition, light_status_roof_bar_object, "Light status 3", "slp">
    light_status_roof_bar_search_lamp_position;
inline constexpr State<LocalVoltage, light_status_roof_bar_object, "Light status 4", "rbllv">
    light_status_roof_bar_local_voltage;

// 4.2.21.

inline constexpr State<CountrySound, country_specific_sound_command_object>
    country_specific_sound_command;
inline constexpr State<CountrySound, country_specific_sound_status_object>
    country_specific_sound_status;

inline constexpr State<AdditionalSound, sound_command_roof_bar_object, "Sound command 1",
                       "additional sound">
    sound_command_roof_bar_additional_sound;
inline constexpr State<SoundSpeed, sound_command_roof_bar_object, "Sound command 1", "swds">
    sound_command_roof_bar_speed;
inline constexpr State<SoundPlace, sound_command_roof_bar_object, "Sound command 1", "scl">
    sound_command_roof_bar_city_land;
inline constexpr State<Order, sound_command_roof_bar_object, "Sound command 1", "sor">
    sound_command_roof_bar_order_readiness;
inline constexpr State<Order, sound_command_roof_bar_object, "Sound command 1", "ato">
    sound_command_roof_bar_acoustic_test_operation;
inline constexpr State<DayNight, sound_command_roof_bar_object, "Sound command 1", "svdn">
    sound_command_roof_bar_volume_day_night;
inline constexpr Number<sound_command_roof_bar_object, "Sound command 1", "sound volume">
    sound_command_roof_bar_volume;
inline constexpr State<Order, sound_command_roof_bar_object, "Sound command 1", "vdva">
    sound_command_roof_bar_velocity_dependent_volume_adjustment;
inline constexpr State<Order, sound_command_roof_bar_object, "Sound command 2", "aac">
    sound_command_roof_bar_audio_active;

inline constexpr State<AdditionalSound, sound_status_roof_bar_object, "Sound status 1",
                       "additional sound">
    sound_status_roof_bar_additional_sound;
inline constexpr State<SoundSpeed, sound_status_roof_bar_object, "Sound status 1", "swds">
    sound_status_roof_bar_speed;
inline constexpr State<SoundPlace, sound_status_roof_bar_object, "Sound status 1", "scl">
    sound_status_roof_bar_city_land;
inline constexpr State<Signal, sound_status_roof_bar_object, "Sound status 1", "sor">
    sound_status_roof_bar_order_readiness;
inline constexpr State<Signal, sound_status_roof_bar_object, "Sound status 1", "ato">
    sound_status_roof_bar_acoustic_test_operation;
inline constexpr State<DayNight, sound_status_roof_bar_object, "Sound status 1", "svdn">
    sound_status_roof_bar_volume_day_night;
inline constexpr Number<sound_status_roof_bar_object, "Sound status 1", "sound volume">
    sound_status_roof_bar_volume;
inline constexpr State<Signal, sound_status_roof_bar_object, "Sound status 1", "vdva">
    sound_status_roof_bar_velocity_dependent_volume_adjustment;
inline constexpr State<Signal, sound_status_roof_bar_object, "Sound status 2", "aas">
    sound_status_roof_bar_audio_active;
inline constexpr State<Speaker, sound_status_roof_bar_object, "Sound status 2", "speak">
    sound_status_roof_bar_speaker;
inline constexpr State<LocalVoltage, sound_status_roof_bar_object, "Sound status 2", "rbslv">
    sound_status_roof_bar_local_voltage;

// 4.2.22.

/// Handles of the fields of the blue light flasher command.
template <Name field>
using BlueLightFlasherCommandField = State<Order, blue_light_flasher_command_object, "", field>;
inline constexpr BlueLightFlasherCommandField<"ffr"> blue_light_flasher_command_front_right;
inline constexpr BlueLightFlasherCommandField<"ffl"> blue_light_flasher_command_front_left;
inline constexpr BlueLightFlasherCommandField<"rfr"> blue_light_flasher_command_rear_right;
inline constexpr BlueLightFlasherCommandField<"rfl"> blue_light_flasher_command_rear_left;
inline constexpr BlueLightFlasherCommandField<"sfr"> blue_light_flasher_command_side_right;
inline constexpr BlueLightFlasherCommandField<"sfl"> blue_light_flasher_command_side_left;
inline constexpr BlueLightFlasherCommandField<"tlfr"> blue_light_flasher_command_trunk_lid_right;
inline constexpr BlueLightFlasherCommandField<"tlfl"> blue_light_flasher_command_trunk_lid_left;
inline constexpr BlueLightFlasherCommandField<"mfr"> blue_light_flasher_command_mirror_right;
inline constexpr BlueLightFlasherCommandField<"mfl"> blue_light_flasher_command_mirror_left;

/// Handles of the fields of the blue light flasher status.
template <Name field>
using BlueLightFlasherStatusField = State<Signal, blue_light_flasher_status_object, "", field>;
inline constexpr BlueLightFlasherStatusField<"ffr"> blue_light_flasher_status_front_right;
inline constexpr BlueLightFlasherStatusField<"ffl"> blue_light_flasher_status_front_left;
inline constexpr BlueLightFlasherStatusField<"rfr"> blue_light_flasher_status_rear_right;
inline constexpr BlueLightFlasherStatusField<"rfl"> blue_light_flasher_status_rear_left;
inline constexpr BlueLightFlasherStatusField<"sfr"> blue_light_flasher_status_side_right;
inline constexpr BlueLightFlasherStatusField<"sfl"> blue_light_flasher_status_side_left;
inline constexpr BlueLightFlasherStatusField<"tlfr"> blue_light_flasher_status_trunk_lid_right;
inline constexpr BlueLightFlasherStatusField<"tlfl"> blue_light_flasher_status_trunk_lid_left;
inline constexpr BlueLightFlasherStatusField<"mfr"> blue_light_flasher_status_mirror_right;
inline constexpr BlueLightFlasherStatusField<"mfl"> blue_light_flasher_status_mirror_left;

// Lights, by their printed names: "mlb1" to "mlb4", "alb1" to "alb16", "af1" to "af16" ...

template <Name light>
inline constexpr State<Order, light_commands_roof_bar_object,
                       entry_with<light_commands_roof_bar_object, light>, light>
    roof_bar_light_command;
template <Name light>
inline constexpr State<Signal, light_status_roof_bar_object,
                       entry_with<light_status_roof_bar_object, light>, light>
    roof_bar_light_status;

}  // namespace canvoy::cia447
