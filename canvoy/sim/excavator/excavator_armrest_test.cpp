// The armrest of an excavator, on the bus behind its seat: what is on both wires, and what the
// machine does without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/sim/excavator/excavator_network_test.hpp"

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
  // It is told when a hand moves, and asked for each 100 ms.
  EXPECT_LE(time_to_rest(network), Duration(600ms));
  EXPECT_FALSE(is_released(network));
  EXPECT_FALSE(is_lit(network.panel().lit(), Lamp::fault)) << "nothing is wrong";
  network.run_until(network.now() + 5s);
  EXPECT_FALSE(is_released(network)) << "whoever presses: the lever is up";
}

/// Frames of SDO from or to the seat (60Ah, 58Ah) and the armrest (607h, 587h).
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
  // canopen/remote/remote_access.hpp, and CiA 301, 7.2.4.3: 6000h:01h, one byte, bit 0.
  const std::vector<std::string> expected = {
      "60A#E0 02 00 07 00 00 00 00", "58A#E0 02 00 07 00 00 00 00", "60A#40 00 60 01 00 00 00 00",
      "607#40 00 60 01 00 00 00 00", "587#4F 00 60 01 01 00 00 00", "58A#4F 00 60 01 01 00 00 00"};
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
  EXPECT_FALSE(find(network.invariants(), InvariantKind::lost_armrest).is_decided());
}

}  // namespace
}  // namespace canvoy::excavator::excavator_armrest_test
