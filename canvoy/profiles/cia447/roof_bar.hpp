// CiA 447-3, clauses 4.2.20 to 4.2.22: light and sound of the roof bar, "blue" light flasher
// module.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.20: light. Five entries of sixteen lights; command and status have the same lights.

/// How the lights of a kind are numbered: sub-index 02h continues where sub-index 01h ends.
constexpr auto beacons_and_flashers(Items<NamedValue> values, unsigned group) {
  return side_by_side(numbered<2>(2, "mlb#", "main light beacon", values, 2 * group + 1),
                      numbered<4>(2, "alb#", "additional light beacon", values, 4 * group + 1),
                      numbered<2>(2, "hdf#", "high distance flasher", values, 2 * group + 1),
                      numbered<2>(2, "ff#", "front flasher", values, 2 * group + 1),
                      numbered<1>(2, "alr#", "alley light right", values, group + 1),
                      numbered<1>(2, "all#", "alley light left", values, group + 1),
                      numbered<1>(2, "wlf#", "working light front", values, group + 1),
                      numbered<1>(2, "wlr#", "working light rear", values, group + 1),
                      numbered<2>(2, "rf#", "rear flasher", values, 2 * group + 1));
}
/// Codes of the search lamp in a command or a status.
struct SearchLampValues {
  Items<NamedValue> right_left;  ///< right, left or stop
  Items<NamedValue> up_down;     ///< up, down or stop
  Items<NamedValue> position;    ///< stored position 1 to 3
};
/// Fields of the indicators and the search lamp.
constexpr auto indicators_and_search_lamp(Items<NamedValue> values,
                                          const SearchLampValues& search_lamp) {
  return side_by_side(numbered<4>(2, "di#", "direction indicator", values),
                      numbered<8>(2, "rwf#", "rear warning flasher", values),
                      field(2, "sl", "search lamp", values),
                      field(2, "sslrl", "swing search lamp right/left", search_lamp.right_left),
                      field(2, "sslud", "swing search lamp up/down", search_lamp.up_down),
                      field(2, "slp", "search lamp position", search_lamp.position));
}
/// Fields of additional beacons and reserve lights.
constexpr auto further_lights(Items<NamedValue> values) {
  return side_by_side(numbered<8>(2, "alb#", "additional light beacon", values, 9),
                      numbered<7>(2, "rl#", "reserve light", values));
}
/// Fields of the 16 additional functions.
constexpr auto additional_functions(Items<NamedValue> values) {
  return numbered<16>(2, "af#", "additional function", values);
}

inline constexpr auto turn_commands =
    command_values<2>("Disable function (turn-off)", "Enable function (turn-on)");
// No code is left for "Function not implemented" (errata Z35).
inline constexpr auto swing_right_left_commands = three_commands(
    "Stop swinging right/left", "Swing the search lamp right", "Swing the search lamp left");
inline constexpr auto swing_up_down_commands = three_commands(
    "Stop swinging up/down", "Swing the search lamp up", "Swing the search lamp down");
inline constexpr auto search_lamp_position_commands =
    three_commands("Bring search lamp in position 1", "Bring search lamp in position 2",
                   "Bring search lamp in position 3");
inline constexpr auto light_command_1_fields = beacons_and_flashers(turn_commands, 0);
inline constexpr auto light_command_2_fields = beacons_and_flashers(turn_commands, 1);
inline constexpr auto light_command_3_fields =
    indicators_and_search_lamp(turn_commands, {.right_left = swing_right_left_commands,
                                               .up_down = swing_up_down_commands,
                                               .position = search_lamp_position_commands});
inline constexpr auto light_command_4_fields =
    side_by_side(further_lights(turn_commands), reserved<2>());
inline constexpr auto light_command_5_fields = additional_functions(turn_commands);
inline constexpr EntryInfo light_commands_roof_bar_entries[] = {
    highest_sub_index(5, 5),
    at(1, "Light command 1", command(DataType::unsigned32, light_command_1_fields)),
    at(2, "Light command 2", command(DataType::unsigned32, light_command_2_fields)),
    at(3, "Light command 3", command(DataType::unsigned32, light_command_3_fields)),
    at(4, "Light command 4", command(DataType::unsigned32, light_command_4_fields)),
    at(5, "Light command 5", command(DataType::unsigned32, light_command_5_fields))};
inline constexpr auto light_commands_roof_bar_object = array_object(
    0x6130, "Light commands roof bar", "4.2.20.1", "Switches the lights of the roof bar.",
    light_commands_roof_bar_entries, {.errata = "Z06, Z19, Z35"});

inline constexpr auto enabled_states =
    status_values<2>("The function is disabled (off)", "The function is enabled (on)");
// No code is left for "Failure" (errata Z35).
/// Two-bit codes of a status with three states.
constexpr std::array<NamedValue, 4> three_states(std::string_view first, std::string_view second,
                                                 std::string_view third) {
  return {NamedValue{0, first}, NamedValue{1, second}, NamedValue{2, third},
          status_sentinels<2>.highest};
}
inline constexpr auto swing_right_left_states =
    three_states("The function is not active", "The search lamp is moving right",
                 "The search lamp is moving left");
inline constexpr auto swing_up_down_states = three_states(
    "The function is not active", "The search lamp is moving up", "The search lamp is moving down");
inline constexpr auto search_lamp_positions =
    three_states("The search lamp is in position 1", "The search lamp is in position 2",
                 "The search lamp is in position 3");
inline constexpr auto local_voltages =
    three_states("Voltage is OK", "Under voltage", "Over voltage");
inline constexpr auto light_status_1_fields = beacons_and_flashers(enabled_states, 0);
inline constexpr auto light_status_2_fields = beacons_and_flashers(enabled_states, 1);
inline constexpr auto light_status_3_fields =
    indicators_and_search_lamp(enabled_states, {.right_left = swing_right_left_states,
                                                .up_down = swing_up_down_states,
                                                .position = search_lamp_positions});
inline constexpr auto light_status_4_fields =
    side_by_side(further_lights(enabled_states),
                 field(2, "rbllv", "roof bar light local voltage", local_voltages));
inline constexpr auto light_status_5_fields = additional_functions(enabled_states);
/// An entry of 6131h.
constexpr EntryInfo light_status(unsigned sub, std::string_view name, Items<FieldInfo> fields) {
  return at(sub, name, status(DataType::unsigned32, Mapping::by_default, fields));
}
inline constexpr EntryInfo light_status_roof_bar_entries[] = {
    highest_sub_index(5, 5),
    light_status(1, "Light status 1", light_status_1_fields),
    light_status(2, "Light status 2", light_status_2_fields),
    light_status(3, "Light status 3", light_status_3_fields),
    light_status(4, "Light status 4", light_status_4_fields),
    light_status(5, "Light status 5", light_status_5_fields)};
inline constexpr auto light_status_roof_bar_object = array_object(
    0x6131, "Light status roof bar", "4.2.20.2", "Which lights of the roof bar are on.",
    light_status_roof_bar_entries, {.errata = "Z19, Z35, Z45"});

// 4.2.21: sound. Codes from 4Fh are printed as manufacturer-specific. 40h to 4Eh would be
// undefined, and are read as part of them (errata Z08).

inline constexpr std::int64_t first_manufacturer_sound = 0x40;
/// Codes from the first one of makers to `last`.
constexpr NamedValue manufacturer_sounds(std::int64_t last, std::string_view name) {
  return {first_manufacturer_sound, last, name, Meaning::manufacturer};
}
/// Sounds from 0 upward, reserved codes, those of the manufacturer, and the codes above.
template <std::size_t count, std::size_t above>
constexpr auto sounds(const std::string_view (&names)[count], const NamedValue (&rest)[above]) {
  std::array<NamedValue, count + 1 + above> values{};
  for (std::size_t i = 0; i < count; ++i) values[i] = NamedValue(i, names[i]);
  values[count] = reserved_codes(static_cast<std::int64_t>(count), first_manufacturer_sound - 1);
  for (std::size_t i = 0; i < above; ++i) values[count + 1 + i] = rest[i];
  return values;
}
/// Country-specific sounds. The first one, silence, has two codes.
template <std::size_t above>
constexpr auto country_sounds(std::string_view silence, const NamedValue (&rest)[above]) {
  return sounds({silence,
                 "DIN",
                 "Italian police",
                 "Italian ambulance",
                 "Italian fire fight",
                 "Netherlands 2-sound",
                 "Netherlands 3-sound",
                 "Austria (Vienna rescue)",
                 "Austria rescue",
                 "Austria police",
                 "Austria fire fight",
                 "Austria ambulance",
                 "Norway",
                 "Sweden",
                 "Denmark",
                 "France police",
                 "France fire fight",
                 "France gendarmerie",
                 "France UMH",
                 "France ambulance",
                 "Piste",
                 "Great Britain fire fight",
                 "USA"},
                rest);
}
inline constexpr std::string_view manufacturer_sounds_name = "Manufacturer-specific sounds";
inline constexpr auto country_sound_commands =
    country_sounds("No sound", {manufacturer_sounds(0xFD, manufacturer_sounds_name),
                                command_sentinels<8>.second_highest, command_sentinels<8>.highest});
inline constexpr auto country_sound_states = country_sounds(
    "No sound selected", {manufacturer_sounds(0xFD, manufacturer_sounds_name),
                          status_sentinels<8>.second_highest, status_sentinels<8>.highest});
inline constexpr auto country_specific_sound_command_object = variable_object(
    0x6138, "Country-specific sound command roof bar", "4.2.21.1",
    "Chooses the sound of a country.",
    command(DataType::unsigned8, ValueInfo{.names = country_sound_commands}), {.errata = "Z08"});
inline constexpr auto country_specific_sound_status_object = variable_object(
    0x6139, "Country-specific sound status roof bar", "4.2.21.2",
    "The sound of a country that is chosen.",
    status(DataType::unsigned8, Mapping::no, ValueInfo{.names = country_sound_states}),
    {.errata = "Z08"});

/// Silence, the sounds of the profile and of makers, and these codes above them.
template <std::size_t above>
constexpr auto additional_sounds(std::string_view silence, const NamedValue (&rest)[above]) {
  return sounds({silence, "Country-specific sound", "Peak", "US-HI-LO", "US-YELP", "Sweden-YELP",
                 "WAIL", "Air horn", "Cricket (Grille: Austria-specific sound)"},
                rest);
}
inline constexpr std::string_view additional_sounds_name =
    "Manufacturer-specific additional sounds";
inline constexpr auto additional_sound_commands = additional_sounds(
    "No sound (turn-off)",
    {manufacturer_sounds(0xFC, additional_sounds_name), reserved_codes(0xFD, 0xFD),
     command_sentinels<8>.second_highest, command_sentinels<8>.highest});
inline constexpr auto additional_sound_states = additional_sounds(
    "No sound", {manufacturer_sounds(0xFD, additional_sounds_name),
                 status_sentinels<8>.second_highest, status_sentinels<8>.highest});

/// Steps 1 to 62 from raw 0 upward. The command reserves the last one (errata Z09).
inline constexpr ValueInfo volume_command = wanted<6, 0x3C>(Unit::none, {.offset = 1});
inline constexpr ValueInfo volume_status = measured<6, 0x3D>(Unit::none, {.offset = 1});

/// Codes of the sound in a command or a status.
struct SoundValues {
  Items<NamedValue> sound;     ///< which sound
  Items<NamedValue> speed;     ///< double speed
  Items<NamedValue> city;      ///< sound for the city or the land
  Items<NamedValue> function;  ///< on or off
  Items<NamedValue> day;       ///< day or night
};
/// Fields of the sound.
constexpr auto sound_fields(const SoundValues& values, std::string_view city_description,
                            const ValueInfo& volume) {
  return side_by_side(field(8, "additional sound", "which sound", values.sound),
                      field(2, "swds", "sound with double speed", values.speed), reserved<6>(),
                      field(2, "scl", city_description, values.city),
                      field(2, "sor", "sound order readiness", values.function),
                      field(2, "ato", "acoustic test operation", values.function),
                      field(2, "svdn", "sound volume day/night", values.day),
                      field(6, "sound volume", "step of the volume", volume),
                      field(2, "vdva", "velocity dependent volume adjustment", values.function));
}
inline constexpr auto speed_commands =
    command_values<2>("Play the sound with normal speed", "Play the sound with double speed");
inline constexpr auto city_commands =
    command_values<2>("Switch to land sound signal", "Switch to city sound signal");
inline constexpr auto day_commands =
    command_values<2>("Switch to day sound signal", "Switch to night sound signal");
inline constexpr auto sound_command_1_fields = sound_fields({.sound = additional_sound_commands,
                                                             .speed = speed_commands,
                                                             .city = city_commands,
                                                             .function = turn_commands,
                                                             .day = day_commands},
                                                            "switch city/land", volume_command);
inline constexpr auto sound_command_2_fields =
    side_by_side(field(2, "aac", "audio active command", turn_commands), reserved<2, 15>());
inline constexpr EntryInfo sound_command_roof_bar_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Sound command 1", command(DataType::unsigned32, sound_command_1_fields)),
    at(2, "Sound command 2", command(DataType::unsigned32, sound_command_2_fields))};
inline constexpr auto sound_command_roof_bar_object =
    array_object(0x613A, "Sound command roof bar", "4.2.21.3", "Sounds the roof bar.",
                 sound_command_roof_bar_entries, {.errata = "Z08, Z09, Z28"});

// 02h and 03h of swds are printed like those of a command (errata Z10).
inline constexpr auto speed_states = status_values<2>("The sound is playing with normal speed",
                                                      "The sound is playing with double speed");
inline constexpr auto city_states =
    status_values<2>("Land sound signal is on", "City sound signal is on");
inline constexpr auto turned_states =
    status_values<2>("Function is turned off", "Function is turned on");
inline constexpr auto day_states =
    status_values<2>("Day sound signal is on", "Night sound signal is on");
inline constexpr auto speaker_states = status_values<2>("Not defined", "Speaker is OK");
inline constexpr auto sound_status_1_fields = sound_fields({.sound = additional_sound_states,
                                                            .speed = speed_states,
                                                            .city = city_states,
                                                            .function = turned_states,
                                                            .day = day_states},
                                                           "sound city/land", volume_status);
inline constexpr auto sound_status_2_fields = side_by_side(
    field(2, "aas", "audio active status", turned_states),
    field(2, "speak", "speaker", speaker_states),
    field(2, "rbslv", "roof bar sound local voltage", local_voltages), reserved<2, 13>());
inline constexpr EntryInfo sound_status_roof_bar_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Sound status 1",
       status(DataType::unsigned32, Mapping::by_default, sound_status_1_fields)),
    at(2, "Sound status 2",
       status(DataType::unsigned32, Mapping::by_default, sound_status_2_fields))};
inline constexpr auto sound_status_roof_bar_object =
    array_object(0x613B, "Sound status roof bar", "4.2.21.4", "What the roof bar sounds.",
                 sound_status_roof_bar_entries, {.errata = "Z08, Z10, Z35, Z45"});

// 4.2.22: flashers of the car.

/// Fields of the flashers, two bits each.
constexpr auto blue_flashers(Items<NamedValue> values) {
  return side_by_side(
      field(2, "ffr", "front flasher right", values), field(2, "ffl", "front flasher left", values),
      field(2, "rfr", "rear flasher right", values), field(2, "rfl", "rear flasher left", values),
      field(2, "sfr", "side flasher right", values), field(2, "sfl", "side flasher left", values),
      field(2, "tlfr", "trunk lid flasher right", values),
      field(2, "tlfl", "trunk lid flasher left", values),
      field(2, "mfr", "mirror flasher right", values),
      field(2, "mfl", "mirror flasher left", values), reserved<2, 6>());
}
inline constexpr auto blue_light_flasher_command_fields = blue_flashers(turn_commands);
inline constexpr auto blue_light_flasher_command_object = variable_object(
    0x6140, "\"Blue\" light flasher command", "4.2.22.1", "Switches the flashers.",
    command(DataType::unsigned32, blue_light_flasher_command_fields), {.errata = "Z05, Z25"});
inline constexpr auto blue_light_flasher_status_fields = blue_flashers(turned_states);
inline constexpr auto blue_light_flasher_status_object = variable_object(
    0x6141, "\"Blue\" light flasher status", "4.2.22.2", "Which flashers are on.",
    status(DataType::unsigned32, Mapping::by_default, blue_light_flasher_status_fields),
    {.errata = "Z05, Z45"});

}  // namespace canvoy::cia447
