// How often a slave has restarted without being told, and how long its master waits before it boots
// it again. What the boot-up itself brings about would go on for ever, as fast as the bus is.
//
//     SlaveRestarts restarts;
//     if (const auto delay = restarts.count(now)) boot_at(now + *delay); else give_up();
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// Three times at once, then after 1, 2, 4 and 8 s, then no more; without a restart for half a
/// minute it begins to count anew.
class SlaveRestarts {
 public:
  static constexpr Duration slowest = 8s;

  /// One more: how long to wait, from zero to `slowest`; nothing where it is to be given up.
  constexpr std::optional<Duration> count(Time now) {
    if (now - last_ > calm) count_ = 0;
    last_ = now;
    if (is_exhausted()) return std::nullopt;
    ++count_;
    if (count_ <= prompt_max) return Duration::zero();
    return slowest / (1U << (all_max - count_));
  }
  /// The next one is too many, unless it comes late.
  constexpr bool is_exhausted() const { return count_ == all_max; }
  /// It has been waited for, and the slave has not been calm since.
  constexpr bool is_slow(Time now) const { return count_ > prompt_max && now - last_ <= calm; }

 private:
  static constexpr unsigned prompt_max = 3;
  static constexpr unsigned all_max = prompt_max + 4;
  static constexpr Duration calm = 30s;

  Time last_{};
  std::uint8_t count_ = 0;
};

}  // namespace canvoy
