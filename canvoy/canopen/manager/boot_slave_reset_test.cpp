// The step of the boot-up of a slave that determines whether it is reset: it is, unless it has just
// booted, or must be kept alive and is operational (CiA 302-2; letters E, F and L).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_reset_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t kept_alive = 0x15;

/// Slave 5 answers its device type: the step under test follows. Without a boot-up message.
struct ResettingMaster : BootNetwork {
  void identify() {
    start();
    run_until(Time(1s));
    forget();
    answer(5, 0x1000, 0, 0x191);
  }
};

/// Like DisturbedMaster, but for a slave that is kept alive: it is asked at once.
struct KeepingMaster : BootNetwork {
  explicit KeepingMaster(std::uint32_t assignment = kept_alive) { assign(5, assignment); }
  void identify() {
    start();
    forget();
    answer(5, 0x1000, 0, 0x191);
  }
};

TEST(BootSlaveReset, IsDoneToASlaveThatSentNoBootUpMessage) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.expect({"000#82 05"});
  sut.run_until(Time(1100ms));
  sut.receive("705#00");
  sut.expect({"000#01 05"});
  sut.expect_log({"@1000 5 reset", "@1100 5 error_control", "@1100 5 booted", "@1100 5 started"});
}

TEST(BootSlaveReset, IsNotDoneToASlaveThatHasJustBooted) {
  BootNetwork sut;
  sut.assign(5, optional_slave);
  sut.start();
  sut.forget();
  sut.bring_up(5);
  sut.expect({"605#40 00 10 00 00 00 00 00", "000#01 05"});
}

TEST(BootSlaveReset, IsFollowedByAQuestionWhereNoBootUpMessageComes) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.run_until(Time(2s));
  sut.expect({"@1000000 000#82 05", "@2000000 605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.expect({"000#01 05"});
  sut.expect_log({"@1000 5 reset", "@2000 5 no_boot_up", "@2000 5 device_type",
                  "@2000 5 error_control", "@2000 5 booted", "@2000 5 started"});
}

TEST(BootSlaveReset, ThatEndsASlaveLeadsToTheNextAttempt) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.run_until(Time(4s));
  sut.expect_log({"@1000 5 reset", "@2000 5 no_boot_up", "@2000 5 device_type",
                  "@3000 5 retried B 05040000", "@4000 5 device_type"});
}

TEST(BootSlaveReset, GivesTheSlaveTheTimeThatTheOwnerSets) {
  BootNetwork sut(2, {.options = {.boot_up_time_out = 5s}});
  sut.assign(5, optional_slave);
  sut.start();
  sut.forget();
  sut.run_until(Time(5s));
  sut.expect({"@5000000 605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.run_until(Time(10s));
  sut.expect({"@5000000 000#82 05", "@10000000 605#40 00 10 00 00 00 00 00"});
}

TEST(BootSlaveReset, TakesTheHeartbeatsOfBeforeForNoBootUp) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.receive("705#05");
  sut.receive("705#7F");
  sut.expect_log({"5 reset"});
}

TEST(BootSlaveReset, SparesAnOperationalSlaveThatIsKeptAliveByItsHeartbeat) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.expect({});
  sut.run_until(Time(200ms));
  sut.receive("705#05");
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@200 5 booted L"});
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
  EXPECT_EQ(sut.manager.slave_error(5), BootError::already_operational);
}

TEST(BootSlaveReset, IsDoneToASlaveThatIsKeptAliveButNotOperational) {
  for (const char* heartbeat : {"705#7F", "705#04"}) {
    KeepingMaster sut;
    sut.watch(5, 300);
    sut.identify();
    sut.receive(heartbeat);
    sut.expect({"000#82 05"});
    sut.expect_log({"5 node_state", "5 reset"});
  }
}

TEST(BootSlaveReset, IsNotDoneToASlaveThatIsKeptAliveAndHasJustBooted) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.start();
  sut.boot_up(5);
  sut.forget();
  sut.answer(5, 0x1000, 0, 0x191);
  sut.receive("705#7F");
  sut.receive("705#7F");
  sut.expect({"000#01 05"});
  sut.expect_log({"5 node_state", "5 error_control", "5 booted", "5 started"});
}

TEST(BootSlaveReset, NeedsAHeartbeatOfASlaveThatIsKeptAlive) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.run_until(Time(1h));
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@300 5 failed E"});
}

TEST(BootSlaveReset, TakesAHeartbeatInTheVeryLastMicrosecond) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.run_until(Time(300ms - 1us));
  sut.receive("705#05");
  sut.expect_log({"5 node_state", "5 booted L"});
}

TEST(BootSlaveReset, AsksForTheStateByGuardingWhereNoHeartbeatIsKnown) {
  KeepingMaster sut(0x00C8'0315);  // guard time 200 ms
  sut.identify();
  sut.expect({"705#R1"});
  sut.run_until(Time(20ms));
  sut.receive("705#85");
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@20 5 booted L"});
}

TEST(BootSlaveReset, NeedsAnAnswerToGuardingOfASlaveThatIsKeptAlive) {
  KeepingMaster sut(0x00C8'0315);
  sut.identify();
  sut.run_until(Time(1h));
  sut.expect({"705#R1"});
  sut.expect_log({"@0 5 node_state", "@200 5 failed F"});
}

TEST(BootSlaveReset, FollowsWhatWasHeardLastWhereThereIsNoErrorControl) {
  KeepingMaster operational;
  operational.start();
  operational.receive("705#05");
  operational.forget();
  operational.answer(5, 0x1000, 0, 0x191);
  operational.expect({});
  operational.expect_log({"5 booted L"});

  KeepingMaster unheard;
  unheard.identify();
  unheard.expect({"000#82 05"});
}

TEST(BootSlaveReset, SparesNobodyWhenTheNetworkBeginsUnlessOneIsKeptAlive) {
  BootNetwork sut;
  sut.assign(4, optional_slave);
  sut.assign(5, kept_alive);
  sut.assign(6, 0x01);
  sut.start();
  sut.expect({"77F#00", "000#82 04", "000#82 06", "605#40 00 10 00 00 00 00 00"});
}

/// All are reset by one command, and none is asked before its boot-up message, up to the highest
/// node-ID.
TEST(BootSlaveReset, OfAllComesBeforeTheFirstQuestionToTheHighestNodeIdAsWell) {
  for (const NodeId slave : {NodeId{2}, NodeId{126}, NodeId{127}}) {
    BootNetwork sut(2, {}, 1);
    sut.assign(slave, optional_slave);
    sut.start();
    sut.expect({"701#00", "000#82 00"});
    sut.boot_up(slave);
    const std::string request = slave == 2 ? "602" : slave == 126 ? "67E" : "67F";
    sut.expect({request + "#40 00 10 00 00 00 00 00"});
  }
}

TEST(BootSlaveReset, IsLeftToTheSlavesWhereTheOwnerWantsIt) {
  BootNetwork sut(2, {.options = {.resets_slaves = false}});
  sut.assign(5, optional_slave);
  sut.start();
  sut.expect({"77F#00", "605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.expect({"000#82 05"});
}

}  // namespace
}  // namespace canvoy::boot_slave_reset_test
