// When the frames with one identifier were heard, as a period, how far they run ahead of it, and
// their shortest distance: what the analysis takes of a bus of which nobody knows the plan.
//
//     Arrivals arrivals;
//     arrivals.add(now);                            // for each frame
//     arrivals.describe(message, listened_for);
//
// Memory: the corners of the hull of (number, time), some dozens in practice, and not more than the
// square root of twice the microseconds that were listened for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

class Arrivals {
 public:
  /// Times come in order; one that is before the latest counts as the latest.
  void add(Time when);

  std::uint64_t count() const { return count_; }   ///< of times that were added
  Duration shortest() const { return shortest_; }  ///< zero before the second
  Duration longest() const { return longest_; }    ///< zero before the second

  /// Sets `period`, `ahead`, `distance` and `bursts` so that all that was heard within `listened`
  /// (not shorter than it took, and above zero) fits them. The period is the mean one while frames
  /// came, or `listened` over their number where they came in a part of it only. At least one was
  /// heard.
  void describe(BusMessage& message, Duration listened) const;

 private:
  struct Corner {
    double number;  ///< of frames before it
    double us;      ///< since the first
  };
  /// Of a row of events a period apart: how far ahead of it some came.
  struct Bucket {
    double lowest_us = 0;  ///< the least lead of a frame over the row from the first; 0 or below
    double ahead_us = 0;   ///< how far a lead rose above the least before it; 0 or more
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
