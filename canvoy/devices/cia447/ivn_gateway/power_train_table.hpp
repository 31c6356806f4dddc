// Reactions of cruise control and four-wheel drive to commands, and the states of engine and gear,
// which are reported (CiA 447-3, 4.2.4). At power-on the car is parked.
#pragma once

#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* power_train_commands[] = {&cruise_control_command_object,
                                                             &four_wheel_drive_command_object};

inline constexpr Mirror power_train_mirrors[] = {
    {&cruise_control_command_object, &cruise_control_status_object, 0ms},
    {&four_wheel_drive_command_object, &four_wheel_drive_status_object, 500ms}};

/// There is no code for a car that neither accelerates nor decelerates (errata C1).
inline constexpr Effect power_train_effects[] = {
    pulse(cruise_control_command_accelerate_decelerate, Acceleration::accelerate,
          cruise_control_status_accelerate_decelerate, Acceleration::accelerate,
          Acceleration::not_available, 1s),
    pulse(cruise_control_command_accelerate_decelerate, Acceleration::decelerate,
          cruise_control_status_accelerate_decelerate, Acceleration::decelerate,
          Acceleration::not_available, 1s)};

inline constexpr Rest power_train_rests[] = {
    rest(actual_engine_revolutions_terminal_61, Signal::no),
    rest(engine_status, Engine::off),
    rest(transmission_selector_lever_position, SelectorLever::parking),
    rest(automatic_gear_mode, GearMode::comfort),
    rest(parking_brake, Signal::yes),
    rest(coupling_switch, Signal::no),
    rest(engaged_gear, Gear::none),
    rest(cruise_control_status_accelerate_decelerate, Acceleration::not_available),
    rest(cruise_control_status_store, StoredSpeed::released)};

inline constexpr SwitchedTable power_train_table = {.commands = power_train_commands,
                                                    .mirrors = power_train_mirrors,
                                                    .effects = power_train_effects,
                                                    .rests = power_train_rests};

}  // namespace canvoy::cia447
