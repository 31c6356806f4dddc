// What a soak says of a network that has run: which invariants are broken, and where a sabotage was
// not seen.
#pragma once

#include <cstdint>
#include <cstdio>

namespace canvoy::soak {

/// Tells of each invariant that is broken.
template <class Network>
bool all_hold(std::uint64_t seed, const Network& network) {
  bool good = true;
  for (const auto& invariant : network.invariants()) {
    if (invariant.held) continue;
    good = false;
    std::printf("seed %llu: %s: %g where no more than %g may be\n",
                static_cast<unsigned long long>(seed), invariant_name(invariant.kind).name.data(),
                invariant.worst, invariant.allowed);
    std::fflush(stdout);
  }
  return good;
}

/// Whether this invariant is broken; `complaint` where it is not.
template <class Network, class Kind>
bool is_seen(std::uint64_t seed, const Network& network, Kind kind, const char* complaint) {
  for (const auto& invariant : network.invariants()) {
    if (invariant.kind == kind && !invariant.held) return true;
  }
  std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), complaint);
  return false;
}

}  // namespace canvoy::soak
