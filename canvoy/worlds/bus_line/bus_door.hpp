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

enum class DoorState : std::uint8_t { closed, opening, open, closing };

class BusDoor {
 public:
  static constexpr Duration open_time = 1500ms;
  static constexpr Duration close_time = 2500ms;

  /// Opens the door by the driver's button; without effect while the door is out of order.
  void open(Time now);
  void close(Time now);
  /// Says whether a person stands in the door: then it does not close, and opens again while it
  /// closes.
  void obstruct(Time now, bool is_obstructed);
  /// Breaks or repairs the door: a broken door keeps its state, or stops where it is.
  void break_down(Time now, bool is_broken);

  Time deadline() const { return until_; }
  void advance(Time now);

  DoorState state() const { return state_; }
  bool is_closed() const { return state_ == DoorState::closed; }
  bool is_open() const { return state_ == DoorState::open; }
  bool is_obstructed() const { return is_obstructed_; }
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
