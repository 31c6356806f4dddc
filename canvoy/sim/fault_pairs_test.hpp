// Pairs of faults in a world, with which tests try each kind beside each other: the second begins
// with the first, while it lasts, or as it ends.
//
//     for (const std::size_t second : kinds_beside(first, fault_kinds)) {
//       options.faults.faults = pair_of_faults<ScheduledFault>(first, second, start, lasts);
//       ...
//       EXPECT_EQ(broken(network), "");
//     }
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/sim/invariant.hpp"

namespace canvoy {

/// Kinds that are tried beside this one: every fourth, different ones for each kind; or all.
inline std::vector<std::size_t> kinds_beside(std::size_t first, std::size_t kinds) {
  const std::size_t step = tries_all() ? 1 : 4;
  std::vector<std::size_t> all;
  for (std::size_t kind = first % step; kind < kinds; kind += step) all.push_back(kind);
  return all;
}

/// A pair of faults of the same duration. Their kinds determine how they overlap.
template <class Fault>
std::vector<Fault> pair_of_faults(std::size_t first, std::size_t second, Time start,
                                  Duration lasts) {
  const Duration meets[] = {{}, lasts / 2, lasts};
  Fault one{};
  one.kind = static_cast<decltype(one.kind)>(first);
  one.start = start;
  one.duration = lasts;
  Fault other = one;
  other.kind = static_cast<decltype(other.kind)>(second);
  other.start += meets[(first + second) % 3];
  return {one, other};
}

/// Text of a pair: `lost-node and restart`
template <class Fault>
std::string pair_name(const std::vector<Fault>& pair) {
  return std::string(fault_name(pair.front().kind)) + " and " +
         std::string(fault_name(pair.back().kind));
}

/// Names of the broken invariants of a world, each followed by a space.
template <class Network>
std::string broken_names(const Network& network) {
  std::string names;
  for (const auto& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

}  // namespace canvoy
