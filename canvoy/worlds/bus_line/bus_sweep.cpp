#include "canvoy/worlds/bus_line/bus_sweep.hpp"

#include <array>
#include <cstdio>

#include "canvoy/sim/soak_faults.hpp"
#include "canvoy/worlds/bus_line/bus_soak.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::size_t sweep_places = 3;
constexpr std::array<std::string_view, sweep_places> place_names = {"terminal", "between", "stop"};
/// Faults begin when the bus has left its first stop, and leave time to come back.
constexpr Time first_begin{Duration(6min)};
constexpr Time last_begin{Duration(26min)};
constexpr Duration fault_times[] = {1s, 10s, 1min, 5min, 10min};

BusNetworkOptions swept_bus(std::uint64_t seed) {
  BusNetworkOptions options;
  options.faults.seed = seed;
  options.length = bus_sweep_time;
  return options;
}

/// A span of time in which the bus is at one kind of place.
struct Span {
  Time from{};
  Time to{};
};

/// Spans of a run without a fault, by the order of place_names. At a terminal, the bus arrives once
/// more, where the next journey begins.
std::array<std::vector<Span>, sweep_places> spans_of(const BusNetwork& network) {
  using How = StopReached::How;
  std::array<std::vector<Span>, sweep_places> spans;
  const StopReached* last = nullptr;
  Time since{};
  bool is_terminal = false;
  for (const NetworkEvent& event : network.events()) {
    const auto* reached = std::get_if<StopReached>(&event.what);
    if (reached == nullptr) continue;
    if (last != nullptr && last->how == How::arrives && reached->how == How::arrives) {
      is_terminal = true;
      continue;
    }
    if (last != nullptr && since >= first_begin && since <= last_begin) {
      const std::size_t stood = is_terminal ? 0 : 2;
      spans.at(reached->how == How::leaves ? stood : 1).push_back({since, event.at});
    }
    last = reached;
    since = event.at;
    is_terminal = false;
  }
  return spans;
}

/// Kinds that are judged, each with the devices at which it may be.
std::vector<ScheduledFault> faults_to_sweep() {
  std::vector<ScheduledFault> faults;
  for (std::size_t i = 0; i < fault_kinds; ++i) {
    const auto kind = static_cast<FaultKind>(i);
    faults.push_back({.kind = kind});
    if (!has_node(kind)) continue;
    for (const DevicePlace& place : places_of(BusDesign{}.cars)) {
      faults.push_back({.kind = kind, .node = place.id});
    }
  }
  return faults;
}

}  // namespace

std::vector<SweptFault> swept_faults(std::uint64_t seed) {
  BusNetwork network(swept_bus(seed));
  network.run_until(Time(bus_sweep_time));
  const auto spans = spans_of(network);
  Random random(seed);
  std::vector<SweptFault> swept;
  for (ScheduledFault fault : faults_to_sweep()) {
    for (std::size_t place = 0; place < sweep_places; ++place) {
      const auto& all = spans.at(place);
      if (all.empty()) continue;
      const Span& span = all[random.below(static_cast<std::uint32_t>(all.size()))];
      fault.start = span.from + soak_time_up_to(random, span.to - span.from);
      fault.duration = fault_times[random.below(std::size(fault_times))];
      swept.push_back({place_names.at(place), fault});
    }
  }
  return swept;
}

std::vector<std::string> wrong_verdicts(std::uint64_t seed, const SweptFault& swept) {
  BusNetworkOptions options = swept_bus(seed);
  options.faults.faults = {swept.fault};
  const std::string where = fault_text(swept.fault) + " (" + std::string(swept.place) + "): ";
  std::vector<std::string> wrong;
  BusNetwork network(options);
  network.run_until(Time(bus_sweep_time));
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, " %g where no more than %g may be", invariant.worst,
                  invariant.allowed);
    wrong.push_back(where + std::string(invariant_name(invariant.kind).name) + numbers);
  }
  if (swept.fault.node != 0) return wrong;
  freeze(options);
  BusNetwork sabotaged(options);
  sabotaged.run_until(Time(bus_sweep_time));
  for (const Invariant& invariant : sabotaged.invariants()) {
    if (invariant.kind == InvariantKind::lie && invariant.held) {
      wrong.push_back(where + "a destination that does not change was not seen");
    }
  }
  return wrong;
}

}  // namespace canvoy::bus_line
