// Measures when frames with one identifier arrive: their period, how far they run ahead of it, and
// their shortest distance. Input of the analysis for a bus without a known schedule.
//
//     Arrivals arrivals;
//     arrivals.add(now);                            // for each frame
//     arrivals.describe(message, listened_for);
//
// Memory: the corners of the hull of (number, time), some dozens in practice, and not more than the
// square root of twice the microseconds listened.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

class Arrivals {
 public:
  /// Adds a time. Times come in order; a time before the latest counts as the latest.
  void add(Time when);

  std::uint64_t count() const { return count_; }  ///< number of times added
  /// Shortest distance; zero before the second time.
  Duration shortest() const { return shortest_; }
  Duration longest() const { return longest_; }  ///< longest distance; zero before the second time

  /// Sets `period`, `ahead`, `distance` and `bursts` so that all frames heard within `listened` fit
  /// them. `listened` is above zero and not shorter than the observed span. The period is the mean
  /// one while frames came, or `listened` divided by their number if they came in only a part of
  /// it. Needs at least one frame.
  void describe(BusMessage& message, Duration listened) const;

 private:
  struct Corner {
    double number;  ///< number of frames before it
    double us;      ///< since the first
  };
  /// Measures a row of events one period apart: how far ahead of it some came.
  struct Bucket {
    double lowest_us = 0;  ///< least lead of a frame over the row from the first; 0 or below
    double ahead_us = 0;   ///< greatest rise of a lead above the least before it; 0 or more
  };
  static constexpr std::size_t buckets_max = 24;
  static double bucket_period_us(std::size_t bucket);

  static void add_corner(std::vector<Corner>& hull, Corner next, double side);

  std::vector<Corner> late_;   // above all others
  std::vector<Corner> early_;  // below all others
  std::array<Bucket, buckets_max> buckets_{};
  std::uint64_t count_ = 0;
  Time first_{};
  Time latest_{};
  Duration shortest_{};
  Duration longest_{};
};

}  // namespace canvoy::timing
