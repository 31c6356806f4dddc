// How many instances of a message are queued in the first t of a busy period, and when their
// events were: what response_time.cpp asks. Times are nanoseconds.
//
//     Release release = Release::anywhere(message);
//     release.count(t) * frame_ns
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

/// At or above the quotient. `divisor` is above zero.
constexpr std::int64_t divided_up(std::int64_t number, std::int64_t divisor) {
  return number > 0 ? (number - 1) / divisor + 1 : number / divisor;
}

class Release {
 public:
  /// All come as early as they can: the first at the start of the busy period.
  static Release anywhere(const BusMessage& message) {
    Release made(message);
    made.add_row(message.period, message.ahead);
    if (message.distance > Duration{}) made.add_row(message.distance, Duration{});
    for (const Burst& each : message.bursts) made.add_row(each.period, each.ahead);
    return made;
  }
  /// The first event at or behind the start of the busy period is at `phase_ns`, 0 to below the
  /// period; those before count where their jitter brings them into it.
  static Release at_phase(const BusMessage& message, std::int64_t phase_ns) {
    Release made(message);
    const std::int64_t period_ns = ns(message.period);
    const std::int64_t delayed = (made.jitter_ns_ + phase_ns) / period_ns;
    made.rows_.push_back({period_ns, delayed * period_ns - phase_ns});
    made.begins_with_row_ = true;
    return made;
  }

  /// Queued in [0, t), which `t_ns` ends. Not below 0.
  std::int64_t count(std::int64_t t_ns) const {
    std::int64_t least = divided_up(t_ns + rows_.front().lead_ns, rows_.front().period_ns);
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      least = std::min(least, divided_up(t_ns + rows_[i].lead_ns, rows_[i].period_ns));
    }
    return std::max<std::int64_t>(least, 0);
  }
  /// The event of an instance, from 0 on.
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
    std::int64_t lead_ns;    ///< how far before its place an instance may be, with its jitter
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
