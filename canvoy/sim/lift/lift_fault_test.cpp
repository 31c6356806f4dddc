// Faults of a building with lifts beside those of lift_single_fault_test.cpp; and whatever a seed
// brings, what must hold does.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_soak.hpp"
#include "canvoy/sim/lift/testing/broken.hpp"

namespace canvoy::lift {
namespace {

Invariant find(const LiftNetwork& network, InvariantKind kind) {
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.kind == kind) return invariant;
  }
  ADD_FAILURE() << "no such invariant";
  return {};
}

/// A car that is on its way up with one passenger when the fault begins at 14 s; another one comes
/// when the fault has gone after 40 s.
struct LiftFaultTest : testing::Test {
  LiftFaultTest() {
    description.arrivals = {{.at = Time(2s), .from = 1, .to = 8},
                            {.at = Time(60s), .from = 3, .to = 1}};
  }
  LiftNetwork& run(ScheduledFault fault) {
    fault.start = Time(14s);
    fault.duration = 40s;
    description.faults = {fault};
    network = std::make_unique<LiftNetwork>(description);
    network->run_until(Time(4min));
    return *network;
  }
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  std::unique_ptr<LiftNetwork> network;
};

TEST_F(LiftFaultTest, ACarThatStandsDoesNotStartWithADeadEncoder) {
  description.arrivals = {{.at = Time(20s), .from = 1, .to = 8}};  // in the midst of the fault
  run({.kind = FaultKind::dead_encoder});
  EXPECT_EQ(broken(*network), "");
  EXPECT_TRUE(find(*network, InvariantKind::safe_stand).decided);
  EXPECT_EQ(network->summary().served, 1U);
}

/// What a node told by virtual inputs (6010h), and when, in tenths of a second.
struct Inputs {
  using Request = std::pair<Duration::rep, int>;
  static void add(void* self, Time now, ControllerId, const Frame& frame) {
    auto& inputs = *static_cast<Inputs*>(self);
    if (frame.id != 0x480U + inputs.node) return;
    inputs.requests.emplace_back((now - Time{}) / 100ms, frame.data[5] & 3);
  }
  NodeId node = 0;
  std::vector<Request> requests{};
};

TEST_F(LiftFaultTest, AButtonThatIsLetGoWithoutPowerIsNotPressedWhenThePowerComesBack) {
  constexpr NodeId panel = node_id::first_landing_panel + 2;  // of floor 3
  // They press half a second after they have come, for 0.3 s.
  description.arrivals = {{.at = Time(13'400ms), .from = 3, .to = 1},
                          {.at = Time(80s), .from = 3, .to = 1}};
  description.faults = {
      {.kind = FaultKind::lost_node, .start = Time(14s), .duration = 500ms, .node = panel}};
  network = std::make_unique<LiftNetwork>(description);
  Inputs told{.node = panel};
  network->observe(0, {.context = &told, .on_frame = Inputs::add});
  network->run_until(Time(90s));
  const std::vector<Inputs::Request> expected = {{0, 0}, {139, 1}, {145, 0}, {805, 1}, {808, 0}};
  EXPECT_EQ(told.requests, expected);
}

TEST_F(LiftFaultTest, InAFireTheCarGoesToTheFireFloorAndEverybodyLeavesIt) {
  description.arrivals.pop_back();
  const LiftNetwork& sut = run({.kind = FaultKind::fire_alarm});
  EXPECT_EQ(broken(sut), "");
  EXPECT_TRUE(find(sut, InvariantKind::fire_recall).decided);
  EXPECT_EQ(sut.summary().served, 0U);
  EXPECT_EQ(sut.snapshot().riding, 0U);
}

#ifdef NDEBUG
constexpr std::uint64_t seeds = 20;
constexpr Duration run_time = soak_time;
#else  // with sanitizers
constexpr std::uint64_t seeds = 2;
constexpr Duration run_time = 12min;
#endif

class LiftSeedTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LiftSeedTest, WhateverGoesWrongWhatMustHoldDoes) {
  LiftNetwork network(soak_network(GetParam(), run_time));
  network.run_until(Time(run_time));
  EXPECT_EQ(broken(network), "");
  EXPECT_GT(network.summary().served, 0U);
}
INSTANTIATE_TEST_SUITE_P(Seeds, LiftSeedTest, testing::Range(std::uint64_t{1}, seeds + 1));

}  // namespace
}  // namespace canvoy::lift
