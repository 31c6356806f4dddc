// A car that two buttons drive, up and down, while one of them is held, and not beyond the first
// and the last floor. If it comes to rest short of these, it continues when the button is held
// again.
//
//     HandDrive hand;
//     if (hand.obey(1, motion.stopping_position_micrometre, floors)) run(hand.direction());
#pragma once

#include <cstdint>
#include <utility>

#include "canvoy/devices/cia417/lift/lift_floors.hpp"

namespace canvoy::cia417 {

class HandDrive {
 public:
  /// Starts with released buttons.
  void begin_anew() { *this = {}; }
  /// Call it when something else has stopped the car.
  void stop() { direction_ = 0; }
  /// -1 down, 0 standing, 1 up.
  int direction() const { return direction_; }
  /// `wanted` is the direction of the buttons; `stops_at` is where the car would come to rest. True
  /// if the direction has changed.
  bool obey(int wanted, std::int32_t stops_at, const LiftFloors& floors) {
    if (wanted != end_) end_ = 0;
    if (wanted > 0 && stops_at >= floors.highest()) end_ = 1;
    if (wanted < 0 && stops_at <= floors.lowest()) end_ = -1;
    const int direction = end_ != 0 ? 0 : wanted;
    return std::exchange(direction_, static_cast<std::int8_t>(direction)) != direction;
  }

 private:
  std::int8_t direction_ = 0;
  std::int8_t end_ = 0;  ///< of its travel, reached by the button that is still held
};

}  // namespace canvoy::cia417
