// What one lift of a described building has: the button that a fault holds down, and the key lock
// of a floor.
#include "canvoy/worlds/lift/shaft_plan.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::shaft_plan_test {
namespace {

CallKey stuck_at(const LiftNetworkDescription& network, FloorNumber spot) {
  return ShaftPlan(network, 2).stuck_button({.kind = FaultKind::stuck_button, .spot = spot});
}

TEST(ShaftPlan, AStuckButtonOfALandingWantsToTheMainFloorAndThereUp) {
  const LiftNetworkDescription network = standard_lift_network({.lifts = 2, .floors = 4});
  EXPECT_EQ(stuck_at(network, 1), (CallKey{.floor = 1, .direction = Direction::up}));
  EXPECT_EQ(stuck_at(network, 3), (CallKey{.floor = 3, .direction = Direction::down}));
  EXPECT_EQ(stuck_at(network, no_floor), (CallKey{.lift = 2, .floor = 1})) << "in the car";
}

/// At the main floor, the destination is the nearest other one, which each building has.
TEST(ShaftPlan, AStuckButtonOfDestinationControlNamesAnotherFloor) {
  LiftNetworkDescription network = standard_lift_network({.lifts = 2, .floors = 2});
  network.service.destination_control = true;
  EXPECT_EQ(stuck_at(network, 1), (CallKey{.floor = 1, .to = 2}));
  EXPECT_EQ(stuck_at(network, 2), (CallKey{.floor = 2, .to = 1}));
  network.building.main_floor = 2;
  EXPECT_EQ(stuck_at(network, 2), (CallKey{.floor = 2, .to = 1}));
  EXPECT_EQ(stuck_at(network, 1), (CallKey{.floor = 1, .to = 2}));
}

TEST(ShaftPlan, AKeyIsWantedInTheCarForTheFloorsThatItLocks) {
  LiftNetworkDescription network = standard_lift_network({.lifts = 2, .floors = 4});
  network.building.lifts[1].locked_by_key = {{{}, {3}}};
  EXPECT_EQ(ShaftPlan(network, 2).key_for({.lift = 2, .floor = 3}), 1U);
  EXPECT_EQ(ShaftPlan(network, 2).key_for({.lift = 2, .floor = 4}), std::nullopt);
  EXPECT_EQ(ShaftPlan(network, 2).key_for({.floor = 3, .direction = Direction::up}), std::nullopt)
      << "at a landing";
  EXPECT_EQ(ShaftPlan(network, 1).key_for({.lift = 1, .floor = 3}), std::nullopt);
}

}  // namespace
}  // namespace canvoy::lift::shaft_plan_test
