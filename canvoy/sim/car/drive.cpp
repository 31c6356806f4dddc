#include "canvoy/sim/car/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace canvoy::car {

void Drive::go(double metres, double metres_per_second) {
  rest_ = metres;
  limit_ = metres_per_second;
}

void Drive::step(Duration time) {
  if (is_standing()) return;
  const double seconds = std::chrono::duration<double>(time).count();
  // As fast as it may be to stand at the end of the leg.
  const double to_stand = std::sqrt(2 * deceleration * rest_);
  const double wanted = std::min({limit_, speed_ + acceleration * seconds, to_stand});
  const double driven = std::min(rest_, (speed_ + wanted) / 2 * seconds);
  speed_ = wanted;
  metres_ += driven;
  rest_ -= driven;
  constexpr double arrived = 0.05;
  if (rest_ > arrived) return;
  metres_ += rest_;
  rest_ = 0;
  speed_ = 0;
}

}  // namespace canvoy::car
