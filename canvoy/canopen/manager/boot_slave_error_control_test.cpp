// The last step of the boot-up of a slave: its error control begins (CiA 302-2; letter K).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_error_control_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;

/// Slave 5 must send a heartbeat every 300 ms.
struct WatchingMaster : BootNetwork {
  explicit WatchingMaster(std::uint32_t assignment = optional_slave) {
    assign(5, assignment);
    watch(5, 300);
    start();
    forget();
    bring_up(5);
    sent.clear();
  }
};

/// Requests of the master for node guarding.
struct Guard {
  GuardingHooks hooks() { return {callback<&Guard::start>(*this), callback<&Guard::stop>(*this)}; }
  bool start(NodeId slave, Duration time, std::uint8_t factor) {
    log.push_back("guard " + std::to_string(slave) + " each " + std::to_string(time / 1ms) +
                  " factor " + std::to_string(factor));
    return true;
  }
  void stop(NodeId slave) { log.push_back("stop " + std::to_string(slave)); }
  std::vector<std::string> log;
};

TEST(BootSlaveErrorControl, WaitsForTheFirstHeartbeat) {
  WatchingMaster sut;
  sut.run_until(Time(100ms));
  sut.expect({});
  sut.receive("705#7F");
  sut.expect({"@100000 000#01 05"});
  sut.expect_log({"@0 5 device_type", "@0 5 error_control", "@100 5 booted", "@100 5 started"});
}

TEST(BootSlaveErrorControl, FailsWithoutAHeartbeat) {
  WatchingMaster sut;
  sut.run_until(Time(1h));
  sut.expect({});
  sut.expect_log({"@0 5 device_type", "@0 5 error_control", "@300 5 failed K"});
  EXPECT_EQ(sut.manager.slave_error(5), BootError::no_error_control);
}

TEST(BootSlaveErrorControl, TakesAHeartbeatInTheVeryLastMicrosecond) {
  WatchingMaster sut;
  sut.run_until(Time(300ms - 1us));
  sut.receive("705#7F");
  sut.expect({"000#01 05"});
}

TEST(BootSlaveErrorControl, GoesOnAfterBootUp) {
  WatchingMaster sut;
  sut.run_until(Time(100ms));
  sut.receive("705#7F");
  sut.forget();
  sut.run_until(Time(400ms - 1us));
  sut.expect_log({});
  sut.run_until(Time(400ms));
  sut.expect_log({"@400 5 lost"});
  sut.expect({"@400000 000#81 05"});
}

TEST(BootSlaveErrorControl, IsNotAskedOfASlaveWithoutAnEntryIn1016h) {
  for (const std::uint32_t other : {4U, 6U}) {
    BootNetwork sut;
    sut.assign(5, optional_slave);
    sut.watch(static_cast<NodeId>(other), 300);
    sut.start();
    sut.forget();
    sut.bring_up(5);
    sut.run_for(1h);
    sut.expect_log({"@0 5 device_type", "@0 5 error_control", "@0 5 booted", "@0 5 started"});
  }
}

TEST(BootSlaveErrorControl, IsGuardingWhere1F81hHasAGuardTime) {
  Guard guard;
  BootNetwork sut(2, {.guarding = guard.hooks()});
  sut.assign(5, 0x00C8'0305);
  sut.start();
  guard.log.clear();
  sut.boot_up(5);
  EXPECT_EQ(guard.log, (std::vector<std::string>{"stop 5"}));
  sut.answer(5, 0x1000, 0, 0);
  EXPECT_EQ(guard.log, (std::vector<std::string>{"stop 5", "guard 5 each 200 factor 3"}));
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
}

TEST(BootSlaveErrorControl, IsTheHeartbeatWhereThereAreBoth) {
  Guard guard;
  BootNetwork sut(2, {.guarding = guard.hooks()});
  sut.assign(5, 0x00C8'0305);
  sut.watch(5, 300);
  sut.start();
  sut.boot_up(5);
  guard.log.clear();
  sut.answer(5, 0x1000, 0, 0);
  EXPECT_TRUE(guard.log.empty());
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booting);
}

TEST(BootSlaveErrorControl, LosesAGuardedSlaveWhenGuardingSaysSo) {
  Guard guard;
  BootNetwork sut(2, {.guarding = guard.hooks()});
  sut.assign(5, 0x00C8'0305);
  sut.start();
  sut.bring_up(5);
  sut.forget();
  sut.manager.guarding_lost(5);
  sut.settle();
  sut.expect({"000#81 05"});
  sut.expect_log({"5 lost"});
  EXPECT_EQ(guard.log.back(), "stop 5");
}

TEST(BootSlaveErrorControl, BeginsAtOnceWithASlaveThatTheMasterDoesNotBoot) {
  BootNetwork sut;
  sut.assign(5, 0x01);
  sut.watch(5, 300);
  sut.start();
  sut.forget();
  sut.boot_up(5);
  sut.expect({});
  sut.receive("705#7F");
  sut.expect({});
  sut.expect_log({"5 error_control", "5 booted"});
  sut.run_until(Time(1h));
  sut.expect({});
  sut.expect_log({"@300 5 lost"});
}

TEST(BootSlaveErrorControl, ThatASlaveLeavesByARestartBeginsAnew) {
  WatchingMaster sut;
  sut.run_until(Time(200ms));
  sut.forget();
  sut.receive("705#00");
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  sut.expect_log({"5 restarted in error_control", "5 device_type"});
  sut.run_until(Time(400ms));
  sut.answer(5, 0x1000, 0, 0);
  sut.run_until(Time(700ms));
  sut.expect_log({"@400 5 error_control", "@700 5 failed K"});
}

}  // namespace
}  // namespace canvoy::boot_slave_error_control_test
