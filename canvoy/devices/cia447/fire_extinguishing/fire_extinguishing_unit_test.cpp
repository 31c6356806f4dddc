// The fire extinguishing system at the wire (CiA 447-3, 4.2.5). PDO 69 is 38Eh of node 5.
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::fire_extinguishing_unit_test {
namespace {

class FireExtinguishingTest : public testing::Test {
 protected:
  std::string after(FireExtinguishing state) {
    unit_->switching().report(fire_extinguishing_system_status, state);
    bench.cable.run_for(0s);
    return bench.cable.last(0x38E);
  }

  FireExtinguishingUnit* unit_ = nullptr;
  CarBench bench{only_unit<FireExtinguishingKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
};

TEST_F(FireExtinguishingTest, ItIsInStandbyWhenItHasLookedAtItself) {
  EXPECT_EQ(bench.cable.last(0x38E), "38E#F3") << "initialization";
  bench.cable.run_for(2999ms);
  EXPECT_EQ(bench.cable.last(0x38E), "38E#F3");
  bench.cable.run_for(1ms);
  EXPECT_EQ(bench.cable.last(0x38E), "38E#F1");
}

TEST_F(FireExtinguishingTest, WhatItDoesIsTold) {
  bench.cable.run_for(3s);
  EXPECT_EQ(after(FireExtinguishing::automatic_started), "38E#F4");
  EXPECT_EQ(after(FireExtinguishing::standby_limited), "38E#F2");
  EXPECT_EQ(after(FireExtinguishing::deactivated), "38E#F0");
}

TEST_F(FireExtinguishingTest, WhoReportsDuringInitializationEndsIt) {
  bench.cable.run_for(1s);
  EXPECT_EQ(after(FireExtinguishing::automatic_started), "38E#F4");
  bench.cable.run_for(10s);
  EXPECT_EQ(bench.cable.last(0x38E), "38E#F4");
}

TEST_F(FireExtinguishingTest, AFailureIsTold) {
  bench.cable.run_for(3s);
  unit_->switching().sense(Sensing::failure);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38E), "38E#FE");
  unit_->switching().sense(Sensing::not_available);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x38E), "38E#FF");
}

TEST_F(FireExtinguishingTest, AnNmtResetInitializesNothing) {
  bench.cable.run_for(3s);
  bench.cable.send("000#81 05");
  bench.cable.clear();
  bench.cable.send("000#01 05");
  EXPECT_EQ(bench.cable.last(0x38E), "38E#F1");
}

TEST_F(FireExtinguishingTest, ItTakesNoCommands) {
  EXPECT_EQ(bench.ask("2F 69 60 00 00 00 00 00"), "80 69 60 00 02 00 01 06");
}

}  // namespace
}  // namespace canvoy::cia447::fire_extinguishing_unit_test
