#include "canvoy/worlds/charger/service_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::charger::service_watch_test {
namespace {

class ServiceWatchTest : public testing::Test {
 protected:
  void run_for(Duration duration, bool asks, double ampere) {
    for (const Time end = now + duration; now < end;) {
      now += 100ms;
      sut.on_step(now, asks ? 60 : 0, ampere);
    }
  }

  ServiceWatch sut{60};
  Time now{};
};

TEST_F(ServiceWatchTest, ABatteryThatIsChargedDoesNotWait) {
  run_for(1h, true, 60);
  EXPECT_EQ(sut.waiting_max(), 0s);
}

TEST_F(ServiceWatchTest, ABatteryThatDoesNotAskDoesNotWait) {
  run_for(1h, false, 0);
  EXPECT_EQ(sut.waiting_max(), 0s);
}

TEST_F(ServiceWatchTest, TheLongestTimeWithoutCurrentCounts) {
  run_for(7s, true, 0);
  run_for(1s, true, 60);
  run_for(5s, true, 0.001);
  EXPECT_EQ(sut.waiting_max(), 7s);
}

TEST_F(ServiceWatchTest, AFaultExcusesUntilTheLastOneIsMended) {
  sut.fault_began(now, FaultKind::too_hot);
  run_for(60s, true, 0);
  sut.fault_began(now, FaultKind::pdo_loss);
  sut.fault_ended(now, FaultKind::too_hot);
  run_for(60s, true, 0);
  EXPECT_EQ(sut.waiting_max(), 0s);
  sut.fault_ended(now, FaultKind::pdo_loss);
  run_for(3s, true, 0);
  EXPECT_EQ(sut.waiting_max(), 3s);
}

TEST_F(ServiceWatchTest, ARestartExcusesFromItsStartAndNotForEver) {
  run_for(2s, true, 0);
  sut.fault_began(now, FaultKind::battery_restart);
  run_for(4s, true, 0);
  EXPECT_EQ(sut.waiting_max(), 4s);
}

TEST_F(ServiceWatchTest, FramesThatAreSentAgainExcuseFromTheirStartAndNotForEver) {
  run_for(2s, true, 0);
  sut.fault_began(now, FaultKind::corrupted_frames);
  run_for(20s, true, 0);
  EXPECT_EQ(sut.waiting_max(), 20s);
}

TEST_F(ServiceWatchTest, WhatIsGivenLessThanAskedForIsMissing) {
  run_for(15s, true, 0);  // allowed time after the start
  run_for(30min, true, 60);
  run_for(10min, true, 45);
  EXPECT_EQ(sut.waiting_max(), 15s);
  EXPECT_NEAR(sut.missing_percent(), 100 * 15.0 * 10 / (60 * 40), 0.01);
}

TEST_F(ServiceWatchTest, WhatTheChargerCannotGiveIsNotMissing) {
  sut = ServiceWatch(40);
  run_for(1h, true, 40);
  EXPECT_EQ(sut.missing_percent(), 0);
  EXPECT_GT(sut.measured(), 0U);
}

TEST_F(ServiceWatchTest, NothingIsMeasuredUntilAFaultIsLongOver) {
  run_for(20s, true, 60);
  const auto before = sut.measured();
  sut.fault_began(now, FaultKind::pdo_loss);
  run_for(1min, true, 0);
  sut.fault_ended(now, FaultKind::pdo_loss);
  run_for(15s, true, 0);
  EXPECT_EQ(sut.measured(), before);
  EXPECT_EQ(sut.missing_percent(), 0);
}

}  // namespace
}  // namespace canvoy::charger::service_watch_test
