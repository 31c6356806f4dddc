// A passenger of a lift: what he wants, what he does about it, and what he sees of the lifts.
#pragma once

#include <cstdint>
#include <functional>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/traffic.hpp"

namespace canvoy::lift {

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
  Arrival wish{};
  PassengerState state = PassengerState::waiting;
  Time waiting_since{};
  Time riding_since{};
  Time looks_at = never;  ///< for a button, next
  Time gives_up_at = never;
  Time pressed_at{};          ///< or has seen the lamp lit
  LiftNumber lift = 0;        ///< where he is, or that he was told to take; 0: any
  LiftNumber refuses = 0;     ///< had no place for him: not again before its door has closed
  bool asks = false;          ///< has pressed a destination, and has no lift yet
  bool told_to_wait = false;  ///< by the terminal, which knows his wish
};

enum class DoorView : std::uint8_t { closed, opening, open, closing };

/// What people see of a car.
struct CarView {
  FloorNumber floor = no_floor;  ///< where its door is, when that is not closed
  DoorNumber doorway = 1;
  DoorView door = DoorView::closed;
  /// Where it says that it goes on to; none: wherever somebody wants to.
  Direction direction = Direction::none;
  bool overload = false;   ///< the car says so, and must not leave
  bool accepts = true;     ///< false: out of order, fire service or otherwise not for passengers
  bool evacuates = false;  ///< everybody has to leave it where it is

  friend bool operator==(const CarView&, const CarView&) = default;
};

struct HallButton {
  FloorNumber floor = 1;
  Direction direction = Direction::up;
  FloorNumber to = no_floor;  ///< he presses that of a lift that goes there; no_floor: any
};
struct CarButton {
  LiftNumber lift = 1;
  FloorNumber floor = 1;
};
struct DestinationButton {
  FloorNumber floor = 1;  ///< where it is
  FloorNumber to = 2;
};

/// What people do to a building. Whoever simulates its devices fills it; what is empty does
/// nothing.
struct PassengerHands {
  std::function<void(const HallButton&, bool pressed)> hall_button{};
  std::function<void(const CarButton&, bool pressed)> car_button{};
  std::function<void(const DestinationButton&, bool pressed)> destination_button{};
  std::function<void(LiftNumber, bool pressed)> door_open_button{};
  /// Somebody stands in the way of light barrier and door.
  std::function<void(LiftNumber, DoorNumber, bool is_in_the_way)> doorway{};
  /// Somebody has got to where he wanted.
  std::function<void(LiftNumber)> carried{};
  /// Somebody takes the stairs who has waited since then.
  std::function<void(Time since)> gave_up{};
  /// What all people in a car weigh, after it has changed.
  std::function<void(LiftNumber, double mass_kg)> load{};
};

/// How people behave.
struct PassengerOptions {
  bool destination_control = false;  ///< they say at the landing where they want to go
  /// Of the rated persons: nobody steps into a car with more, but one who finds it empty. CIBSE
  /// Guide D takes 0.8.
  double fill_share = 0.8;
  Duration transfer = 1200ms;       ///< a person in or out
  Duration in_doorway = 900ms;      ///< of this, in the way of the light barrier
  Duration press = 300ms;           ///< a button is held
  Duration reaction = 500ms;        ///< until a person presses a button
  Duration look_again = 5s;         ///< whether the lamp is lit; else he presses once more
  Duration press_anyway = 30s;      ///< who has waited so long presses whatever the lamp shows
  Duration ask_anyway = 10min;      ///< the same of who was told a lift, or to wait for one
  Duration patience_least = 10min;  ///< then he takes the stairs
  Duration patience_most = 20min;
  double holds_door = 0.02;  ///< share of those who board, for somebody who comes late
  Duration hold_least = 3s;
  Duration hold_most = 8s;
  double stops_closing_door = 0.3;  ///< share of those who find it closing, with the hand
  /// In a car that stands at another floor with open doors, before he tries another one.
  Duration patience_in_car = 90s;
  std::uint64_t seed = 1;
};

}  // namespace canvoy::lift
