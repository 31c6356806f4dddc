#include "canvoy/text/doctor/heartbeat_watch.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::text {

namespace {

bool is_near(Duration a, Duration b) {
  constexpr Duration least = 2ms;
  return std::chrono::abs(a - b) <= b / 32 + least;
}

}  // namespace

// With one sender, two consecutive intervals differ only by chance, and sum up to twice its period.
// With two senders of the same period, they alternate, and sum up to the period.
void RhythmWatch::hear(Time at, std::optional<Duration> expected) {
  constexpr unsigned pairs_least = 7;
  const Duration interval = at - latest_;
  latest_ = at;
  if (++heard_ < 2) return;
  const Duration pair = interval + interval_;
  const bool is_told = expected && *expected > Duration::zero();
  const bool may_be = !is_told || is_near(pair, *expected);
  if (heard_ > 3) {
    const bool is_uneven = std::chrono::abs(interval - interval_) > pair / 8;
    alternating_ = may_be && is_uneven && is_near(pair, pair_) ? alternating_ + 1 : 0;
  }
  if (heard_ > 2 && is_told) {
    const bool is_sooner = interval < *expected * 15 / 16;
    expected_pairs_ = may_be && is_sooner ? expected_pairs_ + 1 : 0;
  }
  if (alternating_ >= pairs_least || expected_pairs_ >= pairs_least) {
    const Time since = found_ ? found_->since : at;
    found_ = TwoRhythms{pair, std::min(interval, interval_), since, at};
  }
  interval_ = interval;
  pair_ = pair;
}

bool CrossingWatch::is_crossed(Time at, Duration period) const {
  constexpr Duration least = 10ms;
  bool has_between = false;
  for (std::size_t back = 1; back <= std::min(count_, times_max); ++back) {
    const Duration ago = at - times_[(count_ - back) % times_max];
    if (is_near(ago, period)) return has_between;
    if (ago > period) return false;
    has_between = has_between || (ago > least && period - ago > least);
  }
  return false;
}

void CrossingWatch::hear(Time at, std::optional<Duration> period) {
  constexpr std::size_t crossed_least = 8;
  const bool is_known = period && *period > Duration::zero();
  crossed_[count_ % times_max] = is_known && is_crossed(at, *period);
  times_[count_ % times_max] = at;
  ++count_;
  if (crossed_.count() >= crossed_least) found_ = at;
}

void PeriodsWatch::hear(Time at) {
  constexpr std::size_t least = 12;
  times_[count_++ % times_max] = at;
  if (count_ < least || is_near(ago(0) - ago(1), ago(1) - ago(2))) return;
  // Between two heartbeats of the shorter period comes at most one of the longer.
  for (const std::size_t start : {0U, 1U}) {
    for (const std::size_t step : {1U, 2U}) try_period(start, ago(start) - ago(start + step));
  }
}

/// Assigns each heartbeat to the sender whose sequence ends with number `start`, or to the other.
void PeriodsWatch::try_period(std::size_t start, Duration period) {
  constexpr unsigned mine_least = 6;
  constexpr unsigned others_least = 4;
  const std::size_t heard = std::min(count_, times_max);
  unsigned mine = 1;
  unsigned others = 0;
  Time my_time = ago(start);
  Time other_time{};
  Duration other_period{};
  for (std::size_t back = 0; back < heard; ++back) {
    if (back == start) continue;
    const Time time = ago(back);
    if (back > start && is_near(my_time - time, period)) {
      my_time = time;
      ++mine;
      continue;
    }
    if (back > start && my_time - time > period) return;
    if (others == 1) other_period = other_time - time;
    if (others > 1 && !is_near(other_time - time, other_period)) return;
    other_time = time;
    ++others;
  }
  const bool is_enough = mine >= mine_least && others >= others_least;
  // Each second heartbeat of one sender, and those between, of which one was late, are no two.
  if (is_enough && other_period > period * 17 / 16) {
    found_ = TwoPeriods{period, other_period, ago(0)};
  }
}

void NodeHeartbeats::hear(Time at, NmtState state, std::optional<Duration> expected,
                          Duration awake) {
  is_heard_ = true;
  if (is_running_) {
    const Duration interval = std::max(at - latest_, Duration::zero());
    if (intervals_.size() < intervals_max) {
      intervals_.push_back(interval);
    } else {
      intervals_[next_++ % intervals_max] = interval;
    }
    add_gap({at, interval, awake - awake_});
  }
  rhythm_.hear(at, expected);
  crossings_.hear(at, expected);
  periods_.hear(at);
  take_state(at, state);
  is_running_ = true;
  latest_ = at;
  awake_ = awake;
}

void NodeHeartbeats::take_state(Time at, NmtState state) {
  if (states_ >= 2 && state == before_ && state != state_) {
    most_turns_ = std::max(most_turns_, ++turns_);
    if (most_turns_ == turns_) in_turns_ = {state_, state};
    turned_at_ = at;
  } else if (states_ >= 2) {
    turns_ = 0;
  }
  states_ = std::min(states_ + 1, 2U);
  before_ = state_;
  state_ = state;
}

/// The time of the first heartbeat after a boot-up depends on the configuring node.
void NodeHeartbeats::boot_up(Time at, Duration awake, bool is_expected) {
  if (is_running_ && !is_expected) add_gap({at, at - latest_, awake - awake_});
  has_booted_ = true;
  is_running_ = false;
  states_ = 0;
  turns_ = 0;
}

void NodeHeartbeats::commanded(bool is_reset) {
  states_ = 0;
  turns_ = 0;
  if (is_reset) restart();
}

void NodeHeartbeats::restart() {
  is_running_ = false;
  rhythm_.restart();
  crossings_.restart();
  periods_.restart();
}

void NodeHeartbeats::forget() {
  restart();
  intervals_.clear();
  next_ = 0;
  gaps_.clear();
}

void NodeHeartbeats::end(Time at, Duration awake) {
  if (is_running_) add_gap({at, at - latest_, awake - awake_});
}

void NodeHeartbeats::add_gap(const HeartbeatGap& gap) {
  const auto place =
      std::ranges::upper_bound(gaps_, gap.awake, std::ranges::greater{}, &HeartbeatGap::awake);
  if (gaps_.size() == gaps_max && place == gaps_.end()) return;
  gaps_.insert(place, gap);
  if (gaps_.size() > gaps_max) gaps_.pop_back();
}

Duration NodeHeartbeats::period() const {
  constexpr std::size_t least = 3;
  if (intervals_.size() < least) return {};
  std::vector<Duration> sorted = intervals_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

std::pair<unsigned, unsigned> NodeHeartbeats::uneven(Duration period) const {
  const auto off = std::ranges::count_if(intervals_, [period](Duration interval) {
    return std::chrono::abs(interval - period) > period / 5 && interval < 2 * period;
  });
  return {static_cast<unsigned>(off), static_cast<unsigned>(intervals_.size())};
}

Duration NodeHeartbeats::jitter() const {
  if (intervals_.size() < 2) return {};
  double sum = 0;
  for (const Duration interval : intervals_) sum += static_cast<double>(interval.count());
  const double mean = sum / static_cast<double>(intervals_.size());
  double squares = 0;
  for (const Duration interval : intervals_) {
    const double off = static_cast<double>(interval.count()) - mean;
    squares += off * off;
  }
  return Duration(std::llround(std::sqrt(squares / static_cast<double>(intervals_.size() - 1))));
}

}  // namespace canvoy::text
