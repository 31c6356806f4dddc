// Complaints of the owner of a charging yard, and the verdict that each breaks: alone, and beside a
// harmless fault in another bay, which excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <variant>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/charger/charging_yard.hpp"

namespace canvoy::charger::yard_sabotage_test {
namespace {

// On the shared bus, chargers have node-IDs 5 and 6, and batteries 10 and 11.
constexpr Time trouble_at{5min};
constexpr Duration phase = 57ms;

class Scene {
 public:
  explicit Scene(const YardOptions& options)
      : yard(options), stranger_(yard.world().bus().attach({})) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void send(std::string_view frame) { yard.world().bus().send(stranger_, wire_frame(frame)); }
  ChargingPlant& plant(unsigned bay) { return yard.bay(bay - 1).devices().plant(); }

  ChargingYard yard;

 private:
  ControllerId stranger_;
};

using Broken = std::variant<InvariantKind, YardInvariantKind>;

/// The error from the start, and the action each 100 ms from trouble_at on; what breaks, of which
/// bay or battery.
struct Sabotage {
  const char* what = nullptr;
  Broken breaks{};
  unsigned part = 2;
  std::function<void(YardOptions&)> with = {};
  std::function<void(Scene&)> each = {};
  Time end{35min};
};
void PrintTo(const Sabotage& sabotage, std::ostream* out) {
  *out << sabotage.what;
}

std::function<void(Scene&)> says(std::vector<std::string_view> frames) {
  return [frames = std::move(frames)](Scene& it) {
    for (const std::string_view frame : frames) it.send(frame);
  };
}
std::function<void(Scene&)> sticks_at(double ampere) {
  return [ampere](Scene& it) { it.plant(2).stage.faults.stuck_ampere = ampere; };
}
/// What the bays are told by their owner: the plugs code node-IDs of batteries.
std::function<void(YardOptions&)> with_goal(double charge) {
  return [charge](YardOptions& yard) {
    yard.goal = Goal{.state_of_charge = charge, .at = Time(30min)};
  };
}

const Sabotage sabotages[] = {
    // The morning.
    {.what = "a stranger stops the second charger",
     .breaks = YardInvariantKind::battery_goal,
     .each = says({"000#02 06"})},
    {.what = "a stranger stops the second battery",
     .breaks = YardInvariantKind::charger_goal,
     .each = says({"000#02 0B"})},
    {.what = "a stranger says that the second battery is full",
     .breaks = YardInvariantKind::battery_goal,
     .each = says({"38B#C0 03 64"})},
    {.what = "a stranger asks for 2 A in the name of the second battery",
     .breaks = YardInvariantKind::battery_goal,
     .each = says({"38B#20 00 32"})},
    {.what = "the second power stage is dead",
     .breaks = YardInvariantKind::charger_goal,
     .each = sticks_at(0)},
    {.what = "the second power stage gives a third",
     .breaks = YardInvariantKind::battery_goal,
     .each = sticks_at(20)},
    {.what = "the vehicle comes too late",
     .breaks = YardInvariantKind::battery_goal,
     .with = [](YardOptions& yard) { yard.vehicles[1].arrives = Time(20min); }},
    {.what = "the vehicle leaves too early",
     .breaks = YardInvariantKind::charger_goal,
     .with = [](YardOptions& yard) { yard.vehicles[1].leaves = Time(10min); }},
    {.what = "nobody changes the plug before the other vehicle has gone",
     .breaks = YardInvariantKind::battery_goal,
     .part = 3,
     .with =
         [](YardOptions& yard) {
           yard.vehicles.push_back({.bay = 2, .state_of_charge = 0.5});
           yard.batteries = 3;
           yard.change_time = 1h;
         }},
    {.what = "more is wanted than a night has hours",
     .breaks = YardInvariantKind::battery_goal,
     .with = with_goal(0.95)},
    // One bay harms or hinders the other.
    {.what = "a stranger resets all chargers each 5 s",
     .breaks = InvariantKind::less_than_asked,
     .each =
         [count = 0U](Scene& it) mutable {
           if (count++ % 50 == 0) it.send("000#81 00");
         }},
    {.what = "the second battery is left waiting while the first is charged",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"18B#A0 00 00", "28B#A0 00 00 00 C8 00 00"})},
    {.what = "a contactor of the second bay is welded, and its vehicle is not ready",
     .breaks = InvariantKind::current_outside_handshake,
     .with =
         [](YardOptions& yard) {
           yard.bay.faults.faults.push_back(
               {.kind = FaultKind::not_ready, .start = trouble_at, .part = 2});
         },
     .each = sticks_at(30)},
    {.what = "a contactor of the second bay is welded until the battery is full",
     .breaks = InvariantKind::over_voltage,
     .with = [](YardOptions& yard) { yard.vehicles[1].state_of_charge = 0.97; },
     .each = sticks_at(60)},
    {.what = "a sensor of the second bay hangs in the air in the heat",
     .breaks = InvariantKind::charged_hot_or_cold,
     .with = [](YardOptions& yard) { yard.bay.ambience_celsius = 55; },
     .each =
         [](Scene& it) {
           for (const unsigned bay : {1U, 2U}) it.plant(bay).battery.faults.shown_celsius = 20;
         }},
    {.what = "both chargers are told the node-ID of the first battery",
     .breaks = InvariantKind::battery_left_waiting,
     .with = [](YardOptions& yard) { yard.bay.charger.bay_battery = 10; }},
    // Batteries that only measure.
    {.what = "the charger stops when the battery is full, and never equalises",
     .breaks = YardInvariantKind::equalised,
     .with =
         [](YardOptions& yard) {
           yard.kinds = {BatteryKind::plain};
           yard.vehicles[1].state_of_charge = 0.985;
         },
     .each =
         [](Scene& it) {
           if (it.plant(2).battery.is_full()) it.plant(2).stage.faults.stuck_ampere = 0;
         },
     .end = Time(2h)},
    {.what = "the curve is that of a warmer place",
     .breaks = InvariantKind::over_voltage,
     .with =
         [](YardOptions& yard) {
           yard.kinds = {BatteryKind::plain};
           yard.vehicles[1].state_of_charge = 0.95;
         },
     .each = sticks_at(40)},
    // The mains.
    {.what = "the fuse is too small",
     .breaks = YardInvariantKind::supply,
     .part = 0,
     .with = [](YardOptions& yard) { yard.supply_watt = 5000; }},
};

using Case = std::tuple<Sabotage, bool>;

class YardSabotageTest : public testing::TestWithParam<Case> {};

YardOptions two_bays() {
  YardOptions yard;
  yard.chargers = 2;
  yard.batteries = 2;
  yard.one_bus = true;
  yard.vehicles = {{.bay = 1, .state_of_charge = 0.75}, {.bay = 2, .state_of_charge = 0.75}};
  with_goal(0.8)(yard);
  return yard;
}

template <class Invariants, class Kind>
bool is_broken(const Invariants& all, Kind kind, unsigned part) {
  return std::ranges::any_of(
      all, [&](const auto& one) { return one.kind == kind && one.part == part && !one.held; });
}

bool breaks(const ChargingYard& yard, const Sabotage& sabotage) {
  if (const auto* kind = std::get_if<InvariantKind>(&sabotage.breaks)) {
    return is_broken(yard.invariants(), *kind, sabotage.part);
  }
  return is_broken(yard.goals(), std::get<YardInvariantKind>(sabotage.breaks), sabotage.part);
}

TEST_P(YardSabotageTest, BreaksWhatItIsAbout) {
  const auto& [sabotage, is_beside] = GetParam();
  YardOptions options = two_bays();
  if (sabotage.with) sabotage.with(options);
  if (is_beside) {
    options.bay.faults.faults.push_back(
        {.kind = FaultKind::clock_drift, .start = trouble_at - 2min, .part = 1});
  }
  Scene scene(options);
  for (Time now = trouble_at + phase; sabotage.each && now <= sabotage.end; now += 100ms) {
    scene.yard.world().at(now, [&](Time) { sabotage.each(scene); });
  }
  scene.yard.run_until(sabotage.end);
  EXPECT_TRUE(breaks(scene.yard, sabotage));
}

/// Without any of them, all is well.
TEST(YardSabotage, IsWhatBreaksIt) {
  ChargingYard sut(two_bays());
  sut.run_until(Time(2h));
  EXPECT_TRUE(sut.all_hold());
}

/// Alone in a full run only: what breaks beside a fault also breaks without it.
std::vector<bool> beside() {
  return tries_all() ? std::vector{true, false} : std::vector{true};
}
INSTANTIATE_TEST_SUITE_P(All, YardSabotageTest,
                         testing::Combine(testing::ValuesIn(sabotages),
                                          testing::ValuesIn(beside())));

}  // namespace
}  // namespace canvoy::charger::yard_sabotage_test
