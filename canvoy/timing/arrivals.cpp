#include "canvoy/timing/arrivals.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::timing {

void Arrivals::add(Time when) {
  if (count_ == 0) first_ = latest_ = when;
  when = std::max(when, latest_);
  const Duration gap = when - latest_;
  if (count_ > 0) {
    shortest_ = count_ == 1 ? gap : std::min(shortest_, gap);
    longest_ = std::max(longest_, gap);
  }
  latest_ = when;
  const Corner next = {static_cast<double>(count_), static_cast<double>((when - first_).count())};
  for (std::size_t i = 0; i < buckets_max; ++i) {
    // Lead of this frame over the row.
    const double level = next.number * bucket_period_us(i) - next.us;
    buckets_[i].lowest_us = std::min(buckets_[i].lowest_us, level);
    buckets_[i].ahead_us = std::max(buckets_[i].ahead_us, level - buckets_[i].lowest_us);
  }
  add_corner(late_, next, 1);
  add_corner(early_, next, -1);
  ++count_;
}

/// From 128 us, a short frame at 500 kbit/s, each twice as long as the one before.
double Arrivals::bucket_period_us(std::size_t bucket) {
  constexpr double first_us = 128;
  return first_us * static_cast<double>(std::uint64_t{1} << bucket);
}

/// Removes corners that the line to the next one passes on the wrong side.
void Arrivals::add_corner(std::vector<Corner>& hull, Corner next, double side) {
  while (hull.size() > 1) {
    const Corner& last = hull.back();
    const Corner& before = hull[hull.size() - 2];
    const double turn = (last.number - before.number) * (next.us - before.us) -
                        (last.us - before.us) * (next.number - before.number);
    if (turn * side < 0) break;
    hull.pop_back();
  }
  hull.push_back(next);
}

void Arrivals::describe(BusMessage& message, Duration listened) const {
  const Duration active = latest_ - first_;
  const auto all = static_cast<double>(count_);
  double period_us = static_cast<double>(listened.count()) / all;
  if (count_ > 1) {
    const double mean_us = static_cast<double>(active.count()) / (all - 1);
    const bool came_throughout = static_cast<double>((listened - active).count()) <= 2 * mean_us;
    if (came_throughout) period_us = mean_us;
  }
  period_us = std::max(period_us, 1.0);
  const auto place = [&](const Corner& each) { return each.us - each.number * period_us; };
  double latest = 0;
  double earliest = 0;
  for (const Corner& each : late_) latest = std::max(latest, place(each));
  for (const Corner& each : early_) earliest = std::min(earliest, place(each));
  message.period = Duration(static_cast<std::int64_t>(period_us));
  message.ahead = Duration(static_cast<std::int64_t>(std::ceil(latest - earliest)));
  message.bursts.clear();
  for (std::size_t i = 0; i < buckets_max; ++i) {
    const Duration row(static_cast<std::int64_t>(bucket_period_us(i)));
    if (row <= shortest_ || row >= message.period) continue;  // another row contains it already
    message.bursts.push_back(
        {row, Duration(static_cast<std::int64_t>(std::ceil(buckets_[i].ahead_us)))});
  }
  message.distance = count_ > 1 ? std::clamp(shortest_, Duration{0}, message.period) : Duration{0};
}

}  // namespace canvoy::timing
