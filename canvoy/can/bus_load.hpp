// The load of a bus: the share of time in which its wire was not idle, recently and since the
// start.
//
//     BusLoad load(1'000'000'000);       // of the last second
//     load.add(begin_ns, end_ns);        // for each frame, with its intermission, and each error
//     double share = load.recent(now_ns);
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace canvoy {

/// Measures the load. Times are nanoseconds since the start. The window slides in steps of a 32nd;
/// within the oldest step the load is taken as even. Adding is constant for spans shorter than a
/// step.
class BusLoad {
 public:
  constexpr BusLoad() = default;
  /// Makes a measurement with a window of `window_ns`, at least 32.
  constexpr explicit BusLoad(std::int64_t window_ns)
      : step_ns_(std::max<std::int64_t>(window_ns / steps, 1)), step_end_ns_(step_ns_) {}

  /// Adds a span in which the wire was busy. Spans come in order and do not overlap.
  constexpr void add(std::int64_t from_ns, std::int64_t to_ns) {
    total_ns_ += to_ns - from_ns;
    while (to_ns > step_end_ns_) {
      if (from_ns < step_end_ns_) {
        busy_ns_[current_] += step_end_ns_ - from_ns;
        from_ns = step_end_ns_;
      }
      next_step(from_ns);
    }
    busy_ns_[current_] += to_ns - from_ns;
  }

  /// Load from 0 to 1, for the window up to `now_ns`; before the first window is over, since the
  /// start.
  constexpr double recent(std::int64_t now_ns) const {
    const std::int64_t window_ns = step_ns_ * steps;
    const std::int64_t window_begin_ns = std::max<std::int64_t>(now_ns - window_ns, 0);
    double busy_ns = 0.0;
    for (std::size_t age = 0; age <= steps; ++age) {
      const std::int64_t end_ns = step_end_ns_ - static_cast<std::int64_t>(age) * step_ns_;
      if (end_ns <= window_begin_ns) break;
      busy_ns += share_inside(busy_ns_[(current_ + slots - age) % slots], end_ns, window_begin_ns);
    }
    const std::int64_t span_ns = now_ns - window_begin_ns;
    return span_ns <= 0 ? 0.0 : std::min(busy_ns / static_cast<double>(span_ns), 1.0);
  }

  /// Load from 0 to 1, since the start.
  constexpr double total(std::int64_t now_ns) const {
    if (now_ns <= 0) return 0.0;
    return std::min(static_cast<double>(total_ns_) / static_cast<double>(now_ns), 1.0);
  }
  /// Time in which the wire was busy since the start, in nanoseconds.
  constexpr std::int64_t total_ns() const { return total_ns_; }

 private:
  static constexpr std::int64_t steps = 32;
  static constexpr std::size_t slots = steps + 1;  // the window, and the present step

  constexpr void next_step(std::int64_t from_ns) {
    const std::int64_t idle_steps = (from_ns - step_end_ns_) / step_ns_;
    if (idle_steps >= static_cast<std::int64_t>(slots)) {
      busy_ns_ = {};
      step_end_ns_ += idle_steps * step_ns_;
    }
    current_ = (current_ + 1) % slots;
    busy_ns_[current_] = 0;
    step_end_ns_ += step_ns_;
  }

  /// Busy time of a step inside the window; proportional for a step that the window covers partly.
  constexpr double share_inside(std::int64_t busy_ns, std::int64_t end_ns,
                                std::int64_t window_begin_ns) const {
    const std::int64_t outside_ns = window_begin_ns - (end_ns - step_ns_);
    const double busy = static_cast<double>(busy_ns);
    if (outside_ns <= 0) return busy;
    return busy * static_cast<double>(step_ns_ - outside_ns) / static_cast<double>(step_ns_);
  }

  std::array<std::int64_t, slots> busy_ns_{};
  std::size_t current_ = 0;
  std::int64_t step_ns_ = 1;
  std::int64_t step_end_ns_ = 1;
  std::int64_t total_ns_ = 0;
};

}  // namespace canvoy
