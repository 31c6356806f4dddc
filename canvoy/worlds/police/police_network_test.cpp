// Patrols of a police car: all invariants hold without a fault, and after each.
#include "canvoy/worlds/police/police_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::police::police_network_test {
namespace {

/// Half of it is patrol; then power runs after, and all devices sleep.
constexpr Duration patrol = 100min;
constexpr Duration long_patrol = 150min;

PoliceOptions short_patrol(std::uint64_t seed, Duration length = patrol) {
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = length;
  return options;
}

/// Names of the broken invariants.
std::string broken(const PoliceNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

template <class What>
std::vector<What> all_of(const PoliceNetwork& network) {
  std::vector<What> found;
  for (const PoliceEvent& event : network.events()) {
    if (const auto* what = std::get_if<What>(&event.what)) found.push_back(*what);
  }
  return found;
}

/// Devices that lose power, and the time at which all sleep, in order.
std::string sleep_of(const PoliceNetwork& network) {
  Time parked{};
  std::string seen;
  for (const PoliceEvent& event : network.events()) {
    if (const auto* activity = std::get_if<ActivityChanged>(&event.what)) {
      if (activity->activity == Activity::off_duty) parked = event.at;
    } else if (const auto* power = std::get_if<PowerSwitched>(&event.what)) {
      if (power->is_on) continue;
      // 4.2.7 leaves the times to the device: here a quarter of an hour and half an hour.
      const Duration after_run = power->is_radio ? 30min : 15min;
      EXPECT_NEAR(std::chrono::duration<double>(event.at - parked - after_run).count(), 0, 0.01);
      seen += power->is_radio ? "radio " : "periphery ";
    } else if (const auto* changed = std::get_if<car::NetworkChanged>(&event.what)) {
      if (changed->event.kind == cia447::CarEvent::Kind::asleep) seen += "asleep ";
      if (changed->event.kind == cia447::CarEvent::Kind::awake) seen += "awake ";
    }
  }
  return seen;
}

TEST(PolicePatrol, CallsAreAttendedToAndReportedAndThenTheNetworkSleepsAndWakesUp) {
  PoliceNetwork network(short_patrol(1, long_patrol));
  network.run_until(Time(long_patrol));
  EXPECT_EQ(broken(network), "");
  ASSERT_GE(network.calls().size(), 3u);
  for (const EmergencyCall& call : network.calls()) {
    ASSERT_TRUE(call.heard && call.acknowledged && call.arrived && call.reported);
    EXPECT_LT(*call.heard, *call.acknowledged);
    EXPECT_LT(*call.arrived, *call.reported);
  }
  // FMS: signs on, on the way and there for each call, takes a person along, has a break, is at
  // home.
  const auto sent = [statuses = all_of<StatusSent>(network)](int status) {
    return std::ranges::count(statuses, status, &StatusSent::status);
  };
  const auto calls = std::ssize(network.calls());
  const auto brought = std::ranges::count_if(network.calls(), &EmergencyCall::brings_somebody);
  const auto threatened = std::ranges::count_if(network.calls(), &EmergencyCall::is_threatened);
  EXPECT_EQ(sent(0), threatened);
  EXPECT_EQ(sent(1), 1 + calls + sent(6));
  EXPECT_EQ(sent(2), 1);
  EXPECT_EQ(sent(3), calls);
  EXPECT_EQ(sent(4), calls);
  EXPECT_GE(sent(5), 1);
  EXPECT_EQ(sent(6), 1);
  EXPECT_EQ(sent(7), brought);
  EXPECT_EQ(sent(8), brought);
  EXPECT_EQ(sent(9), 1);
  EXPECT_EQ(sleep_of(network), "periphery radio asleep awake ");
  for (const auto& node : network.nodes()) EXPECT_TRUE(node->is_operational());
  // Three clients share the terminal.
  std::array<unsigned, client_count> shown{};
  for (const TerminalTaken& taken : all_of<TerminalTaken>(network)) {
    if (taken.client) ++shown.at(static_cast<std::size_t>(*taken.client));
  }
  for (const unsigned times : shown) EXPECT_GT(times, 0u);
}

TEST(PolicePatrol, TheSameOptionsGiveTheSamePatrol) {
  PoliceNetwork one(short_patrol(3));
  PoliceNetwork other(short_patrol(3));
  one.run_until(Time(15min));
  other.run_until(Time(15min));
  EXPECT_EQ(one.world().bus().statistics().frames, other.world().bus().statistics().frames);
  EXPECT_EQ(one.events().size(), other.events().size());
}

/// The holder dies in the middle of its menu: the terminal does not hear it for three seconds, and
/// the next client that requests the pad has it.
TEST(PolicePatrol, AHolderThatDiesLosesTheTerminal) {
  PoliceOptions options = short_patrol(1);
  options.faults.faults = {
      {.kind = FaultKind::dead_client, .start = Time(10min), .duration = 30min}};
  PoliceNetwork network(options);
  network.run_until(Time(10min));
  while (network.now() < Time(30min) && network.around().title.empty()) {
    network.run_until(network.now() + 100ms);
  }
  ASSERT_EQ(network.around().title, "RADIO");
  EXPECT_EQ(network.terminal().holder(cia447::TerminalPart::number_pad), radio_id);
  // It is lost 3 s after its last heartbeat, which was up to 1 s before it died.
  network.run_until(network.now() + 1900ms);
  EXPECT_EQ(network.around().title, "RADIO");
  network.run_until(network.now() + 1200ms);
  EXPECT_EQ(network.terminal().holder(cia447::TerminalPart::number_pad), 0);
  EXPECT_EQ(network.around().title, "");
  network.run_until(Time(45min));
  EXPECT_EQ(broken(network), "");
}

TEST(PolicePatrol, ABurntLampIsReadOnTheDisplayAndTheCarIsSeenAllTheSame) {
  PoliceOptions options = short_patrol(1);
  options.faults.faults = {{.kind = FaultKind::burnt_lamp, .start = Time(10min)}};
  PoliceNetwork network(options);
  network.run_until(Time(10min + 1s));
  EXPECT_EQ(network.around().text_2, "READY\nLAMP BROKEN");
  network.run_until(Time(25min));
  EXPECT_EQ(broken(network), "");
}

/// In the middle of a patrol, on the way to a call: commands meanwhile are carried out afterwards.
TEST(PolicePatrol, WhoWakesUpLearnsWhatTheCrewWants) {
  PoliceNetwork network(short_patrol(1));
  network.run_until(Time(12min));
  ASSERT_TRUE(network.crew().wish().is_blue);
  cia447::CarMaster& master = *network.node(cia447::gateway_node_id).device().master();
  master.send_to_sleep();
  network.world().touched(0);
  network.run_until(Time(12min + 30s));
  ASSERT_TRUE(network.snapshot().is_asleep);
  network.run_until(Time(30min));
  ASSERT_FALSE(network.crew().wish().is_blue && network.crew().wish().has_siren);
  master.wake_up();
  network.world().touched(0);
  network.run_until(Time(45min));
  EXPECT_EQ(broken(network), "");
}

/// The terminal is lost as the last emergency ends: its key is pressed without effect until it
/// returns.
TEST(PolicePatrol, NobodyGoesHomeFromACarThatFlashes) {
  PoliceOptions options = short_patrol(1);
  options.length = 3h;
  PoliceNetwork before(options);
  before.run_until(Time(2h));  // no call comes after it
  const Time reported = before.calls().back().reported.value_or(Time(2h)) - 10s;
  options.faults.faults = {{.kind = FaultKind::lost_node,
                            .start = reported,
                            .duration = Time(2h + 10min) - reported,
                            .node = terminal_id}};
  PoliceNetwork network(options);
  network.run_until(Time(2h + 9min));
  EXPECT_TRUE(network.snapshot().is_blue);
  EXPECT_EQ(network.crew().activity(), Activity::parking);
  network.run_until(Time(2h + 25min));
  EXPECT_FALSE(network.snapshot().is_blue);
  EXPECT_EQ(network.crew().activity(), Activity::off_duty);
  EXPECT_EQ(broken(network), "");
}

class PoliceSeed : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PoliceSeed, AllHoldsWithoutAFault) {
  PoliceOptions options = short_patrol(GetParam());
  options.length = tries_all() ? long_patrol : patrol;
  PoliceNetwork network(options);
  network.run_until(Time(options.length));
  EXPECT_EQ(broken(network), "");
}

INSTANTIATE_TEST_SUITE_P(Some, PoliceSeed, testing::Range<std::uint64_t>(4, tries_all() ? 8 : 5));

// Each fault alone: state that was lost is restored.

struct FaultCase {
  const char* text;
};
class PoliceFault : public testing::TestWithParam<FaultCase> {};

TEST_P(PoliceFault, AloneBreaksNothing) {
  PoliceOptions options = short_patrol(1);
  const ParsedFault<FaultKind> parsed = parse_fault<FaultKind>(GetParam().text);
  ASSERT_TRUE(parsed.fault) << parsed.error;
  options.faults.faults = {*parsed.fault};
  const Time over = options.faults.faults.front().end();
  PoliceNetwork network(options);
  network.run_until(Time(25min));
  EXPECT_EQ(broken(network), "") << GetParam().text;
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
  const bool is_over = over < Time(25min);
  EXPECT_TRUE(std::ranges::any_of(network.calls(), [&](const EmergencyCall& call) {
    return call.reported && (!is_over || *call.reported > over);
  }));
}

// With seed 1 the first call comes at 11 min 22 s, and the crew is on its way until 15 min 40 s.
constexpr FaultCase fault_cases[] = {
    {"lost-node@11min+40s"},          {"lost-node@0s+30s"},
    {"lost-node:node=1@0s+1min"},     {"lost-node:node=1@11min+5min"},
    {"lost-node:node=3@11min+3min"},  {"lost-node:node=4@12min+1min"},
    {"lost-node:node=5@12min+20s"},   {"lost-node:node=6@11min+1min"},
    {"lost-node:node=7@11min+1min"},  {"lost-node:node=8@5min+30s"},
    {"lost-node:node=9@11min+1min"},  {"lost-node:node=10@11min+1min"},
    {"lost-node:node=11@11min+1min"}, {"restart@12min"},
    {"restart:node=1@12min"},         {"restart:node=3@12min"},
    {"restart:node=4@12min"},         {"restart:node=5@12min"},
    {"restart:node=6@326s"},          {"restart:node=7@12min"},
    {"restart:node=8@326s"},          {"restart:node=9@12min"},
    {"restart:node=10@12min"},        {"cable-cut@11min+1min"},
    {"cable-cut@12min+1s"},           {"cable-cut@0s+20s"},
    {"babbling-node@11min+10s"},      {"corrupted-frames@5min+2h"},
    {"overload@11min+3min"},          {"dead-client@10min+5min"}};

INSTANTIATE_TEST_SUITE_P(Each, PoliceFault, testing::ValuesIn(fault_cases));

/// Both get a node-ID and are started and supervised like all others (4.2.5, 4.2.6).
TEST(PolicePatrol, AnArmouredCarHasFireExtinguishingAndFreshAirAboard) {
  PoliceOptions options;
  options.length = 150min;
  options.is_armoured = true;
  PoliceNetwork network(options);
  network.run_until(Time(150min));
  EXPECT_EQ(network.nodes().size(), 13u);
  EXPECT_TRUE(network.node(fire_extinguishing_id).is_operational());
  EXPECT_TRUE(network.node(fresh_air_id).is_operational());
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::police::police_network_test
