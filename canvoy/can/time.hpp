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

using namespace std::chrono_literals;

}  // namespace canvoy
