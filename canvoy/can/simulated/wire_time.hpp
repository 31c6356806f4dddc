// Time on the wire, in nanoseconds since the start: every bit rate of CiA 301 has a bit time
// without remainder.
//
//     std::int64_t end_ns = to_ns(now) + 47 * bit_time_ns(125'000);
//     Time end = to_time(end_ns);
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// No event: greater than any time.
inline constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();

/// Converts from and to the time of the world, rounded up: no event is seen before it has happened.
constexpr std::int64_t to_ns(Time time) {
  const std::int64_t us = time.time_since_epoch().count();
  return us > never_ns / 1000 ? never_ns : us * 1000;
}
/// Converts to the time of the world, rounded up to a microsecond.
constexpr Time to_time(std::int64_t ns) {
  return ns == never_ns ? never : Time(Duration((ns + 999) / 1000));
}

/// Bit time for 1000 to 1'000'000 bit/s, rounded to the nanosecond; other rates are limited to that
/// range.
constexpr std::int64_t bit_time_ns(std::uint32_t bit_rate) {
  const std::int64_t rate = std::clamp<std::uint32_t>(bit_rate, 1000, 1'000'000);
  return (1'000'000'000 + rate / 2) / rate;
}

}  // namespace canvoy
