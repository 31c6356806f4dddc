// Draws the faults of a soak: a seed decides which occur, when and for how long, alone and in
// pairs.
//
//     Random random(seed);
//     faults = soak_faults(random, 6, time - quiet, [](Random& random, Time start) {
//       return soak_fault<FaultKind>(random, start);
//     });
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy {

/// Draws a time from zero to just below `max`, in whole milliseconds.
inline Duration soak_time_up_to(Random& random, Duration max) {
  return Duration(1ms) * random.below(static_cast<std::uint32_t>(max / Duration(1ms)));
}

/// Draws a fault of any kind of a world that lasts from an instant to minutes. A fault of a node is
/// at any of `nodes` nodes; `node_at` returns them by their numbers from 0 on.
template <class Kind>
ScheduledFault<Kind> soak_fault(Random& random, Time start, std::size_t nodes = 0,
                                NodeId (*node_at)(std::size_t) = nullptr) {
  constexpr Duration longest[] = {200ms, 3s, 30s, 5min};
  const auto any_of = [&random](std::size_t count) {
    return random.below(static_cast<std::uint32_t>(count));
  };
  ScheduledFault<Kind> fault{};
  fault.kind = static_cast<Kind>(any_of(untampered_kinds(fault_grammar<Kind>().kinds)));
  fault.start = start;
  fault.duration = Duration(1ms) + soak_time_up_to(random, longest[random.below(4)]);
  if (has_node(fault.kind)) fault.node = node_at(any_of(nodes));
  if (has_spot(fault.kind))
    fault.spot = static_cast<std::uint8_t>(1 + any_of(fault_row(fault.kind).traits.spot));
  return fault;
}

/// Draws one to `most` faults, or one more, that begin within `time`, some of them at its start.
/// Half of them meet another one: at the same time, while it lasts, or as it ends. `any_fault`
/// makes one that begins at an instant.
template <class AnyFault>
auto soak_faults(Random& random, std::uint32_t most, Duration time, const AnyFault& any_fault) {
  std::vector<std::invoke_result_t<const AnyFault&, Random&, Time>> faults;
  const unsigned count = 1 + random.below(most);
  while (faults.size() < count) {
    const bool at_start = random.below(8) == 0;
    const auto first = any_fault(random, at_start ? Time{} : Time(soak_time_up_to(random, time)));
    faults.push_back(first);
    if (random.below(2) == 0) continue;
    const Time meets[] = {first.start, first.start + soak_time_up_to(random, first.duration + 1ms),
                          first.end()};
    faults.push_back(any_fault(random, meets[random.below(3)]));
  }
  return faults;
}

}  // namespace canvoy
