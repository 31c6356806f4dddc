#include "canvoy/devices/cia447/taximeter/wheel_pulses.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

/// About 3 km/h, from which 6053h is accurate to 1 %.
constexpr unsigned turning = 60;
/// Twice the delay of 6053h.
constexpr Duration late = 1s;
/// Lower limit of the error tolerance of a taximeter (Directive 2014/32/EU, annex IX): 4 m, in
/// thousandths.
constexpr std::uint64_t least_error = 4;
constexpr std::uint64_t thousand = 1000;
/// Some values of a period of 100 ms may be lost; those in between are not known.
constexpr Duration gap = 500ms;
constexpr Duration window_length = 10s;
/// In percent: 1 % of 6053h, 1.8 % of 6055h, and their difference in time.
constexpr std::uint64_t tolerated = 105;
constexpr std::uint64_t hundred = 100;
constexpr std::uint64_t tenth = 10;

}  // namespace

bool WheelCheck::take(const WheelSeen& seen) {
  const bool turns = seen.half_rpm && *seen.half_rpm >= turning;
  standing_ = turns && seen.turned == 0 ? standing_ + seen.since : Duration{};
  watch_rest(seen);
  watch_ratio(seen);
  watch_engine(seen);
  return rest_ <= late;
}

void WheelCheck::watch_rest(const WheelSeen& seen) {
  if (!seen.half_rpm || *seen.half_rpm != 0) {
    rest_ = {};
    extra_ = 0;
    is_extra_ = false;
    return;
  }
  rest_ += seen.since;
  if (rest_ <= late) return;
  extra_ += seen.turned;
  is_extra_ = extra_ * thousand >= least_error * seen.k;
}

void WheelCheck::watch_ratio(const WheelSeen& seen) {
  const bool is_known = seen.half_rpm && *seen.half_rpm >= turning && seen.since <= gap;
  if (!is_known) {
    window_ = {};
    pulses_ = turns_ = 0;
    return;
  }
  window_ += seen.since;
  pulses_ += seen.turned;
  turns_ += *seen.half_rpm * static_cast<std::uint64_t>(seen.since / 1ms);
  if (window_ >= window_length) close_window();
}

void WheelCheck::close_window() {
  if (first_pulses_ == 0) {
    first_pulses_ = pulses_;
    first_turns_ = turns_;
  }
  const bool is_extra =
      pulses_ * hundred * first_turns_ > first_pulses_ * tolerated * turns_ && first_pulses_ != 0;
  extra_windows_ = is_extra ? extra_windows_ + 1 : 0;
  window_ = {};
  pulses_ = turns_ = 0;
}

/// An electric car has no turning engine, and a stopped engine of others may turn again at once.
void WheelCheck::watch_engine(const WheelSeen& seen) {
  if (!seen.engine || *seen.engine != 0) {
    has_engine_turned_ |= seen.engine.has_value();
    without_engine_ = 0;
    is_without_engine_ = false;
    return;
  }
  if (!has_engine_turned_) return;
  without_engine_ += seen.turned;
  is_without_engine_ = without_engine_ * tenth >= seen.k;
}

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
