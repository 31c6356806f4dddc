// A shift of an excavator, and each of its referees against a manipulated device.
#include "canvoy/worlds/excavator/excavator_network.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>

#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_network_test {
namespace {

TEST(ExcavatorNetwork, EarthIsMovedAndAllHolds) {
  ExcavatorNetwork network({.length = 30min});
  network.run_until(Time(30min));
  EXPECT_EQ(broken(network), Names());
  const ExcavatorSnapshot end = network.snapshot();
  EXPECT_GT(end.statistics.earth.heaped, 50);
  EXPECT_LT(end.statistics.earth.spilled, end.statistics.earth.heaped / 10);
  EXPECT_GT(end.statistics.presses, 12u);
  EXPECT_GT(end.statistics.metres, 3) << "it drives on when there is no earth left";
  for (const NodeSnapshot& node : end.nodes) {
    const bool is_behind = node.id == armrest_id;
    EXPECT_EQ(node.state, is_behind ? NmtState::pre_operational : NmtState::operational);
  }
}

TEST(ExcavatorNetwork, SeesAllThatThereIsToJudge) {
  ExcavatorNetwork network({.length = 10min});
  network.run_until(Time(10min));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.is_decided()) << invariant_name(invariant.kind).name;
    const bool is_always_seen =
        invariant.kind == InvariantKind::lost_seat || invariant.kind == InvariantKind::lost_host ||
        invariant.kind == InvariantKind::lost_armrest ||
        invariant.kind == InvariantKind::unwanted_motion ||
        invariant.kind == InvariantKind::axis_delta || invariant.kind == InvariantKind::display ||
        invariant.kind == InvariantKind::service;
    if (!is_always_seen) continue;
    EXPECT_GT(invariant.worst, 0) << invariant_name(invariant.kind).name;
  }
}

TEST(ExcavatorNetwork, WhoWorksWithoutABreakFillsTheTankWhenTheLampSaysSo) {
  ExcavatorOptions options{.length = 90min};
  options.shift.work = 12h;
  ExcavatorNetwork network(options);
  network.run_until(Time(30min));
  EXPECT_LT(network.snapshot().fuel_percent, 20) << "with a fifth it begins";
  while (network.snapshot().fuel_percent < 20 && network.now() < Time(90min)) {
    network.run_until(network.now() + 1min);
  }
  EXPECT_EQ(broken(network), Names());
  EXPECT_GT(network.snapshot().fuel_percent, 80);
}

TEST(ExcavatorNetwork, ASeatThatPollsDoesAsWell) {
  ExcavatorNetwork network({.length = 5min, .sensing_period = 2ms});
  network.run_until(Time(5min));
  EXPECT_EQ(broken(network), Names());
}

// Each referee detects its own errors, and no other one does.

struct Tampering {
  std::string_view broken;
  void (*tamper)(ExcavatorOptions&);
  Duration length = 10min;
  std::string_view also = {};  ///< is broken by what breaks it
};
std::ostream& operator<<(std::ostream& out, const Tampering& tampering) {
  return out << tampering.broken;
}

class ExcavatorSabotage : public testing::TestWithParam<Tampering> {};

TEST_P(ExcavatorSabotage, BreaksThisInvariantAlone) {
  ExcavatorOptions options{.length = GetParam().length};
  GetParam().tamper(options);
  ExcavatorNetwork network(options);
  network.run_until(Time(options.length));
  Names expected{GetParam().broken};
  if (!GetParam().also.empty()) expected.push_back(GetParam().also);
  EXPECT_THAT(broken(network), testing::UnorderedElementsAreArray(expected));
  Names told;
  for (const ExcavatorEvent& event : network.events()) {
    const auto* const news = std::get_if<InvariantBroken>(&event.what);
    if (news != nullptr) told.push_back(invariant_name(news->invariant.kind).name);
  }
  EXPECT_THAT(told, testing::UnorderedElementsAreArray(expected)) << "each once";
}
/// Several faults, one after the other, so that some of them meet a moving machine.
std::vector<ScheduledFault> many(const ScheduledFault& fault) {
  std::vector<ScheduledFault> all;
  for (int i = 0; i < 12; ++i) {
    all.push_back(fault);
    all.back().start = Time(1min) + i * Duration(61s);
    all.back().duration = Duration(8s);
  }
  return all;
}

const Tampering tamperings[] = {
    {"unwanted_motion",
     [](ExcavatorOptions& options) {
       options.sabotage.trusting_host = options.sabotage.single_channel = true;
       options.faults.faults = many({.kind = FaultKind::stuck_axis});
     }},
    {"unwanted_motion",
     [](ExcavatorOptions& options) {
       options.has_trainer = options.sabotage.obeys_all_seats = true;
     }},
    {"lost_seat",
     [](ExcavatorOptions& options) {
       options.sabotage.patient_host = true;
       options.faults.faults = many({.kind = FaultKind::lost_node, .node = seat_id});
     }},
    {"lost_host",
     [](ExcavatorOptions& options) {
       options.sabotage.patient_valves = true;
       options.faults.faults = many({.kind = FaultKind::lost_node});
     }},
    {"lost_armrest",
     [](ExcavatorOptions& options) {
       options.sabotage.old_lever = true;
       options.faults.faults = many({.kind = FaultKind::vanished_armrest});
     }},
    {"presses", [](ExcavatorOptions& options) { options.sabotage.slow_buttons = true; }, 20min},
    {"presses", [](ExcavatorOptions& options) { options.sabotage.counts_levels = true; }, 30min},
    {"axis_delta", [](ExcavatorOptions& options) { options.sabotage.coarse_deltas = true; }},
    {"indicators", [](ExcavatorOptions& options) { options.sabotage.burnt_lamp = true; }},
    {"indicators",
     [](ExcavatorOptions& options) {
       options.sabotage.keeps_lamps = true;
       options.faults.faults = {
           {.kind = FaultKind::lost_node, .start = Time(2min), .duration = 5s}};
     }},
    {"display", [](ExcavatorOptions& options) { options.sabotage.frozen_display = true; }, 20min},
    {"service", [](ExcavatorOptions& options) { options.sabotage.pierced_bucket = true; }, 10min,
     "spilled"},
    {"device_missing",
     [](ExcavatorOptions& options) {
       options.sabotage.forgetful_host = true;
       options.faults.faults = {
           {.kind = FaultKind::restart, .start = Time(2min), .node = valves_id}};
     },
     150s, "throttle"},
};
INSTANTIATE_TEST_SUITE_P(All, ExcavatorSabotage, testing::ValuesIn(tamperings));

// The machine stops.

TEST(ExcavatorNetwork, ALostSeatStopsTheMachineWithinTheConsumerTime) {
  for (const Movement movement : {Movement::slew, Movement::boom, Movement::stick}) {
    ExcavatorNetwork network({.length = 10min});
    run_until_moving(network, movement);
    network.node(seat_id).power(false);
    // 500 ms since the last heartbeat, and the time that a valve and the slew need to come to rest.
    EXPECT_LE(time_to_rest(network), Duration(900ms));
  }
}

/// What is pressed while the module is gone has no effect later, when it is not expected.
TEST(ExcavatorNetwork, AButtonThatIsPressedWithoutTheValvesSwitchesNothingWhenTheyReturn) {
  ExcavatorOptions options{.length = 2min};
  options.shift.recorded = {{Time(20s), HandInput::light, 0.2}, {Time(60s), HandInput::light, 0.2}};
  ExcavatorNetwork network(options);
  network.run_until(Time(10s));
  network.node(valves_id).power(false);
  network.run_until(Time(30s));
  network.node(valves_id).power(true);
  network.run_until(Time(59s));
  EXPECT_FALSE(is_lit(network.panel().lit(), Lamp::light));
  network.run_until(Time(62s));
  EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::light)) << "pressed with them";
}

TEST(ExcavatorNetwork, ALostHostStopsTheMachineAndTheSeatSaysSo) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::slew);
  network.node(host_id).power(false);
  EXPECT_LE(time_to_rest(network), Duration(900ms));
  network.run_until(network.now() + 500ms);
  EXPECT_EQ(network.panel().lit(), lamps_without_host);
  EXPECT_EQ(network.panel().shown(Shown::fuel), no_value);
  EXPECT_EQ(network.node(seat_id).node().state(), NmtState::pre_operational) << "1029h:01h";
}

/// 1016h watches from the first heartbeat on: a node that has not heard it is not started.
TEST(ExcavatorNetwork, AHostThatDiesAsItStartsTheSeatIsMissedAsWell) {
  for (const Duration at : {80ms, 160ms, 240ms, 320ms}) {
    ExcavatorNetwork network(with_faults({{.start = Time(at), .duration = 20s}}));
    network.run_until(Time(2min));
    EXPECT_EQ(broken(network), Names()) << at.count();
  }
}

TEST(ExcavatorNetwork, AStuckSensorDoesNotMoveTheMachineWhenTheStickIsLetGo) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::boom);
  network.panel().jam(Stick::right_y, true);
  const double way = network.panel().wanted(Movement::boom);
  while (network.panel().wanted(Movement::boom) * way > 0) {
    network.run_until(network.now() + 20ms);
  }
  network.run_until(network.now() + 400ms);
  EXPECT_EQ(network.machine().speed(Movement::boom), 0);
  EXPECT_GT(std::abs(network.panel().sensed(Stick::right_y)), 3000);
}

TEST(ExcavatorNetwork, ABrokenWireStopsItsMovementAndLightsALamp) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::boom);
  network.panel().break_wire(Stick::right_y, true);
  network.run_until(network.now() + 600ms);
  EXPECT_EQ(network.machine().speed(Movement::boom), 0);
  EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::fault));
}

// State that was lost is restored.

struct Return {
  FaultKind kind;
  NodeId node;
};
std::ostream& operator<<(std::ostream& out, const Return& back) {
  return out << fault_name(back.kind) << " of " << int{back.node};
}
class ExcavatorReturn : public testing::TestWithParam<Return> {};

TEST_P(ExcavatorReturn, ItDigsAndTheLampsAreRight) {
  ExcavatorNetwork network(with_faults({{.kind = GetParam().kind,
                                         .start = Time(1min),
                                         .duration = Duration(20s),
                                         .node = GetParam().node}}));
  network.run_until(Time(1min + 20s));
  const double heap = network.machine().earth().heaped;
  network.run_until(Time(3min));
  EXPECT_GT(network.machine().earth().heaped, heap + 1);
  network.run_until(Time(4min));
  EXPECT_EQ(broken(network), Names());
}
std::vector<Return> returns() {
  std::vector<Return> all;
  for (const DevicePlace& place : device_places) {
    for (const FaultKind kind : {FaultKind::lost_node, FaultKind::restart, FaultKind::bus_off,
                                 FaultKind::lost_frames, FaultKind::delayed_frames}) {
      all.push_back({kind, place.id});
    }
    if (place.id != valves_id) all.push_back({FaultKind::cable_cut, place.id});
  }
  for (const FaultKind kind :
       {FaultKind::babbling_node, FaultKind::corrupted_frames, FaultKind::stuck_axis,
        FaultKind::broken_wire, FaultKind::drifting_axis, FaultKind::vanished_armrest}) {
    all.push_back({kind, 0});
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, ExcavatorReturn, testing::ValuesIn(returns()));

// Unusual sizes.

TEST(ExcavatorNetwork, EarthThatIsNeverDugIsNotSpilled) {
  ExcavatorNetwork network({.length = 5s});
  network.run_until(Time(5s));
  ASSERT_EQ(network.machine().earth().heaped + network.machine().earth().spilled, 0);
  EXPECT_FALSE(find(network.invariants(), InvariantKind::spilled).is_decided());
}

TEST(ExcavatorNetwork, AShiftMayBeOverAtOnce) {
  ExcavatorNetwork network({.length = 1ms});
  network.run_until(Time(1s));
  EXPECT_TRUE(network.all_hold());
}

TEST(ExcavatorNetwork, FaultsMayBeThereFromTheStart) {
  for (std::size_t kind = 0; kind < fault_kinds; ++kind) {
    ExcavatorNetwork network(with_faults(
        {{.kind = static_cast<FaultKind>(kind), .start = Time{}, .duration = Duration(30s)}}));
    network.run_until(Time(3min));
    EXPECT_EQ(broken(network), Names()) << fault_name(static_cast<FaultKind>(kind));
    EXPECT_GT(network.machine().earth().heaped, 1);
  }
}

/// The actions of devices that are not simulated here are unknown.
TEST(ExcavatorNetwork, WhoIsNotPlayedIsNotJudged) {
  ExcavatorNetwork network({.length = 5min, .real = {seat_id}});
  network.run_until(Time(5min));
  const std::vector<Invariant> all = network.invariants();
  EXPECT_FALSE(find(all, InvariantKind::presses).is_decided());
  EXPECT_FALSE(find(all, InvariantKind::unwanted_motion).is_decided());
  EXPECT_TRUE(find(all, InvariantKind::device_missing).is_decided());
  EXPECT_FALSE(find(all, InvariantKind::device_missing).held) << "and it is missing";
}

}  // namespace
}  // namespace canvoy::excavator::excavator_network_test
