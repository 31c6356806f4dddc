// A passenger of a lift: their destination, their actions, and what they see of the lifts.
#pragma once

#include <cstdint>
#include <functional>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/traffic.hpp"

namespace canvoy::lift {

/// Where a person is on the way.
enum class PassengerState : std::uint8_t {
  waiting,    ///< at a landing
  boarding,   ///< on the way through the door
  riding,     ///< in a car
  leaving,    ///< on the way out
  served,     ///< at the destination
  gave_up,    ///< waited too long, and took the stairs
  evacuated,  ///< was asked out of the car by a fire service
};

struct Passenger {
  Arrival wish{};                                  ///< from where to where, and when
  PassengerState state = PassengerState::waiting;  ///< where the person is
  Time waiting_since{};                            ///< since the arrival at the landing
  Time riding_since{};                             ///< since the person is in the car
  Time looks_at = never;                           ///< next time at a button
  Time gives_up_at = never;                        ///< takes the stairs then
  Time pressed_at{};                               ///< or has seen the lamp lit
  LiftNumber lift = 0;        ///< lift in which the passenger is, or is to go; 0: any
  LiftNumber refuses = 0;     ///< lift that had no room: not again before its door has closed
  bool asks = false;          ///< has entered a destination, and has no lift yet
  bool told_to_wait = false;  ///< by the terminal, which has the destination
};

/// The door of a car as people see it.
enum class DoorView : std::uint8_t { closed, opening, open, closing };

/// Visible state of a car.
struct CarView {
  FloorNumber floor = no_floor;      ///< floor of its door, while that is not closed
  DoorNumber doorway = 1;            ///< number of the door at that floor
  DoorView door = DoorView::closed;  ///< of that door
  /// Direction in which it shows that it goes on; none: wherever a passenger wants to.
  Direction direction = Direction::none;
  bool overload = false;   ///< the car shows it, and must not leave
  bool accepts = true;     ///< false: out of order, fire service or otherwise not for passengers
  bool evacuates = false;  ///< all passengers must leave it where it is

  friend bool operator==(const CarView&, const CarView&) = default;
};

/// A button at a landing.
struct HallButton {
  FloorNumber floor = 1;                ///< of the landing
  Direction direction = Direction::up;  ///< up or down
  FloorNumber to = no_floor;  ///< destination: people press the button of a lift that goes there;
                              ///< no_floor: any
};
/// A button in a car.
struct CarButton {
  LiftNumber lift = 1;    ///< of the car
  FloorNumber floor = 1;  ///< destination
};
/// A destination that people enter at a landing.
struct DestinationButton {
  FloorNumber floor = 1;  ///< floor of the terminal
  FloorNumber to = 2;     ///< destination
};

/// Actions of people at a building. The simulation of its devices sets them; an empty one does
/// nothing.
struct PassengerHands {
  /// A button at a landing, by the floor.
  std::function<void(const HallButton&, bool pressed)> hall_button{};
  /// A button in a car.
  std::function<void(const CarButton&, bool pressed)> car_button{};
  /// A destination at a terminal.
  std::function<void(const DestinationButton&, bool pressed)> destination_button{};
  /// The button in the car that opens the door.
  std::function<void(LiftNumber, bool pressed)> door_open_button{};
  /// A person steps into the way of light barrier and door, or out of it.
  std::function<void(LiftNumber, DoorNumber, bool is_in_the_way)> doorway{};
  /// A passenger has reached the destination.
  std::function<void(LiftNumber)> carried{};
  /// A person who has waited since `since` takes the stairs.
  std::function<void(Time since)> gave_up{};
  /// The mass of all people in a car has changed.
  std::function<void(LiftNumber, double mass_kg)> load{};
};

/// Behaviour of people.
struct PassengerOptions {
  bool destination_control = false;  ///< they enter their destination at the landing
  /// Share of the rated persons beyond which people do not board a car, unless it is empty. CIBSE
  /// Guide D uses 0.8.
  double fill_share = 0.8;
  Duration transfer = 1200ms;       ///< a person in or out
  Duration in_doorway = 900ms;      ///< part of it, in the way of the light barrier
  Duration press = 300ms;           ///< time for which a button is held
  Duration reaction = 500ms;        ///< until a person presses a button
  Duration look_again = 5s;         ///< then a passenger looks at the lamp, and presses again if it
                                    ///< is dark
  Duration press_anyway = 30s;      ///< wait after which a passenger presses whatever the lamp
                                    ///< shows
  Duration ask_anyway = 10min;      ///< like press_anyway, for people who were told a lift, or to
                                    ///< wait for one
  Duration patience_least = 10min;  ///< after it people take the stairs
  Duration patience_most = 20min;   ///< by chance between least and most
  double holds_door = 0.02;         ///< share of boarding people who hold the door for a late one
  Duration hold_least = 3s;         ///< by chance between least and most
  Duration hold_most = 8s;          ///< by chance between least and most
  double stops_closing_door = 0.3;  ///< share of people at a closing door who stop it with the hand
  /// Time in a car that stands at another floor with open doors, after which a passenger tries
  /// another one.
  Duration patience_in_car = 90s;
  std::uint64_t seed = 1;  ///< of all chance of people
};

}  // namespace canvoy::lift
