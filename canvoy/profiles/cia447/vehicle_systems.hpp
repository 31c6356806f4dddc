// CiA 447-3, clauses 4.2.5 to 4.2.8: fire extinguishing system, emergency fresh-air system, power
// supply of add-on devices, discrete inputs.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

inline constexpr auto fire_extinguishing_states =
    status_values<4>("Deactivated", "Standby without limitation", "Standby with limited function",
                     "Initialization", "Automatic started", "Manual started", "Activated");
inline constexpr auto fire_extinguishing_system_status_fields = side_by_side(
    field(4, "fire extinguishing system status", "what it does", fire_extinguishing_states),
    reserved<4>());
inline constexpr auto fire_extinguishing_system_status_object = variable_object(
    0x6069, "Fire extinguishing system status", "4.2.5.1",
    "What the fire extinguishing system does.",
    status(DataType::unsigned8, Mapping::by_default, fire_extinguishing_system_status_fields),
    {.errata = "D4"});

inline constexpr auto fresh_air_states =
    status_values<4>("Deactivated", "Standby without limitation", "Standby with limited function",
                     "Standby without sensory activation", "Initialization", "Manual started",
                     "Manually activated", "Automatic activated");
inline constexpr auto emergency_fresh_air_system_status_fields = side_by_side(
    field(4, "emergency fresh-air system status", "what it does", fresh_air_states), reserved<4>());
inline constexpr auto emergency_fresh_air_system_status_object = variable_object(
    0x606C, "Emergency fresh-air system status", "4.2.6.1",
    "What the emergency fresh-air system does.",
    status(DataType::unsigned8, Mapping::by_default, emergency_fresh_air_system_status_fields),
    {.errata = "D4"});

// 4.2.7: power supply of radio and periphery.

inline constexpr auto radio_power_supply_status_fields =
    side_by_side(field(2, "radio power on", "whether the radio has power", no_yes),
                 field(2, "after run active", "power although the ignition is off", no_yes),
                 field(2, "5murpco", "5 minutes until radio power cut off", no_yes),
                 field(2, "radio overload", "the radio takes too much", no_yes));
inline constexpr auto radio_power_supply_status_object = variable_object(
    0x6070, "Radio power supply status", "4.2.7.1", "Power supply of the radio.",
    status(DataType::unsigned8, Mapping::by_default, radio_power_supply_status_fields));
inline constexpr auto radio_power_requests =
    command_values<2>("No radio power off request", "Radio power off request");
inline constexpr auto radio_power_supply_command_fields = side_by_side(
    field(2, "radio power off", "whether to cut it off", radio_power_requests), reserved<2, 3>());
inline constexpr auto radio_power_supply_command_object = variable_object(
    0x6071, "Radio power supply command", "4.2.7.2", "Takes the power from the radio.",
    command(DataType::unsigned8, radio_power_supply_command_fields));

inline constexpr auto periphery_power_supply_status_fields =
    side_by_side(field(2, "periphery power on", "whether the periphery has power", no_yes),
                 field(2, "after run active", "power although the ignition is off", no_yes),
                 field(2, "5muppco", "5 minutes until periphery power cut off", no_yes),
                 field(2, "periphery overload", "the periphery takes too much", no_yes));
inline constexpr auto periphery_power_supply_status_object = variable_object(
    0x6073, "Periphery power supply status", "4.2.7.3", "Power supply of the periphery.",
    status(DataType::unsigned8, Mapping::by_default, periphery_power_supply_status_fields));
inline constexpr auto periphery_power_requests =
    command_values<2>("No periphery power off request", "Periphery power off request");
inline constexpr auto periphery_power_supply_command_fields =
    side_by_side(field(2, "periphery power off", "whether to cut it off", periphery_power_requests),
                 reserved<2, 3>());
inline constexpr auto periphery_power_supply_command_object = variable_object(
    0x6074, "Periphery power supply command", "4.2.7.4", "Takes the power from the periphery.",
    command(DataType::unsigned8, periphery_power_supply_command_fields));

// 4.2.8: discrete inputs.

inline constexpr auto input_states = status_values<2>("Input not active", "Input active");
inline constexpr auto discrete_inputs_status_fields = side_by_side(
    field(2, "taximeter di", "taximeter discrete input", input_states),
    field(2, "PTT di", "PTT discrete input", input_states),
    field(2, "occupdet di", "occupant detection discrete input", input_states),
    field(2, "roof sign di", "roof sign discrete input", input_states),
    field(2, "beacon sdi", "beacon status discrete input", input_states), reserved<2, 3>());
inline constexpr auto discrete_inputs_status_object = variable_object(
    0x6078, "Discrete inputs status", "4.2.8.1", "Which discrete inputs are active.",
    status(DataType::unsigned16, Mapping::by_default, discrete_inputs_status_fields));

}  // namespace canvoy::cia447
