#include "canvoy/text/doctor/sync_watch.hpp"

#include <algorithm>

namespace canvoy::text {

void SyncWatch::hear(Time at, const Frame& frame, std::optional<Duration> expected) {
  if (heard_.count != 0) intervals_[intervals_heard_++ % intervals_max] = at - heard_.last;
  heard_.add(at);
  rhythm_.hear(at, expected);
  can_id_ = static_cast<std::uint16_t>(frame.id);
  hear_counter(at, frame);
}

/// The counter restarts with 1 after its overflow, and when its producer restarts.
void SyncWatch::hear_counter(Time at, const Frame& frame) {
  const std::uint8_t counter = frame.length == 1 ? frame.data[0] : std::uint8_t{0};
  const bool follows = counter == counter_ + 1 || counter <= 1 || counter_ == 0;
  if (!follows) jumps_.add(at);
  counter_ = counter;
}

Duration SyncWatch::period() const {
  constexpr std::size_t least = 4;
  const std::size_t count = std::min(intervals_heard_, intervals_max);
  if (count < least) return {};
  std::array<Duration, intervals_max> sorted = intervals_;
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return sorted[count / 2];
}

}  // namespace canvoy::text
