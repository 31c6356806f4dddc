// Two faults of a taxi at once, each kind with each. All invariants hold, all devices return,
// passengers are carried and pay what they owe; and after that nothing is excused.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_fault_pairs_test {
namespace {

/// Trips take minutes. Both faults begin during the first one, or during the second one after it.
TaxiOptions short_shift(std::size_t first, std::size_t second) {
  TaxiOptions options;
  options.length = 1h;
  options.alarm = 12min;
  options.shift.waiting_max = 30s;
  options.shift.trip_max_metres = 2000;
  options.faults.seed = 1 + first * fault_kinds + second;
  options.faults.faults = pair_of_faults<ScheduledFault>(first, second, Time(6min), 90s);
  // Of two devices, each one in turn.
  const auto node = [](std::size_t number) {
    return static_cast<NodeId>(1 + number % device_names.size());
  };
  options.faults.faults.front().node = node(first + second);
  options.faults.faults.back().node = node(first + 3 * second + 1);
  return options;
}

bool is_carried_after(const TaxiNetwork& network, std::size_t trips) {
  const std::span<const Trip> all = network.trips();
  return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(trips), all.end(),
                     [](const Trip& trip) { return !trip.is_disturbed() && trip.paid > 0; });
}

class TaxiFaultPairs : public testing::TestWithParam<std::size_t> {};

TEST_P(TaxiFaultPairs, WithEachOtherKind) {
  for (const std::size_t second : kinds_beside(GetParam(), fault_kinds)) {
    const TaxiOptions options = short_shift(GetParam(), second);
    const std::vector<ScheduledFault>& faults = options.faults.faults;
    SCOPED_TRACE(pair_name(faults));
    TaxiNetwork network(options);
    network.run_until(faults.back().end() + 20s);
    const std::size_t trips = network.trips().size();
    for (const auto& node : network.nodes()) {
      EXPECT_TRUE(node->is_operational()) << node->place().name;
    }
    network.run_until(Time(20min));
    while (network.now() < Time(40min) && !is_carried_after(network, trips)) {
      network.run_until(network.now() + 1min);
    }
    EXPECT_EQ(broken_names(network), "");
    EXPECT_TRUE(is_carried_after(network, trips));
    network.node(alarm_id).power(false);  // by no fault of the plan
    network.run_until(network.now() + 19s);
    EXPECT_EQ(broken_names(network), "");
    network.run_until(network.now() + 2s);
    EXPECT_EQ(broken_names(network), "device_missing ");
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TaxiFaultPairs, testing::Range<std::size_t>(0, fault_kinds));

}  // namespace
}  // namespace canvoy::taxi::taxi_fault_pairs_test
