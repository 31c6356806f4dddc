// CiA 447-3, clause 4.2.16: the tariff display on the roof, with up to 16 lamps.
#pragma once

#include "canvoy/profiles/cia447/taximeter.hpp"
#include "canvoy/profiles/cia447/values.hpp"
#include "canvoy/profiles/cia447/vehicle_systems.hpp"

namespace canvoy::cia447 {

inline constexpr auto power_down_states = status_values<2>("No power down", "Power down");
inline constexpr auto lamp_inputs =
    status_values<2>("CAN used", "Discrete inputs used (lamp driver input)");
inline constexpr auto lamp_driver_inputs = status_values<2>(
    "Discrete lamp driver input is not available", "Discrete lamp driver input available");
inline constexpr NamedValue lamp_number_names[] = {status_sentinels<5>.second_highest,
                                                   status_sentinels<5>.highest,
                                                   {0x00, "Not defined", Meaning::invalid},
                                                   reserved_codes(0x11, 0x1D)};
inline constexpr ValueInfo lamp_number = {.limits = within(0x01, 0x10), .names = lamp_number_names};
inline constexpr auto tariff_display_information_and_status_fields = side_by_side(
    field(2, "power down", "whether it sleeps", power_down_states),
    field(2, "input", "what sets the lamps", lamp_inputs),
    field(2, "dldi", "discrete lamp driver input", lamp_driver_inputs),
    field(5, "number of lamps/lights", "how many are used", lamp_number),
    field(3, "tlc", "tariff level characters: how many", measured<3, 2>()), reserved<1, 2>());
inline constexpr auto tariff_display_information_and_status_object = variable_object(
    0x6100, "Tariff display information and status", "4.2.16.1",
    "What the tariff display has, and what sets it.",
    status(DataType::unsigned16, Mapping::no, tariff_display_information_and_status_fields),
    {.errata = "Z13"});

// Lamps: 4 bits each, 8 in an object. The first three have names.

/// Fields of lamps 1 to 8, of which the first three have names.
constexpr auto lamps_1_to_8(std::string_view numbered_name, Items<NamedValue> values) {
  return side_by_side(field(4, "taxi light", "", values), field(4, "vacant light", "", values),
                      field(4, "emcy light", "emergency light", values),
                      numbered<5>(4, numbered_name, "", values, 4));
}
inline constexpr auto lamp_failures = status_values<4>("No lamp failure", "Open load", "Over load");
inline constexpr auto lamp_states =
    status_values<4>("Lamp off", "Lamp on", "Lamp dimmed", "Lamp blinking");
inline constexpr auto lamp_commands =
    command_values<4>("Lamp off", "Lamp on", "Lamp dimmed", "Lamp blinking");

inline constexpr auto tariff_display_lamp_failures_1_fields = lamps_1_to_8("fl#", lamp_failures);
inline constexpr auto tariff_display_lamp_failures_1_object = variable_object(
    0x6101, "Tariff display lamp failures 1", "4.2.16.2", "Which of lamps 1 to 8 are broken.",
    status(DataType::unsigned32, Mapping::by_default, tariff_display_lamp_failures_1_fields),
    {.errata = "Z40, Z45"});
inline constexpr auto tariff_display_lamp_failures_2_fields =
    numbered<8>(4, "fl#", "failure lamp", lamp_failures, 9);
inline constexpr auto tariff_display_lamp_failures_2_object = variable_object(
    0x6102, "Tariff display lamp failures 2", "4.2.16.3", "Which of lamps 9 to 16 are broken.",
    status(DataType::unsigned32, Mapping::no, tariff_display_lamp_failures_2_fields),
    {.errata = "Z40, Z45"});

inline constexpr auto tariff_display_inputs_status_fields =
    numbered<16>(2, "i#", "input", input_states);
inline constexpr auto tariff_display_inputs_status_object = variable_object(
    0x6103, "Tariff display inputs status", "4.2.16.4", "Which of inputs 1 to 16 are active.",
    status(DataType::unsigned32, Mapping::by_default, tariff_display_inputs_status_fields),
    {.errata = "Z37, Z45"});

inline constexpr auto tariff_display_lamps_status_1_fields = lamps_1_to_8("l#", lamp_states);
inline constexpr auto tariff_display_lamps_status_1_object = variable_object(
    0x6104, "Tariff display lamps status 1", "4.2.16.5", "What lamps 1 to 8 do.",
    status(DataType::unsigned32, Mapping::by_default, tariff_display_lamps_status_1_fields),
    {.errata = "Z40"});
inline constexpr auto tariff_display_lamps_status_2_fields =
    numbered<8>(4, "l#", "lamp", lamp_states, 9);
inline constexpr auto tariff_display_lamps_status_2_object =
    variable_object(0x6105, "Tariff display lamps status 2", "4.2.16.6", "What lamps 9 to 16 do.",
                    status(DataType::unsigned32, Mapping::no, tariff_display_lamps_status_2_fields),
                    {.errata = "Z40"});
inline constexpr auto tariff_display_lamps_command_1_fields = lamps_1_to_8("l#", lamp_commands);
inline constexpr auto tariff_display_lamps_command_1_object =
    variable_object(0x6106, "Tariff display lamps command 1", "4.2.16.7", "Sets lamps 1 to 8.",
                    command(DataType::unsigned32, tariff_display_lamps_command_1_fields));
inline constexpr auto tariff_display_lamps_command_2_fields =
    numbered<8>(4, "l#", "lamp", lamp_commands, 9);
inline constexpr auto tariff_display_lamps_command_2_object =
    variable_object(0x6107, "Tariff display lamps command 2", "4.2.16.8", "Sets lamps 9 to 16.",
                    command(DataType::unsigned32, tariff_display_lamps_command_2_fields));

inline constexpr auto power_down_commands =
    command_values<2>("Do not enter the power down mode", "Enter the power down mode");
inline constexpr auto display_configurations =
    three_commands("No configuration command", "Configure via CAN: CAN operation",
                   "Configure by using discrete inputs: Discrete operation");
inline constexpr auto tariff_display_configuration_fields =
    side_by_side(field(2, "epdm", "enter power down mode", power_down_commands),
                 field(2, "configure", "what sets the lamps: 6106h and 6107h, or inputs",
                       display_configurations),
                 reserved<1, 4>());
inline constexpr auto tariff_display_configuration_object = variable_object(
    0x6109, "Tariff display configuration", "4.2.16.9",
    "Lets the display sleep; says what sets its lamps.",
    command(DataType::unsigned8, tariff_display_configuration_fields), {.errata = "Z35"});
inline constexpr auto tariff_display_tariff_level_object = variable_object(
    0x610A, "Tariff display tariff level", "4.2.16.10", "The tariff that is shown.",
    status(DataType::unsigned16, Mapping::no, tariff_level_fields), {.errata = "Z12, Z46"});

}  // namespace canvoy::cia447
