#include "canvoy/sim/gap_runs.hpp"

#include <cmath>
#include <cstdio>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/sim/excavator/excavator_network.hpp"
#include "canvoy/sim/gap_sweep.hpp"
#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/standstill_watch.hpp"
#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy {

namespace {

/// Before it all begin to work, and after it everybody has the time to come back.
constexpr Duration begin = 10s;
constexpr Duration quiet = 5min;

/// What is broken, in the words of the world.
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

/// The same options without a fault say what happens when.
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

/// What a run of a world with one gap is drawn from.
struct Drawn {
  FaultGrammar grammar;
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
  GapRun run{.fault = fault_text(drawn.grammar, written(fault)), .wrong = {}};
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
/// A trip that has ended short (4 s), a fault that is gone (5 s), and doors that stay open for who
/// gets in (4 s); after a gap that was noticed in a heartbeat's time.
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
  GapRun run{.fault = fault_text(lift::fault_grammar(), lift::written(fault)), .wrong = {}};
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
  lift::ScheduledFault fault{.lift = node.lift, .node = node.id};
  place(fault, kinds, random, draw_gap(random, moments, lift_times));
  description.faults = {fault};
  return run_lift(description, fault);
}

// The others.

GapRun charger_gap(std::uint64_t seed) {
  using namespace charging;
  Random random(seed);
  ChargingOptions options;
  options.faults.seed = seed;
  if (random.below(2) == 0) options.battery = BatteryPlant::lithium_48v();
  options.state_of_charge = 0.1 + 0.001 * random.below(700);
  constexpr FaultKind kinds[] = {FaultKind::cable_cut, FaultKind::pdo_loss,
                                 FaultKind::heartbeat_loss, FaultKind::battery_silent};
  constexpr Duration times[] = {1s, 2s, 3s};
  return run_gap<ChargingNetwork>(options, {fault_grammar(), 20min, times}, kinds, ScheduledFault{},
                                  random);
}

/// Kinds of a world whose nodes can be cut off, or lose their power.
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
  return run_gap<TaxiNetwork>(options, {fault_grammar(), options.length, times},
                              gap_kinds<FaultKind>, ScheduledFault{.node = node}, random);
}

GapRun police_gap(std::uint64_t seed) {
  using namespace police;
  Random random(seed);
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = 50min;
  constexpr Duration times[] = {500ms, 1s, 2s};
  const auto node = static_cast<NodeId>(1 + random.below(device_names.size()));
  return run_gap<PoliceNetwork>(options, {fault_grammar(), options.length, times},
                                gap_kinds<FaultKind>, ScheduledFault{.node = node}, random);
}

GapRun bus_gap(std::uint64_t seed) {
  using namespace bus;
  Random random(seed);
  BusNetworkOptions options;
  options.faults.seed = seed;
  options.length = 45min;
  constexpr Duration times[] = {1200ms, 2500ms};
  const NodeId node = one_of(device_places, random).id;
  return run_gap<BusNetwork>(options, {fault_grammar(), options.length, times},
                             gap_kinds<FaultKind>, ScheduledFault{.node = node}, random);
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
  return run_gap<ExcavatorNetwork>(options, {fault_grammar(), options.length, times}, kinds,
                                   ScheduledFault{.node = node}, random);
}

constexpr GapWorld worlds[] = {{"lift", lift_gap}, {"charger", charger_gap},
                               {"taxi", taxi_gap}, {"police", police_gap},
                               {"bus", bus_gap},   {"excavator", excavator_gap}};

}  // namespace

std::span<const GapWorld> gap_worlds() {
  return worlds;
}

}  // namespace canvoy
