// Counts the restarts of a slave without a command, and limits new attempts of its master: if the
// boot-up itself causes them, they would continue forever, at the speed of the bus.
//
//     SlaveRestarts restarts;
//     if (const auto delay = restarts.count(now)) boot_at(now + *delay); else give_up();
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// Three times at once, then after 1, 2, 4 and 8 s, then no more; after half a minute without a
/// restart the count starts again.
class SlaveRestarts {
 public:
  static constexpr Duration slowest = 8s;  ///< longest delay of an attempt

  /// Counts a restart. Returns the time to wait, from zero to `slowest`; nothing if no attempt is
  /// left.
  constexpr std::optional<Duration> count(Time now) {
    if (now - last_ > calm) count_ = 0;
    last_ = now;
    if (is_exhausted()) return std::nullopt;
    ++count_;
    if (count_ <= prompt_max) return Duration::zero();
    return slowest / (1U << (all_max - count_));
  }
  /// True if the next restart exceeds the limit, unless it comes late.
  constexpr bool is_exhausted() const { return count_ == all_max; }
  /// True if an attempt was delayed, and the slave has not run for long enough since.
  constexpr bool is_slow(Time now) const { return count_ > prompt_max && now - last_ <= calm; }

 private:
  static constexpr unsigned prompt_max = 3;
  static constexpr unsigned all_max = prompt_max + 4;
  static constexpr Duration calm = 30s;

  Time last_{};
  std::uint8_t count_ = 0;
};

}  // namespace canvoy
