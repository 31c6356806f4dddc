// Lifts that do not serve all floors, doors that do not open at all of them, floors that need a
// key; and panels with more, or fewer, controls than usual.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_floors_test {
namespace {

using cia417::BasicFunction;
using cia417::SpecialFunction;

/// Removes the panels where no lift goes.
void take_down_panels(LiftNetworkDescription& description) {
  std::erase_if(description.nodes, [&](const NodeDescription& node) {
    return std::ranges::any_of(node.floors, [&](FloorNumber floor) {
      return !description.building.serves(node.lift, floor);
    });
  });
}

/// Lift 1 goes to floors 1 to 4, lift 2 to 1 and 5 to 8.
LiftNetworkDescription two_zones(bool destination_control) {
  LiftNetworkDescription description =
      standard_lift_network({.lifts = 2, .floors = 8, .destination_control = destination_control});
  description.building.zones = {{"low", {1, 2, 3, 4}}, {"high", {1, 5, 6, 7, 8}}};
  description.building.lifts[0].zone = "low";
  description.building.lifts[1].zone = "high";
  description.traffic.pattern = TrafficPattern::lunch;
  description.traffic.percent_in_5_minutes = 8;
  take_down_panels(description);
  if (!destination_control) {
    std::erase_if(description.nodes, [](const NodeDescription& node) { return node.lift == 0; });
  }
  return description;
}

TEST(LiftFloors, EachLiftServesTheFloorsOfItsZone) {
  for (const bool destination_control : {false, true}) {
    const LiftNetworkDescription description = two_zones(destination_control);
    ASSERT_EQ(check(description), "");
    LiftNetwork network(description);
    network.run_until(Time(12min));
    std::set<FloorNumber> stops[2];
    for (const LiftEvent& event : network.events()) {
      const auto* const opened = std::get_if<DoorsOpened>(&event.what);
      if (opened != nullptr) stops[opened->lift - 1].insert(opened->floor);
    }
    EXPECT_EQ(stops[0], (std::set<FloorNumber>{1, 2, 3, 4}));
    EXPECT_EQ(stops[1], (std::set<FloorNumber>{1, 5, 6, 7, 8}));
    EXPECT_GT(network.summary().served, 20U);
    EXPECT_EQ(network.summary().gave_up, 0U);
    EXPECT_EQ(broken(network), "");
  }
}

TEST(LiftFloors, ADoorOpensWhereTheBuildingHasOneForIt) {
  StandardLifts options{.floors = 4};
  options.lift.doors = 0b0011;
  options.lift.floors_of_door = {{{1, 2}, {2, 3, 4}}};
  LiftNetworkDescription description = standard_lift_network(options);
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 4, .mass_kg = 80},
                          {.at = Time(60s), .from = 2, .to = 3, .mass_kg = 80}};
  ASSERT_EQ(check(description), "");
  LiftNetwork network(description);
  std::set<std::pair<FloorNumber, int>> open;
  while (network.now() < Time(2min)) {
    network.run_until(network.now() + 100ms);
    const LiftSnapshot lift = network.snapshot().lifts.at(0);
    for (int door = 1; door <= 2; ++door) {
      const bool is_open = lift.doors.at(static_cast<std::size_t>(door) - 1).open_share > 0.1;
      if (is_open) open.emplace(lift.nearest_floor, door);
    }
  }
  EXPECT_EQ(open, (std::set<std::pair<FloorNumber, int>>{{1, 1}, {2, 1}, {2, 2}, {3, 2}, {4, 2}}));
  EXPECT_EQ(network.summary().served, 2U);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftFloors, WhoMayGoToALockedFloorTurnsItsKey) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.building.lifts[0].locked_by_key[1] = {3};
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 3, .mass_kg = 80}};
  ASSERT_EQ(check(description), "");
  LiftNetwork network(description);
  unsigned turns = 0;
  network.observe(
      0, {.context = &turns, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
            // The car panel, special function key lock 2, turned.
            const bool is_key = frame.id == 0x490 && frame.data[0] == 0x0E &&
                                frame.data[1] == 0x06 && frame.data[5] == 0x81;
            if (is_key) ++*static_cast<unsigned*>(self);
          }});
  network.run_until(Time(90s));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(turns, 1U);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftFloors, ALockedFloorIsNotServedWithoutItsKey) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.building.lifts[0].locked_by_key[1] = {3};
  const auto panel =
      std::ranges::find(description.nodes, DeviceKind::car_panel, &NodeDescription::kind);
  panel->panel.keys = {SpecialFunction::door_open};  // none to turn
  description.arrivals = {{.at = Time(5s), .from = 1, .to = 3, .mass_kg = 80}};
  LiftNetwork network(description);
  network.run_until(Time(60s));
  const auto stops_at_3 = std::ranges::count_if(network.events(), [](const LiftEvent& event) {
    const auto* const opened = std::get_if<DoorsOpened>(&event.what);
    return opened != nullptr && opened->floor == 3;
  });
  EXPECT_EQ(stops_at_3, 0);
}

struct WrongFloors : testing::Test {
  LiftNetworkDescription network = standard_lift_network({.lifts = 2, .floors = 4});
  LiftDesign& lift = network.building.lifts[1];
};

TEST_F(WrongFloors, AreToldInOneLine) {
  lift.zone = "high";
  EXPECT_EQ(check(network), "lift 2: there is no zone 'high'; write [[zone]] with this name");
  network.building.zones = {{"high", {1, 9}}};
  EXPECT_EQ(check(network), "zone 'high' names floor 9, which is not there");
  network.building.zones = {{"high", {2, 3}}};
  EXPECT_EQ(check(network), "lift 2 does not serve the fire floor");
  network.building.zones = {{"high", {1}}};
  EXPECT_EQ(check(network), "lift 2 serves one floor alone");
  network.building.zones = {{"high", {1, 2}}, {"high", {3}}};
  EXPECT_EQ(check(network), "zone 'high' needs a name of its own");
  network.building.zones = {{"high", {1, 2}}};
  EXPECT_EQ(check(network),
            "lifts 1 and 2 of the group do not serve the same floors: say destination_control = "
            "true, or leave the group controller out");
  network.service.destination_control = true;
  EXPECT_EQ(check(network),
            "lift-landing-panel with node-ID 23: lift 2 does not serve floor 3: leave it out");
  take_down_panels(network);
  EXPECT_EQ(check(network), "");
  network.arrivals = {{.at = Time(1s), .from = 3, .to = 4}};
  EXPECT_EQ(check(network), "");
  network.building.lifts[0].zone = "high";
  take_down_panels(network);
  EXPECT_EQ(check(network), "no lift goes from floor 3 to floor 4");
}

TEST_F(WrongFloors, OfDoorsAreToldInOneLine) {
  lift.floors_of_door[1] = {1};
  EXPECT_EQ(check(network), "door 2 of lift 2 is not there");
  lift.doors = 0b0011;
  lift.floors = {1, 2};
  lift.floors_of_door[1] = {3};
  EXPECT_EQ(check(network), "door 2 of lift 2 opens at no floor");
}

template <class Record>
std::vector<std::uint64_t> bytes_of(const std::vector<Record>& records) {
  std::vector<std::uint64_t> all;
  for (const Record& record : records) all.push_back(cia417::encode(record));
  return all;
}

TEST(PanelDescriptionTest, ALandingPanelHasTheKeysAndDisplaysThatAreNamed) {
  const PanelControls made = landing_controls(
      {.floors = {3},
       .highest = 4,
       .panel = {.keys = {{SpecialFunction::out_of_order, SpecialFunction::fan_1}},
                 .displays = {{*panel_display_of("arrival"), *panel_display_of("fire")}}}});
  // 4.3.1: function, sub-function, lifts, floor, doors, data; the first byte is the lowest.
  EXPECT_EQ(bytes_of(made.inputs),
            (std::vector<std::uint64_t>{0x00'10'03'FF'01'02, 0x00'10'03'FF'02'02,
                                        0x80'10'03'01'10'0E, 0x00'10'03'01'01'0E}));
  EXPECT_EQ(
      bytes_of(made.outputs),
      (std::vector<std::uint64_t>{0x00'10'03'01'01'02, 0x00'10'03'01'02'02, 0x00'10'03'01'00'44,
                                  0x00'10'03'01'04'43, 0x00'10'03'01'10'0E, 0x00'10'03'01'01'0E}));
}

TEST(PanelDescriptionTest, AllNamesAreReadBack) {
  EXPECT_EQ(special_function_names().size(), 22U);
  for (const std::string_view name : special_function_names()) {
    EXPECT_EQ(special_function_name(*special_function_of(name)), name);
  }
  EXPECT_EQ(special_function_of("vip-service"), SpecialFunction::vip_service);
  EXPECT_EQ(special_function_of("dogging-service-down"), SpecialFunction::dogging_service_down);
  EXPECT_EQ(panel_display_names().size(), 15U);
  for (const std::string_view name : panel_display_names()) {
    EXPECT_EQ(panel_display_name(*panel_display_of(name)), name);
  }
  EXPECT_FALSE(special_function_of("bell"));
  EXPECT_FALSE(panel_display_of("bell"));
}

/// A device on the bus of a panel that starts it and sends it the values to show.
struct Teller {
  void start(Time) {}
  void receive(const Frame&, Time) {}
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {}
  void overrun(Time) {}
};

TEST(PanelDescriptionTest, AGongRingsWhereThePanelHasOne) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = lift_bit_rate});
  Teller teller;
  const SlotIndex slot = world.add_slot(bus);
  world.occupy(slot, teller);
  world.start(slot);
  std::vector<std::pair<BasicFunction, unsigned>> shown;
  const LiftPanel panel(
      world, bus, 23,
      landing_controls(
          {.floors = {3}, .highest = 4, .panel = {.displays = {{*panel_display_of("arrival")}}}}),
      [&](const cia417::VirtualOutput& output, const cia417::OutputView& view) {
        if (view.on) shown.emplace_back(output.function, view.sub_function);
      });
  world.start(panel.slot());
  world.run_until(Time(1s));
  const Port port = world.port(slot);
  port.send(port.context, Frame::data_frame(0x000, {0x01, 0x17}));
  port.send(port.context, Frame::data_frame(0x400, {0x41, 0x02, 0x01, 0x03, 0x10, 0x01}));
  port.send(port.context, Frame::data_frame(0x400, {0x44, 0x02, 0x01, 0x03, 0x10, 0x01}));
  world.run_until(Time(2s));
  EXPECT_EQ(
      shown,
      (std::vector<std::pair<BasicFunction, unsigned>>{{BasicFunction::arrival_indication, 2U}}))
      << "for down; it has no lantern";
}

TEST(PanelDescriptionTest, AParameterDisablesAButtonOfAPanelThatHasThem) {
  for (const bool is_disabled : {false, true}) {
    LiftNetworkDescription description = standard_lift_network({.floors = 4});
    description.arrivals = {{.at = Time(5s), .from = 4, .to = 1, .mass_kg = 80}};
    NodeDescription& panel = description.nodes.back();
    ASSERT_EQ(panel.kind, DeviceKind::landing_panel);
    panel.panel.parameters = true;
    // Parameter 1 of its only button; bit 0 enables it (4.3.2).
    if (is_disabled) panel.values = {{0x6120, 1, {0xFE, 0xFF, 0xFF, 0xFF}}};
    LiftNetwork network(description);
    network.run_until(Time(60s));
    EXPECT_FALSE(network.refused());
    EXPECT_EQ(network.summary().served, is_disabled ? 0U : 1U);
  }
}

TEST(PanelDescriptionTest, APanelWithoutParametersTakesNone) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.nodes.back().values = {{0x6120, 1, {0xFE, 0xFF, 0xFF, 0xFF}}};
  const LiftNetwork network(description);
  ASSERT_TRUE(network.refused());
  EXPECT_EQ(network.refused()->refusal.reason, AbortCode::no_object);
}

}  // namespace
}  // namespace canvoy::lift::lift_floors_test
