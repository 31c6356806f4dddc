// The radio at the wire (CiA 447-3, 4.2.18). PDO 83 (39Ch of node 5) is radio status and radio
// device status; PDO 84 of node 10 (23Dh) is the power supply.
#include "canvoy/devices/cia447/radio/radio_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::radio_unit_test {
namespace {

class Radio : public testing::Test {
 protected:
  std::string command(const std::string& byte) {
    return bench.ask("2F 16 61 00 " + byte + " 00 00 00");
  }
  void turn_on() {
    command("FD");
    cable.run_for(1s);
  }

  RadioUnit* unit_ = nullptr;
  CarBench bench{only_unit<RadioKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
  Cable& cable = bench.cable;
};

TEST_F(Radio, ItIsOffAtFirst) {
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F0");
}

TEST_F(Radio, ItIsOnASecondAfterItWasToldTo) {
  EXPECT_EQ(command("FD"), "60 16 61 00 00 00 00 00");
  cable.run_for(999ms);
  EXPECT_EQ(cable.count(0x39C), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F1");
  command("FC");
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F0");
}

TEST_F(Radio, PushToTalkTransmitsWhileItIsOn) {
  command("F7");
  cable.run_for(1s);
  EXPECT_EQ(bench.ask("40 17 61 00 00 00 00 00"), "4F 17 61 00 F0 00 00 00") << "it is off";
  turn_on();
  command("F7");
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F5");
  command("F3");
  cable.run_for(50ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F1");
}

TEST_F(Radio, WhatIsTurnedOffDoesNotTransmit) {
  turn_on();
  command("F7");
  cable.run_for(50ms);
  command("FC");
  cable.run_for(100ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F0");
}

TEST_F(Radio, WithoutPowerItIsOffAndSaysSo) {
  turn_on();
  command("F7");
  cable.run_for(50ms);
  cable.send("23D#00 01");
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x39C), "39C#F4 F0");
  cable.send("23D#01 01");
  cable.run_for(999ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F0");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F1") << "it was on before, but nobody talks";
}

TEST_F(Radio, WhatWasTurnedOffMeanwhileStaysOff) {
  turn_on();
  cable.send("23D#00 01");
  command("FC");
  cable.send("23D#01 01");
  cable.run_for(5s);
  EXPECT_EQ(bench.ask("40 17 61 00 00 00 00 00"), "4F 17 61 00 F0 00 00 00");
}

TEST_F(Radio, APowerSupplyThatFallsSilentSaysNothingOfThePower) {
  cable.send("23D#00 01");
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x39C), "39C#F4 F0");
  cable.run_for(3s);
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F0");
  turn_on();
  EXPECT_EQ(cable.last(0x39C), "39C#F0 F1");
}

/// Requests of node 5 to node 10 are on 349h, answers on 2C9h (facts 2.2).
TEST_F(Radio, APowerSupplyThatIsHeardAgainIsAskedForThePower) {
  cable.send("23D#00 01");
  cable.run_for(3s);
  ASSERT_EQ(cable.last(0x39C), "39C#F0 F0");
  cable.send("70A#05");
  EXPECT_EQ(cable.last(0x349), "349#40 70 60 00 00 00 00 00");
  cable.send("2C9#4F 70 60 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x349), "349#40 73 60 00 00 00 00 00");
  cable.send("2C9#80 73 60 00 00 00 02 06");
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x39C), "39C#F4 F0") << "power off detected";
}

TEST_F(Radio, AnErrorIsTold) {
  unit_->switching().report(radio_status_error_1, Signal::yes);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x39C), "39C#F1 F0");
  unit_->switching().sense(radio_device_status_power, Sensing::failure);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x39C), "39C#F1 F2");
}

TEST_F(Radio, ReservedCodesAreRefused) {
  EXPECT_EQ(command("FE"), "80 16 61 00 30 00 09 06");
  EXPECT_EQ(command("FB"), "80 16 61 00 30 00 09 06");
}

}  // namespace
}  // namespace canvoy::cia447::radio_unit_test
