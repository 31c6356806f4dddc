// The clock of a node with a quartz error of some parts per million, relative to the true time of
// the world.
//
//     DriftingClock clock(+50);                       // 50 µs fast each second
//     node.advance(clock.node_time(now));
//     Time wake = clock.world_time(node.next_deadline());
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// The clock. It and the world's clock show zero at the start. All arithmetic is in integers: no
/// rounding accumulates.
class DriftingClock {
 public:
  constexpr DriftingClock() = default;
  /// Makes a clock; `drift_ppm` is limited to -900'000 to 900'000.
  constexpr explicit DriftingClock(std::int32_t drift_ppm)
      : drift_ppm_(drift_ppm < -ppm_max ? -ppm_max : (drift_ppm > ppm_max ? ppm_max : drift_ppm)) {}

  /// Parts per million by which the clock is fast; negative: slow.
  constexpr std::int32_t drift_ppm() const { return drift_ppm_; }

  /// Time of the node's clock, rounded down, at the world time `world`.
  constexpr Time node_time(Time world) const {
    if (drift_ppm_ == 0 || world == never) return world;
    return Time(Duration(scaled(world.time_since_epoch().count(), million + drift_ppm_, million)));
  }

  /// First world time at which the node's clock shows `node` or more; never for never.
  constexpr Time world_time(Time node) const {
    if (drift_ppm_ == 0 || node == never) return node;
    const std::int64_t count = node.time_since_epoch().count();
    Time world(Duration(scaled(count, million, million + drift_ppm_)));
    while (node_time(world) < node) world += Duration(1);
    while (node_time(world - Duration(1)) >= node) world -= Duration(1);
    return world;
  }

 private:
  static constexpr std::int64_t million = 1'000'000;
  static constexpr std::int32_t ppm_max = 900'000;

  /// value * factor / divisor, rounded down, without overflow of the product in any realistic time
  /// span.
  static constexpr std::int64_t scaled(std::int64_t value, std::int64_t factor,
                                       std::int64_t divisor) {
    const std::int64_t whole = floor_div(value, divisor);
    return whole * factor + floor_div((value - whole * divisor) * factor, divisor);
  }
  static constexpr std::int64_t floor_div(std::int64_t value, std::int64_t divisor) {
    return value / divisor - (value % divisor < 0 ? 1 : 0);
  }

  std::int32_t drift_ppm_ = 0;
};

}  // namespace canvoy
