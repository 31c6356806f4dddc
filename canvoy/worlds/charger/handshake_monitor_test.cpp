#include "canvoy/worlds/charger/handshake_monitor.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::charger::handshake_monitor_test {
namespace {

/// Battery 10 (0Ah) and charger 5, with the default COB-IDs of CiA 418.
class HandshakeMonitorTest : public testing::Test {
 protected:
  void hear(std::string_view frame) { sut.on_frame(now, wire_frame(frame)); }
  void step(double ampere) {
    now += 100ms;
    sut.on_step(now, pilot_signal, ampere);
  }
  /// All conditions are met from `now` on.
  void agree() {
    sut.on_step(now, pilot_signal, 0);
    hear("70A#05");
    hear("705#05");
    hear("28A#A0 00 01 00 C8 00 00");
    hear("38A#C0 03 14");
    hear("20A#01");
  }
  /// Current flows, while the required frames come.
  void charge(int steps) {
    for (int i = 0; i < steps; ++i) {
      agree();
      step(60);
    }
  }

  HandshakeMonitor sut{{.charger = 5,
                        .battery = 10,
                        .battery_tpdos = {0x18A, 0x28A, 0x38A},
                        .charger_tpdos = {0x20A, 0x30A, 0x40A},
                        .heartbeat_time = 2s,
                        .data_time = 600ms}};
  Time now{1s};
  bool pilot_signal = true;
};

TEST_F(HandshakeMonitorTest, CurrentInsideOfAHandshakeIsInOrder) {
  charge(100);
  EXPECT_TRUE(sut.is_valid(now));
  EXPECT_EQ(sut.outside_max(), 0s);
}

TEST_F(HandshakeMonitorTest, WithoutCurrentNothingIsOutside) {
  for (int i = 0; i < 100; ++i) step(0);
  EXPECT_FALSE(sut.is_valid(now));
  EXPECT_EQ(sut.outside_max(), 0s);
}

TEST_F(HandshakeMonitorTest, CurrentWithoutAnyHandshakeIsOutsideFromTheStart) {
  step(1);
  EXPECT_EQ(sut.outside_max(), 1100ms);
}

TEST_F(HandshakeMonitorTest, CurrentThatBeginsBeforeTheHandshakeIsOutsideUntilThen) {
  for (int i = 0; i < 20; ++i) step(0);
  step(5);
  step(10);
  charge(10);
  EXPECT_EQ(sut.outside_max(), 200ms);
}

TEST_F(HandshakeMonitorTest, CurrentThatBeginsInTheSameMomentAsReadyIsNotAfterIt) {
  hear("70A#05");
  hear("28A#A0 00 01 00 C8 00 00");
  hear("38A#C0 03 14");
  hear("20A#00");
  sut.on_set_point(60);
  hear("20A#01");
  EXPECT_EQ(sut.begun_before_ready(), 1U) << "the time between them does not matter";
  sut.on_set_point(30);
  sut.on_set_point(60);
  EXPECT_EQ(sut.begun_before_ready(), 1U) << "it flows already";
  sut.on_set_point(0);
  sut.on_set_point(60);
  EXPECT_EQ(sut.begun_before_ready(), 1U) << "it has been told now";
  sut.on_set_point(0);
  hear("20A#00");
  sut.on_set_point(1);
  EXPECT_EQ(sut.begun_before_ready(), 2U);
  sut.on_set_point(0);
  hear("20A#01");
  hear("705#7F");
  sut.on_set_point(1);
  EXPECT_EQ(sut.begun_before_ready(), 3U) << "what it said before it left operational is void";
}

TEST_F(HandshakeMonitorTest, EachLackAloneEndsTheHandshake) {
  for (const char* frame : {
           "28A#A0 00 00 00 C8 00 00",  // the battery is not ready (TPDO 2)
           "18A#A0 00 00",              // the same in TPDO 1
           "20A#00",                    // the charger is not ready (its TPDO 1)
           "30A#00 00 00",              // the same in TPDO 2
           "40A#00 00 00 64",           // and in TPDO 3
           "70A#7F",                    // the battery is pre-operational
           "70A#04",                    // or stopped
           "70A#00",                    // or has booted
           "705#7F",                    // so is the charger
           "000#80 00",                 // all nodes are commanded into pre-operational
           "000#02 0A",                 // the battery is stopped
           "000#81 05",                 // the charger is reset
           "000#82 0A",                 // the battery's communication is reset
       }) {
    sut = HandshakeMonitor({.charger = 5,
                            .battery = 10,
                            .battery_tpdos = {0x18A, 0x28A, 0x38A},
                            .charger_tpdos = {0x20A, 0x30A, 0x40A},
                            .heartbeat_time = 2s,
                            .data_time = 600ms});
    charge(3);
    ASSERT_TRUE(sut.is_valid(now)) << frame;
    hear(frame);
    EXPECT_FALSE(sut.is_valid(now)) << frame;
    step(60);
    step(60);
    EXPECT_EQ(sut.outside_max(), 200ms) << frame;
  }
}

TEST_F(HandshakeMonitorTest, WhatIsForOthersDoesNotEndTheHandshake) {
  charge(3);
  for (const char* frame : {"000#80 0B", "000#80", "000#80 0A 00", "70B#7F", "70A#7F 00", "20A#",
                            "28A#A0 00", "0000070A#7F", "70A#R1", "18B#A0 00 00"}) {
    hear(frame);
    EXPECT_TRUE(sut.is_valid(now)) << frame;
  }
}

TEST_F(HandshakeMonitorTest, AnNmtStartIsEnoughToBeOperational) {
  charge(1);
  hear("70A#7F");
  hear("705#7F");
  EXPECT_FALSE(sut.is_valid(now));
  hear("000#01 00");
  EXPECT_TRUE(sut.is_valid(now));
}

TEST_F(HandshakeMonitorTest, APdoProvesThatItsSenderIsOperational) {
  charge(1);
  hear("70A#7F");
  hear("38A#C0 03 14");
  EXPECT_TRUE(sut.is_valid(now));
  hear("705#7F");
  hear("20A#01");
  EXPECT_TRUE(sut.is_valid(now));
}

TEST_F(HandshakeMonitorTest, SilenceOfTheHeartbeatEndsTheHandshakeWhenItsTimeIsOver) {
  charge(1);
  const Time last = now - 100ms;
  while (now < last + 3s) {
    hear("28A#A0 00 01 00 C8 00 00");
    hear("38A#C0 03 14");
    step(60);
  }
  EXPECT_EQ(sut.outside_max(), 1s) << "three seconds after the last heartbeat, two are allowed";
}

TEST_F(HandshakeMonitorTest, SilenceOfProcessDataEndsTheHandshakeWhenItsTimeIsOver) {
  for (const char* renewed : {"28A#A0 00 01 00 C8 00 00", "38A#C0 03 14"}) {
    charge(1);
    const Duration before = sut.outside_max();
    const Time last = now - 100ms;
    while (now < last + 900ms) {
      hear("70A#05");
      hear(renewed);
      step(60);
    }
    EXPECT_EQ(sut.outside_max(), 300ms) << renewed << ", before " << before.count();
  }
}

TEST_F(HandshakeMonitorTest, WithoutThePilotSignalThereIsNoHandshake) {
  charge(2);
  pilot_signal = false;
  step(60);
  EXPECT_FALSE(sut.is_valid(now));
  step(60);
  EXPECT_EQ(sut.outside_max(), 100ms) << "the signal is looked at with each step";
}

TEST_F(HandshakeMonitorTest, TheLongestTimeIsKept) {
  charge(2);
  hear("20A#00");
  for (int i = 0; i < 4; ++i) step(60);
  charge(5);
  hear("20A#00");
  step(60);
  EXPECT_EQ(sut.outside_max(), 400ms);
}

}  // namespace
}  // namespace canvoy::charger::handshake_monitor_test
