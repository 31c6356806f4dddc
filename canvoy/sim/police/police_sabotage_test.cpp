// Each referee of a police car can fail: what a crew would complain of breaks it, and no other one;
// alone, and together with a fault elsewhere that comes again and again and excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/sim/police/police_excuses.hpp"
#include "canvoy/sim/police/police_network.hpp"

namespace canvoy::police::police_sabotage_test {
namespace {

/// On patrol for half of it; then power runs after, and all sleep.
constexpr Duration patrol = 100min;
/// With seed 1 the first call comes at 11 min 22 s, and the crew is on its way until 15 min 40 s.
constexpr Time on_its_way(14min);

/// Somebody on the bus who sends each frame of a device again, later.
class Echo {
 public:
  Echo(PoliceNetwork& network, NodeId of, Duration late)
      : bus_(network.world().bus(0)),
        world_(network.world()),
        me_(bus_.attach({})),
        of_(network.node(of).controller()),
        late_(late) {
    bus_.observe({.context = this, .on_frame = hear, .on_state = nullptr});
  }
  Echo(const Echo&) = delete;
  Echo& operator=(const Echo&) = delete;

 private:
  static void hear(void* self, Time, ControllerId sender, const Frame& frame) {
    auto& echo = *static_cast<Echo*>(self);
    if (sender != echo.of_) return;
    echo.world_.at(echo.world_.now() + echo.late_,
                   [&echo, frame](Time) { echo.bus_.send(echo.me_, frame); });
  }

  SimulatedBus& bus_;
  World& world_;
  ControllerId me_;
  ControllerId of_;
  Duration late_;
};

struct Case {
  const char* name;
  InvariantKind breaks;
  Sabotage sabotage{};
  Duration length = patrol;
  NodeId loses_power = 0;  ///< on its way, by no fault of the plan
  NodeId echoed = 0;       ///< each frame of it comes again 8 s later: whoever spoke has ended
  /// Comes each 45 s, or lasts; none of what it can cause is what is to be broken.
  ScheduledFault beside = {.kind = FaultKind::restart, .node = roof_light_id};
};
std::ostream& operator<<(std::ostream& out, const Case& it) {
  return out << it.name;
}

constexpr ScheduledFault restart_of(NodeId node) {
  return {.kind = FaultKind::restart, .node = node};
}
/// All devices have a part in silence.
constexpr ScheduledFault burnt_lamp = {.kind = FaultKind::burnt_lamp, .node = 0};

const Case cases[] = {
    {.name = "ANavigationThatTakesEveryKey",
     .breaks = InvariantKind::keypad,
     .sabotage = {.greedy_navigation = true}},
    {.name = "SignalsThatDoNotGiveTheTerminalBack",
     .breaks = InvariantKind::terminal_wait,
     .sabotage = {.hogging_signals = true},
     .length = 150min},
    {.name = "FlashersThatAreNotWired",
     .breaks = InvariantKind::blue_light,
     .sabotage = {.cuts_flashers = true},
     .beside = restart_of(inputs_id)},
    {.name = "ASirenThatIsNotWired",
     .breaks = InvariantKind::siren,
     .sabotage = {.cuts_siren = true}},
    {.name = "AHandsetWithASlowContact",
     .breaks = InvariantKind::speech,
     .sabotage = {.slow_handset = true}},
    {.name = "ATransmitterThatDoesNotStop",
     .breaks = InvariantKind::carrier,
     .sabotage = {.sticking_relay = true}},
    {.name = "ADisplayThatShowsNothing",
     .breaks = InvariantKind::display,
     .sabotage = {.cuts_display = true},
     .beside = restart_of(navigation_id)},
    {.name = "LocksThatDoNotMove",
     .breaks = InvariantKind::locks,
     .sabotage = {.cuts_locks = true}},
    {.name = "ASupplyThatDoesNotOpen",
     .breaks = InvariantKind::power,
     .sabotage = {.welded_supply = true}},
    {.name = "ADeviceThatDoesNotSleep",
     .breaks = InvariantKind::silence,
     .sabotage = {.speaks_asleep = true},
     .beside = burnt_lamp},
    {.name = "ACrewThatDoesNotAnswer",
     .breaks = InvariantKind::calls,
     .sabotage = {.sleepy_crew = true}},
    {.name = "ATerminalThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = terminal_id},
    {.name = "ABlueLightThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = blue_light_id},
    {.name = "ARadioThatIsAway", .breaks = InvariantKind::device_missing, .loses_power = radio_id},
    {.name = "AnAudioSwitchThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = audio_switch_id},
    {.name = "AHandsFreeThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = hands_free_id},
    {.name = "ASupplyThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = power_supply_id},
    {.name = "InputsThatAreAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = inputs_id},
    {.name = "ANavigationThatIsAway",
     .breaks = InvariantKind::device_missing,
     .loses_power = navigation_id},
    {.name = "ADarkBlueLight",
     .breaks = InvariantKind::blue_light,
     .loses_power = blue_light_id,
     .beside = restart_of(inputs_id)},
    {.name = "ASilentSiren", .breaks = InvariantKind::siren, .loses_power = roof_sound_id},
    {.name = "ADeadTerminal", .breaks = InvariantKind::terminal_wait, .loses_power = terminal_id},
    {.name = "AHandsetThatNobodyHears", .breaks = InvariantKind::speech, .loses_power = inputs_id},
    {.name = "ARadioWithoutPower", .breaks = InvariantKind::power, .loses_power = power_supply_id},
    {.name = "ACallThatCannotBeReported", .breaks = InvariantKind::calls, .loses_power = inputs_id},
    {.name = "AnEchoOfTheTerminal", .breaks = InvariantKind::keypad, .echoed = terminal_id},
    {.name = "AnEchoOfTheHandset", .breaks = InvariantKind::carrier, .echoed = inputs_id},
};

class EachPoliceSabotage : public testing::TestWithParam<Case> {};

PoliceOptions options_of(const Case& it, bool has_fault) {
  PoliceOptions options;
  options.faults.seed = 1;
  options.length = it.length;
  options.sabotage = it.sabotage;
  for (Time start(1min); has_fault && start < Time(it.length); start += 45s) {
    ScheduledFault fault = it.beside;
    fault.start = start;
    if (lasts(fault.kind)) fault.duration = 40s;
    options.faults.faults.push_back(fault);
  }
  return options;
}

/// What is broken when what is to be broken is, or at the end.
std::string found(const Case& it, bool has_fault) {
  PoliceNetwork network(options_of(it, has_fault));
  std::optional<Echo> echo;
  if (it.echoed != 0) echo.emplace(network, it.echoed, 8s);
  if (it.loses_power != 0) {
    network.run_until(on_its_way);
    network.node(it.loses_power).power(false);
  }
  const std::string name = std::string(invariant_name(it.breaks).name) + " ";
  std::string names;
  while (names.find(name) == std::string::npos && network.now() < Time(it.length)) {
    network.run_until(network.now() + 1s);
    names = broken_names(network);
  }
  return names;
}

TEST_P(EachPoliceSabotage, IsFoundAlone) {
  const std::string name = std::string(invariant_name(GetParam().breaks).name) + " ";
  EXPECT_NE((" " + found(GetParam(), false)).find(" " + name), std::string::npos);
}

TEST_P(EachPoliceSabotage, IsFoundBesideAFaultElsewhere) {
  ASSERT_FALSE(can_cause(GetParam().beside, GetParam().breaks) &&
               GetParam().breaks != InvariantKind::device_missing);
  const std::string name = std::string(invariant_name(GetParam().breaks).name) + " ";
  EXPECT_NE((" " + found(GetParam(), true)).find(" " + name), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Each, EachPoliceSabotage, testing::ValuesIn(cases),
                         [](const auto& it) { return std::string(it.param.name); });

/// Without a sabotage all holds, and all is judged that an hour and a half has.
TEST(PoliceSabotages, TheFaultsBesideThemBreakNothing) {
  for (const NodeId node : {roof_light_id, inputs_id, navigation_id}) {
    const Case none{.name = "none", .breaks = InvariantKind::calls, .beside = restart_of(node)};
    PoliceNetwork network(options_of(none, true));
    network.run_until(Time(patrol));
    EXPECT_EQ(broken_names(network), "") << "restarts of node " << unsigned{node};
  }
}

}  // namespace
}  // namespace canvoy::police::police_sabotage_test
