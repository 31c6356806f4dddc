// The highest building of CiA 417: 254 floors, and cars with four doors. Panels of cars and
// landings have more buttons than one group of inputs.
#include <gtest/gtest.h>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::tall_building_test {
namespace {

using cia417::BasicFunction;

TEST(TallBuildingTest, ACarPanelHasAButtonForEachOf254FloorsBesideItsKeys) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = lift_bit_rate});
  CarPanelOptions options{.doors = 0b1111};
  for (unsigned floor = 1; floor <= 254; ++floor) {
    options.floors.push_back(static_cast<FloorNumber>(floor));
  }
  const LiftPanel panel(world, bus, 16, car_controls(options), {});
  for (unsigned floor = 1; floor <= 254; ++floor) {
    EXPECT_TRUE(panel.find({BasicFunction::standard_car_call, static_cast<std::uint8_t>(floor)}))
        << floor;
  }
}

TEST(TallBuildingTest, ATerminalOfThreeLandingsHasAButtonForEachOther) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = lift_bit_rate});
  const LiftPanel panel(
      world, bus, 21,
      landing_controls({.floors = {1, 2, 254}, .highest = 254, .destinations = true}), {});
  constexpr FloorNumber floors[] = {1, 2, 254};
  for (const FloorNumber floor : floors) {
    for (unsigned to = 1; to <= 254; ++to) {
      if (to == floor) continue;
      EXPECT_TRUE(panel.find(
          {BasicFunction::standard_destination_call, static_cast<std::uint8_t>(to), floor}));
    }
  }
}

/// A fast lift: 254 floors are 885 m.
LiftNetworkDescription tall_building(bool destination_control) {
  StandardLifts options{.floors = 254, .destination_control = destination_control};
  options.lift.speed_m_s = 10;
  options.lift.doors = 0b1111;
  return standard_lift_network(options);
}

TEST(TallBuildingTest, PeopleAreBroughtFromAndToTheHighestFloors) {
  LiftNetworkDescription description = tall_building(false);
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 254},
                          {.at = Time(3s), .from = 1, .to = 251},
                          {.at = Time(4s), .from = 253, .to = 1}};
  LiftNetwork network(description);
  network.run_until(Time(8min));
  EXPECT_EQ(network.summary().served, 3U);
  EXPECT_EQ(broken(network), "");
}

TEST(TallBuildingTest, ATerminalSendsThemThereToo) {
  LiftNetworkDescription description = tall_building(true);
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 254},
                          {.at = Time(3s), .from = 252, .to = 253}};
  LiftNetwork network(description);
  network.run_until(Time(8min));
  EXPECT_EQ(network.summary().served, 2U);
  EXPECT_EQ(broken(network), "");
}

}  // namespace
}  // namespace canvoy::lift::tall_building_test
