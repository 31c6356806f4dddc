// The power supply at the wire (CiA 447-3, 4.2.7): on, after-run, five minutes before the end,
// overload, two bits each. PDO 84 (39Dh of node 5) is radio and periphery; PDO 1 of the gateway
// (180h) is the ignition.
#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::power_supply_unit_test {
namespace {

class PowerSupply : public testing::Test {
 protected:
  void ignition(bool is_on) {
    cable.send(is_on ? "180#11" : "180#01");
    cable.run_for(0s);
  }
  std::string status() { return cable.last(0x39D); }
  PowerSupplyHardware hardware() {
    return {.switch_power = callback<&PowerSupply::switched>(*this)};
  }
  void switched(Supply supply, bool is_on) {
    told += supply == Supply::radio ? 'r' : 'p';
    told += is_on ? '+' : '-';
  }

  std::string told;
  PowerSupplyUnit* unit_ = nullptr;
  CarBench bench{only_unit<PowerSupplyKind>, [this](Environment& environment) {
                   environment.watch(unit_);
                   environment.provide(callback<&PowerSupply::hardware>(*this));
                 }};
  Cable& cable = bench.cable;
};

TEST_F(PowerSupply, ThereIsNoPowerBeforeTheIgnition) {
  EXPECT_EQ(status(), "39D#00 00");
  ignition(false);
  cable.run_for(1h);
  EXPECT_EQ(status(), "39D#00 00");
  EXPECT_EQ(told, "");
}

TEST_F(PowerSupply, ThereIsPowerWhileTheIgnitionOrTheAccessoryIsOn) {
  ignition(true);
  EXPECT_EQ(status(), "39D#01 01");
  EXPECT_EQ(told, "r+p+");
  cable.send("180#05");  // accessory only
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 01");
}

/// Requests of node 5 to node 1 are on 340h, answers on 2C0h (facts 2.2); 6007h has one byte.
TEST_F(PowerSupply, AnIgnitionThatWasOnBeforeItBootedIsAskedFor) {
  cable.run_for(500ms);
  EXPECT_EQ(cable.last(0x340), "340#40 07 60 00 00 00 00 00");
  cable.send("2C0#4F 07 60 00 11 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 01");
  EXPECT_EQ(told, "r+p+");
}

TEST_F(PowerSupply, AGatewayThatWasAskedAndFallsSilentLeavesTheAfterRun) {
  cable.run_for(500ms);
  cable.send("2C0#4F 07 60 00 11 00 00 00");
  cable.run_for(2900ms);
  EXPECT_EQ(status(), "39D#01 01");
  cable.run_for(200ms);
  EXPECT_EQ(status(), "39D#05 05") << "it is not heard for three seconds";
}

TEST_F(PowerSupply, AGatewayThatComesBackIsAskedAnew) {
  ignition(true);
  cable.run_for(3100ms);
  EXPECT_EQ(status(), "39D#05 05");
  cable.clear();
  cable.run_for(7400ms);  // ten seconds after the first time
  EXPECT_EQ(cable.last(0x340), "340#40 07 60 00 00 00 00 00");
  cable.send("2C0#4F 07 60 00 11 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 01");
}

TEST_F(PowerSupply, PowerRunsAfterTheIgnitionAndIsCutOffWithAWarning) {
  ignition(true);
  ignition(false);
  EXPECT_EQ(status(), "39D#05 05");
  cable.run_for(10min - 1ms);
  EXPECT_EQ(status(), "39D#05 05");
  cable.run_for(1ms);
  EXPECT_EQ(status(), "39D#05 15") << "the periphery has 15 minutes";
  cable.run_for(5min);
  EXPECT_EQ(status(), "39D#05 00");
  EXPECT_EQ(told, "r+p+p-");
  cable.run_for(10min);
  EXPECT_EQ(status(), "39D#15 00") << "the radio has 30 minutes";
  cable.run_for(5min - 1ms);
  EXPECT_EQ(status(), "39D#15 00");
  cable.run_for(1ms);
  EXPECT_EQ(status(), "39D#00 00");
  EXPECT_EQ(told, "r+p+p-r-");
}

TEST_F(PowerSupply, TheIgnitionEndsTheAfterRun) {
  ignition(true);
  ignition(false);
  cable.run_for(12min);
  ignition(true);
  EXPECT_EQ(status(), "39D#01 01");
  ignition(false);
  cable.run_for(10min);
  EXPECT_EQ(status(), "39D#05 15") << "the time begins anew";
}

TEST_F(PowerSupply, ARequestCutsThePowerAtOnce) {
  ignition(true);
  EXPECT_EQ(bench.ask("2F 71 60 00 FD 00 00 00"), "60 71 60 00 00 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#00 01");
  bench.ask("2F 71 60 00 FF 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(unit_->has_power(Supply::radio), false) << "don't care";
  bench.ask("2F 71 60 00 FC 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 01");
  bench.ask("2F 74 60 00 FD 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 00");
  EXPECT_EQ(bench.ask("2F 74 60 00 FE 00 00 00"), "80 74 60 00 30 00 09 06");
}

TEST_F(PowerSupply, ARequestInTheAfterRunEndsIt) {
  ignition(true);
  ignition(false);
  bench.ask("2F 71 60 00 FD 00 00 00");
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#00 05");
  bench.ask("2F 71 60 00 FC 00 00 00");
  EXPECT_FALSE(unit_->has_power(Supply::radio)) << "the ignition is off";
  ignition(true);
  EXPECT_EQ(status(), "39D#01 01");
}

TEST_F(PowerSupply, TheIgnitionTakesARequestBack) {
  ignition(true);
  bench.ask("2F 71 60 00 FD 00 00 00");
  ignition(false);
  EXPECT_EQ(status(), "39D#00 05");
  ignition(true);
  EXPECT_EQ(status(), "39D#01 01");
}

TEST_F(PowerSupply, AnOverloadTakesThePowerAwayWhileItLasts) {
  ignition(true);
  unit_->report_overload(Supply::periphery, true);
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 40");
  unit_->report_overload(Supply::periphery, false);
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#01 01");
  EXPECT_EQ(told, "r+p+p-p+");
}

TEST_F(PowerSupply, WithoutTheGatewayTheAfterRunBegins) {
  ignition(true);
  cable.run_for(2s);
  cable.send("701#05");
  cable.run_for(2999ms);
  EXPECT_EQ(status(), "39D#01 01");
  cable.run_for(1ms);
  EXPECT_EQ(status(), "39D#05 05");
  ignition(true);
  EXPECT_EQ(status(), "39D#01 01") << "it is back";
}

TEST_F(PowerSupply, AnIgnitionThatNobodyKnowsIsOff) {
  ignition(true);
  cable.send("180#3D");  // ignition on: signal not available
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#05 05");
}

TEST_F(PowerSupply, ABrokenSensorSaysSo) {
  unit_->switching().sense(radio_power_supply_status_overload, Sensing::failure);
  cable.run_for(0s);
  EXPECT_EQ(status(), "39D#80 00");
}

}  // namespace
}  // namespace canvoy::cia447::power_supply_unit_test
