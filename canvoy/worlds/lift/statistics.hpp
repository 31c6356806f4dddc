// Statistics of a run: how long people waited and travelled, how many people a group carries in
// five minutes, how often machines start, how much energy they consume.
//
//     PassengerStatistics statistics;
//     statistics.boarded(now - arrived_at);
//     statistics.served(now, now - arrived_at);
//     statistics.waiting().percentile(90);
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::lift {

/// A sample of durations.
class DurationSample {
 public:
  /// Adds a value; memory grows with their number.
  void add(Duration value);

  /// Number of values.
  std::size_t count() const { return values_.size(); }
  /// Zero where there are no values.
  Duration mean() const;
  /// Zero where there are no values.
  Duration longest() const;
  /// Value that `percent` of the values do not exceed (nearest rank). `percent` is above 0, up to
  /// 100; linear.
  Duration percentile(unsigned percent) const;

 private:
  std::vector<Duration> values_;
  Duration sum_{0};
  Duration longest_{0};
};

/// Statistics of all passengers of a run.
class PassengerStatistics {
 public:
  static constexpr Duration window = 5min;  ///< in which passengers are counted

  /// A passenger boards a car, `waited` after they came to the landing.
  void boarded(Duration waited);
  /// A passenger leaves it at the destination, `since_arrival` after they came to the landing.
  void served(Time now, Duration since_arrival);
  /// A passenger leaves the landing by the stairs: this is a waiting time, too.
  void gave_up(Duration waited) {
    ++gave_up_;
    waiting_.add(waited);
  }

  /// Waiting times: until boarding, or until leaving for those who gave up.
  const DurationSample& waiting() const { return waiting_; }
  /// From arrival at the landing to the destination.
  const DurationSample& to_destination() const { return to_destination_; }
  /// Passengers who reached it.
  std::size_t served_count() const { return to_destination_.count(); }
  /// Passengers who took the stairs.
  std::size_t gave_up_count() const { return gave_up_; }
  /// The greatest number that was carried to their destinations in any five minutes of the run so
  /// far.
  std::size_t most_in_5_minutes() const { return most_in_window_; }

 private:
  DurationSample waiting_;
  DurationSample to_destination_;
  std::deque<Time> recent_;
  std::size_t most_in_window_ = 0;
  std::size_t gave_up_ = 0;
};

/// Times at which cars left the main floor in an up-peak: the interval of the classical
/// calculation.
class DepartureStatistics {
 public:
  /// A car leaves the main floor upward with people in it.
  void departed(Time now, unsigned persons);
  /// Restarts the statistics: a run needs some trips until it is steady.
  void restart();

  /// Number of departures since the start or restart.
  std::size_t count() const { return count_; }
  /// Mean time between two departures; 0 before there are two.
  double interval_s() const;
  /// Mean number of people in a car, without the first; 0 before there are two departures.
  double persons_mean() const;
  /// Computed from departures: persons on board divided by the time.
  double persons_in_5_minutes() const;

 private:
  std::size_t count_ = 0;
  std::uint64_t persons_ = 0;  ///< without those of the first car
  Time first_{};
  Time last_{};
};

/// Statistics of one lift.
struct LiftStatistics {
  std::uint32_t starts = 0;  ///< from a standstill
  double distance_m = 0;     ///< up and down
  double energy_wh = 0;      ///< taken from the mains, less what was returned

  /// Mean over `run`.
  double starts_an_hour(Duration run) const;
};

}  // namespace canvoy::lift
