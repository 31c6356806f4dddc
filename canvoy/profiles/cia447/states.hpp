// States of CiA 447-3 for application code. A status and a command with the same codes share an
// enumeration: the second highest code is `failure` of a status and `not_implemented` of a command,
// the highest one `not_available` and `do_not_care`.
//
//     if (car[cia447::door_status_driver].is(cia447::Opening::closed)) ...
//     roof_bar[cia447::roof_bar_light_command<"mlb1">] = cia447::Order::on;
//
// The compiler checks in states_test.cpp that they have the codes of the tables.
#pragma once

#include <cstdint>

namespace canvoy::cia447 {

// Each enumeration is a row, with its sentinels behind its states.
// clang-format off

/// Most statuses of two bits.
enum class Signal : std::uint8_t {
  no = 0, off = no, yes = 1, on = yes, failure = 2, not_available = 3
};
/// Most commands of two bits.
enum class Order : std::uint8_t { off, on, not_implemented, do_not_care };

// Car body (4.2.2).

/// Central locking (6009h, 600Ah).
enum class Locking : std::uint8_t {
  unlocked, internal, external, selective_unlocked,
  failure = 0xE, not_implemented = failure, not_available = 0xF, do_not_care = not_available
};
/// State of a window or door. The codes of flaps are the other way round.
enum class Opening : std::uint8_t {
  open, closed, is_getting_open, is_getting_closed, failure = 6, not_available = 7
};
/// Command for a window or a door (600Ch, 600Eh).
enum class OpeningCommand : std::uint8_t { open, close, not_implemented, do_not_care };
/// Only tops and back doors can be stopped.
enum class Flap : std::uint8_t {
  closed, open, is_getting_closed, is_getting_open, stopped, failure = 6, not_available = 7
};
/// Code 2 stops tops and back doors. For the others it is `not_implemented`.
enum class FlapCommand : std::uint8_t { close, open, stop, not_implemented = stop, do_not_care };
/// State of a sliding roof (6010h).
enum class SlidingRoof : std::uint8_t {
  closed, open_tilt, open_slide, is_getting_closed_tilt, is_getting_closed_slide,
  is_getting_open_tilt, is_getting_open_slide, stopped_tilt, stopped_slide,
  failure = 0xE, not_available = 0xF
};
/// Command for a sliding roof (6011h).
enum class SlidingRoofCommand : std::uint8_t {
  close_tilt, close_slide, open_tilt, open_slide, stop, not_implemented = 6, do_not_care = 7
};
/// Motion of a seat, its back and its other parts, forward or backward (6018h, 6019h).
enum class SeatMotion : std::uint8_t {
  forward, backward,
  failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// Motion of a seat along its height (6018h, 6019h).
enum class SeatHeight : std::uint8_t {
  up, down, failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// Motion of the angle of a seat (6018h, 6019h).
enum class SeatAngle : std::uint8_t {
  lift, sink, failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// Memory of a seat (6018h, 6019h).
enum class SeatMemory : std::uint8_t {
  none, memory_1, memory_2, memory_3, memory_4,
  failure = 6, not_implemented = failure, not_available = 7, do_not_care = not_available
};
/// State of a wiper (601Ah).
enum class Wiper : std::uint8_t { off, on, failure = 6, not_available = 7 };
/// Stage of a wiper (601Ah, 601Bh).
enum class WiperSwitch : std::uint8_t {
  off, interval, stage_1, stage_2, automatic,
  failure = 6, not_implemented = failure, not_available = 7, do_not_care = not_available
};
/// Side of the steering wheel (601Ch).
enum class SteeringWheelSide : std::uint8_t { left, right, failure, not_available };
/// Command for the temperature (6025h).
enum class TemperatureStep : std::uint8_t { deactivate, warmer, colder, do_not_care };
/// Language of the car (602Ch, 602Dh).
enum class Language : std::uint8_t {
  german, english, french, italian, spanish, japanese, dutch = 7, danish, swedish, turkish,
  portuguese, russian,
  failure = 0x1E, not_implemented = failure, not_available = 0x1F, do_not_care = not_available
};
/// Day or night (6030h), and the volume for it (613Ah, 613Bh).
enum class DayNight : std::uint8_t {
  day, night, failure, not_implemented = failure, not_available, do_not_care = not_available
};

// Light (4.2.3).

/// Interior light (6045h, 6046h).
enum class InteriorLight : std::uint8_t {
  off, on_dimmed, on_undimmed,
  failure = 6, not_implemented = failure, not_available = 7, do_not_care = not_available
};
/// State of the anti-theft system (6047h).
enum class AntiTheft : std::uint8_t {
  disabled, pre_active, active, triggered, failure = 6, not_available = 7
};
/// Command for the anti-theft system (6048h).
enum class AntiTheftCommand : std::uint8_t {
  disable, do_not_trigger, activate, trigger, not_implemented = 6, do_not_care = 7
};

// Power train (4.2.4).

/// State of the engine (6051h).
enum class Engine : std::uint8_t {
  off, ready, cranking, running, stalled, after_run, shutdown,
  failure = 0xFE, not_available = 0xFF
};
/// Position of the selector lever (6052h).
enum class SelectorLever : std::uint8_t {
  intermediate, position_1, position_2, position_3, position_4, driving, neutral, reverse, parking,
  low,
  failure = 0xE, not_available = 0xF
};
/// Mode of the gear (6052h).
enum class GearMode : std::uint8_t {
  manual, sport, comfort, winter, failure = 6, not_available = 7
};
/// Engaged gear (6052h).
enum class Gear : std::uint8_t {
  none, first, second, third, fourth, fifth, sixth, seventh, eighth, reverse,
  failure = 0xE, not_available = 0xF
};
/// Wheels that the pulses are of (6054h).
enum class WheelSource : std::uint8_t {
  front_right, front_left, rear_right, rear_left, average_front, average_rear, average_all,
  failure = 0xFE, not_available = 0xFF
};
/// Unit of the fuel (605Dh).
enum class FuelUnit : std::uint8_t { litre, kilogram, failure, not_available };
/// Command and state of the cruise control (6060h, 6061h).
enum class Acceleration : std::uint8_t {
  accelerate, decelerate,
  failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// Stored speed of the cruise control (6060h, 6061h).
enum class StoredSpeed : std::uint8_t {
  stored, stored_as_maximum, released, recalled,
  failure = 6, not_implemented = failure, not_available = 7, do_not_care = not_available
};

// Fire and air (4.2.5, 4.2.6).

/// State of the fire extinguishing system (6069h).
enum class FireExtinguishing : std::uint8_t {
  deactivated, standby, standby_limited, initialization, automatic_started, manual_started,
  activated,
  failure = 0xE, not_available = 0xF
};
/// State of the emergency fresh-air system (606Ch).
enum class FreshAir : std::uint8_t {
  deactivated, standby, standby_limited, standby_without_sensors, initialization, manual_started,
  manually_activated, automatic_activated,
  failure = 0xE, not_available = 0xF
};

// clang-format on

}  // namespace canvoy::cia447
