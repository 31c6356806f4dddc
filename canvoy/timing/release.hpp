// How many instances of a message are queued in the first t of a busy period, and when their
// events were: what response_time.cpp asks. Times are nanoseconds.
//
//     Release release = Release::anywhere(message);
//     release.count(t) * frame_ns
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

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
    made.lead_ns_ = made.jitter_ns_ + ns(message.ahead);
    made.distance_ns_ = ns(message.distance);
    return made;
  }
  /// The first event at or behind the start of the busy period is at `phase_ns`, 0 to below the
  /// period; those before count where their jitter brings them into it.
  static Release at_phase(const BusMessage& message, std::int64_t phase_ns) {
    Release made(message);
    const std::int64_t delayed = (made.jitter_ns_ + phase_ns) / made.period_ns_;
    made.lead_ns_ = delayed * made.period_ns_ - phase_ns;
    made.begin_ns_ = -made.lead_ns_;
    return made;
  }

  /// Queued in [0, t), which `t_ns` ends. Not below 0.
  std::int64_t count(std::int64_t t_ns) const {
    const std::int64_t by_period = divided_up(t_ns + lead_ns_, period_ns_);
    if (distance_ns_ == 0) return std::max<std::int64_t>(by_period, 0);
    return std::min(by_period, divided_up(t_ns + jitter_ns_, distance_ns_));
  }
  /// The event of an instance, from 0 on.
  std::int64_t event_ns(std::int64_t instance) const {
    if (begin_ns_ != no_phase) return begin_ns_ + instance * period_ns_;
    const std::int64_t ahead_ns = lead_ns_ - jitter_ns_;
    const std::int64_t by_period = instance * period_ns_ - ahead_ns;
    return std::max<std::int64_t>({by_period, instance * distance_ns_, 0}) - jitter_ns_;
  }

 private:
  static constexpr std::int64_t no_phase = std::numeric_limits<std::int64_t>::max();

  static std::int64_t ns(Duration duration) { return std::chrono::nanoseconds(duration).count(); }
  explicit Release(const BusMessage& message)
      : period_ns_(ns(message.period)), jitter_ns_(ns(message.jitter)) {}

  std::int64_t period_ns_;
  std::int64_t jitter_ns_;
  std::int64_t lead_ns_ = 0;
  std::int64_t distance_ns_ = 0;
  std::int64_t begin_ns_ = no_phase;
};

}  // namespace canvoy::timing
