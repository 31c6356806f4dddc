// The slaves of a master in node 127, without the network around them: their order, and their state
// if there is no room (CiA 302-2).
#include "canvoy/canopen/manager/slave_boots.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::slave_boots_test {
namespace {

using State = SlaveBoots::State;

/// Bits 0 and 2 of 1F81h: a slave, and the master boots it. Bit 4: it is kept alive.
constexpr std::uint32_t booted_slave = 0x05;
constexpr std::uint32_t kept_alive = 0x15;

/// One slave is booted at a time, and two NMT commands may wait.
struct Slaves : WireNode {
  Slaves() : WireNode(detail::boot_layout.tables(), 127) { boot(); }

  void name(NodeId slave, std::uint32_t assignment = booted_slave) {
    node.dictionary().set_number(master_object::slave_assignment, slave, assignment);
  }
  /// It answers the only request, for its device type.
  void answer(NodeId slave) {
    node.receive(Frame::data_frame(0x580U + slave, {0x43, 0x00, 0x10, 0x00, 0, 0, 0, 0}), now);
    settle();
  }
  void boot_up(NodeId slave) {
    node.advance(now);
    sut.heard(slave, RemoteState::boot_up);
    settle();
  }
  void note(const BootReport& report) { log.push_back(boot_text(report)); }
  bool guard(NodeId slave, Duration, std::uint8_t) {
    log.push_back("guards " + std::to_string(slave));
    return true;
  }
  void leave(NodeId slave) { log.push_back("leaves " + std::to_string(slave)); }

  std::vector<std::string> log;
  std::array<NmtMaster::RemoteNode, 127> remotes;
  std::array<NmtQueue::Request, 2> requests{};
  std::array<SlaveBoots::Record, 127> records{};
  std::array<BootSlave, 1> slots{BootSlave(node)};
  NmtMaster master{node, remotes};
  NmtQueue commands{node, requests};
  BootContext context{
      node,
      master,
      commands,
      {},
      {.start = callback<&Slaves::guard>(*this), .stop = callback<&Slaves::leave>(*this)},
      {},
      callback<&Slaves::note>(*this)};
  SlaveBoots sut{context, {records, slots}, {}};
};

TEST(SlaveBoots, WhoHasWaitedLongestIsNextWhicheverItsNodeId) {
  Slaves slaves;
  slaves.sut.begin();
  for (const NodeId slave : {NodeId{9}, NodeId{7}, NodeId{5}, NodeId{6}}) {
    slaves.name(slave);
    slaves.boot_up(slave);
    slaves.run_for(1ms);
  }
  slaves.expect({"609#40 00 10 00 00 00 00 00"});
  slaves.answer(9);
  slaves.expect({"607#40 00 10 00 00 00 00 00"});
  slaves.answer(7);
  slaves.expect({"605#40 00 10 00 00 00 00 00"});
  slaves.answer(5);
  slaves.expect({"606#40 00 10 00 00 00 00 00"});
}

/// Waiting for the boot-up message of a slave that was not reset would last forever.
TEST(SlaveBoots, OfWhichTheResetFindsNoRoomAreAskedWithoutIt) {
  Slaves slaves;
  slaves.name(4, kept_alive);
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{7}}) slaves.name(slave);
  slaves.sut.begin();
  slaves.sut.reset_all();
  EXPECT_EQ(slaves.sut.record(4).due, slaves.now) << "one that is kept alive is not reset";
  EXPECT_EQ(slaves.sut.record(5).due, never);
  EXPECT_EQ(slaves.sut.record(6).due, never);
  EXPECT_EQ(slaves.sut.record(7).due, slaves.now) << "two commands wait";
}

TEST(SlaveBoots, ThatIsLostAndCannotBeResetIsAskedWithoutIt) {
  Slaves slaves;
  slaves.name(5);
  slaves.sut.begin();
  slaves.boot_up(5);
  slaves.answer(5);
  ASSERT_EQ(slaves.sut.record(5).state, State::booted);
  slaves.full = true;
  while (slaves.commands.add({6, NmtCommand::start})) {
  }
  slaves.sut.lost(5);
  EXPECT_EQ(slaves.sut.record(5).state, State::waiting);
  EXPECT_EQ(slaves.sut.record(5).due, slaves.now);
}

/// Guard time 100 ms, retry factor 3 (1F81h, bits 31 to 8).
TEST(SlaveBoots, ThatIsNoLongerNamedIsNeitherGuardedNorMissed) {
  Slaves slaves;
  slaves.name(5, 0x0064'0300 | booted_slave);
  slaves.sut.begin();
  slaves.boot_up(5);
  slaves.answer(5);
  EXPECT_EQ(slaves.log.back(), "5 booted");
  slaves.log.clear();
  slaves.name(5, 0);
  slaves.sut.assign(5, false);
  EXPECT_EQ(slaves.log, std::vector<std::string>{"leaves 5"});
  slaves.sut.lost(5);
  EXPECT_EQ(slaves.log.size(), 1U) << "nobody misses it";
  EXPECT_EQ(slaves.sut.record(5).state, State::none);
}

TEST(SlaveBoots, WhoseTurnItIsGivesItToTheNextWhenItIsNoLongerNamed) {
  Slaves slaves;
  slaves.sut.begin();
  for (const NodeId slave : {NodeId{5}, NodeId{6}}) {
    slaves.name(slave);
    slaves.boot_up(slave);
  }
  slaves.expect({"605#40 00 10 00 00 00 00 00"});
  slaves.name(5, 0);
  slaves.sut.assign(5, false);
  slaves.settle();
  slaves.expect({"605#80 00 10 00 00 00 00 08", "606#40 00 10 00 00 00 00 00"});
}

/// Two commands wait, and the bus accepts nothing; then it does.
TEST(SlaveBoots, WhoseStartFindsNoRoomAreStartedWhenThereIsSome) {
  for (const bool all : {false, true}) {
    Slaves slaves;
    slaves.name(5);
    slaves.sut.begin();
    slaves.boot_up(5);
    slaves.answer(5);
    slaves.expect({"605#40 00 10 00 00 00 00 00"});
    slaves.full = true;
    while (slaves.commands.add({6, NmtCommand::start})) {
    }
    all ? slaves.sut.start_all() : slaves.sut.start(5);
    EXPECT_FALSE(slaves.sut.record(5).is_started);
    slaves.run_for(10s);
    slaves.full = false;
    slaves.node.tx_ready(slaves.now);
    slaves.run_for(2s);
    slaves.expect({"000#01 06", "000#01 06", "000#01 05"});
    EXPECT_TRUE(slaves.sut.record(5).is_started);
    EXPECT_EQ(slaves.log.back(), "5 started");
  }
}

/// The only slot is taken by a slave that answers late, and another waits for it.
TEST(SlaveBoots, WhoseStartFindsNoRoomAreStartedWhileOthersAreBooted) {
  Slaves slaves;
  slaves.sut.begin();
  slaves.context.options.sdo_time_out = 20s;
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{7}}) slaves.name(slave);
  slaves.boot_up(5);
  slaves.answer(5);
  slaves.boot_up(6);
  slaves.expect({"605#40 00 10 00 00 00 00 00", "606#40 00 10 00 00 00 00 00"});
  slaves.full = true;
  while (slaves.commands.add({8, NmtCommand::start})) {
  }
  slaves.sut.start(5);
  slaves.boot_up(7);
  slaves.full = false;
  slaves.node.tx_ready(slaves.now);
  slaves.expect({"000#01 08", "000#01 08"});
  slaves.run_for(1s);
  slaves.expect({"000#01 05"});
  EXPECT_EQ(slaves.sut.record(6).state, State::booting);
}

/// One that restarts again and again is delayed, and those that wait beside it are not.
TEST(SlaveBoots, WhoRestartsTooOftenGivesItsTurnToTheNext) {
  Slaves slaves;
  slaves.sut.begin();
  slaves.name(5);
  slaves.name(6);
  slaves.boot_up(5);
  for (int restart = 1; restart <= 4; ++restart) slaves.boot_up(5);
  EXPECT_EQ(slaves.sut.record(5).state, State::waiting) << "for a second";
  slaves.run_for(1s);
  ASSERT_EQ(slaves.sut.record(5).state, State::booting);
  slaves.boot_up(6);
  slaves.sent.clear();
  slaves.boot_up(5);
  slaves.expect({"605#80 00 10 00 00 00 00 08", "606#40 00 10 00 00 00 00 00"});
}

}  // namespace
}  // namespace canvoy::slave_boots_test
