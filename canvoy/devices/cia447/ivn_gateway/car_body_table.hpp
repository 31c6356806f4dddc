// Reactions of the car body to commands, and their duration (CiA 447-3, 4.2.2). Times are those of
// a typical car. At power-on the car is parked: locked, closed, empty.
#pragma once

#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* car_body_commands[] = {
    &switch_illumination_level_command_object,
    &central_locking_system_command_object,
    &window_command_object,
    &door_command_object,
    &car_flap_command_object,
    &wiper_system_command_object,
    &heating_and_air_conditioner_command_object,
    &user_selected_language_command_object};

inline constexpr Mirror car_body_mirrors[] = {
    {&switch_illumination_level_command_object, &switch_illumination_level_status_object, 0ms},
    {&wiper_system_command_object, &wiper_system_status_object, 100ms},
    {&heating_and_air_conditioner_command_object, &heating_and_air_conditioner_status_object,
     100ms},
    {&user_selected_language_command_object, &user_selected_language_status_object, 0ms}};

namespace body_parts {

/// Effects of opening and closing, each with a motion.
template <class Command, class Status>
constexpr std::array<Effect, 2> opening(const Command& command, const Status& status,
                                        Duration takes) {
  return {
      effect(command, OpeningCommand::open, status, Opening::is_getting_open, Opening::open, takes),
      effect(command, OpeningCommand::close, status, Opening::is_getting_closed, Opening::closed,
             takes)};
}
/// Effects of opening and closing a flap.
template <class Command, class Status>
constexpr std::array<Effect, 2> flap(const Command& command, const Status& status, Duration takes) {
  return {effect(command, FlapCommand::close, status, Flap::is_getting_closed, Flap::closed, takes),
          effect(command, FlapCommand::open, status, Flap::is_getting_open, Flap::open, takes)};
}
/// Tops and back doors can be stopped (errata A8).
template <class Command, class Status>
constexpr std::array<Effect, 2> flap_stop(const Command& command, const Status& status) {
  return {stop(command, FlapCommand::stop, status, Flap::is_getting_closed, Flap::stopped),
          stop(command, FlapCommand::stop, status, Flap::is_getting_open, Flap::stopped)};
}

/// Effect of a command on a sliding roof that is in state `from`.
constexpr Effect roof_goes(SlidingRoofCommand command, SlidingRoof from, SlidingRoof moving,
                           SlidingRoof done, Duration takes) {
  Effect made = effect(car_flap_command_sliding_roof, command, car_flap_status_sliding_roof, moving,
                       done, takes);
  made.from = static_cast<std::uint32_t>(from);
  return made;
}
/// Effect of the command to stop on a roof that moves.
constexpr Effect roof_stops(SlidingRoof moving, SlidingRoof stopped) {
  return stop(car_flap_command_sliding_roof, SlidingRoofCommand::stop, car_flap_status_sliding_roof,
              moving, stopped);
}
/// One way to open a roof: tilt or slide. A roof that is open in the other way has to be closed
/// first; until then commands have no effect. Command and status have different codes (errata C3).
struct RoofWay {
  SlidingRoofCommand open_command;   ///< command that opens it this way
  SlidingRoofCommand close_command;  ///< command that closes it again
  SlidingRoof open;                  ///< status
  SlidingRoof is_getting_open;       ///< status during the motion
  SlidingRoof is_getting_closed;     ///< status during the motion
  SlidingRoof stopped;               ///< status after a stop on the way
  Duration takes;                    ///< from one end to the other
};
/// All effects of one way to open a roof.
constexpr std::array<Effect, 8> sliding_roof(const RoofWay& way) {
  const auto opens = [&](SlidingRoof from) {
    return roof_goes(way.open_command, from, way.is_getting_open, way.open, way.takes);
  };
  const auto closes = [&](SlidingRoof from) {
    return roof_goes(way.close_command, from, way.is_getting_closed, SlidingRoof::closed,
                     way.takes);
  };
  return {opens(SlidingRoof::closed),
          opens(way.is_getting_closed),
          opens(way.stopped),
          closes(way.open),
          closes(way.is_getting_open),
          closes(way.stopped),
          roof_stops(way.is_getting_open, way.stopped),
          roof_stops(way.is_getting_closed, way.stopped)};
}
/// Its rear edge rises.
inline constexpr RoofWay roof_tilt = {.open_command = SlidingRoofCommand::open_tilt,
                                      .close_command = SlidingRoofCommand::close_tilt,
                                      .open = SlidingRoof::open_tilt,
                                      .is_getting_open = SlidingRoof::is_getting_open_tilt,
                                      .is_getting_closed = SlidingRoof::is_getting_closed_tilt,
                                      .stopped = SlidingRoof::stopped_tilt,
                                      .takes = 2s};
/// It goes back.
inline constexpr RoofWay roof_slide = {.open_command = SlidingRoofCommand::open_slide,
                                       .close_command = SlidingRoofCommand::close_slide,
                                       .open = SlidingRoof::open_slide,
                                       .is_getting_open = SlidingRoof::is_getting_open_slide,
                                       .is_getting_closed = SlidingRoof::is_getting_closed_slide,
                                       .stopped = SlidingRoof::stopped_slide,
                                       .takes = 4s};

/// Effect of a command for the central locking.
constexpr Effect locks(Locking how) {
  return effect(central_locking_system_command, how, central_locking_system_status, how, 300ms);
}

}  // namespace body_parts

/// Of the central locking: 300 ms for each state.
inline constexpr auto locking_effects = std::array{
    body_parts::locks(Locking::unlocked), body_parts::locks(Locking::internal),
    body_parts::locks(Locking::external), body_parts::locks(Locking::selective_unlocked)};

/// Of the six windows: 3 s from one end to the other.
inline constexpr auto window_effects =
    join(body_parts::opening(window_command_driver, window_status_driver, 3s),
         body_parts::opening(window_command_front_passenger, window_status_front_passenger, 3s),
         body_parts::opening(window_command_rear_right, window_status_rear_right, 3s),
         body_parts::opening(window_command_rear_left, window_status_rear_left, 3s),
         body_parts::opening(window_command_3rd_row_right, window_status_3rd_row_right, 3s),
         body_parts::opening(window_command_3rd_row_left, window_status_3rd_row_left, 3s));

/// Of the four doors: 4 s from one end to the other.
inline constexpr auto door_effects =
    join(body_parts::opening(door_command_driver, door_status_driver, 4s),
         body_parts::opening(door_command_front_passenger, door_status_front_passenger, 4s),
         body_parts::opening(door_command_rear_right, door_status_rear_right, 4s),
         body_parts::opening(door_command_rear_left, door_status_rear_left, 4s));

/// Of hoods, lids, convertible top, back door (both can be stopped), and sliding roof: 0.5 s to 12
/// s.
inline constexpr auto flap_effects =
    join(body_parts::flap(car_flap_command_engine_hood, car_flap_status_engine_hood, 1s),
         body_parts::flap(car_flap_command_fuel_door, car_flap_status_fuel_door, 500ms),
         body_parts::flap(car_flap_command_boot_lid, car_flap_status_boot_lid, 3s),
         body_parts::flap(car_flap_command_boot_lid_window, car_flap_status_boot_lid_window, 1s),
         body_parts::flap(car_flap_command_convertible_top, car_flap_status_convertible_top, 12s),
         body_parts::flap_stop(car_flap_command_convertible_top, car_flap_status_convertible_top),
         body_parts::flap(car_flap_command_back_door, car_flap_status_back_door, 5s),
         body_parts::flap_stop(car_flap_command_back_door, car_flap_status_back_door),
         body_parts::sliding_roof(body_parts::roof_tilt),
         body_parts::sliding_roof(body_parts::roof_slide));

/// Of wipers and air conditioner.
inline constexpr auto comfort_effects = std::array{
    // One stroke of the wipers, which ends when they are switched off.
    pulse(wiper_system_command_front, Order::on, wiper_system_status_front, Wiper::on, Wiper::off,
          1s),
    effect(wiper_system_command_front, Order::off, wiper_system_status_front, Wiper::off, 0ms),
    // Codes of the command are steps, those of the status say whether it is active (errata A8).
    effect(heating_and_air_conditioner_command_temperature, TemperatureStep::deactivate,
           heating_and_air_conditioner_status_temperature, Signal::off, 100ms),
    effect(heating_and_air_conditioner_command_temperature, TemperatureStep::warmer,
           heating_and_air_conditioner_status_temperature, Signal::on, 100ms),
    effect(heating_and_air_conditioner_command_temperature, TemperatureStep::colder,
           heating_and_air_conditioner_status_temperature, Signal::on, 100ms)};

/// All of them, for the table of the function group "car body electronics".
inline constexpr auto car_body_effects =
    join(locking_effects, window_effects, door_effects, flap_effects, comfort_effects);

inline constexpr Rest car_body_rests[] = {
    rest(ignition_switch_status_lock, Signal::no),
    rest(ignition_switch_status_accessory, Signal::no),
    rest(ignition_switch_status_on, Signal::no),
    rest(ignition_switch_status_start, Signal::no),
    rest(central_locking_system_status, Locking::external),
    rest(window_status_driver, Opening::closed),
    rest(window_status_front_passenger, Opening::closed),
    rest(window_status_rear_right, Opening::closed),
    rest(window_status_rear_left, Opening::closed),
    rest(window_status_3rd_row_right, Opening::closed),
    rest(window_status_3rd_row_left, Opening::closed),
    rest(door_status_driver, Opening::closed),
    rest(door_status_front_passenger, Opening::closed),
    rest(door_status_rear_right, Opening::closed),
    rest(door_status_rear_left, Opening::closed),
    rest(turn_indicator_reset_status_right, Signal::no),
    rest(turn_indicator_reset_status_left, Signal::no),
    rest(occupant_classification_status_driver, Signal::no),
    rest(occupant_classification_status_front_passenger, Signal::no),
    rest(occupant_classification_status_rear_right_passenger, Signal::no),
    rest(occupant_classification_status_rear_left_passenger, Signal::no),
    rest(occupant_classification_status_rear_middle_passenger, Signal::no),
    rest(occupant_classification_status_3rd_row_right_passenger, Signal::no),
    rest(occupant_classification_status_3rd_row_left_passenger, Signal::no),
    rest(occupant_classification_status_3rd_row_middle_passenger, Signal::no),
    rest(buckle_switch_status_driver, Signal::no),
    rest(buckle_switch_status_front_passenger, Signal::no),
    rest(buckle_switch_status_rear_right, Signal::no),
    rest(buckle_switch_status_rear_left, Signal::no),
    rest(buckle_switch_status_rear_middle, Signal::no),
    rest(buckle_switch_status_3rd_row_right, Signal::no),
    rest(buckle_switch_status_3rd_row_left, Signal::no),
    rest(buckle_switch_status_3rd_row_middle, Signal::no),
    rest(user_selected_language_status, Language::english),
    rest(day_night_detection, DayNight::day),
    rest(accident_detection_airbag_released, Signal::no),
    rest(accident_detection_presafe_acceleration_threshold_exceeded, Signal::no),
    rest(accident_detection_motor_stop, Signal::no),
    rest(accident_detection, Signal::no),
    rest(tester_present_uds_diagnose_session, Signal::no)};

inline constexpr SwitchedTable car_body_table = {.commands = car_body_commands,
                                                 .mirrors = car_body_mirrors,
                                                 .effects = car_body_effects,
                                                 .rests = car_body_rests};

}  // namespace canvoy::cia447
