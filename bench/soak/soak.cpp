// Campaigns in the simulated worlds, one run for each seed: hours with faults, alone and in pairs,
// in which all invariants must hold, and with a sabotage, which must be detected; or gaps of 1 ms
// to 3 s in the communication of each world; or each fault of a bus at a terminal, between stops
// and at one. Prints a line for each wrong verdict; exit status 0: none, 1: some, 2: wrong usage.
//
//     canvoy_soak taxi 200      # seeds 1 to 200
//     canvoy_soak gaps 17 17    # seed 17 alone, of each world
//     canvoy_soak bus-places 5
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/worlds/bus_line/bus_sweep.hpp"
#include "canvoy/worlds/gap_runs.hpp"

namespace {

using canvoy::SimulatedWorld;

std::optional<std::uint64_t> seed_of(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void tell(const char* world, std::uint64_t seed, const std::string& wrong) {
  std::printf("%s, seed %llu: %s\n", world, static_cast<unsigned long long>(seed), wrong.c_str());
  std::fflush(stdout);
}

bool gaps_are_good(std::uint64_t seed) {
  bool is_good = true;
  for (const SimulatedWorld& world : canvoy::simulated_worlds()) {
    const canvoy::GapRun run = world.gap(seed);
    for (const std::string& wrong : run.wrong) tell(world.name, seed, run.fault + ": " + wrong);
    is_good = is_good && run.wrong.empty();
  }
  return is_good;
}

bool places_are_good(std::uint64_t seed) {
  bool is_good = true;
  for (const canvoy::bus_line::SweptFault& swept : canvoy::bus_line::swept_faults(seed)) {
    const std::vector<std::string> all = canvoy::bus_line::wrong_verdicts(seed, swept);
    for (const std::string& wrong : all) tell("bus", seed, wrong);
    is_good = is_good && all.empty();
  }
  return is_good;
}

bool soak_is_good(const SimulatedWorld& world, std::uint64_t seed) {
  const std::vector<std::string> all = world.soak(seed);
  for (const std::string& wrong : all) tell(world.name, seed, wrong);
  return all.empty();
}

bool run_is_good(std::string_view name, std::uint64_t seed) {
  if (name == "gaps") return gaps_are_good(seed);
  if (name == "bus-places") return places_are_good(seed);
  return soak_is_good(*std::ranges::find(canvoy::simulated_worlds(), name, &SimulatedWorld::name),
                      seed);
}

int usage() {
  std::fprintf(
      stderr,
      "usage: canvoy_soak WORLD [[FIRST] LAST]: numbers of seeds; worlds are gaps, bus-places");
  for (const SimulatedWorld& world : canvoy::simulated_worlds()) {
    std::fprintf(stderr, ", %s", world.name);
  }
  std::fprintf(stderr, "\n");
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 4) return usage();
  const std::string_view name = arguments[1];
  const auto worlds = canvoy::simulated_worlds();
  const bool is_known = name == "gaps" || name == "bus-places" ||
                        std::ranges::find(worlds, name, &SimulatedWorld::name) != worlds.end();
  const std::optional<std::uint64_t> first = count > 3 ? seed_of(arguments[2]) : 1;
  const std::optional<std::uint64_t> last = count > 2 ? seed_of(arguments[count - 1]) : 1000;
  if (!is_known || !first || !last) return usage();
  unsigned bad = 0;
  for (std::uint64_t seed = *first; seed <= *last; ++seed) {
    bad += run_is_good(name, seed) ? 0U : 1U;
  }
  std::printf("%llu seeds, %u with a wrong verdict\n",
              static_cast<unsigned long long>(*last - *first + 1), bad);
  return bad == 0 ? 0 : 1;
}
