// When a network is complete, and which node starts it then: each bit of 1F80h (CiA 302-2).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_network_start_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t mandatory_slave = 0x0D;

TEST(BootNetworkStart, IsNothingOfANodeThatIsNoMaster) {
  for (std::uint32_t startup = 0; startup < 0x80; startup += 2) {
    BootNetwork sut;
    sut.startup(startup);
    sut.assign(5, mandatory_slave);
    sut.start();
    sut.boot_up(5);
    sut.run_until(Time(10s));
    sut.expect({"77F#00"});
    sut.expect_log({});
    // 08h without 04h: a device that enters operational by itself.
    const bool starts_itself = (startup & 0x0C) == 0x08;
    EXPECT_EQ(sut.node.state(), starts_itself ? NmtState::operational : NmtState::pre_operational)
        << startup;
  }
}

TEST(BootNetworkStart, ComesAtOnceWhereThereIsNoSlave) {
  BootNetwork sut;
  sut.start();
  sut.expect({"77F#00", "000#82 00"});
  sut.expect_log({"@0 network booting", "@0 network complete"});
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

/// One mandatory slave (5) and one optional (6); 6 is booted before 5.
struct Started : BootNetwork {
  explicit Started(std::uint32_t bits) {
    startup(bits);
    assign(5, mandatory_slave);
    assign(6, optional_slave);
    start();
    forget();
    bring_up(6);
    bring_up(5);
  }
};

TEST(BootNetworkStart, FollowsAllCombinationsOfBits1To3) {
  for (std::uint32_t bits = 0x01; bits < 0x10; bits += 2) {
    Started sut(bits);
    const bool all_at_once = (bits & 2) != 0;
    const bool starts_itself = (bits & 4) == 0;
    const bool starts_slaves = (bits & 8) == 0;
    std::vector<std::string> frames = {"606#40 00 10 00 00 00 00 00",
                                       "605#40 00 10 00 00 00 00 00"};
    if (starts_slaves && all_at_once) frames.push_back("000#01 00");
    if (starts_slaves && !all_at_once) {
      frames.insert(frames.begin() + 1, "000#01 06");
      frames.push_back("000#01 05");
    }
    sut.expect(frames);
    EXPECT_EQ(sut.node.state(), starts_itself ? NmtState::operational : NmtState::pre_operational)
        << bits;
    EXPECT_EQ(sut.manager.network(), NetworkBoot::complete);
  }
}

TEST(BootNetworkStart, WaitsForAllMandatorySlavesAndForNoOther) {
  BootNetwork sut;
  sut.assign(4, mandatory_slave);
  sut.assign(5, mandatory_slave);
  sut.assign(6, optional_slave);
  sut.start();
  sut.bring_up(4);
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  sut.forget();
  sut.bring_up(5);
  sut.expect_log({"5 device_type", "5 error_control", "5 booted", "5 started", "network complete"});
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

TEST(BootNetworkStart, AtOnceGivesTheOptionalSlavesTheirChance) {
  BootNetwork sut;
  sut.startup(0x03);
  sut.assign(5, mandatory_slave);
  sut.assign(6, optional_slave);
  sut.start();
  sut.forget();
  sut.bring_up(5);
  sut.run_until(Time(2s - 1us));
  sut.expect({"605#40 00 10 00 00 00 00 00", "@1000000 606#40 00 10 00 00 00 00 00"});
  EXPECT_EQ(sut.manager.network(), NetworkBoot::booting);
  sut.run_until(Time(2s));
  sut.expect({"@2000000 606#80 00 10 00 00 00 04 05", "@2000000 000#01 00"});
  EXPECT_EQ(sut.manager.network(), NetworkBoot::complete);
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

TEST(BootNetworkStart, AtOnceStartsThoseThatComeLaterOneByOne) {
  BootNetwork sut;
  sut.startup(0x03);
  sut.assign(5, mandatory_slave);
  sut.assign(6, optional_slave);
  sut.start();
  sut.bring_up(5);
  sut.run_until(Time(2500ms));
  sut.forget();
  sut.bring_up(6);
  sut.expect({"606#40 00 10 00 00 00 00 00", "000#01 06"});
}

TEST(BootNetworkStart, FailsWithAMandatorySlaveAndGoesOnWhenItComesAfterAll) {
  BootNetwork sut;
  sut.assign(5, mandatory_slave);
  sut.stored.store(0x1F85, 5, 0x123);
  sut.start();
  sut.forget();
  sut.bring_up(5);
  sut.answer(5, 0x1018, 1, 0x124);
  sut.expect_log(
      {"5 device_type", "5 vendor_id", "5 failed D 00000124 not 00000123", "network failed"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  // The device is exchanged.
  sut.run_until(Time(1h));
  sut.bring_up(5);
  sut.answer(5, 0x1018, 1, 0x123);
  sut.expect_log({"5 device_type", "5 vendor_id", "5 error_control", "5 booted", "5 started",
                  "network complete"});
  EXPECT_EQ(sut.node.state(), NmtState::operational);
}

TEST(BootNetworkStart, BootsASlaveThatWasGivenUpWhenItIsHeard) {
  BootNetwork sut;
  sut.assign(5, mandatory_slave);
  sut.stored.store(0x1F89, 0, 1000);
  sut.start();
  sut.run_until(Time(10s));
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::failed);
  sut.forget();
  sut.receive("705#05");
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0);
  sut.expect({"000#82 05"});
}

TEST(BootNetworkStart, CountsASlaveThatWasOperationalAsUpAndDoesNotStartIt) {
  BootNetwork sut;
  sut.assign(5, 0x1D);
  sut.watch(5, 300);
  sut.start();
  sut.forget();
  sut.answer(5, 0x1000, 0, 0);
  sut.receive("705#05");
  sut.expect({});
  sut.expect_log({"5 node_state", "5 booted L", "network complete"});
}

TEST(BootNetworkStart, BootsAsManySlavesAtOnceAsThereAreSlotsAndTheOthersInTurn) {
  BootNetwork sut(2);
  for (NodeId slave = 10; slave <= 13; ++slave) sut.assign(slave, mandatory_slave);
  sut.start();
  sut.forget();
  for (const NodeId slave : {NodeId{12}, NodeId{10}, NodeId{13}, NodeId{11}}) {
    sut.run_for(1ms);
    sut.boot_up(slave);
  }
  sut.expect({"@1000 60C#40 00 10 00 00 00 00 00", "@2000 60A#40 00 10 00 00 00 00 00"});
  sut.run_for(1ms);
  sut.answer(10, 0x1000, 0, 0);
  sut.expect({"000#01 0A", "60D#40 00 10 00 00 00 00 00"});
  sut.answer(12, 0x1000, 0, 0);
  sut.expect({"000#01 0C", "60B#40 00 10 00 00 00 00 00"});
}

TEST(BootNetworkStart, BeginsAnewWithEachResetOfTheMaster) {
  for (const char* reset : {"000#81 7F", "000#82 7F"}) {
    BootNetwork sut;
    sut.assign(5, mandatory_slave);
    sut.start();
    sut.bring_up(5);
    sut.forget();
    sut.run_until(Time(1s));
    sut.receive(reset);
    sut.expect({"77F#00", "000#82 00"});
    sut.expect_log({"network booting"});
    EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
    sut.bring_up(5);
    sut.expect({"605#40 00 10 00 00 00 00 00", "000#01 05"});
  }
}

TEST(BootNetworkStart, BootsASlaveThatIsNamedWhileTheNetworkRuns) {
  BootNetwork sut;
  sut.start();
  sut.forget();
  EXPECT_EQ(sut.write(0x1F81, 5, optional_slave), AbortCode::none);
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0);
  sut.expect({"000#82 05"});
  EXPECT_EQ(sut.write(0x1F81, 5, 0), AbortCode::none);
  sut.receive("705#00");
  sut.run_for(1h);
  sut.expect({});
}

TEST(BootNetworkStart, IsCompletedWhenTheSlaveThatWasMissingIsNoLongerNamed) {
  BootNetwork sut;
  sut.assign(5, mandatory_slave);
  sut.assign(6, mandatory_slave);
  sut.start();
  sut.bring_up(6);
  EXPECT_EQ(sut.manager.network(), NetworkBoot::booting);
  EXPECT_EQ(sut.write(0x1F81, 5, 0), AbortCode::none);
  EXPECT_EQ(sut.manager.network(), NetworkBoot::complete);
}

TEST(BootNetworkStart, KnowsTheBits0To6Of1F80hAndRefusesTheOthers) {
  BootNetwork sut;
  sut.start();
  for (unsigned bit = 0; bit < 32; ++bit) {
    EXPECT_EQ(sut.write(0x1F80, 0, 1U << bit), bit <= 6 ? AbortCode::none : AbortCode::value_range);
  }
  for (std::uint32_t bits = 0; bits < 0x80; ++bits) {
    EXPECT_EQ(sut.write(0x1F80, 0, bits), AbortCode::none);
  }
}

TEST(BootNetworkStart, OfAFlyingMasterWaitsUntilItHasWon) {
  BootNetwork sut;
  sut.startup(0x21);
  sut.assign(5, mandatory_slave);
  sut.start();
  sut.run_until(Time(10s));
  sut.expect({"77F#00"});
  sut.manager.become_master();
  sut.settle();
  sut.expect({"000#82 00"});
  sut.manager.retire();
  sut.receive("705#00");
  sut.run_for(1h);
  sut.expect({});
}

}  // namespace
}  // namespace canvoy::boot_network_start_test
