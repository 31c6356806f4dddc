// Patrols of a police car: all holds without a fault, and after each.
#include "canvoy/sim/police/police_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::police::police_network_test {
namespace {

/// On patrol for half of it; then power runs after, and all sleep.
constexpr Duration patrol = 100min;
constexpr Duration long_patrol = 150min;

PoliceOptions short_patrol(std::uint64_t seed, Duration length = patrol) {
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = length;
  return options;
}

/// The names of those that are broken.
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

/// What loses power and when all sleep, in order.
std::string sleep_of(const PoliceNetwork& network) {
  Time parked{};
  std::string seen;
  for (const PoliceEvent& event : network.events()) {
    if (const auto* activity = std::get_if<ActivityChanged>(&event.what)) {
      if (activity->activity == Activity::off_duty) parked = event.at;
    } else if (const auto* power = std::get_if<PowerSwitched>(&event.what)) {
      if (power->is_on) continue;
      // 4.2.7 leaves the times to the device: a quarter and half an hour here.
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
  // Free once, and on the way, there, and free again for each call.
  EXPECT_EQ(all_of<StatusSent>(network).size(), 1 + 3 * network.calls().size());
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
/// the next one that asks has the pad.
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

/// In the middle of a patrol, on the way to a call: what is ordered meanwhile is done afterwards.
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

/// The terminal is lost as the last emergency ends: its key is pressed in vain until it is back.
TEST(PolicePatrol, NobodyGoesHomeFromACarThatFlashes) {
  PoliceOptions options = short_patrol(1);
  options.length = 3h;
  options.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(7170s), .duration = 10min, .node = terminal_id}};
  PoliceNetwork network(options);
  network.run_until(Time(7170s + 9min));
  EXPECT_TRUE(network.snapshot().is_blue);
  EXPECT_EQ(network.crew().activity(), Activity::parking);
  network.run_until(Time(2h + 20min));
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

// Each fault alone: what comes back is learnt anew.

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

}  // namespace
}  // namespace canvoy::police::police_network_test
