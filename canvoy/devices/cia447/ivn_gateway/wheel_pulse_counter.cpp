#include "canvoy/devices/cia447/ivn_gateway/wheel_pulse_counter.hpp"

#include <cmath>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::cia447 {

namespace {

std::int64_t in_um(double metres) {
  constexpr double um_per_m = 1e6;
  return std::llround(metres * um_per_m);
}

}  // namespace

WheelPulseCounter::WheelPulseCounter(const WheelPulseSettings& pulses)
    : per_rotation_(pulses.per_rotation),
      circumference_um_(in_um(pulses.circumference_m)),
      count_max_(pulses.count_max) {
  check_invariant(circumference_um_ > 0);
}

void WheelPulseCounter::drive(double distance_m) {
  const std::int64_t now_um = in_um(distance_m);
  const std::int64_t driven_um = now_um - last_um_.value_or(now_um);
  last_um_ = now_um;
  if (driven_um <= 0) return;
  rest_ += driven_um * per_rotation_;
  const std::int64_t pulses = rest_ / circumference_um_;
  rest_ %= circumference_um_;
  count_ = static_cast<std::uint16_t>((count_ + pulses) % (count_max_ + 1));
}

}  // namespace canvoy::cia447
