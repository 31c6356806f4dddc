// The floors of a lift as positions in its shaft: the floor at which the car stands, the nearest
// one, and the next one at which it can still stop.
//
//     const LiftFloors floors(positions, 10'000);
//     floors.at(motion)                               // 3; 0: at none
//     floors.reachable(motion, Direction::up, 3)      // 5, the first that it can stop at
//
// Positions are micrometres upwards (MotionStatus). Floors count from 1; a lift has at least one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/lift/collective_control.hpp"
#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"

namespace canvoy::cia417 {

/// A view of a few bytes, made where it is needed.
class LiftFloors {
 public:
  /// `positions` rise from floor 1 on. A car stands at a floor if it is within `tolerance`.
  constexpr LiftFloors(std::span<const std::int32_t> positions, std::int32_t tolerance)
      : positions_(positions), tolerance_(tolerance) {}

  /// Number of floors, 1 to 255: also the number of the highest one.
  std::uint8_t count() const { return static_cast<std::uint8_t>(positions_.size()); }
  /// Position of a floor, which must exist, in micrometres.
  std::int32_t position_of(std::uint8_t floor) const { return positions_[floor - 1U]; }
  /// Position of floor 1.
  std::int32_t lowest() const { return positions_.front(); }
  /// Position of the highest floor.
  std::int32_t highest() const { return positions_.back(); }

  /// Of two equally near floors, the upper one.
  std::uint8_t nearest(std::int32_t position) const;
  /// Distance to the nearest floor, without its sign.
  std::int32_t off_floor(std::int32_t position) const;
  /// True within the tolerance of a floor.
  bool is_at_floor(std::int32_t position) const { return off_floor(position) <= tolerance_; }
  /// The floor at which the car stands; 0: none, or it moves.
  std::uint8_t at(const MotionStatus& motion) const;
  /// The first floor on its way at which it can still stop: not `departed` (0: none), from which it
  /// moves in `direction`.
  std::uint8_t reachable(const MotionStatus& motion, Direction direction,
                         std::uint8_t departed) const;

  /// The floor nearest to this one for which `is_wanted` returns true. This one is tried first, and
  /// the lower one of two equally near floors. This one also if there is none.
  template <class Question>
  std::uint8_t nearest_where(std::uint8_t floor, Question is_wanted) const {
    for (unsigned away = 0; away < count(); ++away) {
      const unsigned below = floor > away ? floor - away : 0;
      const unsigned above = floor + away;
      for (const unsigned near : {below, above}) {
        const bool is_floor = near >= 1 && near <= count();
        if (is_floor && is_wanted(static_cast<std::uint8_t>(near))) {
          return static_cast<std::uint8_t>(near);
        }
      }
    }
    return floor;
  }
  /// Like nearest_where(), but in one direction, up if there is none.
  template <class Question>
  std::uint8_t next_where(std::uint8_t floor, Direction direction, Question is_wanted) const {
    const int step = direction == Direction::down ? -1 : 1;
    for (int next = floor; next >= 1 && next <= int{count()}; next += step) {
      if (is_wanted(static_cast<std::uint8_t>(next))) return static_cast<std::uint8_t>(next);
    }
    return floor;
  }

 private:
  std::span<const std::int32_t> positions_;
  std::int32_t tolerance_;
};

}  // namespace canvoy::cia417
