#include "canvoy/worlds/bus_line/line_clock.hpp"

#include <chrono>
#include <cstdlib>

namespace canvoy::bus_line {

namespace {

constexpr Duration time_is_fresh = 5s;
/// Its own clock may be wrong: it waits this long for that of the satellites.
constexpr Duration clock_patience = 3s;

std::int64_t seconds_between(Time from, Time to) {
  return std::chrono::floor<std::chrono::seconds>(to - from).count();
}

}  // namespace

/// Between two messages it uses its own oscillator: messages are sometimes a little late.
bool LineClock::hear(std::int64_t local, Time now) {
  heard_at_ = now;
  if (heard_ && std::abs(*heard_ + seconds_between(base_, now) - local) <= 1) return false;
  const bool jumps = heard_.has_value();
  heard_ = local;
  base_ = now;
  return jumps;
}

std::optional<cia407::CivilTime> LineClock::local(Time now) const {
  if (heard_ && now - heard_at_ < time_is_fresh) {
    return cia447::civil_time(*heard_ + seconds_between(base_, now));
  }
  if (now - booted_ < clock_patience || !own_) return std::nullopt;
  return own_();
}

}  // namespace canvoy::bus_line
