// A charging yard: several chargers and batteries, on a bus each or on one, vehicles that come and
// go, curves, the mains, and the goal. Charges are computed by hand: 400 Ah, 60 A; lead and acid
// keep 92 % of what flows in, lithium 99.5 %.
#include "canvoy/worlds/charger/charging_yard.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::charger::charging_yard_test {
namespace {

YardOptions yard_of(unsigned chargers, std::vector<YardVehicle> vehicles) {
  YardOptions yard;
  yard.bay.manager_id = 1;
  yard.chargers = chargers;
  yard.batteries = static_cast<unsigned>(vehicles.size());
  yard.vehicles = std::move(vehicles);
  return yard;
}

void expect_all_held(const ChargingYard& yard) {
  for (const Invariant& each : yard.invariants()) {
    EXPECT_TRUE(each.held) << "bay " << unsigned{each.part} << ": "
                           << invariant_name(each.kind).name << ' ' << each.worst;
  }
  for (const YardInvariant& each : yard.goals()) {
    EXPECT_TRUE(each.held) << unsigned{each.part} << ": " << invariant_name(each.kind).name << ' '
                           << each.worst;
  }
}

const YardInvariant* goal_of(const std::vector<YardInvariant>& all, YardInvariantKind kind,
                             unsigned part) {
  const auto found = std::ranges::find_if(
      all, [&](const YardInvariant& each) { return each.kind == kind && each.part == part; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<VehicleMoved> moves_of(const ChargingYard& yard, unsigned vehicle) {
  std::vector<VehicleMoved> moves;
  for (const YardEvent& event : yard.events()) {
    const auto* moved = std::get_if<VehicleMoved>(&event.what);
    if (moved != nullptr && moved->vehicle == vehicle) moves.push_back(*moved);
  }
  return moves;
}

class YardOnBuses : public testing::TestWithParam<bool> {};

/// All at once, so that each charger finds all batteries of the bus.
TEST_P(YardOnBuses, EachChargerChargesTheBatteryOfItsBay) {
  YardOptions options = yard_of(
      3, {{.bay = 1}, {.bay = 2, .state_of_charge = 0.3}, {.bay = 3, .state_of_charge = 0.4}});
  options.one_bus = GetParam();
  ChargingYard sut(options);
  sut.run_until(Time(10min));
  EXPECT_EQ(sut.buses(), GetParam() ? 1U : 3U);
  for (std::size_t bay = 0; bay < 3; ++bay) {
    const ChargerOptions& of_bay = sut.bay(bay).options();
    EXPECT_EQ(sut.bay(bay).devices().charger().charger().battery(), of_bay.battery_id) << bay;
    EXPECT_NEAR(sut.bay(bay).devices().plant().ampere(), 60, 0.1) << bay;
    EXPECT_NEAR(sut.vehicles().cells(bay).truth().ampere_hours_in, 9.9, 0.2) << bay;
  }
  expect_all_held(sut);
}

/// A charger whose bay is empty leaves the batteries of the others alone.
TEST_P(YardOnBuses, ABayWithoutABatteryDeliversNothing) {
  YardOptions options = yard_of(2, {{.bay = 2}});
  options.one_bus = GetParam();
  ChargingYard sut(options);
  sut.run_until(Time(5min));
  EXPECT_EQ(sut.bay(0).devices().charger().charger().phase(), cia419::ChargerPhase::unplugged);
  EXPECT_EQ(sut.bay(0).devices().plant().ampere_hours(), 0);
  EXPECT_NEAR(sut.bay(1).devices().plant().ampere(), 60, 0.1);
  expect_all_held(sut);
}

INSTANTIATE_TEST_SUITE_P(All, YardOnBuses, testing::Bool());

/// The charger of bay 1 and the battery of bay 2 are elsewhere: nothing of them is on the simulated
/// bus, nothing is judged that is not seen, and bay 3 is charged and judged as ever.
TEST_P(YardOnBuses, APartOfABayMayBeReal) {
  YardOptions options = yard_of(3, {{.bay = 1}, {.bay = 2}, {.bay = 3}});
  options.one_bus = GetParam();
  options.goal = Goal{.state_of_charge = 0.2, .at = Time(9min)};
  options.supply_watt = 50'000;
  options.real_chargers = {1};
  options.real_batteries = {2};
  ChargingYard sut(options);
  sut.run_until(Time(10min));
  EXPECT_FALSE(sut.world().is_running(sut.bay(0).devices().charger_slot()));
  EXPECT_TRUE(sut.world().is_running(sut.bay(0).devices().battery_slot()));
  EXPECT_TRUE(sut.world().is_running(sut.bay(1).devices().charger_slot()));
  EXPECT_FALSE(sut.world().is_running(sut.bay(1).devices().battery_slot()));
  EXPECT_NEAR(sut.bay(2).devices().plant().ampere(), 60, 0.1);
  EXPECT_EQ(sut.bay(0).devices().plant().ampere_hours(), 0);
  expect_all_held(sut);
  const auto goals = sut.goals();
  for (const unsigned part : {1U, 2U, 3U}) {
    const bool is_played = part == 3;
    EXPECT_EQ(goal_of(goals, YardInvariantKind::battery_goal, part)->is_decided(), is_played);
    EXPECT_EQ(goal_of(goals, YardInvariantKind::charger_goal, part)->is_decided(), is_played);
  }
  EXPECT_FALSE(goal_of(goals, YardInvariantKind::supply, 0)->is_decided())
      << "what the real charger takes is not known";
}

/// From 70 % to 80 %: 40 Ah, of which 92 % remain, at 60 A: 43.5 minutes.
TEST(ChargingYard, ABatteryThatHasTheGoalMakesRoomForTheNext) {
  YardOptions options = yard_of(1, {{.state_of_charge = 0.7}, {.arrives = Time(10min)}});
  options.goal = Goal{};
  ChargingYard sut(options);
  sut.run_until(Time(1h));
  const auto first = moves_of(sut, 1);
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[2].from, VehiclePlace::plugged);
  EXPECT_EQ(first[2].to, VehiclePlace::waiting);
  EXPECT_NEAR(first[2].state_of_charge, 0.8, 1e-4);
  EXPECT_EQ(sut.vehicles().place(1), VehiclePlace::plugged);
  EXPECT_NEAR(sut.bay(0).devices().plant().ampere(), 60, 0.1);
  // 60 minutes less 43.5, two to change, and seconds to begin each charge: 14.5 Ah.
  EXPECT_NEAR(sut.vehicles().cells(1).truth().ampere_hours_in, 14.3, 0.5);
  const ChargingPlant& plant = sut.bay(0).devices().plant();
  EXPECT_NEAR(plant.ampere_hours(),
              sut.vehicles().cells(0).truth().ampere_hours_in +
                  sut.vehicles().cells(1).truth().ampere_hours_in,
              1e-6);
  expect_all_held(sut);
}

TEST(ChargingYard, AVehicleThatLeavesTakesItsBatteryAtOnceAndComesBackWithLess) {
  YardOptions options = yard_of(
      1, {{.state_of_charge = 0.5, .leaves = Time(30min), .returns = Time(90min), .used = 0.1}});
  ChargingYard sut(options);
  sut.run_until(Time(30min));
  EXPECT_NEAR(sut.bay(0).devices().plant().ampere(), 60, 0.1);
  sut.run_until(Time(30min + 200ms));
  EXPECT_EQ(sut.bay(0).devices().plant().ampere(), 0);
  const double left_with = sut.vehicles().cells(0).state_of_charge();
  EXPECT_NEAR(left_with, 0.5 + 30 * 0.92 / 400, 0.003);
  sut.run_until(Time(90min));
  EXPECT_NEAR(sut.vehicles().cells(0).state_of_charge(), left_with - 0.1, 0.001);
  sut.run_until(Time(91min));
  EXPECT_NEAR(sut.bay(0).devices().plant().ampere(), 60, 0.1);
  expect_all_held(sut);
}

// The goal.

/// An hour at 60 A is 55.2 Ah, or 13.8 %.
TEST(ChargingYard, AGoalThatIsMissedIsBrokenByWhatIsMissing) {
  YardOptions options =
      yard_of(2, {{.bay = 1, .state_of_charge = 0.2}, {.bay = 2, .state_of_charge = 0.75}});
  options.goal = Goal{.state_of_charge = 0.8, .at = Time(1h)};
  ChargingYard sut(options);
  sut.run_until(Time(1h - 1min));
  for (const YardInvariant& each : sut.goals()) EXPECT_FALSE(each.is_decided());
  sut.run_until(Time(1h + 1s));
  const auto all = sut.goals();
  for (const YardInvariantKind kind :
       {YardInvariantKind::battery_goal, YardInvariantKind::charger_goal}) {
    const YardInvariant* const missed = goal_of(all, kind, 1);
    ASSERT_NE(missed, nullptr);
    EXPECT_FALSE(missed->held);
    EXPECT_NEAR(missed->worst, 80 - 20 - 13.8, 0.3);
    EXPECT_EQ(missed->allowed, 0);
    const YardInvariant* const reached = goal_of(all, kind, 2);
    ASSERT_NE(reached, nullptr);
    EXPECT_TRUE(reached->held && reached->is_decided());
  }
  EXPECT_FALSE(sut.all_hold());
}

/// A vehicle that leaves before is judged then, and one that is away at that time is not.
TEST(ChargingYard, AGoalHoldsForWhoIsThere) {
  YardOptions options = yard_of(2, {{.bay = 1, .state_of_charge = 0.5, .leaves = Time(30min)},
                                    {.bay = 2, .arrives = Time(2h)}});
  options.goal = Goal{.at = Time(1h)};
  ChargingYard sut(options);
  sut.run_until(Time(3h));
  const auto all = sut.goals();
  EXPECT_FALSE(goal_of(all, YardInvariantKind::battery_goal, 1)->held);
  EXPECT_FALSE(goal_of(all, YardInvariantKind::battery_goal, 2)->is_decided());
  EXPECT_FALSE(goal_of(all, YardInvariantKind::charger_goal, 2)->is_decided());
}

/// 30 minutes without a battery module cost at most 60 A for so long and 15 s: 7.5625 %.
TEST(ChargingYard, AFaultExcusesWhatItCanHaveCost) {
  YardOptions options =
      yard_of(2, {{.bay = 1, .state_of_charge = 0.70}, {.bay = 2, .state_of_charge = 0.70}});
  options.goal = Goal{.at = Time(50min)};
  options.bay.faults.faults = {
      {.kind = FaultKind::battery_silent, .start = Time(10min), .duration = 30min, .part = 2}};
  ChargingYard sut(options);
  sut.run_until(Time(51min));
  const auto all = sut.goals();
  const YardInvariant* const with_fault = goal_of(all, YardInvariantKind::battery_goal, 2);
  EXPECT_NEAR(with_fault->worst, 10 - 20 * 0.92 / 4, 0.3);
  EXPECT_NEAR(with_fault->allowed, 60 * (30.25 / 60) / 400 * 100, 0.1);
  EXPECT_TRUE(with_fault->held);
  EXPECT_EQ(goal_of(all, YardInvariantKind::battery_goal, 1)->allowed, 0);
  expect_all_held(sut);
}

/// A bus of all bays is down for all.
TEST(ChargingYard, AFaultOfTheSharedBusExcusesAllBays) {
  YardOptions options = yard_of(2, {{.bay = 1}, {.bay = 2}});
  options.one_bus = true;
  options.bay.faults.faults = {
      {.kind = FaultKind::babbling_node, .start = Time(5min), .duration = 2min, .part = 2}};
  ChargingYard sut(options);
  sut.run_until(Time(15min));
  expect_all_held(sut);
  const auto begins = std::ranges::count_if(sut.events(), [](const YardEvent& event) {
    const auto* of_bay = std::get_if<ChargerEvent>(&event.what);
    return of_bay != nullptr && event.bay == 2 && std::holds_alternative<FaultBegan>(of_bay->what);
  });
  EXPECT_EQ(begins, 1);
}

// Curves.

TEST(ChargingYard, AChargerHasACurveForABatteryThatRequestsNothing) {
  YardOptions options = yard_of(1, {{.state_of_charge = 0.8}});
  options.kinds = {BatteryKind::plain};
  ChargingYard sut(options);
  double volt_max = 0;
  for (Time now{}; now < Time(8h); now += 1min) {
    sut.run_until(now);
    volt_max = std::max(volt_max, sut.bay(0).devices().plant().battery.terminal_volt());
  }
  const BatteryPlant& cells = sut.vehicles().cells(0);
  EXPECT_TRUE(cells.is_full());
  EXPECT_EQ(sut.bay(0).devices().plant().ampere(), 0);
  EXPECT_LE(volt_max, 24 * 2.4 * 1.01);
  EXPECT_EQ(sut.bay(0).devices().battery().node().dictionary().number(0x1802, 1), 0x8000'038AU);
  const auto all = sut.goals();
  const YardInvariant* const equalised = goal_of(all, YardInvariantKind::equalised, 1);
  ASSERT_NE(equalised, nullptr);
  EXPECT_TRUE(equalised->is_decided());
  expect_all_held(sut);
}

TEST(ChargingYard, BaysMayHaveBatteriesOfSeveralKinds) {
  YardOptions options = yard_of(3, {{.bay = 1}, {.bay = 2}, {.bay = 3}});
  options.kinds = {BatteryKind::lithium, BatteryKind::plain, BatteryKind::lead_acid};
  options.one_bus = true;
  ChargingYard sut(options);
  sut.run_until(Time(1h));
  EXPECT_NEAR(sut.vehicles().cells(0).state_of_charge(), 0.2 + 60 * 0.995 / 400, 0.002);
  EXPECT_NEAR(sut.vehicles().cells(1).state_of_charge(), 0.2 + 60 * 0.92 / 400, 0.002);
  EXPECT_NEAR(sut.vehicles().cells(2).state_of_charge(), 0.2 + 60 * 0.92 / 400, 0.002);
  expect_all_held(sut);
}

// The mains.

/// 93 % of it reach a battery.
TEST(ChargingYard, EnergyComesFromTheMains) {
  YardOptions options = yard_of(2, {{.bay = 1}, {.bay = 2}});
  options.supply_watt = 7000;
  ChargingYard sut(options);
  sut.run_until(Time(1h));
  double delivered = 0;
  for (std::size_t bay = 0; bay < 2; ++bay) {
    delivered += sut.bay(bay).devices().plant().energy_watt_hour();
  }
  EXPECT_NEAR(sut.referee().mains_watt_hours(), delivered / 0.93, delivered * 0.001);
  const YardSnapshot look = sut.snapshot();
  EXPECT_NEAR(look.mains_watt_max, 2 * 60 * look.bays[0].volt / 0.93, 60);
  EXPECT_TRUE(goal_of(sut.goals(), YardInvariantKind::supply, 0)->held);
}

TEST(ChargingYard, ASupplyThatBearsLessIsBroken) {
  YardOptions options = yard_of(2, {{.bay = 1}, {.bay = 2}});
  options.supply_watt = 5000;  // one of them takes some 3.2 kW
  ChargingYard sut(options);
  sut.run_until(Time(5min));
  EXPECT_FALSE(goal_of(sut.goals(), YardInvariantKind::supply, 0)->held);
}

// What is drawn.

TEST(ChargingYard, ASeedDecidesWhenVehiclesCome) {
  YardOptions options;
  options.chargers = 2;
  options.batteries = 4;
  options.goal = Goal{};
  const std::vector<YardVehicle> drawn = drawn_vehicles(options);
  ASSERT_EQ(drawn.size(), 4U);
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_EQ(drawn[i].bay, i % 2 + 1);
    EXPECT_LE(drawn[i].arrives, Time(i < 2 ? 30min : 2h));
    EXPECT_GE(drawn[i].state_of_charge, 0.2);
    EXPECT_LE(drawn[i].state_of_charge, 0.5);
    EXPECT_GE(drawn[i].leaves, options.goal->at + 30min);
  }
  EXPECT_EQ(drawn_vehicles(options)[3].arrives, drawn[3].arrives);
  options.bay.faults.seed = 2;
  EXPECT_NE(drawn_vehicles(options)[3].arrives, drawn[3].arrives);
}

TEST(ChargingYard, IsPlayedForANight) {
  YardOptions options;
  options.bay.manager_id = 1;
  options.chargers = tries_all() ? 3 : 2;
  options.batteries = tries_all() ? 5 : 3;
  options.kinds = {BatteryKind::lead_acid, BatteryKind::lithium, BatteryKind::plain};
  options.goal = Goal{};
  options.vehicles = drawn_vehicles(options);
  ChargingYard sut(options);
  sut.run_until(Time(12h + 1min));
  expect_all_held(sut);
  for (const YardInvariant& each : sut.goals()) {
    if (each.kind != YardInvariantKind::equalised) EXPECT_TRUE(each.is_decided());
  }
  EXPECT_TRUE(std::ranges::is_sorted(sut.events(), {}, &YardEvent::at));
}

}  // namespace
}  // namespace canvoy::charger::charging_yard_test
