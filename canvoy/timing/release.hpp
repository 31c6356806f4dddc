// Counts the instances of a message that are queued in the first t of a busy period, and finds the
// times of their events, for response_time.cpp. Times are nanoseconds.
//
//     Release release = Release::anywhere(message);
//     release.count(t) * frame_ns
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

/// Quotient, rounded up. `divisor` is above zero.
constexpr std::int64_t divided_up(std::int64_t number, std::int64_t divisor) {
  return number > 0 ? (number - 1) / divisor + 1 : number / divisor;
}

class Release {
 public:
  /// Makes all instances come as early as possible: the first at the start of the busy period.
  static Release anywhere(const BusMessage& message) {
    Release made(message);
    made.add_row(message.period, message.ahead);
    if (message.distance > Duration{}) made.add_row(message.distance, Duration{});
    for (const Burst& each : message.bursts) made.add_row(each.period, each.ahead);
    return made;
  }
  /// Places the first event at or after the start of the busy period at `phase_ns`, 0 to below the
  /// period. Events before it count if their jitter brings them into the busy period.
  static Release at_phase(const BusMessage& message, std::int64_t phase_ns) {
    Release made(message);
    const std::int64_t period_ns = ns(message.period);
    const std::int64_t delayed = (made.jitter_ns_ + phase_ns) / period_ns;
    made.rows_.push_back({period_ns, delayed * period_ns - phase_ns});
    made.begins_with_row_ = true;
    return made;
  }

  /// Number of instances queued in [0, t), with t = `t_ns`. Not below 0.
  std::int64_t count(std::int64_t t_ns) const {
    std::int64_t least = divided_up(t_ns + rows_.front().lead_ns, rows_.front().period_ns);
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      least = std::min(least, divided_up(t_ns + rows_[i].lead_ns, rows_[i].period_ns));
    }
    return std::max<std::int64_t>(least, 0);
  }
  /// Event of an instance, counted from 0.
  std::int64_t event_ns(std::int64_t instance) const {
    const Row& first = rows_.front();
    if (begins_with_row_) return instance * first.period_ns - first.lead_ns;
    std::int64_t latest_ns = -jitter_ns_;  // not before the first
    for (const Row& row : rows_) {
      latest_ns = std::max(latest_ns, instance * row.period_ns - row.lead_ns);
    }
    return latest_ns;
  }

 private:
  struct Row {
    std::int64_t period_ns;  ///< above 0
    std::int64_t lead_ns;    ///< greatest lead of an instance over its place, with its jitter
  };

  static std::int64_t ns(Duration duration) { return std::chrono::nanoseconds(duration).count(); }
  explicit Release(const BusMessage& message) : jitter_ns_(ns(message.jitter)) {}
  void add_row(Duration period, Duration ahead) {
    rows_.push_back({ns(period), jitter_ns_ + ns(ahead)});
  }

  std::vector<Row> rows_;
  std::int64_t jitter_ns_;
  bool begins_with_row_ = false;
};

}  // namespace canvoy::timing
