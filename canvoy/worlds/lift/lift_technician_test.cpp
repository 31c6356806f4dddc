// A technician in a building: people who are shut in come out, and what must be closed by hand is
// closed (EN 81-20; EN 81-28).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_technician_test {
namespace {

/// One person rides up when it begins.
LiftNetworkDescription with_fault(const ScheduledFault& fault) {
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 8}};
  description.faults.faults = {fault};
  return description;
}

struct Done {
  Time at{};
  TechnicianDid what{};
};
std::vector<Done> done_in(const LiftNetwork& network) {
  std::vector<Done> all;
  for (const LiftEvent& event : network.events()) {
    if (const auto* const did = std::get_if<TechnicianDid>(&event.what))
      all.push_back({event.at, *did});
  }
  return all;
}
std::vector<TechnicianStep> steps_in(const LiftNetwork& network) {
  std::vector<TechnicianStep> steps;
  for (const Done& each : done_in(network)) steps.push_back(each.what.step);
  return steps;
}

const Invariant& find(const std::vector<Invariant>& all, InvariantKind kind) {
  return *std::ranges::find(all, kind, &Invariant::kind);
}

TEST(LiftTechnician, LetsOutWhoIsShutInByADriveThatHasNoPower) {
  LiftNetwork network(
      with_fault({.kind = FaultKind::lost_node, .start = Time(14s), .duration = 9min, .node = 2}));
  network.run_until(Time(30s));
  const double stuck_m = network.snapshot().lifts[0].position_m;
  ASSERT_EQ(network.snapshot().riding, 1U);
  ASSERT_GT(std::abs(stuck_m - std::round(stuck_m / 3.5) * 3.5), 0.05) << "between two floors";
  network.run_until(Time(9min));
  using enum TechnicianStep;
  const std::vector<TechnicianStep> rescue{called_for_people, arrives, moves_car, lets_out};
  EXPECT_EQ(steps_in(network), rescue) << "and waits for the drive to be mended";
  const std::vector<Done> done = done_in(network);
  const LiftSnapshot car = network.snapshot().lifts[0];
  const double floor_m = (done[3].what.floor - 1) * 3.5;
  EXPECT_NEAR(car.position_m, floor_m, 0.006);
  EXPECT_LE(std::abs(stuck_m - floor_m), 1.75) << "the nearest one";
  EXPECT_NEAR(std::chrono::duration<double>(done[3].at - done[2].at).count(),
              std::abs(stuck_m - floor_m) / 0.3, 0.02);
  EXPECT_EQ(network.snapshot().riding, 0U);
  network.run_until(Time(13min));
  EXPECT_EQ(steps_in(network),
            (std::vector<TechnicianStep>{called_for_people, arrives, moves_car, lets_out, inspects,
                                         resets, rides, leaves}));
  const std::vector<Invariant> all = network.invariants();
  EXPECT_TRUE(find(all, InvariantKind::rescued).is_decided());
  EXPECT_GT(find(all, InvariantKind::rescued).worst, 100);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftTechnician, WithoutOneNobodyIsLetOutAndThatIsBroken) {
  LiftNetworkDescription description =
      with_fault({.kind = FaultKind::lost_node, .start = Time(14s), .node = 2});
  description.service.technician = false;
  LiftNetwork network(description);
  network.run_until(Time(60min));
  EXPECT_TRUE(find(network.invariants(), InvariantKind::rescued).held);
  network.run_until(Time(61min));
  EXPECT_FALSE(find(network.invariants(), InvariantKind::rescued).held) << "EN 81-28: an hour";
  EXPECT_TRUE(steps_in(network).empty());
}

TEST(LiftTechnician, IsNotCalledWhereAFaultIsShort) {
  LiftNetwork network(
      with_fault({.kind = FaultKind::lost_node, .start = Time(14s), .duration = 40s, .node = 2}));
  network.run_until(Time(5min));
  EXPECT_TRUE(steps_in(network).empty());
  EXPECT_EQ(network.summary().served, 1U);
}

/// A safety gear that has caught a car with people in it, and a motor that stays broken: the
/// technician lets them out, and waits; it is not reset before it is mended.
TEST(LiftTechnician, WaitsAtACarThatIsNotWhole) {
  LiftNetwork network(
      with_fault({.kind = FaultKind::runaway, .start = Time(14s), .duration = 20min}));
  network.run_until(Time(20min));
  using enum TechnicianStep;
  EXPECT_EQ(steps_in(network),
            (std::vector<TechnicianStep>{called_for_trip, arrives, moves_car, lets_out}));
  EXPECT_EQ(network.snapshot().riding, 0U);
  const double there_m = network.snapshot().lifts[0].position_m;
  network.run_until(Time(20min + 14s));
  EXPECT_EQ(network.snapshot().lifts[0].position_m, there_m) << "its gear has caught it again";
  network.run_until(Time(22min));
  EXPECT_EQ(steps_in(network),
            (std::vector<TechnicianStep>{called_for_trip, arrives, moves_car, lets_out, inspects,
                                         resets, rides, leaves}));
  EXPECT_EQ(broken(network), "");
}

/// An empty car: its display says that it is out of order.
TEST(LiftTechnician, IsCalledToALiftThatStaysOutOfOrder) {
  LiftNetworkDescription description =
      with_fault({.kind = FaultKind::dead_encoder, .start = Time(2min), .duration = 6min});
  description.arrivals.push_back({.at = Time(12min), .from = 3, .to = 6});
  LiftNetwork network(description);
  network.run_until(Time(12min));
  using enum TechnicianStep;
  EXPECT_EQ(steps_in(network), (std::vector<TechnicianStep>{called_for_fault, arrives, inspects,
                                                            resets, rides, leaves}));
  const std::vector<Done> done = done_in(network);
  EXPECT_GE(done[0].at, Time(4min)) << "most end by themselves";
  EXPECT_LT(done[0].at, Time(4min + 5s));
  EXPECT_GE(done[2].at, Time(8min)) << "mended";
  network.run_until(Time(15min));
  EXPECT_EQ(network.summary().served, 2U);
  EXPECT_EQ(broken(network), "");
}

/// A stranger stops its drive: no controller starts it, and no fault is declared.
TEST(LiftTechnician, IsCalledByARefereesFindingAndStartsTheLiftAgain) {
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  for (int minute = 1; minute < 20; ++minute) {
    description.arrivals.push_back({.at = Time(minute * 1min), .from = 3, .to = 6});
  }
  LiftNetwork network(description);
  network.run_until(Time(5min));
  ASSERT_GT(network.summary().served, 2U);
  const std::uint64_t before = network.summary().served;
  const ControllerId stranger = network.world().bus(0).attach({});
  while (network.snapshot().riding != 0) network.run_until(network.now() + 1s);
  network.world().bus(0).send(stranger, Frame::data_frame(0, {0x02, node_id::drive}));
  network.run_until(Time(20min));
  const std::vector<Invariant> all = network.invariants();
  EXPECT_FALSE(find(all, InvariantKind::lift_serves).held) << "it stood while people waited";
  using enum TechnicianStep;
  const std::vector<TechnicianStep> steps = steps_in(network);
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(std::ranges::find(steps, restarts), steps.end());
  EXPECT_EQ(steps.back(), leaves);
  EXPECT_GT(network.summary().served, before + 3) << "it serves again";
}

/// What slips at its self-test is reset by a technician alone (EN 81-20, 5.6.7.3).
TEST(LiftTechnician, IsCalledByABrakeThatHoldsTooLittle) {
  LiftNetwork network(
      with_fault({.kind = FaultKind::weak_brake, .start = Time(14s), .duration = 60s}));
  network.run_until(Time(60s));
  EXPECT_EQ(network.snapshot().riding, 0U) << "they got out at the end of the trip";
  network.run_until(Time(6min));
  using enum TechnicianStep;
  EXPECT_EQ(steps_in(network), (std::vector<TechnicianStep>{called_for_trip, arrives, inspects,
                                                            resets, rides, leaves}));
  const std::vector<Invariant> all = network.invariants();
  EXPECT_TRUE(find(all, InvariantKind::weak_brake).is_decided());
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::lift::lift_technician_test
