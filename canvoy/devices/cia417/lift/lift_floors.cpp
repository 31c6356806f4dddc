#include "canvoy/devices/cia417/lift/lift_floors.hpp"

#include <algorithm>
#include <cstdlib>

namespace canvoy::cia417 {

std::uint8_t LiftFloors::nearest(std::int32_t position) const {
  const auto above = std::ranges::lower_bound(positions_, position);
  const auto number = static_cast<std::size_t>(above - positions_.begin()) + 1;
  if (number > positions_.size()) return static_cast<std::uint8_t>(number - 1);
  const auto floor = static_cast<std::uint8_t>(number);
  if (floor == 1) return floor;
  const auto below = static_cast<std::uint8_t>(floor - 1);
  return *above - position <= position - position_of(below) ? floor : below;
}

std::int32_t LiftFloors::off_floor(std::int32_t position) const {
  return std::abs(position - position_of(nearest(position)));
}

std::uint8_t LiftFloors::at(const MotionStatus& motion) const {
  if (!motion.available || !motion.standing) return 0;
  const std::int32_t here = motion.position_micrometre;
  return is_at_floor(here) ? nearest(here) : std::uint8_t{0};
}

std::uint8_t LiftFloors::reachable(const MotionStatus& motion, Direction direction,
                                   std::uint8_t departed) const {
  const std::int32_t stops_at = motion.stopping_position_micrometre;
  if (motion.velocity_micrometre_per_second >= 0 && direction != Direction::down) {
    const auto floor = std::ranges::lower_bound(positions_, stops_at - tolerance_);
    const auto number = static_cast<std::size_t>(floor - positions_.begin()) + 1;
    const std::size_t next = direction == Direction::up ? departed + std::size_t{1} : 1;
    return static_cast<std::uint8_t>(
        std::min<std::size_t>(std::max(number, next), positions_.size()));
  }
  const auto above = std::ranges::upper_bound(positions_, stops_at + tolerance_);
  const std::ptrdiff_t next = direction == Direction::down && departed > 1 ? departed - 1 : count();
  return static_cast<std::uint8_t>(std::clamp<std::ptrdiff_t>(above - positions_.begin(), 1, next));
}

}  // namespace canvoy::cia417
