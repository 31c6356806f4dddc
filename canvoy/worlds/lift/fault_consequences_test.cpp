// Required consequences of a fault, and those that are not required beside another fault.
#include "canvoy/worlds/lift/fault_consequences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace canvoy::lift::fault_consequences_test {
namespace {

/// Life guard error or heartbeat error (CiA 301, 7.2.7.1).
const std::vector<std::uint16_t> heartbeat_error = {0x8130};
const std::vector<std::uint16_t> nothing = {};

/// On each cable, in this order: controller 1, drive 2, position 4, door 6, light barrier 9, load
/// 13, car panel 16, landing panels 21 to 28.
struct Lifts {
  explicit Lifts(LiftNetworkDescription made) : description(std::move(made)) {}
  explicit Lifts(LiftNumber lifts) : Lifts(standard_lift_network({.lifts = lifts, .floors = 8})) {}
  static LiftDevicesHooks silent() {
    return {.shaft = {.changed = [](LiftNumber) {},
                      .lamp = [](LiftNumber, const CallKey&, bool) {},
                      .assigned = [](LiftNumber, const DestinationButton&, LiftNumber) {}},
            .heard = [](Time, const BusEvent&) {}};
  }
  static ScheduledFault fault(FaultKind kind, NodeId node = 0, LiftNumber lift = 1) {
    return {.kind = kind, .start = Time(1min), .duration = 30s, .part = lift, .node = node};
  }
  FaultExpectation of(const ScheduledFault& fault) const { return sut.of(fault); }
  FaultExpectation beside(const ScheduledFault& other, const ScheduledFault& fault) {
    description.faults.faults = {other};
    present.add(0);
    FaultExpectation expected = sut.of(fault);
    present.remove(0);
    return expected;
  }
  /// The car is on its way to floor 8.
  void travel() {
    devices.start();
    world.run_until(Time(20s));
    devices.shaft(1).press({.lift = 1, .floor = 8}, true);
    for (int i = 0; i < 100 && speed() < 1; ++i) world.run_for(100ms);
  }
  double speed() const { return std::abs(devices.shaft(1).snapshot(world.now()).speed_m_s); }

  World world;
  LiftNetworkDescription description;
  LiftDevices devices{world, description, silent()};
  PresentFaults present{description.faults.faults, devices};
  FaultConsequences sut{world, description, devices, present};
};

/// The car needs controller, drive, position, door and load; it does without lights and buttons.
TEST(FaultConsequences, OfALostNodeStopTheCarThatNeedsIt) {
  const Lifts sut(1);
  for (const auto& [node, is_needed] :
       {std::pair(0, true), std::pair(1, true), std::pair(2, true), std::pair(4, true),
        std::pair(6, true), std::pair(13, true), std::pair(9, false), std::pair(16, false),
        std::pair(28, false)}) {
    const FaultExpectation expected =
        sut.of(Lifts::fault(FaultKind::lost_node, static_cast<NodeId>(node)));
    EXPECT_EQ(expected.emergencies, heartbeat_error) << node;
    EXPECT_EQ(expected.stands_within.has_value(), is_needed) << node;
  }
}

TEST(FaultConsequences, OfACutAreThoseOfAllBehindItAndNoneAtTheEndOfTheCable) {
  const Lifts sut(1);
  for (const auto& [node, is_needed] :
       {std::pair(0, true), std::pair(9, true), std::pair(13, false), std::pair(27, false)}) {
    const FaultExpectation expected =
        sut.of(Lifts::fault(FaultKind::cable_cut, static_cast<NodeId>(node)));
    EXPECT_EQ(expected.emergencies, heartbeat_error) << node;
    EXPECT_EQ(expected.stands_within.has_value(), is_needed) << node;
  }
  const FaultExpectation at_the_end = sut.of(Lifts::fault(FaultKind::cable_cut, 28));
  EXPECT_EQ(at_the_end.emergencies, nothing);
  EXPECT_FALSE(at_the_end.stands_within.has_value());
}

/// A cable has one cut: the second one takes nothing. A node that is lost twice stays lost.
TEST(FaultConsequences, OfASecondFaultOfTheKindAreNotToldAgain) {
  Lifts sut(1);
  const FaultExpectation cut =
      sut.beside(Lifts::fault(FaultKind::cable_cut, 22), Lifts::fault(FaultKind::cable_cut, 4));
  EXPECT_EQ(cut.emergencies, nothing);
  EXPECT_FALSE(cut.stands_within.has_value());
  EXPECT_FALSE(cut.noticed_within.has_value());
  const ScheduledFault drive = Lifts::fault(FaultKind::lost_node, 2);
  const FaultExpectation lost = sut.beside(drive, drive);
  EXPECT_EQ(lost.emergencies, nothing);
  EXPECT_TRUE(lost.stands_within.has_value());
  EXPECT_EQ(sut.of(drive).emergencies, heartbeat_error) << "the other one is over";
}

/// Detection takes two seconds; after that nothing excuses silence.
TEST(FaultConsequences, OfRopesThatSlipAreNoneWhereTheCurrentGoesBeforeAnybodyCanNotice) {
  Lifts sut(2);
  sut.travel();
  ASSERT_GE(sut.speed(), 1);
  const ScheduledFault slip = Lifts::fault(FaultKind::rope_slip);
  EXPECT_NE(sut.of(slip).emergencies, nothing);
  using enum FaultKind;
  for (const auto& [other, is_told] :
       {std::pair(ScheduledFault{.kind = door_lock, .start = slip.start + 2s}, false),
        std::pair(ScheduledFault{.kind = door_lock, .start = slip.start + 2s + 1us}, true),
        std::pair(ScheduledFault{.kind = safety_contact, .duration = 60s}, true),
        std::pair(ScheduledFault{.kind = safety_contact, .duration = 60s + 1us}, false),
        std::pair(ScheduledFault{.kind = lost_node, .start = slip.start}, false),
        std::pair(ScheduledFault{.kind = lost_node, .start = slip.start, .node = 16}, true),
        std::pair(ScheduledFault{.kind = door_lock, .start = slip.start, .part = 2}, true)}) {
    sut.description.faults.faults = {slip, other};
    EXPECT_EQ(sut.of(slip).emergencies != nothing, is_told) << fault_name(other.kind);
  }
}

/// In a group another lift may carry people, and a lift that is not needed is idle.
TEST(FaultConsequences, OfALiftAloneEndWithinARoundTrip) {
  const ScheduledFault fault = Lifts::fault(FaultKind::dead_encoder);
  const Lifts alone(1);
  EXPECT_EQ(alone.of(fault).serves_within, serves_most(alone.description, 1));
  EXPECT_EQ(Lifts(2).of(fault).serves_within, Duration(30min));
}

/// Its controller is the first on the cable of a group, followed by the lifts in their order.
TEST(FaultConsequences, OfACutBehindTheLastLiftOfAGroupAreNone) {
  const Lifts sut(2);
  for (const NodeId node : {NodeId{0}, node_id::group_controller, NodeId{1}}) {
    EXPECT_EQ(sut.of(Lifts::fault(FaultKind::cable_cut, node, 0)).emergencies, heartbeat_error);
  }
  EXPECT_EQ(sut.of(Lifts::fault(FaultKind::cable_cut, 2, 0)).emergencies, nothing);
  EXPECT_EQ(sut.of(Lifts::fault(FaultKind::lost_node, 0, 0)).emergencies, heartbeat_error);
}

TEST(FaultConsequences, OfAButtonThatNobodyHasAreNone) {
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  std::erase_if(description.nodes, [](const NodeDescription& node) { return node.id == 23; });
  const Lifts sut(std::move(description));
  ScheduledFault button = Lifts::fault(FaultKind::stuck_button);
  button.spot = 4;
  EXPECT_NE(sut.of(button).emergencies, nothing);
  button.spot = 3;
  EXPECT_EQ(sut.of(button).emergencies, nothing) << "the panel of floor 3 is left out";
}

}  // namespace
}  // namespace canvoy::lift::fault_consequences_test
