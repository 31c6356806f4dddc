// Reaction of an NMT master to a slave that is lost or restarts: alone, or with all, by 1F80h bits
// 4 and 6 (CiA 302-2, error control event).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_network_loss_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t mandatory_slave = 0x0D;

/// Slave 5 sends a heartbeat every 300 ms, slave 6 none; both are operational.
struct RunningNetwork : BootNetwork {
  explicit RunningNetwork(std::uint32_t bits, std::uint32_t assignment = mandatory_slave) {
    startup(bits);
    assign(5, assignment);
    assign(6, optional_slave);
    watch(5, 300);
    start();
    bring_up(6);
    bring_up(5);
    heartbeat(5, 0x7F);
    forget();
  }
};

TEST(BootNetworkLoss, ResetsTheSlaveThatIsLostAndBootsItAgain) {
  RunningNetwork sut(0x01);
  sut.run_until(Time(300ms));
  sut.expect({"@300000 000#81 05"});
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::waiting);
  sut.run_until(Time(400ms));
  sut.bring_up(5);
  sut.heartbeat(5, 0x7F);
  sut.expect({"605#40 00 10 00 00 00 00 00", "000#01 05"});
  sut.expect_log({"@300 5 lost", "@400 5 device_type", "@400 5 error_control", "@400 5 booted",
                  "@400 5 started"});
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

TEST(BootNetworkLoss, AsksEachSecondForASlaveThatStaysAway) {
  RunningNetwork sut(0x01, optional_slave);
  sut.run_until(Time(5s));
  sut.expect_log({"@300 5 lost", "@1300 5 device_type", "@2300 5 retried B 05040000",
                  "@3300 5 device_type", "@4300 5 retried B 05040000"});
}

TEST(BootNetworkLoss, GivesAMandatorySlaveItsBootTimeAnew) {
  RunningNetwork sut(0x01);
  sut.stored.store(0x1F89, 0, 3000);
  EXPECT_EQ(sut.write(0x1F89, 0, 3000), AbortCode::none);
  sut.run_until(Time(100s));
  sut.expect_log({"@300 5 lost", "@1300 5 device_type", "@2300 5 retried B 05040000",
                  "@3300 5 device_type", "@4300 5 failed B 05040000"});
  EXPECT_EQ(sut.manager.network(), NetworkBoot::complete);
}

TEST(BootNetworkLoss, OfAMandatorySlaveResetsAllByBit4) {
  RunningNetwork sut(0x11);
  sut.run_until(Time(300ms));
  sut.expect({"@300000 000#81 00", "@300000 77F#00", "@300000 000#82 00"});
  sut.expect_log({"5 lost", "network booting"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(BootNetworkLoss, OfAMandatorySlaveStopsAllByBit6WhateverBit4Says) {
  for (const std::uint32_t bits : {0x41U, 0x51U}) {
    RunningNetwork sut(bits);
    sut.run_until(Time(10s));
    sut.expect({"@300000 000#02 00"});
    sut.expect_log({"5 lost"});
    EXPECT_EQ(sut.node.state(), NmtState::stopped);
  }
}

TEST(BootNetworkLoss, IsRepairedWhenTheStoppedMasterIsStartedAgain) {
  RunningNetwork sut(0x41);
  sut.run_until(Time(10s));
  sut.forget();
  sut.receive("000#01 7F");
  sut.expect({"605#40 00 10 00 00 00 00 00"});
}

TEST(BootNetworkLoss, OfAnOptionalSlaveIsItsOwnAffairWhateverTheBitsSay) {
  for (const std::uint32_t bits : {0x11U, 0x41U, 0x51U}) {
    RunningNetwork sut(bits, optional_slave);
    sut.run_until(Time(400ms));
    sut.expect({"@300000 000#81 05"});
    EXPECT_EQ(sut.node.state(), NmtState::operational);
  }
}

TEST(BootNetworkLoss, OfASlaveThatIsKeptAliveResetsNobody) {
  BootNetwork sut;
  sut.assign(5, 0x1D);
  sut.watch(5, 300);
  sut.start();
  sut.answer(5, 0x1000, 0, 0);
  sut.heartbeat(5, 0x05);
  sut.forget();
  sut.run_until(Time(300ms));
  sut.expect({"@300000 605#40 00 10 00 00 00 00 00"});
  sut.expect_log({"5 lost", "5 device_type"});
  // The cable is mended: the slave was operational all the time.
  sut.answer(5, 0x1000, 0, 0);
  sut.heartbeat(5, 0x05);
  sut.expect({});
  sut.expect_log({"5 node_state", "5 booted L"});
}

TEST(BootNetworkLoss, OfASlaveThatTheMasterDoesNotBootIsToldAndNoMore) {
  RunningNetwork sut(0x51, 0x09);
  sut.run_until(Time(10s));
  sut.expect({});
  sut.expect_log({"@300 5 lost"});
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

TEST(BootNetworkLoss, IsToldOnceUntilTheSlaveIsBack) {
  RunningNetwork sut(0x01);
  sut.run_until(Time(500ms));
  sut.heartbeat(5, 0x05);
  sut.run_until(Time(1200ms));
  sut.expect_log({"@300 5 lost"});
}

TEST(BootNetworkLoss, DoesNotComeWhileHeartbeatsDo) {
  RunningNetwork sut(0x01);
  for (int i = 0; i < 100; ++i) {
    sut.run_for(300ms - 1us);
    sut.heartbeat(5, 0x05);
  }
  sut.expect({});
  sut.expect_log({});
}

TEST(BootNetworkLoss, IsTheSameAsARestartForTheSlaveButNotForTheNetwork) {
  for (const std::uint32_t bits : {0x01U, 0x11U, 0x41U}) {
    RunningNetwork sut(bits);
    sut.run_until(Time(100ms));
    sut.boot_up(5);
    sut.expect({"@100000 605#40 00 10 00 00 00 00 00"});
    sut.answer(5, 0x1000, 0, 0);
    sut.heartbeat(5, 0x7F);
    sut.expect({"000#01 05"});
    sut.expect_log({"@100 5 restarted in done", "@100 5 device_type", "@100 5 error_control",
                    "@100 5 booted", "@100 5 started"});
    EXPECT_EQ(sut.node.state(), NmtState::operational);
  }
}

TEST(BootNetworkLoss, OfOneSlaveDoesNotTouchTheOthers) {
  RunningNetwork sut(0x01);
  sut.run_until(Time(10s));
  EXPECT_EQ(sut.manager.slave_state(6), BootManager::SlaveState::booted);
}

}  // namespace
}  // namespace canvoy::boot_network_loss_test
