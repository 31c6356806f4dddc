#include "canvoy/worlds/gap_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "canvoy/sim/gap_sweep.hpp"
#include "canvoy/worlds/bus_line/bus_soak.hpp"
#include "canvoy/worlds/charger/charger_soak.hpp"
#include "canvoy/worlds/excavator/excavator_soak.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_soak.hpp"
#include "canvoy/worlds/lift/standstill_watch.hpp"
#include "canvoy/worlds/police/police_soak.hpp"
#include "canvoy/worlds/taxi/taxi_soak.hpp"

namespace canvoy {

namespace {

/// All nodes start to work before `begin`, and have `quiet` after the gap to come back.
constexpr Duration begin = 10s;
constexpr Duration quiet = 5min;

/// Broken invariants, in the words of the world.
template <class Network>
void judge(const Network& network, GapRun& run) {
  for (const auto& invariant : network.invariants()) {
    if (invariant.held) continue;
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, ": %g where no more than %g may be", invariant.worst,
                  invariant.allowed);
    run.wrong.push_back(std::string(invariant_name(invariant.kind).name) + numbers);
  }
}

/// Events of a run with the same options and without a fault.
template <class Network, class Options>
std::vector<Time> moments_without_fault(const Options& options, Duration time) {
  Network network(options);
  network.run_until(Time(time));
  return moments_of(network.events(), Time(begin), Time(time - quiet));
}

template <class List>
const auto& one_of(const List& list, Random& random) {
  return list[random.below(static_cast<std::uint32_t>(std::size(list)))];
}

template <class Fault, class Kinds>
void place(Fault& fault, const Kinds& kinds, Random& random, const Gap& gap) {
  fault.kind = one_of(kinds, random);
  fault.start = gap.start;
  fault.duration = gap.duration;
}

/// Data from which a run of a world with one gap is drawn.
struct Drawn {
  Duration time;
  std::span<const Duration> consumer_times;
};

template <class Network, class Options, class Fault, class Kinds>
GapRun run_gap(Options options, const Drawn& drawn, const Kinds& kinds, Fault fault,
               Random& random) {
  const Duration time = drawn.time;
  const auto moments = moments_without_fault<Network>(options, time);
  if (moments.empty()) return {};
  place(fault, kinds, random, draw_gap(random, moments, drawn.consumer_times));
  GapRun run{.fault = fault_text(fault), .wrong = {}, .time = time};
  options.faults.faults = {fault};
  Network network(options);
  network.run_until(Time(time));
  judge(network, run);
  return run;
}

// Lifts.

/// Heartbeats of drive (1 s) and units (1.5 s) at both ends, of panels (3 s), of a group.
constexpr Duration lift_times[] = {400ms, 800ms, 1000ms, 1500ms, 3s};
constexpr Duration lift_time = 12min;
/// A trip that ends early (4 s), a fault that ends (5 s), and doors that stay open for boarding
/// people (4 s); after a gap that is detected within a heartbeat's time.
constexpr Duration lift_stands_most = 15s;

lift::LiftNetworkDescription lifts_of(Random& random, std::uint64_t seed) {
  lift::StandardLifts options{.seed = seed};
  options.lifts = static_cast<lift::LiftNumber>(random.below(4) == 0 ? 2 + random.below(2) : 1);
  options.floors = static_cast<lift::FloorNumber>(4 + random.below(9));
  options.traffic.pattern = static_cast<lift::TrafficPattern>(random.below(4));
  lift::LiftNetworkDescription made = lift::standard_lift_network(options);
  made.people.holds_door = 0;
  return made;
}

GapRun run_lift(const lift::LiftNetworkDescription& description,
                const lift::ScheduledFault& fault) {
  GapRun run{.fault = fault_text(fault), .wrong = {}, .time = lift_time};
  lift::LiftNetwork network(description);
  lift::StandstillWatch watch;
  for (Time at{}; at <= Time(lift_time); at += lift::StandstillWatch::period) {
    network.run_until(at);
    watch.look(network.snapshot());
  }
  judge(network, run);
  if (watch.longest() > fault.duration + lift_stands_most) {
    char text[80];
    std::snprintf(text, sizeof text, "stood still for %.1f s with people who wanted to go",
                  std::chrono::duration<double>(watch.longest()).count());
    run.wrong.emplace_back(text);
  }
  return run;
}

GapRun lift_gap(std::uint64_t seed) {
  Random random(seed);
  lift::LiftNetworkDescription description = lifts_of(random, seed);
  const auto moments = moments_without_fault<lift::LiftNetwork>(description, lift_time);
  if (moments.empty()) return {};
  constexpr lift::FaultKind kinds[] = {lift::FaultKind::cable_cut, lift::FaultKind::cable_cut,
                                       lift::FaultKind::cable_cut, lift::FaultKind::lost_node};
  const lift::NodeDescription& node = one_of(description.nodes, random);
  lift::ScheduledFault fault{.part = node.lift, .node = node.id};
  place(fault, kinds, random, draw_gap(random, moments, lift_times));
  description.faults.faults = {fault};
  return run_lift(description, fault);
}

// The other worlds.

GapRun charger_gap(std::uint64_t seed) {
  using namespace charger;
  Random random(seed);
  ChargerOptions options;
  options.faults.seed = seed;
  if (random.below(2) == 0) options.battery = BatteryPlant::lithium_48v();
  options.state_of_charge = 0.1 + 0.001 * random.below(700);
  constexpr FaultKind kinds[] = {FaultKind::cable_cut, FaultKind::pdo_loss,
                                 FaultKind::heartbeat_loss, FaultKind::battery_silent};
  constexpr Duration times[] = {1s, 2s, 3s};
  return run_gap<ChargerNetwork>(options, {20min, times}, kinds, charger::ScheduledFault{}, random);
}

/// Kinds of gaps in a world with nodes that can be cut off, or lose their power.
template <class Kind>
constexpr Kind gap_kinds[] = {Kind::cable_cut, Kind::cable_cut, Kind::cable_cut, Kind::lost_node};

GapRun taxi_gap(std::uint64_t seed) {
  using namespace taxi;
  Random random(seed);
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = 50min;
  constexpr Duration times[] = {500ms, 1s, 2s};
  const auto node = static_cast<NodeId>(1 + random.below(device_names.size()));
  return run_gap<TaxiNetwork>(options, {options.length, times}, gap_kinds<FaultKind>,
                              taxi::ScheduledFault{.node = node}, random);
}

GapRun police_gap(std::uint64_t seed) {
  using namespace police;
  Random random(seed);
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = 50min;
  constexpr Duration times[] = {500ms, 1s, 2s};
  const auto node = static_cast<NodeId>(1 + random.below(device_names.size()));
  return run_gap<PoliceNetwork>(options, {options.length, times}, gap_kinds<FaultKind>,
                                police::ScheduledFault{.node = node}, random);
}

GapRun bus_gap(std::uint64_t seed) {
  using namespace bus_line;
  Random random(seed);
  BusNetworkOptions options;
  options.faults.seed = seed;
  options.length = 45min;
  constexpr Duration times[] = {1200ms, 2500ms};
  const NodeId node = one_of(places_of(options.design.cars), random).id;
  return run_gap<BusNetwork>(options, {options.length, times}, gap_kinds<FaultKind>,
                             bus_line::ScheduledFault{.node = node}, random);
}

GapRun excavator_gap(std::uint64_t seed) {
  using namespace excavator;
  Random random(seed);
  ExcavatorOptions options;
  options.faults.seed = seed;
  options.length = 12min;
  constexpr FaultKind kinds[] = {FaultKind::cable_cut, FaultKind::cable_cut, FaultKind::bus_off,
                                 FaultKind::lost_node};
  constexpr Duration times[] = {consumer_time};
  const NodeId node = one_of(device_places, random).id;
  return run_gap<ExcavatorNetwork>(options, {options.length, times}, kinds,
                                   excavator::ScheduledFault{.node = node}, random);
}

// Soaks.

/// A run with the faults of its options, in which all must hold.
template <class Network, class Options>
SoakRun faulty_run(const Options& options, Duration time) {
  Network network(options);
  network.run_until(Time(time));
  GapRun judged;
  judge(network, judged);
  const auto& faults = options.faults.faults;
  const auto begins = [time](const auto& fault) { return fault.start < Time(time); };
  return {.wrong = judged.wrong,
          .time = network.now() - Time{},
          .sabotaged_time = {},
          .faults = static_cast<std::size_t>(std::ranges::count_if(faults, begins))};
}

/// Adds the time of a run with a sabotage, and a line if this invariant is not broken in it.
template <class Network, class Kind>
SoakRun and_seen(SoakRun run, const Network& sabotaged, Kind kind, const char* complaint) {
  run.sabotaged_time += sabotaged.now() - Time{};
  for (const auto& invariant : sabotaged.invariants()) {
    if (invariant.kind == kind && !invariant.held) return run;
  }
  run.wrong.emplace_back(complaint);
  return run;
}
template <class Network, class Options, class Kind>
SoakRun soak_of(const Options& options, const Options& sabotaged, Duration time, Kind kind,
                const char* complaint) {
  Network network(sabotaged);
  network.run_until(Time(time));
  return and_seen(faulty_run<Network>(options, time), network, kind, complaint);
}

SoakRun lift_soak(std::uint64_t seed) {
  using namespace lift;
  SoakRun run = faulty_run<LiftNetwork>(soak_network(seed), soak_time);
  const SoakRun pairs = faulty_run<LiftNetwork>(soak_network_of_pairs(seed), soak_time);
  for (const std::string& line : pairs.wrong) run.wrong.push_back("pairs of faults: " + line);
  run.time += pairs.time;
  run.faults += pairs.faults;
  return run;
}

SoakRun charger_soak(std::uint64_t seed) {
  using namespace charger;
  ChargerNetwork network(soak_charging(seed));
  weld_contactor(network);
  network.run_until(Time(charging_soak_time));
  return and_seen(faulty_run<ChargerNetwork>(soak_charging(seed), charging_soak_time), network,
                  InvariantKind::current_outside_handshake, "a welded contactor was not seen");
}

SoakRun taxi_soak(std::uint64_t seed) {
  using namespace taxi;
  TaxiOptions sabotaged = soak_taxi(seed);
  enlarge_wheels(sabotaged);
  return soak_of<TaxiNetwork>(soak_taxi(seed), sabotaged, taxi_soak_time, InvariantKind::distance,
                              "wheels that are too large were not seen");
}

SoakRun police_soak(std::uint64_t seed) {
  using namespace police;
  PoliceOptions sabotaged = soak_police(seed);
  darken(sabotaged);
  return soak_of<PoliceNetwork>(soak_police(seed), sabotaged, police_soak_time,
                                InvariantKind::blue_light, "flashers without light were not seen");
}

SoakRun bus_soak(std::uint64_t seed) {
  using namespace bus_line;
  BusNetworkOptions sabotaged = soak_bus(seed);
  freeze(sabotaged);
  return soak_of<BusNetwork>(soak_bus(seed), sabotaged, bus_soak_time, InvariantKind::lie,
                             "a destination that does not change was not seen");
}

SoakRun excavator_soak(std::uint64_t seed) {
  using namespace excavator;
  ExcavatorOptions sabotaged = soak_excavator(seed);
  darken(sabotaged);
  return soak_of<ExcavatorNetwork>(soak_excavator(seed), sabotaged, excavator_soak_time,
                                   InvariantKind::indicators, "a lamp without light was not seen");
}

constexpr SimulatedWorld all_worlds[] = {
    {"lift", lift_gap, lift_soak}, {"charger", charger_gap, charger_soak},
    {"taxi", taxi_gap, taxi_soak}, {"police", police_gap, police_soak},
    {"bus", bus_gap, bus_soak},    {"excavator", excavator_gap, excavator_soak}};

}  // namespace

std::span<const SimulatedWorld> simulated_worlds() {
  return all_worlds;
}

}  // namespace canvoy
