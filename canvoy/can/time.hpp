// Time below the operating system: 64-bit microseconds since start.
//
//     Time now{};  Time deadline = now + 200ms;
#pragma once

#include <chrono>
#include <cstdint>
#include <type_traits>

#include "canvoy/can/machine.hpp"

namespace canvoy {

/// The clock of a node, a bus or a simulated world. It has no now(): time is passed in from
/// outside.
struct Clock {
  using rep = std::int64_t;                             ///< microseconds
  using period = std::micro;                            ///< for <chrono>
  using duration = std::chrono::duration<rep, period>;  ///< for <chrono>
  using time_point = std::chrono::time_point<Clock>;    ///< for <chrono>
  static constexpr bool is_steady = true;               ///< never goes back
};

using Duration = Clock::duration;  ///< signed, in microseconds
using Time = Clock::time_point;    ///< microseconds since the start of the clock

/// Deadline of an object that waits for nothing.
inline constexpr Time never = Time::max();

/// True if a < b, in the fewest instructions: the operator of <chrono> becomes a call where code
/// must be small.
constexpr bool is_before(Time a, Time b) {
  return a.time_since_epoch().count() < b.time_since_epoch().count();
}

/// Lower bits of a point in time, in microseconds: enough for comparison with stored ones.
constexpr std::uint32_t low_ticks(Time time) {
  return static_cast<std::uint32_t>(time.time_since_epoch().count());
}

namespace detail {

class HalvedTime {
 public:
  constexpr HalvedTime(Time time)  // NOLINT(google-explicit-constructor): it is one
      : low_(static_cast<std::uint32_t>(time.time_since_epoch().count())),
        high_(static_cast<std::int32_t>(time.time_since_epoch().count() >> 32)) {}
  constexpr operator Time() const {  // NOLINT(google-explicit-constructor): it is one
    return Time(Duration(static_cast<std::int64_t>(
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(high_)) << 32 | low_)));
  }

 private:
  std::uint32_t low_;
  std::int32_t high_;
};

}  // namespace detail

/// A point in time as a member of objects. On a small machine, which has many, it needs an
/// alignment of four bytes only.
using StoredTime = std::conditional_t<is_small_machine, detail::HalvedTime, Time>;

/// Times as members of objects. They are computed in 32 bits: 64 bits cost a small processor a
/// call.
constexpr Duration from_milliseconds(std::uint16_t count) {
  return Duration(count * std::uint32_t{1000});
}
/// Duration in microseconds of a count of 100 microseconds, as inhibit times have it.
constexpr Duration from_100_microseconds(std::uint16_t count) {
  return Duration(count * std::uint32_t{100});
}

using namespace std::chrono_literals;

}  // namespace canvoy
