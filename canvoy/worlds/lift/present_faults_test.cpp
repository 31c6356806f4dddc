#include "canvoy/worlds/lift/present_faults.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::lift::present_faults_test {
namespace {

/// Two lifts of eight floors in a group. On each cable, in this order: controller 1, drive 2,
/// position 4, door 6, light barrier 9, load 13, car panel 16, landing panels from 21 on, of which
/// 23 is that of floors 3 and 4.
struct PresentFaultsTest : testing::Test {
  static LiftNetworkDescription building() {
    LiftNetworkDescription made = standard_lift_network({.lifts = 2, .floors = 8});
    std::erase_if(made.nodes, [](const NodeDescription& node) { return node.id == 24; });
    for (NodeDescription& node : made.nodes) {
      if (node.id == 23) node.floors = {3, 4};
    }
    return made;
  }
  static ScheduledFault fault(FaultKind kind, NodeId node = 0, LiftNumber lift = 1) {
    return {.kind = kind, .start = Time(1min), .part = lift, .node = node};
  }
  /// True if no node would report `later`, where `present` is the only present fault.
  bool silences(const ScheduledFault& present, const ScheduledFault& later) {
    plan = {present};
    PresentFaults alone(plan, devices);
    alone.add(0);
    return alone.silences(later);
  }
  bool is_like(const ScheduledFault& present, const ScheduledFault& later) {
    plan = {present};
    PresentFaults alone(plan, devices);
    alone.add(0);
    return alone.has_like(later);
  }

  World world;
  LiftNetworkDescription description = building();
  LiftDevices devices{world, description, {}};
  std::vector<ScheduledFault> plan;
};

TEST_F(PresentFaultsTest, AreTheSameByTheirKindLiftNodeAndFloor) {
  const ScheduledFault lost = fault(FaultKind::lost_node, 2);
  EXPECT_TRUE(is_like(lost, lost));
  EXPECT_TRUE(is_like(fault(FaultKind::lost_node), lost)) << "the drive suits the kind";
  EXPECT_FALSE(is_like(lost, fault(FaultKind::lost_node, 4)));
  EXPECT_FALSE(is_like(lost, fault(FaultKind::lost_node, 2, 2)));
  EXPECT_FALSE(is_like(lost, fault(FaultKind::babbling_node, 2)));
  ScheduledFault button = fault(FaultKind::stuck_button);
  button.spot = 3;
  ScheduledFault other = button;
  other.spot = 4;
  EXPECT_TRUE(is_like(button, button));
  EXPECT_FALSE(is_like(button, other)) << "of one panel";
}

TEST_F(PresentFaultsTest, OfACableAreOneCutWhereverItIs) {
  const ScheduledFault cut = fault(FaultKind::cable_cut, 4);
  EXPECT_TRUE(is_like(cut, fault(FaultKind::cable_cut, 22)));
  EXPECT_FALSE(is_like(cut, fault(FaultKind::cable_cut, 4, 2)));
  EXPECT_FALSE(is_like(cut, fault(FaultKind::cable_cut, 1, 0))) << "the cable of the group";
}

TEST_F(PresentFaultsTest, OfAnAlarmOfAllLiftsAreOneOfEach) {
  const ScheduledFault of_all = fault(FaultKind::fire_alarm, 0, 0);
  EXPECT_TRUE(is_like(of_all, fault(FaultKind::fire_alarm, 0, 2)));
  EXPECT_TRUE(is_like(of_all, fault(FaultKind::fire_alarm, 0, 1)));
  EXPECT_FALSE(is_like(fault(FaultKind::fire_alarm, 0, 1), fault(FaultKind::fire_alarm, 0, 2)));
  EXPECT_FALSE(is_like(of_all, fault(FaultKind::fire_brigade, 0, 2)));
}

TEST_F(PresentFaultsTest, AreThereUntilTheLastOfThemIsOverAndMayComeBack) {
  plan = {fault(FaultKind::dead_encoder), fault(FaultKind::dead_encoder)};
  PresentFaults sut(plan, devices);
  sut.add(0);
  sut.add(1);
  sut.remove(0);
  EXPECT_TRUE(sut.has_like(plan[0]));
  sut.remove(1);
  EXPECT_FALSE(sut.has_like(plan[0]));
  sut.add(0);
  EXPECT_TRUE(sut.has_like(plan[1]));
}

/// A panel sends its first heartbeat after 2 s; a node that was never heard is not missed (CiA 301,
/// 7.2.8.3.2.2).
TEST_F(PresentFaultsTest, ThatBeginBeforeTheFirstHeartbeatAreNotMissed) {
  const PresentFaults sut(plan, devices);
  for (const FaultKind kind :
       {FaultKind::lost_node, FaultKind::cable_cut, FaultKind::babbling_node}) {
    ScheduledFault early = fault(kind);
    early.start = Time(2s) - 1us;
    EXPECT_TRUE(sut.silences(early));
    early.start = Time(2s);
    EXPECT_FALSE(sut.silences(early));
  }
  ScheduledFault encoder = fault(FaultKind::dead_encoder);
  encoder.start = Time{};
  EXPECT_FALSE(sut.silences(encoder)) << "it tells by itself";
}

TEST_F(PresentFaultsTest, TakeTheHeartbeatsOfAllOfThoseBehindThemOrThoseThatWouldTell) {
  const ScheduledFault babble = fault(FaultKind::babbling_node, 16);
  const ScheduledFault cut = fault(FaultKind::cable_cut, 4);
  const ScheduledFault controller = fault(FaultKind::lost_node, 1);
  const ScheduledFault drive = fault(FaultKind::lost_node, 2);
  const ScheduledFault panel = fault(FaultKind::lost_node, 16);
  for (const ScheduledFault& later : {drive, panel, cut}) {
    EXPECT_TRUE(silences(babble, later));
    EXPECT_TRUE(silences(controller, later));
    EXPECT_FALSE(silences(drive, later)) << "the controller tells of others";
  }
  EXPECT_TRUE(silences(cut, panel));
  EXPECT_FALSE(silences(cut, drive)) << "it stands before the cut";
  EXPECT_FALSE(silences(cut, fault(FaultKind::lost_node, 4))) << "so does the node that it is at";
  EXPECT_FALSE(silences(cut, fault(FaultKind::babbling_node, 2))) << "that of the drive is left";
  EXPECT_FALSE(silences(fault(FaultKind::door_lock, 6), panel)) << "its unit is heard";
  EXPECT_FALSE(silences(fault(FaultKind::babbling_node, 16, 2), panel)) << "another cable";
}

TEST_F(PresentFaultsTest, OfTheGroupTakeThoseOfTheGroupAndNoneOfALift) {
  const ScheduledFault lost = fault(FaultKind::lost_node, 0, 0);
  const ScheduledFault cut = fault(FaultKind::cable_cut, 1, 0);
  EXPECT_TRUE(silences(cut, lost));
  EXPECT_TRUE(silences(lost, cut));
  EXPECT_FALSE(silences(lost, fault(FaultKind::lost_node, 2)));
  EXPECT_FALSE(silences(fault(FaultKind::babbling_node), lost));
}

/// Where a plan names no node, the cable is cut behind the controller.
TEST_F(PresentFaultsTest, ACutWithoutANodeTakesThemBehindTheController) {
  for (const NodeId node : {NodeId{1}, NodeId{0}}) {
    EXPECT_TRUE(silences(fault(FaultKind::cable_cut, node), fault(FaultKind::lost_node, 2)));
  }
}

}  // namespace
}  // namespace canvoy::lift::present_faults_test
