// CiA 447-3: handles for application code, of fire extinguishing, fresh air, power supply, discrete
// inputs and the terminal (4.2.5 to 4.2.9).
//
//     Values terminal(node.dictionary());
//     terminal[cia447::display_1_command] = cia447::AccessCommand::lock;
//     terminal[cia447::icon_display_1_command_content[2]] = cia447::Icon::bell;  // icon 2
#pragma once

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/terminal.hpp"
#include "canvoy/profiles/cia447/vehicle_systems.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.5.

inline constexpr State<FireExtinguishing, fire_extinguishing_system_status_object, "",
                       "fire extinguishing system status">
    fire_extinguishing_system_status;

// 4.2.6.

inline constexpr State<FreshAir, emergency_fresh_air_system_status_object, "",
                       "emergency fresh-air system status">
    emergency_fresh_air_system_status;

// 4.2.7.

inline constexpr State<Signal, radio_power_supply_status_object, "", "radio power on">
    radio_power_supply_status_on;
inline constexpr State<Signal, radio_power_supply_status_object, "", "after run active">
    radio_power_supply_status_after_run_active;
inline constexpr State<Signal, radio_power_supply_status_object, "", "5murpco">
    radio_power_supply_status_cut_off_in_5_minutes;
inline constexpr State<Signal, radio_power_supply_status_object, "", "radio overload">
    radio_power_supply_status_overload;
inline constexpr State<Order, radio_power_supply_command_object, "", "radio power off">
    radio_power_supply_command_off;

inline constexpr State<Signal, periphery_power_supply_status_object, "", "periphery power on">
    periphery_power_supply_status_on;
inline constexpr State<Signal, periphery_power_supply_status_object, "", "after run active">
    periphery_power_supply_status_after_run_active;
inline constexpr State<Signal, periphery_power_supply_status_object, "", "5muppco">
    periphery_power_supply_status_cut_off_in_5_minutes;
inline constexpr State<Signal, periphery_power_supply_status_object, "", "periphery overload">
    periphery_power_supply_status_overload;
inline constexpr State<Order, periphery_power_supply_command_object, "", "periphery power off">
    periphery_power_supply_command_off;

// 4.2.8.

inline constexpr State<Signal, discrete_inputs_status_object, "", "taximeter di">
    discrete_inputs_status_taximeter_di;
inline constexpr State<Signal, discrete_inputs_status_object, "", "PTT di">
    discrete_inputs_status_ptt_di;
inline constexpr State<Signal, discrete_inputs_status_object, "", "occupdet di">
    discrete_inputs_status_occupdet_di;
inline constexpr State<Signal, discrete_inputs_status_object, "", "roof sign di">
    discrete_inputs_status_roof_sign_di;
inline constexpr State<Signal, discrete_inputs_status_object, "", "beacon sdi">
    discrete_inputs_status_beacon_sdi;

// 4.2.9.

inline constexpr State<TerminalAccess, number_pad_status_object, "", "number pad access">
    number_pad_status_access;
inline constexpr State<AccessCommand, number_pad_command_object, "", "number pad command">
    number_pad_command;
inline constexpr State<NumberPadKey, number_pad_user_interaction_object, "", "number pad">
    number_pad_user_interaction;
inline constexpr State<TerminalAccess, function_keys_status_object, "", "function key access">
    function_keys_status_key_access;
inline constexpr State<AccessCommand, function_keys_command_object, "", "function key command">
    function_keys_command_key;
inline constexpr State<FunctionKey, function_keys_user_interaction_object, "", "function key">
    function_keys_user_interaction_key;
inline constexpr State<TerminalAccess, control_keys_status_object, "", "control key access">
    control_keys_status_key_access;
inline constexpr State<AccessCommand, control_keys_command_object, "", "control keys command">
    control_keys_command;
inline constexpr State<ControlKey, control_keys_user_interaction_object, "", "control key">
    control_keys_user_interaction_key;
inline constexpr State<TerminalAccess, steering_wheel_switch_pad_status_object, "",
                       "steering wheel switch pad access">
    steering_wheel_switch_pad_status_access;
inline constexpr State<AccessCommand, steering_wheel_switch_pad_command_object, "",
                       "steering wheel switch pad access command">
    steering_wheel_switch_pad_command_access;
inline constexpr State<TipSwitch, steering_wheel_switch_pad_user_interaction_object, "",
                       "steering wheel switch pad interaction">
    steering_wheel_switch_pad_user_interaction;
inline constexpr State<TerminalAccess, emergency_key_status_object, "", "emergency key access">
    emergency_key_status_access;
inline constexpr State<AccessCommand, emergency_key_command_object, "",
                       "emergency key access command">
    emergency_key_command_access;
inline constexpr State<Signal, emergency_key_user_interaction_object, "",
                       "emergency key interaction">
    emergency_key_user_interaction;

inline constexpr Number<display_1_parameters_object, "Line number">
    display_1_parameters_line_number;
inline constexpr Number<display_1_parameters_object, "Column number">
    display_1_parameters_column_number;
inline constexpr Number<display_1_parameters_object, "Maximal character number">
    display_1_parameters_maximal_character_number;
inline constexpr State<TerminalAccess, display_1_status_object, "", "display 1 status">
    display_1_status;
inline constexpr State<AccessCommand, display_1_command_object, "", "display 1 command">
    display_1_command;
inline constexpr Text<display_1_text_object> display_1_text;
inline constexpr Text<display_1_title_object> display_1_title;

inline constexpr Number<display_2_parameters_object, "Line number">
    display_2_parameters_line_number;
inline constexpr Number<display_2_parameters_object, "Column number">
    display_2_parameters_column_number;
inline constexpr Number<display_2_parameters_object, "Maximal character number">
    display_2_parameters_maximal_character_number;
inline constexpr State<TerminalAccess, display_2_status_object, "", "display 2 status">
    display_2_status;
inline constexpr State<AccessCommand, display_2_command_object, "", "display 2 command">
    display_2_command;
inline constexpr Text<display_2_text_object> display_2_text;
inline constexpr State<Order, buzzer_command_object, "", "buzzer command"> buzzer_command;

inline constexpr State<Signal, functional_warnings_status_object, "", "fesce">
    functional_warnings_status_fire_extinguishing_system_cartridge_empty;
inline constexpr State<Signal, functional_warnings_status_object, "", "fesa">
    functional_warnings_status_fire_extinguishing_system_active;
inline constexpr State<Signal, functional_warnings_status_object, "", "feso">
    functional_warnings_status_fire_extinguishing_system_on;
inline constexpr State<Signal, functional_warnings_status_object, "", "fesf">
    functional_warnings_status_fire_extinguishing_system_fault;
inline constexpr State<Signal, functional_warnings_status_object, "", "fasce">
    functional_warnings_status_fresh_air_system_cylinder_empty;
inline constexpr State<Signal, functional_warnings_status_object, "", "fasa">
    functional_warnings_status_fresh_air_system_active;
inline constexpr State<Signal, functional_warnings_status_object, "", "fasi">
    functional_warnings_status_fresh_air_system_inactive;
inline constexpr State<WarningCommand, functional_warnings_command_object>
    functional_warnings_command;

inline constexpr State<AccessCommand, icon_display_1_command_object, "Icon 1 command", "command">
    icon_display_1_command;
inline constexpr State<Icon, icon_display_1_command_object, "Icon 1 command", "icon content">
    icon_display_1_command_content;
inline constexpr State<IconFormat, icon_display_1_command_object, "Icon 1 command", "format">
    icon_display_1_command_format;

inline constexpr State<IconAccess, icon_display_1_status_object, "Icon 1 status", "status">
    icon_display_1_status;
inline constexpr State<Icon, icon_display_1_status_object, "Icon 1 status", "icon content">
    icon_display_1_status_content;
inline constexpr State<IconFormat, icon_display_1_status_object, "Icon 1 status", "format">
    icon_display_1_status_format;

inline constexpr State<AccessCommand, icon_display_2_command_object, "Icon 1 command", "command">
    icon_display_2_command;
inline constexpr State<Icon, icon_display_2_command_object, "Icon 1 command", "icon content">
    icon_display_2_command_content;
inline constexpr State<IconFormat, icon_display_2_command_object, "Icon 1 command", "format">
    icon_display_2_command_format;

inline constexpr State<IconAccess, icon_display_2_status_object, "Icon 1 status", "status">
    icon_display_2_status;
inline constexpr State<Icon, icon_display_2_status_object, "Icon 1 status", "icon content">
    icon_display_2_status_content;
inline constexpr State<IconFormat, icon_display_2_status_object, "Icon 1 status", "format">
    icon_display_2_status_format;

}  // namespace canvoy::cia447
