// The emergency fresh-air system at the wire (CiA 447-3, 4.2.6). PDO 68 is 38Dh of node 5.
#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::emergency_fresh_air_unit_test {
namespace {

class FreshAirTest : public testing::Test {
 protected:
  std::string after(FreshAir state) {
    unit_->switching().report(emergency_fresh_air_system_status, state);
    bench.cable.run_for(0s);
    return bench.cable.last(0x38D);
  }

  EmergencyFreshAirUnit* unit_ = nullptr;
  CarBench bench{only_unit<EmergencyFreshAirKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
};

TEST_F(FreshAirTest, ItIsInStandbyWhenItHasLookedAtItself) {
  EXPECT_EQ(bench.cable.last(0x38D), "38D#F4") << "initialization";
  bench.cable.run_for(2999ms);
  EXPECT_EQ(bench.cable.last(0x38D), "38D#F4");
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.cable.last(0x38D), "38D#F1");
}

TEST_F(FreshAirTest, WhatItDoesIsTold) {
  bench.cable.run_for(3s);
  EXPECT_EQ(after(FreshAir::automatic_activated), "38D#F7");
  EXPECT_EQ(after(FreshAir::standby_limited), "38D#F2");
  EXPECT_EQ(after(FreshAir::deactivated), "38D#F0");
}

TEST_F(FreshAirTest, WhoReportsDuringInitializationEndsIt) {
  bench.cable.run_for(1s);
  EXPECT_EQ(after(FreshAir::automatic_activated), "38D#F7");
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.cable.last(0x38D), "38D#F7");
}

TEST_F(FreshAirTest, AFailureIsTold) {
  bench.cable.run_for(3s);
  unit_->switching().sense(Sensing::failure);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38D), "38D#FE");
  unit_->switching().sense(Sensing::not_available);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38D), "38D#FF");
}

TEST_F(FreshAirTest, AnNmtResetInitializesNothing) {
  bench.cable.run_for(3s);
  bench.cable.send("000#81 05");
  bench.cable.clear();
  bench.cable.send("000#01 05");
  EXPECT_EQ(bench.cable.last(0x38D), "38D#F1");
}

TEST_F(FreshAirTest, ItTakesNoCommands) {
  EXPECT_EQ(bench.ask("2F 6C 60 00 00 00 00 00"), "80 6C 60 00 02 00 01 06");
}

}  // namespace
}  // namespace canvoy::cia447::emergency_fresh_air_unit_test
