#include "canvoy/worlds/bus_line/bus_drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace canvoy::bus_line {

namespace {

/// Within this distance and below this speed, it stands.
constexpr double arrived_m = 0.02;

}  // namespace

void BusDrive::begin(const Path& path, double metres) {
  path_ = &path;
  metres_ = metres;
  target_ = metres;
  speed_ = 0;
}

void BusDrive::go(double metres, double metres_per_second) {
  target_ = std::max(metres, metres_);
  limit_ = metres_per_second;
}

void BusDrive::step(Duration time) {
  if (is_standing()) return;
  const double seconds = std::chrono::duration<double>(time).count();
  const double way = rest();
  // The speed v at the end of the step from which it can stand at the end of the way:
  // (speed + v) / 2 * seconds + v * v / (2 * deceleration) = way.
  const double slowing = deceleration * seconds / 2;
  const double inner = slowing * slowing + deceleration * (2 * way - speed_ * seconds);
  const double to_stand = inner <= 0 ? 0 : std::sqrt(inner) - slowing;
  const double slowest = std::max(0.0, speed_ - deceleration * seconds);
  const double wanted =
      std::max(slowest, std::min({limit_, speed_ + acceleration * seconds, to_stand}));
  const double driven = std::min(way, (speed_ + wanted) / 2 * seconds);
  speed_ = wanted;
  metres_ += driven;
  odometer_ += driven;
  if (rest() > arrived_m) return;
  odometer_ += rest();
  metres_ = target_;
  speed_ = 0;
}

void BusDrive::roll(Duration time, double metres_per_second) {
  const double seconds = std::chrono::duration<double>(time).count();
  const double driven = std::clamp(path_->metres() - metres_, 0.0, metres_per_second * seconds);
  speed_ = metres_per_second;
  metres_ += driven;
  odometer_ += driven;
}

}  // namespace canvoy::bus_line
