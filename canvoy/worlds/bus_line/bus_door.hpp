// A door of a bus, as it is: it takes its time, opens again where a person stands in it, and may be
// out of order.
//
//     BusDoor door;
//     door.open(now);
//     door.advance(door.deadline());
//     door.state();                   // open
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::bus_line {

/// What the leaves do.
enum class DoorState : std::uint8_t { closed, opening, open, closing };

class BusDoor {
 public:
  static constexpr Duration open_time = 1500ms;   ///< from closed to open
  static constexpr Duration close_time = 2500ms;  ///< from open to closed

  /// Opens the door by the driver's button; without effect while the door is out of order.
  void open(Time now);
  /// Closes the door by the driver's button; it waits for a person in it.
  void close(Time now);
  /// Says whether a person stands in the door: then it does not close, and opens again while it
  /// closes.
  void obstruct(Time now, bool is_obstructed);
  /// Breaks or repairs the door: a broken door keeps its state, or stops where it is.
  void break_down(Time now, bool is_broken);

  /// End of the present movement; never: it does not move.
  Time deadline() const { return until_; }
  /// Ends the movement that is due by `now`.
  void advance(Time now);

  /// What the leaves do at present.
  DoorState state() const { return state_; }
  /// True at the end of closing.
  bool is_closed() const { return state_ == DoorState::closed; }
  /// True at the end of opening: people pass.
  bool is_open() const { return state_ == DoorState::open; }
  /// True while a person or thing is in it.
  bool is_obstructed() const { return is_obstructed_; }
  /// True while it is out of order.
  bool is_broken() const { return is_broken_; }
  /// Number of times that the door opened again because a person stood in it.
  unsigned reversals() const { return reversals_; }

 private:
  DoorState state_ = DoorState::closed;
  Time until_ = never;
  bool is_obstructed_ = false;
  bool is_broken_ = false;
  unsigned reversals_ = 0;
};

}  // namespace canvoy::bus_line
