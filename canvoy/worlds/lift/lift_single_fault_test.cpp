// After each single fault the car stands safely, the right emergency is on the bus, and service
// resumes after the fault: each fault in a single lift, and in the first lift of a group. The codes
// are those of CiA 301, 7.2.7 (50xxh hardware, 8130h heartbeat) and CiA 417-1, 8.4 (FFxxh).
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_single_fault_test {
namespace {

constexpr Time begin(14s);
constexpr Time end(60s);
constexpr LiftNumber lifts_of_group = 3;

struct Row {
  const char* name;
  FaultKind kind;
  NodeId node;  ///< node of the fault
  FloorNumber floor;
  std::uint16_t code;
  NodeId teller;
  bool stands;  ///< the lift cannot run without the broken part
  bool bears;   ///< it serves while the fault is present
};

constexpr Row rows[] = {
    {"LostDrive", FaultKind::lost_node, 2, 0, 0x8130, 1, true, false},
    {"LostPositionUnit", FaultKind::lost_node, 4, 0, 0x8130, 1, true, false},
    {"LostDoorUnit", FaultKind::lost_node, 6, 0, 0x8130, 1, true, false},
    {"LostLoadUnit", FaultKind::lost_node, 13, 0, 0x8130, 1, true, false},
    {"LostController", FaultKind::lost_node, 1, 0, 0x8130, 2, true, false},
    {"LostCarPanel", FaultKind::lost_node, 16, 0, 0x8130, 1, false, true},
    {"LostLandingPanel", FaultKind::lost_node, 22, 0, 0x8130, 1, false, true},
    {"LostLightBarrier", FaultKind::lost_node, 9, 0, 0x8130, 1, false, true},
    {"CableCutBehindController", FaultKind::cable_cut, 1, 0, 0x8130, 2, true, false},
    {"CableCutBehindDrive", FaultKind::cable_cut, 2, 0, 0x8130, 1, true, false},
    {"StuckLandingButton", FaultKind::stuck_button, 0, 4, 0xFF04, 24, false, true},
    {"StuckCarButton", FaultKind::stuck_button, 0, 0, 0xFF04, 16, false, true},
    {"BrokenLightBarrier", FaultKind::light_barrier, 0, 0, 0xFF01, 9, false, true},
    {"FingerProtector", FaultKind::finger_protector, 6, 0, 0xFF02, 6, false, true},
    {"MotionDetector", FaultKind::motion_detector, 0, 0, 0xFF03, 6, false, true},
    {"DoorLock", FaultKind::door_lock, 6, 0, 0xFF04, 1, true, false},
    {"SafetyContact", FaultKind::safety_contact, 0, 0, 0xFF04, 1, true, false},
    {"RopeSensor", FaultKind::rope_sensor, 0, 0, 0xFF04, 13, true, false},
    {"Runaway", FaultKind::runaway, 0, 0, 0xFF05, 2, true, false},
    {"DeadEncoder", FaultKind::dead_encoder, 0, 0, 0x5000, 4, true, false},
    {"BabblingCarPanel", FaultKind::babbling_node, 16, 0, 0x8130, 1, true, false},
    {"BabblingLandingPanel", FaultKind::babbling_node, 22, 0, 0x8130, 1, true, false},
};

std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << row.name;
}

struct SingleFaultTest : testing::TestWithParam<std::tuple<Row, bool>> {
  static const Row& row() { return std::get<Row>(GetParam()); }
  static bool is_group() { return std::get<bool>(GetParam()); }

  static LiftNetworkDescription description() {
    const LiftNumber lifts = is_group() ? lifts_of_group : LiftNumber{1};
    LiftNetworkDescription made = standard_lift_network({.lifts = lifts, .floors = 8});
    // One passenger rides when it begins, one comes during it, and one after it.
    made.arrivals = {{.at = Time(2s), .from = 1, .to = 8},
                     {.at = Time(20s), .from = 3, .to = 1},
                     {.at = Time(90s), .from = 3, .to = 1}};
    made.faults.faults = {{.kind = row().kind,
                           .start = begin,
                           .duration = end - begin,
                           .node = row().node,
                           .spot = row().floor}};
    return made;
  }

  /// Time of the first one of a code on the bus of the first lift.
  static Time reported_at(const LiftNetwork& network, NodeId node, std::uint16_t code) {
    for (const LiftEvent& event : network.events()) {
      const auto* const told = std::get_if<EmergencySeen>(&event.what);
      if (told == nullptr || told->bus != 0) continue;
      if (told->node == node && told->code == code) return event.at;
    }
    return never;
  }

  static bool is_judged(const LiftNetwork& network, InvariantKind kind) {
    const std::vector<Invariant> all = network.invariants();
    return std::any_of(all.begin(), all.end(), [&](const Invariant& one) {
      return one.kind == kind && one.part == 1 && one.fault == 0 && one.is_decided() && one.held;
    });
  }
};

TEST(SingleFaultOfALift, BeginsWhileTheCarIsOnItsWayWithOnePerson) {
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 8}};
  LiftNetwork sut(description);
  sut.run_until(begin);
  EXPECT_GT(sut.snapshot().lifts.at(0).speed_m_s, 0.5);
  EXPECT_EQ(sut.snapshot().riding, 1U);
}

TEST_P(SingleFaultTest, TheCarStandsTheEmergencyIsOnTheBusAndServiceResumes) {
  LiftNetwork network(description());
  network.run_until(begin + 10s);
  EXPECT_TRUE(!row().stands || network.snapshot().lifts[0].speed_m_s == 0) << "safely";
  const std::uint32_t starts = network.snapshot().lifts[0].starts;
  network.run_until(end);
  EXPECT_TRUE(!row().stands || network.snapshot().lifts[0].starts == starts) << "and stays so";
  EXPECT_EQ(network.summary().served > 0, row().bears || is_group()) << "others go on";
  network.run_until(Time(4min));
  EXPECT_EQ(broken(network), "");
  const Time told = reported_at(network, row().teller, row().code);
  EXPECT_GT(told, begin);
  EXPECT_LT(told, begin + 11s);
  EXPECT_EQ(is_judged(network, InvariantKind::safe_stand), row().stands);
  EXPECT_TRUE(is_judged(network, InvariantKind::emergency_told));
  // In a group other lifts carry new passengers, where the lift has not lost its turn to them.
  const bool is_needed = !is_group() || row().stands;
  EXPECT_TRUE(!is_needed || is_judged(network, InvariantKind::service_resumed));
  EXPECT_EQ(network.summary().served, 3U);
}

std::string name_of(const testing::TestParamInfo<std::tuple<Row, bool>>& info) {
  return std::string(std::get<Row>(info.param).name) +
         (std::get<bool>(info.param) ? "InAGroup" : "OfASingleLift");
}

INSTANTIATE_TEST_SUITE_P(EachFault, SingleFaultTest,
                         testing::Combine(testing::ValuesIn(rows), testing::Bool()), name_of);

}  // namespace
}  // namespace canvoy::lift::lift_single_fault_test
