#include "canvoy/worlds/lift/statistics.hpp"

#include <algorithm>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::lift {

void DurationSample::add(Duration value) {
  values_.push_back(value);
  sum_ += value;
  longest_ = std::max(longest_, value);
}

Duration DurationSample::mean() const {
  if (values_.empty()) return Duration{0};
  return sum_ / static_cast<Duration::rep>(values_.size());
}

Duration DurationSample::longest() const {
  return longest_;
}

Duration DurationSample::percentile(unsigned percent) const {
  if (values_.empty()) return Duration{0};
  const std::size_t rank = std::max<std::size_t>((values_.size() * percent + 99) / 100, 1);
  std::vector<Duration> ranked = values_;
  const auto wanted = ranked.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(ranked.begin(), wanted, ranked.end());
  return *wanted;
}

void PassengerStatistics::boarded(Duration waited) {
  waiting_.add(waited);
}

void PassengerStatistics::served(Time now, Duration since_arrival) {
  to_destination_.add(since_arrival);
  recent_.push_back(now);
  while (recent_.front() <= now - window) recent_.pop_front();
  most_in_window_ = std::max(most_in_window_, recent_.size());
}

void DepartureStatistics::departed(Time now, unsigned persons) {
  if (count_ == 0) {
    first_ = now;
  } else {
    persons_ += persons;
  }
  last_ = now;
  ++count_;
}

void DepartureStatistics::restart() {
  *this = {};
}

double DepartureStatistics::interval_s() const {
  if (count_ < 2) return 0;
  return in_seconds(last_ - first_) / static_cast<double>(count_ - 1);
}

double DepartureStatistics::persons_mean() const {
  if (count_ < 2) return 0;
  return static_cast<double>(persons_) / static_cast<double>(count_ - 1);
}

double DepartureStatistics::persons_in_5_minutes() const {
  if (count_ < 2) return 0;
  return static_cast<double>(persons_) / in_seconds(last_ - first_) *
         in_seconds(PassengerStatistics::window);
}

double LiftStatistics::starts_an_hour(Duration run) const {
  return run <= Duration{0} ? 0 : starts / in_seconds(run) * 3600;
}

}  // namespace canvoy::lift
