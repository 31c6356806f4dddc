#include "canvoy/worlds/bus_line/bus_door.hpp"

namespace canvoy::bus_line {

void BusDoor::open(Time now) {
  if (is_broken_ || state_ == DoorState::open || state_ == DoorState::opening) return;
  state_ = DoorState::opening;
  until_ = now + open_time;
}

void BusDoor::close(Time now) {
  if (is_broken_ || is_obstructed_) return;
  if (state_ == DoorState::closed || state_ == DoorState::closing) return;
  state_ = DoorState::closing;
  until_ = now + close_time;
}

void BusDoor::obstruct(Time now, bool is_obstructed) {
  is_obstructed_ = is_obstructed;
  if (!is_obstructed || state_ != DoorState::closing || is_broken_) return;
  ++reversals_;
  open(now);
}

void BusDoor::break_down(Time now, bool is_broken) {
  is_broken_ = is_broken;
  if (is_broken) {
    until_ = never;
  } else if (state_ == DoorState::opening) {
    until_ = now + open_time;
  } else if (state_ == DoorState::closing) {
    until_ = now + close_time;
  }
}

void BusDoor::advance(Time now) {
  if (now < until_) return;
  until_ = never;
  state_ = state_ == DoorState::opening ? DoorState::open : DoorState::closed;
}

}  // namespace canvoy::bus_line
