// Campaigns in the simulated worlds, one run for each seed: hours with faults, alone and in pairs,
// in which all invariants must hold, and with a sabotage, which must be detected; or gaps of 1 ms
// to 3 s in the communication of each world; or each fault of a bus at a terminal, between stops
// and at one. Prints a line for each wrong verdict, and at the end of each campaign what it
// simulated; exit status 0: no wrong verdict, 1: some, 2: wrong usage.
//
//     canvoy_soak all 5         # seeds 1 to 5 of each campaign
//     canvoy_soak taxi 200      # seeds 1 to 200
//     canvoy_soak gaps 17 17    # seed 17 alone, of each world
//     canvoy_soak bus-places 5
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <ratio>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
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

/// What a campaign simulated, and how many of its seeds had a wrong verdict.
struct Sum {
  std::uint64_t seeds = 0;
  unsigned wrong_seeds = 0;
  std::size_t faults = 0;
  canvoy::Duration time{};
  canvoy::Duration sabotaged_time{};
};

bool play_gaps(std::uint64_t seed, Sum& sum) {
  bool is_good = true;
  for (const SimulatedWorld& world : canvoy::simulated_worlds()) {
    const canvoy::GapRun run = world.gap(seed);
    for (const std::string& wrong : run.wrong) tell(world.name, seed, run.fault + ": " + wrong);
    is_good = is_good && run.wrong.empty();
    sum.faults += run.fault.empty() ? 0U : 1U;
    sum.time += run.time;
  }
  return is_good;
}

bool play_places(std::uint64_t seed, Sum& sum) {
  bool is_good = true;
  for (const canvoy::bus_line::SweptFault& swept : canvoy::bus_line::swept_faults(seed)) {
    const std::vector<std::string> all = canvoy::bus_line::wrong_verdicts(seed, swept);
    for (const std::string& wrong : all) tell("bus", seed, wrong);
    is_good = is_good && all.empty();
    ++sum.faults;
    sum.time += canvoy::bus_line::bus_sweep_time;
    if (swept.fault.node == 0) sum.sabotaged_time += canvoy::bus_line::bus_sweep_time;
  }
  return is_good;
}

bool play_soak(const SimulatedWorld& world, std::uint64_t seed, Sum& sum) {
  const canvoy::SoakRun run = world.soak(seed);
  for (const std::string& wrong : run.wrong) tell(world.name, seed, wrong);
  sum.faults += run.faults;
  sum.time += run.time;
  sum.sabotaged_time += run.sabotaged_time;
  return run.wrong.empty();
}

bool play(std::string_view name, std::uint64_t seed, Sum& sum) {
  if (name == "gaps") return play_gaps(seed, sum);
  if (name == "bus-places") return play_places(seed, sum);
  return play_soak(*std::ranges::find(canvoy::simulated_worlds(), name, &SimulatedWorld::name),
                   seed, sum);
}

/// True if no verdict was wrong.
bool run_campaign(std::string_view name, std::uint64_t first, std::uint64_t last) {
  Sum sum;
  for (std::uint64_t seed = first; seed <= last; ++seed, ++sum.seeds) {
    sum.wrong_seeds += play(name, seed, sum) ? 0U : 1U;
  }
  const auto hours = [](canvoy::Duration time) {
    return std::chrono::duration<double, std::ratio<3600>>(time).count();
  };
  std::printf(
      "%.*s: %llu seeds, %.1f h with %zu faults, %.1f h with a sabotage as well, %u seeds "
      "with a wrong verdict\n",
      static_cast<int>(name.size()), name.data(), static_cast<unsigned long long>(sum.seeds),
      hours(sum.time), sum.faults, hours(sum.sabotaged_time), sum.wrong_seeds);
  std::fflush(stdout);
  return sum.wrong_seeds == 0;
}

std::vector<std::string_view> all_campaigns() {
  std::vector<std::string_view> names;
  for (const SimulatedWorld& world : canvoy::simulated_worlds()) names.emplace_back(world.name);
  names.insert(names.end(), {"gaps", "bus-places"});
  return names;
}

int usage() {
  std::fprintf(stderr,
               "usage: canvoy_soak CAMPAIGN [[FIRST] LAST]: numbers of seeds; campaigns are all");
  for (const std::string_view name : all_campaigns()) {
    std::fprintf(stderr, ", %.*s", static_cast<int>(name.size()), name.data());
  }
  std::fprintf(stderr, "\n");
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 4) return usage();
  const std::string_view name = arguments[1];
  std::vector<std::string_view> campaigns = all_campaigns();
  if (name != "all")
    std::erase_if(campaigns, [name](std::string_view each) { return each != name; });
  const std::optional<std::uint64_t> first = count > 3 ? seed_of(arguments[2]) : 1;
  const std::optional<std::uint64_t> last = count > 2 ? seed_of(arguments[count - 1]) : 1000;
  if (campaigns.empty() || !first || !last) return usage();
  bool is_good = true;
  for (const std::string_view each : campaigns)
    is_good = run_campaign(each, *first, *last) && is_good;
  return is_good ? 0 : 1;
}
