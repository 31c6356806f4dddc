// Reactions of lights and signals of the car to commands (CiA 447-3, 4.2.3).
#pragma once

#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* car_light_commands[] = {
    &car_light_command_object, &car_interior_light_command_object,
    &anti_theft_warning_system_command_object, &horn_command_object,
    &flashing_light_command_object};

inline constexpr Mirror car_light_mirrors[] = {
    {&car_light_command_object, &car_light_status_object, 50ms},
    {&car_interior_light_command_object, &car_interior_light_status_object, 50ms},
    {&flashing_light_command_object, &flashing_light_status_object, 50ms}};

inline constexpr Effect car_light_effects[] = {
    // A tip of the lever causes three flashes.
    pulse(car_light_command_tip_turn_indication_right, Order::on,
          car_light_status_tip_turn_indication_right, Signal::on, Signal::off, 2s),
    effect(car_light_command_tip_turn_indication_right, Order::off,
           car_light_status_tip_turn_indication_right, Signal::off, 0ms),
    pulse(car_light_command_tip_turn_indication_left, Order::on,
          car_light_status_tip_turn_indication_left, Signal::on, Signal::off, 2s),
    effect(car_light_command_tip_turn_indication_left, Order::off,
           car_light_status_tip_turn_indication_left, Signal::off, 0ms),

    // Code 1 is "pre-active" in the status and "do not trigger" in the command (errata C4).
    effect(anti_theft_warning_system_command, AntiTheftCommand::disable,
           anti_theft_warning_system_status, AntiTheft::disabled, 200ms),
    effect(anti_theft_warning_system_command, AntiTheftCommand::activate,
           anti_theft_warning_system_status, AntiTheft::pre_active, AntiTheft::active, 10s),
    effect(anti_theft_warning_system_command, AntiTheftCommand::trigger,
           anti_theft_warning_system_status, AntiTheft::triggered, 0ms),
    effect_from(anti_theft_warning_system_command, AntiTheftCommand::do_not_trigger,
                anti_theft_warning_system_status, AntiTheft::triggered, AntiTheft::active),

    effect(horn_command, Order::off, horn_status, Signal::off, 50ms),
    effect(horn_command, Order::on, horn_status, Signal::on, 50ms)};

inline constexpr SwitchedTable car_light_table = {
    .commands = car_light_commands, .mirrors = car_light_mirrors, .effects = car_light_effects};

}  // namespace canvoy::cia447
