// A campaign of lifts with faults: for each seed an hour of a building with people and one fault
// after the other, and a line for each invariant that was broken. Exit status 0: none was.
//
//     canvoy_soak_lift 1000       # seeds 1 to 1000
//     canvoy_soak_lift 17 17      # seed 17 alone
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>

#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_soak.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::lift;

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// How many invariants were broken.
unsigned run(std::uint64_t seed) {
  LiftNetwork network(soak_network(seed));
  network.run_until(Time(soak_time));
  unsigned broken = 0;
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    ++broken;
    std::printf("seed %llu: invariant %d of lift %d, fault %lld: %g where no more than %g may be\n",
                static_cast<unsigned long long>(seed), static_cast<int>(invariant.kind),
                invariant.lift,
                invariant.fault == no_fault ? -1 : static_cast<long long>(invariant.fault),
                invariant.value, invariant.bound);
    std::fflush(stdout);
  }
  return broken;
}

}  // namespace

int main(int count, char** arguments) {
  const std::optional<std::uint64_t> first = count > 2 ? number(arguments[1]) : 1;
  const std::optional<std::uint64_t> last = count > 1 ? number(arguments[count - 1]) : 1000;
  if (!first || !last || count > 3) {
    std::fputs("usage: canvoy_soak_lift [[FIRST] LAST]: numbers of seeds\n", stderr);
    return 2;
  }
  unsigned bad = 0;
  for (std::uint64_t seed = *first; seed <= *last; ++seed) bad += run(seed) != 0 ? 1U : 0U;
  std::printf("%llu seeds of an hour, %u with a broken invariant\n",
              static_cast<unsigned long long>(*last - *first + 1), bad);
  return bad == 0 ? 0 : 1;
}
