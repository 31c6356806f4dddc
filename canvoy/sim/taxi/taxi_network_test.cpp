// Shifts of a taxi: all holds without a fault, and after each; and each referee sees what it is
// there for.
#include "canvoy/sim/taxi/taxi_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::taxi::taxi_network_test {
namespace {

constexpr Duration evening = 4h;

TaxiOptions short_shift(std::uint64_t seed) {
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = evening;
  options.alarm = 1h;
  return options;
}

/// The names of those that are broken.
std::string broken(const TaxiNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

template <class What>
std::size_t count(const TaxiNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(
      network.events(),
      [](const TaxiEvent& event) { return std::holds_alternative<What>(event.what); }));
}

TEST(TaxiShift, PeopleAreCarriedAndPayWhatTheTariffAsks) {
  TaxiNetwork network(short_shift(1));
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "");
  ASSERT_GE(network.trips().size(), 5u);
  EXPECT_EQ(count<ShiftChanged>(network), 2u) << "it begins and ends";
  EXPECT_EQ(count<AlarmPressed>(network), 1u);
  const auto& lines = network.paper().lines();
  const auto totals = std::ranges::count_if(
      lines, [](const std::string& line) { return line.starts_with("TOTAL"); });
  EXPECT_EQ(static_cast<std::size_t>(totals), network.trips().size()) << "a receipt for each";
}

TEST(TaxiShift, TheTariffChangesAtTenAtNight) {
  TaxiOptions options = short_shift(1);
  options.length = 6h;  // from 18:00
  TaxiNetwork network(options);
  network.run_until(Time(options.length));
  EXPECT_EQ(broken(network), "");
  bool is_night = false;
  for (const TaxiEvent& event : network.events()) {
    const auto* tariff = std::get_if<TariffChanged>(&event.what);
    if (tariff == nullptr) continue;
    // Level 2 of the example from 22:00 on: four hours after the start.
    EXPECT_EQ(tariff->level[0], event.at < Time(4h) ? '1' : '2');
    is_night = is_night || tariff->level[0] == '2';
  }
  EXPECT_TRUE(is_night);
}

TEST(TaxiShift, TheNetworkSleepsAndWakesUp) {
  TaxiNetwork network(short_shift(2));
  network.run_until(Time(evening));
  std::string seen;
  for (const TaxiEvent& event : network.events()) {
    const auto* changed = std::get_if<car::NetworkChanged>(&event.what);
    if (changed == nullptr) continue;
    if (changed->event.kind == cia447::CarEvent::Kind::asleep) seen += "asleep ";
    if (changed->event.kind == cia447::CarEvent::Kind::awake) seen += "awake ";
  }
  EXPECT_EQ(seen, "asleep awake ");
  for (const auto& node : network.nodes()) EXPECT_TRUE(node->is_operational());
}

TEST(TaxiShift, TheSameOptionsGiveTheSameShift) {
  TaxiNetwork one(short_shift(3));
  TaxiNetwork other(short_shift(3));
  one.run_until(Time(2h));
  other.run_until(Time(2h));
  EXPECT_EQ(one.world().bus().statistics().frames, other.world().bus().statistics().frames);
  EXPECT_EQ(one.drive().metres(), other.drive().metres());
  EXPECT_EQ(one.events().size(), other.events().size());
}

class TaxiSeed : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TaxiSeed, AllHoldsWithoutAFault) {
  TaxiNetwork network(short_shift(GetParam()));
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "");
}

INSTANTIATE_TEST_SUITE_P(Some, TaxiSeed, testing::Range<std::uint64_t>(4, 10));

// Each fault alone: what comes back is learnt anew, and nobody pays what he does not owe.

struct FaultCase {
  const char* text;
};
class TaxiFault : public testing::TestWithParam<FaultCase> {};

TEST_P(TaxiFault, AloneBreaksNothing) {
  TaxiOptions options = short_shift(1);
  const FaultParse parsed = parse_fault(fault_grammar(), GetParam().text);
  ASSERT_TRUE(parsed.fault) << parsed.error;
  options.faults.faults = {scheduled(*parsed.fault)};
  TaxiNetwork network(options);
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "") << GetParam().text;
  for (const auto& node : network.nodes()) {
    EXPECT_TRUE(node->is_operational()) << node->place().name;
  }
}

constexpr FaultCase fault_cases[] = {{"lost-node@15min+5s"},
                                     {"lost-node@15min+40s"},
                                     {"lost-node@0s+30s"},
                                     {"lost-node:node=1@15min+20s"},
                                     {"lost-node:node=1@0s+1min"},
                                     {"lost-node:node=3@15min+20min"},
                                     {"lost-node:node=5@15min+3min"},
                                     {"restart@15min"},
                                     {"restart:node=1@15min"},
                                     {"restart:node=3@20min"},
                                     {"restart:node=5@20min"},
                                     {"restart:node=8@20min"},
                                     {"cable-cut@15min+1min"},
                                     {"cable-cut@0s+20s"},
                                     {"babbling-node@15min+10s"},
                                     {"corrupted-frames@10min+1h"},
                                     {"wheel-signal@15min+3min"}};

INSTANTIATE_TEST_SUITE_P(Each, TaxiFault, testing::ValuesIn(fault_cases));

// Each referee can fail: a sabotage in the whole network breaks it, and no other one.

TEST(TaxiSabotage, AMeterThatIsCheatedOfItsPulsesChargesTooLittle) {
  TaxiOptions options = short_shift(1);
  options.car.wheel_circumference_m = 2.1;  // the meter's k is of wheels of 2 m
  TaxiNetwork network(options);
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "fare distance ");
}

TEST(TaxiSabotage, ATariffThatIsNotTheOneThatHolds) {
  static constexpr cia447::TariffLevel dear[] = {{.name = {'1', 0},
                                                  .initial_fare = 3900,
                                                  .distance_rate = 2400,
                                                  .time_rate = 33'000,
                                                  .increment = 100}};
  TaxiOptions options = short_shift(1);
  options.tariff_of_town = options.meter.tariff;
  options.meter.tariff = {.id = 1, .levels = dear};
  TaxiNetwork network(options);
  network.run_until(Time(3h));
  EXPECT_EQ(broken(network), "fare ");
}

TEST(TaxiSabotage, AClockThatIsSlowMakesTripsShorter) {
  TaxiNetwork network(short_shift(1));
  network.world().set_clock_drift(taximeter_id - SlotIndex{1}, -10'000);
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "duration ");
}

TEST(TaxiSabotage, APassengerWhoIsAskedForMoreThanTheMeterCounts) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().pocketed = 500;
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "totals receipts ");
}

TEST(TaxiSabotage, ASignThatIsNeverSwitched) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().cuts_sign = true;
  network.run_until(Time(1h));
  EXPECT_EQ(broken(network), "roof_sign ");
}

TEST(TaxiSabotage, ADeviceThatDoesNotSleep) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().speaks_asleep = true;
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "silence ");
}

TEST(TaxiSabotage, AMeterThatDoesNotObey) {
  TaxiNetwork network(short_shift(1));
  network.sabotage().blocks_keys = true;
  network.run_until(Time(evening));
  EXPECT_EQ(broken(network), "no_service carried ");
}

TEST(TaxiSabotage, ADeviceThatIsNotThere) {
  TaxiNetwork network(short_shift(1));
  network.world().at(Time(20min), [&](Time) { network.node(alarm_id).power(false); });
  network.run_until(Time(1h));
  EXPECT_EQ(broken(network), "device_missing ");
}

}  // namespace
}  // namespace canvoy::taxi::taxi_network_test
