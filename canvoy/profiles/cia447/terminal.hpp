// CiA 447-3, clause 4.2.9: the terminal: keys, displays, buzzer, warnings. Of two displays, the
// first is the primary one, and the second extends it.
#pragma once

#include "canvoy/profiles/cia447/access_names.hpp"
#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// Keys: holder, requests, and the pressed key.

inline constexpr auto access_commands =
    command_values<2>("Release (control device by vehicle standard application)",
                      "Lock (control device by car add-on device application)");

inline constexpr auto number_pad_access_texts =
    access_texts("Number pad access is not active", "Number pad access");
inline constexpr auto number_pad_access_states = access_values(number_pad_access_texts);
inline constexpr auto number_pad_status_fields = side_by_side(
    field(5, "number pad access", "who has it", number_pad_access_states), reserved<1, 3>());
inline constexpr auto number_pad_status_object = variable_object(
    0x6080, "Number pad status", "4.2.9.2", "Who has the number pad.",
    status(DataType::unsigned8, Mapping::by_default, number_pad_status_fields), {.errata = "D8"});
inline constexpr auto number_pad_command_fields = side_by_side(
    field(2, "number pad command", "who is to have it", access_commands), reserved<2, 3>());
inline constexpr auto number_pad_command_object = variable_object(
    0x6081, "Number pad command", "4.2.9.3", "Takes the number pad, or gives it back.",
    command(DataType::unsigned8, number_pad_command_fields), {.errata = "A4"});
inline constexpr auto number_pad_keys = status_values<5>(
    "No key pressed", "Key 1 pressed", "Key 2 pressed", "Key 3 pressed", "Key 4 pressed",
    "Key 5 pressed", "Key 6 pressed", "Key 7 pressed", "Key 8 pressed", "Key 9 pressed",
    "Key # pressed", "Key 0 pressed", "Key * pressed", "More than one key pressed");
inline constexpr auto number_pad_user_interaction_fields =
    side_by_side(field(5, "number pad", "the key", number_pad_keys), reserved<1, 3>());
inline constexpr auto number_pad_user_interaction_object = variable_object(
    0x6082, "Number pad user interaction", "4.2.9.4", "The key that is pressed.",
    status(DataType::unsigned8, Mapping::by_default, number_pad_user_interaction_fields),
    {.errata = "C6"});

inline constexpr auto function_key_access_texts =
    access_texts("Function key access is not active", "Function key access");
inline constexpr auto function_key_access_states = access_values(function_key_access_texts);
inline constexpr auto function_keys_status_fields = side_by_side(
    field(5, "function key access", "who has them", function_key_access_states), reserved<1, 3>());
inline constexpr auto function_keys_status_object =
    variable_object(0x6085, "Function keys status", "4.2.9.5", "Who has the function keys.",
                    status(DataType::unsigned8, Mapping::by_default, function_keys_status_fields),
                    {.errata = "D8"});
inline constexpr auto function_keys_command_fields = side_by_side(
    field(2, "function key command", "who is to have them", access_commands), reserved<2, 3>());
inline constexpr auto function_keys_command_object = variable_object(
    0x6086, "Function keys command", "4.2.9.6", "Takes the function keys, or gives them back.",
    command(DataType::unsigned8, function_keys_command_fields), {.errata = "B2, D10"});
inline constexpr auto function_keys = status_values<4>(
    "No key pressed", "Function key 1 pressed", "Function key 2 pressed", "Function key 3 pressed",
    "Function key 4 pressed", "Function key 5 pressed", "Function key 6 pressed",
    "Function key 7 pressed", "More than one key pressed");
inline constexpr auto function_keys_user_interaction_fields =
    side_by_side(field(4, "function key", "the key", function_keys), reserved<1, 4>());
inline constexpr auto function_keys_user_interaction_object = variable_object(
    0x6087, "Function keys user interaction", "4.2.9.7", "The function key that is pressed.",
    status(DataType::unsigned8, Mapping::by_default, function_keys_user_interaction_fields),
    {.errata = "B2"});

inline constexpr auto control_key_access_texts =
    access_texts("Control key access is not active", "Control key access");
inline constexpr auto control_key_access_states = access_values(control_key_access_texts);
inline constexpr auto control_keys_status_fields = side_by_side(
    field(5, "control key access", "who has them", control_key_access_states), reserved<1, 3>());
inline constexpr auto control_keys_status_object =
    variable_object(0x608A, "Control keys status", "4.2.9.8", "Who has the control keys.",
                    status(DataType::unsigned8, Mapping::by_default, control_keys_status_fields),
                    {.errata = "B2, D8"});
inline constexpr auto control_keys_command_fields = side_by_side(
    field(2, "control keys command", "who is to have them", access_commands), reserved<2, 3>());
inline constexpr auto control_keys_command_object = variable_object(
    0x608B, "Control keys command", "4.2.9.9", "Takes the control keys, or gives them back.",
    command(DataType::unsigned8, control_keys_command_fields), {.errata = "B2"});
inline constexpr auto control_keys = status_values<5>(
    "No key pressed", "Key \"up\" pressed", "Key \"down\" pressed", "Key \"right\" pressed",
    "Key \"left\" pressed", "Key \"turn right\" pressed", "Key \"turn left\" pressed",
    "Key \"OK\" pressed", "Key \"clear\" pressed", "Key \"return\" pressed", "Key \"send\" pressed",
    "Key \"end\" pressed", "F1 pressed", "F2 pressed", "F3 pressed", "F4 pressed",
    "More than one key pressed");
inline constexpr auto control_keys_user_interaction_fields =
    side_by_side(field(5, "control key", "the key", control_keys), reserved<1, 3>());
inline constexpr auto control_keys_user_interaction_object = variable_object(
    0x608C, "Control keys user interaction", "4.2.9.10", "The control key that is pressed.",
    status(DataType::unsigned8, Mapping::by_default, control_keys_user_interaction_fields),
    {.errata = "B3"});

inline constexpr auto steering_wheel_access_texts =
    access_texts("Steering wheel access is not active", "Steering wheel access");
inline constexpr auto steering_wheel_access_states = access_values(steering_wheel_access_texts);
inline constexpr auto steering_wheel_switch_pad_status_fields = side_by_side(
    field(5, "steering wheel switch pad access", "who has it", steering_wheel_access_states),
    reserved<1, 3>());
inline constexpr auto steering_wheel_switch_pad_status_object = variable_object(
    0x6090, "Steering wheel switch pad status", "4.2.9.11", "Who has the switches at the wheel.",
    status(DataType::unsigned8, Mapping::by_default, steering_wheel_switch_pad_status_fields),
    {.errata = "B3, D8"});
inline constexpr auto steering_wheel_switch_pad_command_fields = side_by_side(
    field(2, "steering wheel switch pad access command", "who is to have it", access_commands),
    reserved<2, 3>());
inline constexpr auto steering_wheel_switch_pad_command_object = variable_object(
    0x6091, "Steering wheel switch pad command", "4.2.9.12",
    "Takes the switches at the wheel, or gives them back.",
    command(DataType::unsigned8, steering_wheel_switch_pad_command_fields), {.errata = "B2, D10"});
inline constexpr auto tip_switches = status_values<4>(
    "No steering wheel tip switch pressed", "Steering wheel tip switch 1 pressed",
    "Steering wheel tip switch 2 pressed", "Steering wheel tip switch 3 pressed",
    "Steering wheel tip switch 4 pressed", "Steering wheel tip switch 5 pressed",
    "Steering wheel tip switch 6 pressed", "Steering wheel tip switch 7 pressed",
    "Steering wheel tip switch 8 pressed", "Steering wheel tip switch 9 pressed",
    "Steering wheel tip switch 10 pressed", "Steering wheel tip switch 11 pressed",
    "Steering wheel tip switch 12 pressed", "More than one steering wheel tip switch pressed");
inline constexpr auto steering_wheel_switch_pad_user_interaction_fields =
    side_by_side(field(4, "steering wheel switch pad interaction", "the switch", tip_switches),
                 reserved<1, 4>());
inline constexpr auto steering_wheel_switch_pad_user_interaction_object =
    variable_object(0x6092, "Steering wheel switch pad user interaction", "4.2.9.13",
                    "The switch at the wheel that is pressed.",
                    status(DataType::unsigned8, Mapping::by_default,
                           steering_wheel_switch_pad_user_interaction_fields));

inline constexpr auto emergency_key_access_texts =
    access_texts("Emergency key access is not active", "Emergency key access");
inline constexpr auto emergency_key_access_states = access_values(emergency_key_access_texts);
inline constexpr auto emergency_key_status_fields = side_by_side(
    field(5, "emergency key access", "who has it", emergency_key_access_states), reserved<1, 3>());
inline constexpr auto emergency_key_status_object =
    variable_object(0x6093, "Emergency key status", "4.2.9.14", "Who has the emergency key.",
                    status(DataType::unsigned8, Mapping::by_default, emergency_key_status_fields),
                    {.errata = "B2, D8"});
inline constexpr auto emergency_key_command_fields =
    side_by_side(field(2, "emergency key access command", "who is to have it", access_commands),
                 reserved<2, 3>());
inline constexpr auto emergency_key_command_object = variable_object(
    0x6094, "Emergency key command", "4.2.9.15", "Takes the emergency key, or gives it back.",
    command(DataType::unsigned8, emergency_key_command_fields), {.errata = "B2, D10"});
inline constexpr auto emergency_key_states =
    status_values<2>("No emergency key pressed", "Emergency key pressed");
inline constexpr auto emergency_key_user_interaction_fields = side_by_side(
    field(2, "emergency key interaction", "the key", emergency_key_states), reserved<1, 6>());
inline constexpr auto emergency_key_user_interaction_object = variable_object(
    0x6095, "Emergency key user interaction", "4.2.9.16", "Whether the emergency key is pressed.",
    status(DataType::unsigned8, Mapping::by_default, emergency_key_user_interaction_fields),
    {.errata = "B2"});

// Displays.

/// 254 codes for the numbers 1 to 254: raw 00h is 1 (errata A6).
inline constexpr ValueInfo one_based = measured<8>(Unit::none, {.offset = 1});
inline constexpr EntryInfo display_parameter_entries[] = {
    highest_sub_index(3, 3),
    at(1, "Line number", status(DataType::unsigned8, Mapping::no, one_based)),
    at(2, "Column number", status(DataType::unsigned8, Mapping::no, one_based)),
    at(3, "Maximal character number", status(DataType::unsigned8, Mapping::no, one_based))};
/// As many characters of 8 bits as the parameters of a display can express.
inline constexpr std::uint16_t display_text_capacity = 254;

inline constexpr auto display_access_texts = access_texts("Off", "On and access");
inline constexpr auto display_states = access_values(display_access_texts);

inline constexpr auto display_1_parameters_object =
    array_object(0x6096, "Display 1 parameters", "4.2.9.17", "How much the display can show.",
                 display_parameter_entries, {.errata = "A6, D8, D9"});
inline constexpr auto display_1_status_fields =
    side_by_side(field(5, "display 1 status", "who has it", display_states), reserved<3>());
inline constexpr auto display_1_status_object =
    variable_object(0x6097, "Display 1 status", "4.2.9.18", "Who has the display.",
                    status(DataType::unsigned8, Mapping::by_default, display_1_status_fields),
                    {.errata = "B2, D8"});
// No code is left for "Function not implemented" (errata A7).
inline constexpr auto display_1_commands =
    three_commands("Release (control device by vehicle standard application)",
                   "Lock device for car add-on device application (usage of CANopen objects)",
                   "Lock device for ISO-TP transmitted content");
inline constexpr auto display_1_command_fields = side_by_side(
    field(2, "display 1 command", "who is to have it", display_1_commands), reserved<6>());
inline constexpr auto display_1_command_object =
    variable_object(0x6098, "Display 1 command", "4.2.9.19", "Takes the display, or gives it back.",
                    command(DataType::unsigned8, display_1_command_fields), {.errata = "A7, B2"});
inline constexpr auto display_1_text_object =
    variable_object(0x6099, "Display 1 text", "4.2.9.20", "What the display shows.",
                    status_text(display_text_capacity));
inline constexpr auto display_1_title_object =
    variable_object(0x609A, "Display 1 title", "4.2.9.21", "What the display shows as its title.",
                    status_text(display_text_capacity), {.errata = "C10, C11"});

inline constexpr auto display_2_parameters_object =
    array_object(0x609B, "Display 2 parameters", "4.2.9.22", "How much the display can show.",
                 display_parameter_entries, {.errata = "A6, D8, D9"});
inline constexpr auto display_2_status_fields =
    side_by_side(field(5, "display 2 status", "who has it", display_states), reserved<3>());
inline constexpr auto display_2_status_object =
    variable_object(0x609C, "Display 2 status", "4.2.9.23", "Who has the display.",
                    status(DataType::unsigned8, Mapping::by_default, display_2_status_fields),
                    {.errata = "B4, D8"});
inline constexpr auto lock_commands =
    command_values<2>("Release (control device by vehicle standard application)",
                      "Lock (lock device for car add-on device application)");
inline constexpr auto display_2_command_fields =
    side_by_side(field(2, "display 2 command", "who is to have it", lock_commands), reserved<6>());
inline constexpr auto display_2_command_object =
    variable_object(0x609D, "Display 2 command", "4.2.9.24", "Takes the display, or gives it back.",
                    command(DataType::unsigned8, display_2_command_fields), {.errata = "A7, B2"});
inline constexpr auto display_2_text_object =
    variable_object(0x609E, "Display 2 text", "4.2.9.25", "What the display shows.",
                    status_text(display_text_capacity), {.errata = "C11"});

// Buzzer and warnings.

inline constexpr auto buzzer_commands = command_values<2>("Buzzer off", "Buzzer on");
inline constexpr auto buzzer_command_fields = side_by_side(
    field(2, "buzzer command", "whether it is to sound", buzzer_commands), reserved<6>());
inline constexpr auto buzzer_command_object =
    variable_object(0x60A0, "Buzzer command", "4.2.9.26", "Sounds the buzzer.",
                    command(DataType::unsigned8, buzzer_command_fields), {.errata = "D2"});

// The figure has the fields one bit higher and leaves bit 0 unused. Here they start at bit 0, as
// everywhere. The other reading is selectable (Profile::readings).
inline constexpr auto warning_states = status_values<2>("Warning not active", "Warning is active");
inline constexpr auto functional_warnings =
    side_by_side(field(2, "fesce", "fire extinguishing system cartridge empty", warning_states),
                 field(2, "fesa", "fire extinguishing system active", warning_states),
                 field(2, "feso", "fire extinguishing system on", warning_states),
                 field(2, "fesf", "fire extinguishing system fault", warning_states),
                 field(2, "fasce", "fresh air system cylinder empty", warning_states),
                 field(2, "fasa", "fresh air system active", warning_states),
                 field(2, "fasi", "fresh air system inactive", warning_states));
inline constexpr auto functional_warnings_status_fields =
    side_by_side(functional_warnings, reserved<18>());
inline constexpr auto functional_warnings_status_object =
    variable_object(0x60A1, "Functional warnings status", "4.2.9.27", "Which warnings are on.",
                    status(DataType::unsigned32, Mapping::no, functional_warnings_status_fields),
                    {.errata = "Z01"});
inline constexpr NamedValue unused_bit[] = {{1, "not used", Meaning::padding}};
inline constexpr auto functional_warnings_from_bit_1_fields =
    side_by_side(field(1, "bit 0", "not used", unused_bit), functional_warnings, reserved<17>());
inline constexpr auto functional_warnings_from_bit_1_object = variable_object(
    0x60A1, "Functional warnings status", "4.2.9.27", "Which warnings are on.",
    status(DataType::unsigned32, Mapping::no, functional_warnings_from_bit_1_fields),
    {.errata = "Z01"});

inline constexpr NamedValue functional_warning_commands[] = {
    {0x0000, "Reset all warnings"},
    {0x0001, "Reset fire extinguishing system cartridge empty"},
    {0x0002, "Reset fire extinguishing system active"},
    {0x0003, "Reset fire extinguishing system on"},
    {0x0004, "Reset fire extinguishing system fault"},
    {0x0005, "Reset fresh air system cylinder empty"},
    {0x0006, "Reset fresh air system active"},
    {0x0007, "Reset fresh air system inactive"},
    reserved_codes(0x0008, 0x8000),
    {0x8001, "Set fire extinguishing system cartridge empty"},
    {0x8002, "Set fire extinguishing system active"},
    {0x8003, "Set fire extinguishing system on"},
    {0x8004, "Set fire extinguishing system fault"},
    {0x8005, "Set fresh air system cylinder empty"},
    {0x8006, "Set fresh air system active"},
    {0x8007, "Set fresh air system inactive"},
    reserved_codes(0x8008, 0xFFFD),
    command_sentinels<16>.second_highest,
    command_sentinels<16>.highest};
inline constexpr auto functional_warnings_command_object =
    variable_object(0x60A2, "Functional warnings command", "4.2.9.28", "Sets and resets warnings.",
                    command(DataType::unsigned16, ValueInfo{.names = functional_warning_commands}));

// Icons beside the text of the displays.

/// Their names are identifiers, and stay as printed (errata Z49).
inline constexpr std::string_view icons[] = {
    "Display no icon",
    "Display icon number 1: DIN_PicAntenna",
    "Display icon number 2: DIN_PicMicro",
    "Display icon number 3: DIN_PicEmptyCircle",
    "Display icon number 4: DIN_PicFilledCircle",
    "Display icon number 5: DIN_PicSpeakerOn",
    "Display icon number 6: DIN_PicSpeakerOff",
    "Display icon number 7: DIN_PicSignalOut",
    "Display icon number 8: DIN_PicSignalIn",
    "Display icon number 9: DIN_PicGPSActive",
    "Display icon number 10: DIN_PicCrossedCircle",
    "Display icon number 11: DIN_PicBell",
    "Display icon number 12: DIN_PicClock",
    "Display icon number 13: DIN_PicSkipToEnd (search run)",
    "Display icon number 14: DIN_PicTaxameter",
};
/// A code that is reserved in a command is "Failure" in a status. A sender of a status uses the
/// second highest code (errata Z11).
template <std::size_t count>
constexpr std::array<NamedValue, count> reserved_is_failure(std::array<NamedValue, count> values) {
  for (NamedValue& value : values) {
    if (value.meaning != Meaning::reserved) continue;
    value.name = "Failure";
    value.meaning = Meaning::failure;
  }
  const NamedValue range = values[count - 3];
  values[count - 3] = values[count - 2];
  values[count - 2] = range;
  return values;
}
inline constexpr auto icon_commands = coded<8>(icons, command_sentinels<8>);
inline constexpr auto icon_states = reserved_is_failure(coded<8>(icons, status_sentinels<8>));
inline constexpr auto icon_format_commands = command_values<3>("Standard", "Highlighted");
inline constexpr auto icon_format_states =
    reserved_is_failure(status_values<3>("Standard", "Highlighted"));
inline constexpr auto icon_access_states =
    status_values<2>("Released (device controlled by vehicle standard application)",
                     "Locked (device locked for car add-on device application)");

inline constexpr auto icon_command_fields =
    side_by_side(field(2, "command", "who is to have it", lock_commands),
                 field(8, "icon content", "which icon", icon_commands),
                 field(3, "format", "how it is shown", icon_format_commands), reserved<1, 3>());
inline constexpr auto icon_status_fields =
    side_by_side(field(2, "status", "who has it", icon_access_states),
                 field(8, "icon content", "which icon", icon_states),
                 field(3, "format", "how it is shown", icon_format_states), reserved<1, 3>());
/// One icon: who is to have it, which one it is, and how it is to be shown.
constexpr EntryInfo icon_command(unsigned sub, std::string_view name,
                                 Category category = Category::optional) {
  return at(sub, name, command(DataType::unsigned16, icon_command_fields), category);
}
/// One icon: who has it, which one it is, and how it is shown.
constexpr EntryInfo icon_status(unsigned sub, std::string_view name,
                                Category category = Category::optional) {
  return at(sub, name, status(DataType::unsigned16, Mapping::no, icon_status_fields), category);
}
inline constexpr EntryInfo icon_command_entries[] = {
    highest_sub_index(1, 4), icon_command(1, "Icon 1 command", Category::mandatory),
    icon_command(2, "Icon 2 command"), icon_command(3, "Icon 3 command"),
    icon_command(4, "Icon 4 command")};
inline constexpr EntryInfo icon_status_entries[] = {
    highest_sub_index(1, 4), icon_status(1, "Icon 1 status", Category::mandatory),
    icon_status(2, "Icon 2 status"), icon_status(3, "Icon 3 status"),
    icon_status(4, "Icon 4 status")};

inline constexpr auto icon_display_1_command_object =
    array_object(0x60A6, "Icon display 1 command", "4.2.9.29", "Shows icons on display 1.",
                 icon_command_entries, {.errata = "Z20, Z24, Z48, Z49"});
inline constexpr auto icon_display_1_status_object =
    array_object(0x60A7, "Icon display 1 status", "4.2.9.30", "Icons on display 1.",
                 icon_status_entries, {.errata = "Z11, Z20, Z24, Z48, Z49"});
inline constexpr auto icon_display_2_command_object =
    array_object(0x60AA, "Icon display 2 command", "4.2.9.31", "Shows icons on display 2.",
                 icon_command_entries, {.errata = "Z20, Z24, Z48, Z49"});
inline constexpr auto icon_display_2_status_object =
    array_object(0x60AB, "Icon display 2 status", "4.2.9.32", "Icons on display 2.",
                 icon_status_entries, {.errata = "Z11, Z20, Z24, Z48, Z49"});

}  // namespace canvoy::cia447
