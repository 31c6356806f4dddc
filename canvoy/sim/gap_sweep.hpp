// Draws gaps in the communication of a simulated world, at moments that matter in it: a run without
// a fault shows what happens when, and the gap begins around one of these events.
//
//     const auto moments = moments_of(network.events(), Time(10s), Time(15min));
//     Random random(seed);
//     const Gap gap = draw_gap(random, moments, consumer_times);
//     options.faults.faults = {{.kind = FaultKind::cable_cut, .start = gap.start,
//                               .duration = gap.duration}};
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// A loss of communication. It may be too short to be detected: some gaps are shorter than each
/// time after which a partner counts as lost.
struct Gap {
  Time start{};         ///< of the world
  Duration duration{};  ///< shortest_gap to longest_gap
};

inline constexpr Duration shortest_gap = 1ms;  ///< a frame or two
inline constexpr Duration longest_gap = 3s;    ///< longer than the usual consumer times

/// Times of the events, except the beginnings and ends of faults.
template <class Events>
std::vector<Time> moments_of(const Events& events, Time from, Time until) {
  std::vector<Time> moments;
  for (const auto& event : events) {
    if (event.at >= from && event.at < until) moments.push_back(event.at);
  }
  return moments;
}

namespace detail {

inline Duration up_to(Random& random, Duration most) {
  const auto count = static_cast<std::uint32_t>(most / Duration(1us));
  return Duration(random.below(count));
}

/// Draws a length around a time after which a partner counts as lost, or else of any order of
/// magnitude, each as likely.
inline Duration draw_length(Random& random, std::span<const Duration> consumer_times) {
  constexpr Duration around = 100ms;
  if (!consumer_times.empty() && random.below(2) == 0) {
    const auto count = static_cast<std::uint32_t>(consumer_times.size());
    const Duration time = consumer_times[random.below(count)] - around + up_to(random, 2 * around);
    return std::clamp(time, shortest_gap, longest_gap);
  }
  constexpr Duration orders[] = {10ms, 100ms, 1s, longest_gap};
  return std::max(shortest_gap, up_to(random, orders[random.below(4)]));
}

}  // namespace detail

/// Draws a gap that begins before, at or after one of the moments, and lasts 1 ms to 3 s. `moments`
/// must not be empty.
inline Gap draw_gap(Random& random, std::span<const Time> moments,
                    std::span<const Duration> consumer_times) {
  const Time moment = moments[random.below(static_cast<std::uint32_t>(moments.size()))];
  const Duration length = detail::draw_length(random, consumer_times);
  // The event is in the gap, at one of its ends, or near it.
  const Duration earlier = detail::up_to(random, length + 20ms);
  return {std::max(Time(1ms), moment + 10ms - earlier), length};
}

}  // namespace canvoy
