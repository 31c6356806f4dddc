// What is reported of a run: how long people waited and travelled, how many a group carries in five
// minutes, how often machines start, what they consume.
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
  void add(Duration value);

  std::size_t count() const { return values_.size(); }
  /// Zero where there are none.
  Duration mean() const;
  Duration longest() const;
  /// `percent` of the values are not longer (nearest rank). Above 0 to 100; linear.
  Duration percentile(unsigned percent) const;

 private:
  std::vector<Duration> values_;
  Duration sum_{0};
  Duration longest_{0};
};

/// Of all passengers of a run.
class PassengerStatistics {
 public:
  static constexpr Duration window = 5min;

  /// A passenger is in a car, `waited` after he came to the landing.
  void boarded(Duration waited);
  /// He left it at his destination, `since_arrival` after he came to the landing.
  void served(Time now, Duration since_arrival);
  /// He left the landing by the stairs: he waited, too.
  void gave_up(Duration waited) {
    ++gave_up_;
    waiting_.add(waited);
  }

  /// Of those who boarded, until they did; of those who gave up, until they left.
  const DurationSample& waiting() const { return waiting_; }
  const DurationSample& to_destination() const { return to_destination_; }
  std::size_t served_count() const { return to_destination_.count(); }
  std::size_t gave_up_count() const { return gave_up_; }
  /// The most that were carried to their destination in any five minutes of the run so far.
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
  void departed(Time now, unsigned persons);
  /// From now on: a run needs some trips until it is steady.
  void restart();

  std::size_t count() const { return count_; }
  /// Mean time between two departures; 0 before there are two.
  double interval_s() const;
  double persons_mean() const;
  /// As the cars left: persons on board by the time.
  double persons_in_5_minutes() const;

 private:
  std::size_t count_ = 0;
  std::uint64_t persons_ = 0;  ///< without the first car's
  Time first_{};
  Time last_{};
};

/// Of one lift.
struct LiftStatistics {
  std::uint32_t starts = 0;
  double distance_m = 0;
  double energy_wh = 0;

  double starts_an_hour(Duration run) const;
};

}  // namespace canvoy::lift
