// Complaints of the owner of a battery, and the invariant that each breaks: alone, and beside a
// harmless fault, which excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <ostream>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

namespace canvoy::charger::charging_sabotage_test {
namespace {

// A charger with node-ID 5 and a battery with 10; CAN-IDs of the pre-defined connection set (CiA
// 301) and of the battery's TPDOs 1 to 3.
constexpr Time trouble_at{5min};
/// Within each tenth of a second: after the battery has sent, and before the charger decides.
constexpr Duration phase = 57ms;

/// A network with a foreign device on its bus.
class Scene {
 public:
  explicit Scene(const ChargerOptions& options)
      : network(options), stranger_(network.world().bus().attach({})) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void send(std::string_view frame) { network.world().bus().send(stranger_, wire_frame(frame)); }
  PowerStageFaults& stage() { return network.plant().stage.faults; }
  BatteryFaults& cells() { return network.plant().battery.faults; }

  ChargerNetwork network;

 private:
  ControllerId stranger_;
};

/// The error from the start, the action each 100 ms from trouble_at on, and the invariant that
/// detects it.
struct Sabotage {
  const char* what = nullptr;
  InvariantKind breaks{};
  std::function<void(ChargerOptions&)> with = {};
  std::function<void(Scene&)> each = {};
  Duration lasts = 5min;  ///< the run goes on for this time after trouble_at
};
void PrintTo(const Sabotage& sabotage, std::ostream* out) {
  *out << sabotage.what;
}

std::function<void(Scene&)> says(std::vector<std::string_view> frames) {
  return [frames = std::move(frames)](Scene& it) {
    for (const std::string_view frame : frames) it.send(frame);
  };
}
/// Does the trick once in `times` calls.
std::function<void(Scene&)> rarely(unsigned times, std::function<void(Scene&)> trick) {
  return [times, trick = std::move(trick), count = 0U](Scene& it) mutable {
    if (count++ % times == 0) trick(it);
  };
}
std::function<void(ChargerOptions&)> fault(FaultKind kind, Duration lasts = for_the_rest) {
  return [=](ChargerOptions& options) {
    options.faults.faults.push_back({kind, trouble_at, lasts});
  };
}

constexpr std::string_view dead_battery_lives[] = {"70A#05", "18A#A0 00 01",
                                                   "28A#A0 00 01 00 C8 00 00", "38A#C0 03 32"};
const std::function<void(Scene&)> lives =
    says({std::begin(dead_battery_lives), std::end(dead_battery_lives)});
std::function<void(ChargerOptions&)> both(std::function<void(ChargerOptions&)> one,
                                          std::function<void(ChargerOptions&)> other) {
  return [one = std::move(one), other = std::move(other)](ChargerOptions& options) {
    one(options);
    other(options);
  };
}
std::function<void(ChargerOptions&)> ambience(double celsius) {
  return [celsius](ChargerOptions& options) { options.ambience_celsius = celsius; };
}
std::function<void(Scene&)> sticks_at(double ampere) {
  return [ampere](Scene& it) { it.stage().stuck_ampere = ampere; };
}

// Values of CiA 419, 7.2: 6010h in 1/8 degrees, 6000h: bit 0 is ready, 6060h in 1/1024 V, 6070h in
// 1/16 A, 6081h in %. 20 degrees are 00A0h, 50 V 0000C800h, 60 A 03C0h, 2 A 0020h.
const Sabotage sabotages[] = {
    // The charge stops.
    {.what = "a stranger stops the charger",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"000#02 05"})},
    {.what = "a stranger stops the battery",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"000#02 0A"})},
    {.what = "a stranger says that the battery is not ready",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"18A#A0 00 00", "28A#A0 00 00 00 C8 00 00"})},
    {.what = "a stranger says that the battery is full",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"38A#C0 03 64"})},
    {.what = "a stranger takes the battery's heartbeat away",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"60A#2B 17 10 00 00 00 00 00"})},
    {.what = "a stranger takes the battery's request away",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"60A#23 02 18 01 8A 03 00 80"})},
    {.what = "the power stage is dead",
     .breaks = InvariantKind::battery_left_waiting,
     .each = sticks_at(0)},
    {.what = "the charger was set to 0 A",
     .breaks = InvariantKind::battery_left_waiting,
     .with = [](ChargerOptions& options) { options.charger.limits.current_max_ampere = 0; }},
    // The charge takes the night and the morning.
    {.what = "a stranger asks for 2 A",
     .breaks = InvariantKind::less_than_asked,
     .each = says({"38A#20 00 32"})},
    {.what = "a stranger resets the charger each 5 s",
     .breaks = InvariantKind::less_than_asked,
     .each = rarely(50, says({"000#81 05"}))},
    {.what = "a stranger resets the battery each 5 s",
     .breaks = InvariantKind::less_than_asked,
     .each = rarely(50, says({"000#81 0A"}))},
    {.what = "the power stage gives a third",
     .breaks = InvariantKind::less_than_asked,
     .each = sticks_at(20)},
    {.what = "a stranger says that the battery has 10 V",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"28A#A0 00 01 00 28 00 00"})},
    {.what = "a stranger says that the battery is hot",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"18A#E0 01 01", "28A#E0 01 01 00 C8 00 00"})},
    {.what = "a stranger lets the battery tell its values once a minute",
     .breaks = InvariantKind::battery_left_waiting,
     .each = rarely(100, says({"60A#2B 00 18 05 60 EA 00 00", "60A#2B 01 18 05 60 EA 00 00",
                               "60A#2B 02 18 05 60 EA 00 00"}))},
    {.what = "a stranger sends as a second charger",
     .breaks = InvariantKind::less_than_asked,
     .each = rarely(10, says({"20A#01"}))},
    {.what = "a stranger takes the battery out of operation",
     .breaks = InvariantKind::battery_left_waiting,
     .each = says({"000#80 0A"})},
    // The cells are harmed.
    {.what = "a stranger asks for 60 A where the battery wants less",
     .breaks = InvariantKind::more_than_asked,
     .with =
         [](ChargerOptions& options) {
           options.battery = BatteryPlant::lithium_48v();
           options.state_of_charge = 0.94;
         },
     .each = says({"60A#23 02 18 01 8A 03 00 80", "38A#C0 03 32"}),
     .lasts = 30min},
    {.what = "a stranger says that the battery is ready, and drowns its own word",
     .breaks = InvariantKind::more_than_asked,
     .with = both(fault(FaultKind::not_ready), fault(FaultKind::pdo_loss)),
     .each = lives},
    {.what = "a stranger goes on for a dead battery",
     .breaks = InvariantKind::more_than_asked,
     .with = fault(FaultKind::battery_silent),
     .each = lives},
    {.what = "a contactor is welded, and the battery is not ready",
     .breaks = InvariantKind::current_outside_handshake,
     .with = fault(FaultKind::not_ready),
     .each = sticks_at(30)},
    {.what = "the power stage falls by 2 A a second",
     .breaks = InvariantKind::current_outside_handshake,
     .with = both(fault(FaultKind::not_ready),
                  [](ChargerOptions& options) { options.stage.fall_ampere_per_second = 2; })},
    {.what = "a contactor is welded until the battery is full",
     .breaks = InvariantKind::over_voltage,
     .with = [](ChargerOptions& options) { options.state_of_charge = 0.97; },
     .each = sticks_at(60),
     .lasts = 20min},
    {.what = "the sensor of a hot battery hangs in the air",
     .breaks = InvariantKind::charged_hot_or_cold,
     .with = ambience(55),
     .each = [](Scene& it) { it.cells().shown_celsius = 20; }},
    {.what = "the sensor of a frozen battery hangs in the air",
     .breaks = InvariantKind::charged_hot_or_cold,
     .with = ambience(-8),
     .each = [](Scene& it) { it.cells().shown_celsius = 20; }},
    {.what = "a stranger says that a hot battery is cool",
     .breaks = InvariantKind::charged_hot_or_cold,
     .with = both(ambience(55), fault(FaultKind::pdo_loss)),
     .each = lives},
    // The count differs from the delivered charge.
    {.what = "the meter shows too much",
     .breaks = InvariantKind::ampere_hours,
     .with = [](ChargerOptions& options) { options.stage.meter_gain = 1.03; }},
    {.what = "the meter shows too little",
     .breaks = InvariantKind::energy,
     .with = [](ChargerOptions& options) { options.stage.meter_gain = 0.97; }},
    {.what = "the meter shows 2 A at rest",
     .breaks = InvariantKind::ampere_hours,
     .with = [](ChargerOptions& options) { options.stage.meter_offset_ampere = 2; }},
    {.what = "the charger does not wait until it has said that it is ready",
     .breaks = InvariantKind::current_before_ready,
     .with = [](ChargerOptions& options) { options.charger.control_period = 100us; }},
};

/// Faults beside a sabotage: several at once, or, in a full run, none and each as well.
using Faults = std::vector<ScheduledFault>;
const std::vector<Faults> beside = {{{FaultKind::clock_drift, trouble_at - 2min},
                                     {FaultKind::corrupted_frames, trouble_at + 1min, 30s}},
                                    {},
                                    {{FaultKind::clock_drift, trouble_at - 2min}},
                                    {{FaultKind::corrupted_frames, trouble_at - 2min}},
                                    {{FaultKind::battery_restart, trouble_at - 2min, 1s}}};
using Case = std::tuple<Sabotage, Faults>;

class ChargerSabotageTest : public testing::TestWithParam<Case> {};

TEST_P(ChargerSabotageTest, BreaksWhatItIsAbout) {
  const auto& [sabotage, faults] = GetParam();
  ChargerOptions options;
  if (sabotage.with) sabotage.with(options);
  std::ranges::copy(faults, std::back_inserter(options.faults.faults));
  Scene scene(options);
  const Time end = trouble_at + sabotage.lasts;
  for (Time now = trouble_at + phase; sabotage.each && now <= end; now += 100ms) {
    scene.network.world().at(now, [&](Time) { sabotage.each(scene); });
  }
  scene.network.run_until(end);
  const auto all = scene.network.invariants();
  const auto broken = std::ranges::find_if(
      all, [&](const Invariant& one) { return one.kind == sabotage.breaks && !one.held; });
  EXPECT_NE(broken, all.end());
}

INSTANTIATE_TEST_SUITE_P(All, ChargerSabotageTest,
                         testing::Combine(testing::ValuesIn(sabotages),
                                          testing::ValuesIn(beside.begin(),
                                                            tries_all() ? beside.end()
                                                                        : beside.begin() + 1)));

}  // namespace
}  // namespace canvoy::charger::charging_sabotage_test
