// The armrest of an excavator, on the bus behind its seat: the traffic on both buses, and the
// machine without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_armrest_test {
namespace {

bool is_released(ExcavatorNetwork& network) {
  return network.machine().has_pilot_pressure();
}

TEST(ExcavatorArmrest, OneThatVanishesStopsTheMachineAndTheSeatSaysSo) {
  for (const Movement movement : {Movement::slew, Movement::boom, Movement::stick}) {
    ExcavatorNetwork network({.length = 10min});
    run_until_moving(network, movement);
    network.node(armrest_id).power(false);
    EXPECT_LE(time_to_rest(network), Duration(900ms));
    network.run_until(network.now() + 600ms);
    EXPECT_FALSE(is_released(network));
    EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::fault));
    EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::locked));
  }
}

TEST(ExcavatorArmrest, OneThatComesBackReleasesNothingOfItself) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::boom);
  network.node(armrest_id).power(false);
  network.run_until(network.now() + 1s);
  const unsigned presses = network.driver().presses();
  network.node(armrest_id).power(true);
  while (network.driver().presses() == presses) {
    ASSERT_FALSE(is_released(network));
    ASSERT_LT(network.now(), Time(10min));
    network.run_until(network.now() + 1ms);
  }
  network.run_until(network.now() + 1s);
  EXPECT_FALSE(is_lit(network.panel().lit(), Lamp::fault));
  EXPECT_TRUE(is_released(network));
}

TEST(ExcavatorArmrest, ALeverThatIsRaisedStopsTheMachine) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::slew);
  network.panel().set_lever(false);
  // It reports a motion of a hand, and is read each 100 ms.
  EXPECT_LE(time_to_rest(network), Duration(600ms));
  EXPECT_FALSE(is_released(network));
  EXPECT_FALSE(is_lit(network.panel().lit(), Lamp::fault)) << "nothing is wrong";
  network.run_until(network.now() + 5s);
  EXPECT_FALSE(is_released(network)) << "whoever presses: the lever is up";
}

/// A stick that is held while the lever goes up and down has to rest before it moves the machine.
TEST(ExcavatorArmrest, AStickThatIsHeldWhileTheLeverIsRaisedMovesNothingBeforeItHasRested) {
  ExcavatorOptions options{.length = 1min};
  options.shift.recorded = {{Time(1s), HandInput::lever, 1},    {Time(8s), HandInput::lock, 0.2},
                            {Time(9s), HandInput::throttle, 1}, {Time(11s), HandInput::left_x, 1},
                            {Time(14s), HandInput::lever, 0},   {Time(17s), HandInput::lever, 1},
                            {Time(20s), HandInput::lock, 0.2},  {Time(24s), HandInput::left_x, 0},
                            {Time(25s), HandInput::left_x, 1}};
  ExcavatorNetwork network(options);
  const auto speed = [&](Duration at) {
    network.run_until(Time(at));
    return network.machine().speed(Movement::slew);
  };
  EXPECT_GT(speed(13900ms), 0);
  EXPECT_EQ(speed(16900ms), 0);
  EXPECT_FALSE(is_released(network));
  EXPECT_EQ(speed(22s), 0);
  EXPECT_TRUE(is_released(network)) << "unlocked";
  EXPECT_EQ(speed(23900ms), 0);
  EXPECT_GT(speed(27s), 0);
}

/// Each stops the machine within the time for a hand, and does not release it by itself.
TEST(ExcavatorArmrest, EmergencyStopAndSeatSwitchStopTheMachine) {
  for (const FaultKind kind : {FaultKind::emergency_stop, FaultKind::seat_switch}) {
    ExcavatorNetwork dry({.length = 10min});
    run_until_moving(dry, Movement::slew);
    const Time begin = dry.now();
    ExcavatorOptions options{.length = 10min};
    options.faults.faults = {{.kind = kind, .start = begin, .duration = 30s}};
    ExcavatorNetwork network(options);
    network.run_until(begin);
    EXPECT_LE(time_to_rest(network), Duration(600ms)) << fault_name(kind);
    EXPECT_FALSE(is_released(network));
    EXPECT_TRUE(is_lit(network.panel().lit(), Lamp::locked));
    network.run_until(begin + 30s);
    EXPECT_FALSE(is_released(network)) << "whoever presses";
    const unsigned presses = network.driver().presses();
    while (network.driver().presses() == presses) {
      ASSERT_FALSE(is_released(network)) << "it is locked until the button unlocks it";
      ASSERT_LT(network.now(), Time(10min));
      network.run_until(network.now() + 1ms);
    }
    network.run_until(Time(10min));
    EXPECT_EQ(broken(network), Names()) << fault_name(kind);
  }
}

/// SDO frames from or to the seat (60Ah, 58Ah) and the armrest (607h, 587h).
struct SdoFrames {
  explicit SdoFrames(ExcavatorNetwork& network) {
    for (const BusIndex bus : {BusIndex{0}, BusIndex{1}}) {
      network.world().bus(bus).observe(
          {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
             if (frame.id != 0x60A && frame.id != 0x58A && frame.id != 0x607 && frame.id != 0x587)
               return;
             static_cast<SdoFrames*>(self)->seen.push_back(wire_text(frame));
           }});
    }
  }
  std::vector<std::string> seen;
};

TEST(ExcavatorArmrest, IsReadThroughTheSeatByteForByte) {
  ExcavatorNetwork network({.length = 10min});
  run_until_moving(network, Movement::slew);
  SdoFrames frames(network);
  network.run_until(network.now() + 100ms);
  // canopen/remote/remote_access.hpp, and CiA 301, 7.2.4.3: 6000h:01h, one byte: lever, seat switch
  // and stop are closed.
  const std::vector<std::string> expected = {
      "60A#E0 02 00 07 00 00 00 00", "58A#E0 02 00 07 00 00 00 00", "60A#40 00 60 01 00 00 00 00",
      "607#40 00 60 01 00 00 00 00", "587#4F 00 60 01 07 00 00 00", "58A#4F 00 60 01 07 00 00 00"};
  EXPECT_EQ(frames.seen, expected);
}

TEST(ExcavatorArmrest, ASeatWithoutOneIsNotAskedForIt) {
  ExcavatorNetwork network({.length = 10min, .has_armrest = false});
  SdoFrames frames(network);
  network.run_until(Time(10min));
  EXPECT_EQ(broken(network), Names());
  EXPECT_GT(network.machine().earth().heaped, 10);
  EXPECT_TRUE(std::ranges::none_of(
      frames.seen, [](const std::string& frame) { return frame.starts_with("60A#E0"); }));
  EXPECT_TRUE(std::ranges::none_of(network.invariants(), [](const Invariant& each) {
    return each.kind == InvariantKind::lost_armrest;
  }));
}

}  // namespace
}  // namespace canvoy::excavator::excavator_armrest_test
