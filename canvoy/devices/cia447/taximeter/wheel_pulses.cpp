#include "canvoy/devices/cia447/taximeter/wheel_pulses.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

/// Maximum age difference of two values (4.2.4.6: propagation inside the vehicle).
constexpr Duration lateness_max = 500ms;
/// Number of consecutive values before they are accepted: a value that is sent late, even twice, is
/// not a counter that was set.
constexpr std::uint8_t doubts_max = 4;
/// Longer than any counter takes to overrun; the product below then fits into 64 bits.
constexpr Duration longest_gap = 1h;

}  // namespace

void WheelPulses::set_overrun_value(std::uint16_t highest) {
  if (highest == highest_) return;
  highest_ = highest;
  forget();
}

std::uint32_t WheelPulses::ahead(std::uint16_t value, std::uint16_t base) const {
  return value >= base ? std::uint32_t{value} - base : modulus() - (std::uint32_t{base} - value);
}

std::uint64_t WheelPulses::possible(Duration time) const {
  const auto microseconds =
      static_cast<std::uint64_t>(std::clamp<std::int64_t>(time.count(), 0, longest_gap.count()));
  return fastest_ * microseconds / 1'000'000;
}

void WheelPulses::set_base(std::uint16_t value, Time now) {
  base_ = value;
  base_time_ = now;
  has_base_ = true;
  doubts_ = 0;
}

std::uint32_t WheelPulses::count(std::uint16_t value, Signal valid, Time now) {
  if (valid != Signal::yes) {
    ++counters_.not_valid;
    if (valid == Signal::not_available) forget();
    return 0;
  }
  if (value > highest_) {
    ++counters_.out_of_range;
    return 0;
  }
  if (!has_base_) {
    set_base(value, now);
    return 0;
  }
  // If the counter may have overrun undetected, the number of overruns is not known.
  if (possible(now - base_time_) > believed()) {
    ++counters_.gaps;
    set_base(value, now);
    return 0;
  }
  const std::uint32_t more = ahead(value, base_);
  if (more > believed() || more > possible(now - base_time_ + lateness_max)) {
    return doubt(value, now);
  }
  set_base(value, now);
  return more;
}

std::uint32_t WheelPulses::doubt(std::uint16_t value, Time now) {
  ++counters_.implausible;
  const std::uint32_t more = ahead(value, doubted_);
  const bool goes_on =
      doubts_ > 0 && more <= believed() && more <= possible(now - doubted_time_ + lateness_max);
  doubts_ = goes_on ? static_cast<std::uint8_t>(doubts_ + 1) : std::uint8_t{1};
  doubted_pulses_ = goes_on ? doubted_pulses_ + more : 0;
  doubted_ = value;
  doubted_time_ = now;
  if (doubts_ < doubts_max) return 0;
  ++counters_.restarts;
  set_base(value, now);
  return doubted_pulses_;
}

}  // namespace canvoy::cia447
