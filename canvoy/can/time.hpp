// Time as everything below the operating system counts it: 64-bit microseconds since start.
//
//     Time now{};  Time deadline = now + 200ms;
#pragma once

#include <chrono>
#include <cstdint>

namespace canvoy {

/// The clock of a node, a bus or a simulated world. It has no now(): time is handed in from
/// outside.
struct Clock {
  using rep = std::int64_t;
  using period = std::micro;
  using duration = std::chrono::duration<rep, period>;
  using time_point = std::chrono::time_point<Clock>;
  static constexpr bool is_steady = true;
};

using Duration = Clock::duration;
using Time = Clock::time_point;

/// The deadline of something that waits for nothing.
inline constexpr Time never = Time::max();

/// Times as objects hold them. They are computed in 32 bits: 64 take a small processor a call.
constexpr Duration from_milliseconds(std::uint16_t count) {
  return Duration(count * std::uint32_t{1000});
}
constexpr Duration from_100_microseconds(std::uint16_t count) {
  return Duration(count * std::uint32_t{100});
}

using namespace std::chrono_literals;

}  // namespace canvoy
