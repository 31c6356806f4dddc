#include "canvoy/worlds/bus_line/local_clock.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::bus_line {

LocalClock::LocalClock(std::vector<OffsetChange> changes) : changes_(std::move(changes)) {
  check_invariant(!changes_.empty());
}

std::int64_t LocalClock::offset_at(EpochSeconds utc) const {
  const auto next = std::ranges::upper_bound(changes_, utc, {}, &OffsetChange::since);
  return next == changes_.begin() ? changes_.front().offset : std::prev(next)->offset;
}

EpochSeconds LocalClock::service_begin(const std::chrono::year_month_day& date) const {
  using std::chrono::seconds;
  constexpr EpochSeconds half_a_day = seconds(std::chrono::hours(12)).count();
  const seconds midnight = std::chrono::sys_days(date).time_since_epoch();
  const EpochSeconds noon = midnight.count() + half_a_day;
  // No clock is set at noon, so that the offset around noon holds at noon.
  return noon - offset_at(noon - offset_at(noon)) - half_a_day;
}

}  // namespace canvoy::bus_line
