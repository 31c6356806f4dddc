// How regularly vehicles follow each other at stops, as the Transit Capacity and Quality of Service
// Manual measures it: the standard deviation of the differences between headways and planned ones,
// in relation to the mean of the planned ones.
//
//     Headways headways;
//     headways.add(10min, 7min + 30s);
//     headways.variation();    // 0: as planned; 1: pairs of vehicles
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::bus_line {

class Headways {
 public:
  /// `planned` is above 0; `real` is negative where the vehicle has overtaken the one ahead.
  void add(Duration planned, Duration real) {
    const double deviation = std::chrono::duration<double>(real - planned).count();
    ++count_;
    planned_ += std::chrono::duration<double>(planned).count();
    sum_ += deviation;
    squares_ += deviation * deviation;
    if (real < planned / 4) ++bunched_;
  }
  /// Adds those of another day.
  void add(const Headways& more) {
    count_ += more.count_;
    bunched_ += more.bunched_;
    planned_ += more.planned_;
    sum_ += more.sum_;
    squares_ += more.squares_;
  }

  /// Number of headways.
  std::uint64_t count() const { return count_; }
  /// Standard deviation of the differences to the plan, in relation to the mean of the plan; 0
  /// without any headway.
  double variation() const {
    if (count_ == 0) return 0;
    const auto count = static_cast<double>(count_);
    const double variance = squares_ / count - sum_ / count * (sum_ / count);
    return std::sqrt(variance > 0 ? variance : 0) / (planned_ / count);
  }
  /// Share of headways below a quarter of the planned one, 0 to 1.
  double bunched() const {
    return count_ == 0 ? 0 : static_cast<double>(bunched_) / static_cast<double>(count_);
  }

 private:
  std::uint64_t count_ = 0;
  std::uint64_t bunched_ = 0;
  double planned_ = 0;  ///< sum, in s
  double sum_ = 0;      ///< of deviations, in s
  double squares_ = 0;  ///< of deviations, in s²
};

}  // namespace canvoy::bus_line
