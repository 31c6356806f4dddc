// The messages between a door and its controller, as fields: door controlword (6300h) and door
// statusword (6301h) of one door (CiA 417-4, 4.6.1 and 4.7.1).
//
//     values[door_controlword(2)].set_raw(DoorOrder{.command = DoorCommand::reset}.word());
//     DoorReport::of(values[door_statusword(2)].raw()).state
#pragma once

#include <cstdint>

#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/model/assembled.hpp"

namespace canvoy::cia417 {

/// The field of a door's word to which `handle` refers; it may be a reserved value.
template <class Enumeration, class Handle>
constexpr Enumeration field_of(std::uint16_t word, const Handle& /*handle*/) {
  return static_cast<Enumeration>(extract(word, Handle::Place::bits));
}

/// A controlword. Fields that are not set change nothing.
struct DoorOrder {
  DoorCommand command = DoorCommand::no_action;       ///< open, close, stop, reset
  DoorVelocity velocity = DoorVelocity::no_action;    ///< profile or reduced speed
  Disabling motion_detector = Disabling::no_action;   ///< off or on
  Disabling finger_protector = Disabling::no_action;  ///< off or on
  Disabling lock = Disabling::no_action;              ///< off: the closed door does not lock
  Enabling battery_power = Enabling::no_action;       ///< whether the door may use it

  friend constexpr bool operator==(const DoorOrder&, const DoorOrder&) = default;

  /// Value of 6300h.
  constexpr std::uint16_t word() const {
    return static_cast<std::uint16_t>(Assembled(door_controlword, 0xFFFF)
                                          .set(door_command, command)
                                          .set(door_velocity, velocity)
                                          .set(motion_detector_command, motion_detector)
                                          .set(finger_protector_command, finger_protector)
                                          .set(door_lock_command, lock)
                                          .set(battery_power_command, battery_power)
                                          .raw());
  }
  /// Takes a value of 6300h apart.
  static constexpr DoorOrder of(std::uint16_t word) {
    return {.command = field_of<DoorCommand>(word, door_command),
            .velocity = field_of<DoorVelocity>(word, door_velocity),
            .motion_detector = field_of<Disabling>(word, motion_detector_command),
            .finger_protector = field_of<Disabling>(word, finger_protector_command),
            .lock = field_of<Disabling>(word, door_lock_command),
            .battery_power = field_of<Enabling>(word, battery_power_command)};
  }
};

/// A statusword. Fields that are not set are not available.
struct DoorReport {
  DoorState state = DoorState::not_available;             ///< open, closed, moving
  Detection force_limit = Detection::not_available;       ///< an obstacle, felt by the drive
  Detection motion_detector = Detection::not_available;   ///< someone approaches
  Detection finger_protector = Detection::not_available;  ///< a finger is near the leaf
  Detection lock = Detection::not_available;              ///< yes: locked
  Detection battery_power = Detection::not_available;     ///< yes: in use
  Detection safety_contact = Detection::not_available;    ///< yes: closed

  friend constexpr bool operator==(const DoorReport&, const DoorReport&) = default;

  /// Value of 6301h.
  constexpr std::uint16_t word() const {
    return static_cast<std::uint16_t>(Assembled(door_statusword)
                                          .set(door_state, state)
                                          .set(cia417::force_limit, force_limit)
                                          .set(cia417::motion_detector, motion_detector)
                                          .set(cia417::finger_protector, finger_protector)
                                          .set(door_lock, lock)
                                          .set(cia417::battery_power, battery_power)
                                          .set(cia417::safety_contact, safety_contact)
                                          .raw());
  }
  /// Takes a value of 6301h apart.
  static constexpr DoorReport of(std::uint16_t word) {
    return {.state = field_of<DoorState>(word, door_state),
            .force_limit = field_of<Detection>(word, cia417::force_limit),
            .motion_detector = field_of<Detection>(word, cia417::motion_detector),
            .finger_protector = field_of<Detection>(word, cia417::finger_protector),
            .lock = field_of<Detection>(word, door_lock),
            .battery_power = field_of<Detection>(word, cia417::battery_power),
            .safety_contact = field_of<Detection>(word, cia417::safety_contact)};
  }
};

/// True for a door at its closed end, locked or not.
constexpr bool is_closed(DoorState state) {
  return state == DoorState::closed_with_torque || state == DoorState::closed_without_torque;
}
/// True for a door at its open end.
constexpr bool is_open(DoorState state) {
  return state == DoorState::opened_with_torque || state == DoorState::opened_without_torque;
}
/// True for a door that opens or closes.
constexpr bool is_moving(DoorState state) {
  return state == DoorState::closing || state == DoorState::opening ||
         state == DoorState::re_opening;
}

}  // namespace canvoy::cia417
