// Sleep and wake-up of a device at its wire (facts 2.4): it has node-ID 5, and speaks on 695h.
#include "canvoy/devices/cia447/kit/car_sleep.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::car_sleep_test {
namespace {

class Sleeper : public testing::Test {
 protected:
  void query() { bench.cable.send("691#01 00 00 00 00 00 00 00"); }
  void order_sleep() { bench.cable.send("691#02 00 00 00 00 00 00 00"); }

  CarBench bench{only_unit<BlueLightKind>};
};

TEST_F(Sleeper, ItConsentsBySilenceAndObjectsWithAReason) {
  bench.cable.clear();
  query();
  EXPECT_EQ(bench.cable.count(0x695), 0u);
  bench.device().sleep().object(0x07);
  query();
  EXPECT_EQ(bench.cable.last(0x695), "695#81 07 00 00 00 00 00 00");
  bench.device().sleep().object(std::nullopt);
  bench.cable.clear();
  query();
  EXPECT_EQ(bench.cable.count(0x695), 0u);
}

TEST_F(Sleeper, ItFallsSilentASecondAfterTheOrderAndNothingMakesItSend) {
  order_sleep();
  bench.cable.run_for(999ms);
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 BF 01 00 00") << "still awake";
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.device().sleep().state(), SleepState::asleep);
  bench.cable.clear();
  bench.cable.send("605#40 00 10 00 00 00 00 00");
  bench.cable.send("000#01 05");
  bench.cable.send("000#81 05");
  query();
  bench.cable.run_for(1h);
  EXPECT_EQ(bench.cable.count(0x585), 0u);
  EXPECT_EQ(bench.cable.count(0x705), 0u) << "no heartbeat, and no boot-up message";
  EXPECT_EQ(bench.cable.count(0x38B), 0u);
}

TEST_F(Sleeper, ThatPreparesItselfWakesTheOthersTwice) {
  order_sleep();
  bench.cable.run_for(500ms);
  bench.cable.clear();
  bench.device().sleep().wake_up();
  bench.cable.run_for(1h);
  EXPECT_EQ(bench.cable.count(0x695), 2u);
  EXPECT_EQ(bench.device().sleep().state(), SleepState::awake);
}

TEST_F(Sleeper, AnyNodeWakesItUpAndItBootsAnew) {
  order_sleep();
  bench.cable.run_for(2s);
  bench.cable.clear();
  bench.cable.send("690#82 00 00 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x705), "705#00");
  EXPECT_EQ(bench.device().sleep().state(), SleepState::awake);
  bench.cable.send("000#01 05");
  EXPECT_EQ(bench.cable.last(0x38B), "38B#00 00 F0 FF") << "what it is, it tells anew";
}

TEST_F(Sleeper, AWakeUpWhileItPreparesItselfKeepsItAwake) {
  order_sleep();
  bench.cable.run_for(500ms);
  bench.cable.send("693#82 00 00 00 00 00 00 00");
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.device().sleep().state(), SleepState::awake);
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 BF 01 00 00");
}

TEST_F(Sleeper, OnlyTheGatewayOrdersSleepAndOnlyFramesOf8BytesCount) {
  bench.cable.send("693#02 00 00 00 00 00 00 00");
  bench.cable.send("691#02");
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.device().sleep().state(), SleepState::awake);
  EXPECT_EQ(bench.node().counters().malformed, 1u);
}

TEST_F(Sleeper, ItWakesTheOthersTwice) {
  order_sleep();
  bench.cable.run_for(2s);
  bench.cable.clear();
  bench.device().sleep().wake_up();
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x695), "695#82 FE 00 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x705), "705#00");
  bench.cable.run_for(499ms);
  EXPECT_EQ(bench.cable.count(0x695), 1u);
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.cable.count(0x695), 2u);
  bench.cable.run_for(1h);
  EXPECT_EQ(bench.cable.count(0x695), 2u);
}

}  // namespace
}  // namespace canvoy::cia447::car_sleep_test
