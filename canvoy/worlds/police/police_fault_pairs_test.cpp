// Two faults of a police car at once, each kind with each. All invariants hold, all devices return,
// a call is attended and reported; and after that nothing is excused.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/police/police_network.hpp"

namespace canvoy::police::police_fault_pairs_test {
namespace {

/// Both faults begin on patrol, during a call, or as one ends: it comes in the first quarter of an
/// hour, by the seed.
PoliceOptions short_patrol_with_pair(std::size_t first, std::size_t second) {
  PoliceOptions options;
  options.length = 2h;
  options.faults.seed = 1 + first * fault_kinds + second;
  options.faults.faults = pair_of_faults<ScheduledFault>(first, second, Time(10min), 90s);
  // Of two devices, each one in turn.
  const auto node = [](std::size_t number) {
    return static_cast<NodeId>(1 + number % device_names.size());
  };
  options.faults.faults.front().node = node(first + second);
  options.faults.faults.back().node = node(first + 3 * second + 1);
  return options;
}

class PoliceFaultPairs : public testing::TestWithParam<std::size_t> {};

TEST_P(PoliceFaultPairs, WithEachOtherKind) {
  for (const std::size_t second : kinds_beside(GetParam(), fault_kinds)) {
    const PoliceOptions options = short_patrol_with_pair(GetParam(), second);
    const Time over = options.faults.faults.back().end();
    SCOPED_TRACE(pair_name(options.faults.faults));
    PoliceNetwork network(options);
    network.run_until(over + 20s);
    for (const auto& node : network.nodes()) {
      EXPECT_TRUE(node->is_operational()) << node->place().name;
    }
    const auto is_reported = [over](const EmergencyCall& call) {
      return call.reported && *call.reported > over;
    };
    while (network.now() < Time(50min) && std::ranges::none_of(network.calls(), is_reported)) {
      network.run_until(network.now() + 1min);
    }
    EXPECT_EQ(broken_names(network), "");
    EXPECT_TRUE(std::ranges::any_of(network.calls(), is_reported));
    network.node(inputs_id).power(false);  // by no fault of the plan
    network.run_until(network.now() + 19s);
    EXPECT_EQ(broken_names(network).find("device_missing"), std::string::npos);
    network.run_until(network.now() + 2s);
    EXPECT_NE(broken_names(network).find("device_missing"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, PoliceFaultPairs, testing::Range<std::size_t>(0, fault_kinds));

/// A key that was pressed while the bus was full arrives at its client when the bus is free, and
/// other keys were pressed meanwhile: it still belongs to that client.
TEST(PoliceFaultPairsFound, AKeyThatComesLateIsNobodyElses) {
  PoliceOptions options;
  options.length = 2h;
  options.faults.seed = 1004;
  for (const FaultKind kind : {FaultKind::lost_node, FaultKind::babbling_node}) {
    options.faults.faults.push_back(
        {.kind = kind, .start = Time(677s), .duration = 25s, .node = blue_light_id});
  }
  PoliceNetwork network(options);
  network.run_until(Time(750s));
  EXPECT_EQ(broken_names(network), "");
}

TEST(PoliceFaultPairsFound, OnlyWhereItMayComeLateAnEarlierKeyIsActedOn) {
  const auto keys_are_right = [](const PoliceReferee& referee) {
    return referee.verdicts({}).front().held;
  };
  const auto key = [](std::uint8_t number) {
    return KeyAction{.client = Client::signals, .is_function_key = true, .key = number};
  };
  PoliceReferee referee;
  referee.pressed(key(2), true);
  referee.pressed(key(1), true);
  referee.acted(key(2));
  referee.acted(key(1));
  EXPECT_TRUE(keys_are_right(referee));
  referee.acted(key(2));
  EXPECT_FALSE(keys_are_right(referee)) << "once for each time";
  PoliceReferee of_another;
  of_another.pressed(key(2), true);
  of_another.acted({.client = Client::radio, .is_function_key = true, .key = 2});
  EXPECT_FALSE(keys_are_right(of_another));
  PoliceReferee strict;
  strict.pressed(key(2), true);
  strict.pressed(key(1), false);
  strict.acted(key(2));
  EXPECT_FALSE(keys_are_right(strict)) << "the fault is over";
}

/// The requests of the gateway meanwhile are answered all at once when the bus is free. A gateway
/// that then takes each device to be slow needs half a minute to find one.
TEST(PoliceFaultPairsFound, WhoGetsPowerAsAFullBusIsFreeIsNamedInTime) {
  PoliceOptions options;
  options.length = 2h;
  options.faults.seed = 1004;
  const ScheduledFault lost = {
      .kind = FaultKind::lost_node, .start = Time(4min), .duration = 12s, .node = blue_light_id};
  ScheduledFault full = lost;
  full.kind = FaultKind::babbling_node;
  options.faults.faults = {lost, full};
  PoliceNetwork network(options);
  network.run_until(lost.end() + 20s);
  EXPECT_TRUE(network.node(blue_light_id).is_operational());
}

}  // namespace
}  // namespace canvoy::police::police_fault_pairs_test
