#include "canvoy/canopen/nmt/node_guarding_master.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::node_guarding_master_test {
namespace {

using Texts = std::vector<std::string>;

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
                                std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

/// Records the reports of the guarding master.
struct Report {
  void changed(NodeId node_id, RemoteState state) {
    note("node " + std::to_string(node_id) + " state " +
         std::to_string(static_cast<unsigned>(state)));
  }
  void event(NodeId node_id, NodeGuardingEvent event, bool occurs) {
    note("node " + std::to_string(node_id) +
         (event == NodeGuardingEvent::state ? " wrong state" : " time-out") +
         (occurs ? "" : " resolved"));
  }
  void note(const std::string& text) {
    log.push_back("@" + std::to_string(now->time_since_epoch() / 1us) + " " + text);
  }
  Texts take() { return std::exchange(log, {}); }
  void attach(NodeGuardingMaster& master) {
    master.on_change(callback<&Report::changed>(*this));
    master.on_event(callback<&Report::event>(*this));
  }

  const Time* now;
  Texts log;
};

struct GuardingNode : WireNode {
  GuardingNode() : WireNode(layout.tables(), 1), sut(node, slots) {
    report.now = &now;
    report.attach(sut);
    boot();
  }
  bool guard(NodeId node_id, Duration guard_time = 100ms, std::uint8_t factor = 3) {
    node.advance(now);
    return sut.guard(node_id, guard_time, factor);
  }
  Texts take() { return report.take(); }

  Report report{};
  NodeGuardingMaster::Slot slots[3];
  NodeGuardingMaster sut;
};

TEST(NodeGuardingMaster, AsksByARemoteFrameOfOneByteAtOnceAndEachGuardTime) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.run_until(Time(250ms));
  node.expect({"@0 705#R1", "@100000 705#R1", "@200000 705#R1"});
}

TEST(NodeGuardingMaster, ReportsEachStateOfTheSlaveOnce) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  for (const char* answer : {"705#7F", "705#FF", "705#05", "705#85", "705#04", "705#FF"}) {
    node.receive(answer);
    node.run_for(100ms);
  }
  EXPECT_EQ(node.take(), Texts({"@0 node 5 state 127", "@200000 node 5 state 5",
                                "@400000 node 5 state 4", "@500000 node 5 state 127"}));
  EXPECT_EQ(node.sut.state(5), RemoteState::pre_operational);
}

TEST(NodeGuardingMaster, TakesAnAnswerWithTheSameToggleBitForNone) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.receive("705#85");
  EXPECT_EQ(node.take(), Texts()) << "the first has toggle bit 0";
  node.receive("705#05");
  node.run_until(Time(299ms));
  node.receive("705#7F");
  EXPECT_EQ(node.take(), Texts({"@0 node 5 state 5"}));
  node.run_until(Time(300ms));
  EXPECT_EQ(node.take(), Texts({"@300000 node 5 time-out", "@300000 node 5 state 255"}));
}

TEST(NodeGuardingMaster, LosesASlaveThatIsSilentForGuardTimeTimesFactor) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.run_until(Time(3ms));
  node.receive("705#05");
  node.take();
  node.run_until(Time(303ms) - 1us);
  EXPECT_EQ(node.take(), Texts());
  node.run_until(Time(1s));
  EXPECT_EQ(node.take(), Texts({"@303000 node 5 time-out", "@303000 node 5 state 255"}));
  EXPECT_EQ(node.sut.state(5), RemoteState::lost);
}

TEST(NodeGuardingMaster, LosesASlaveThatWasNeverHeard) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.run_until(Time(1h));
  EXPECT_EQ(node.take(), Texts({"@300000 node 5 time-out", "@300000 node 5 state 255"}));
}

TEST(NodeGuardingMaster, GoesOnAskingALostSlaveAndResolvesByItsAnswer) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.receive("705#05");
  node.run_until(Time(500ms));
  node.take();
  node.expect({"@0 705#R1", "@100000 705#R1", "@200000 705#R1", "@300000 705#R1", "@400000 705#R1",
               "@500000 705#R1"});
  node.receive("705#85");
  EXPECT_EQ(node.take(), Texts({"@500000 node 5 time-out resolved", "@500000 node 5 state 5"}));
  node.run_until(Time(800ms));
  EXPECT_EQ(node.take(), Texts({"@800000 node 5 time-out", "@800000 node 5 state 255"}));
}

TEST(NodeGuardingMaster, TakesABootUpForARestartOfNodeAndToggleBit) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.receive("705#05");
  node.receive("705#00");
  node.receive("705#7F");
  node.receive("705#FF");
  EXPECT_EQ(node.take(), Texts({"@0 node 5 state 5", "@0 node 5 state 0", "@0 node 5 state 127"}));
  node.run_until(Time(400ms));
  node.take();
  node.receive("705#00");
  EXPECT_EQ(node.take(), Texts({"@400000 node 5 time-out resolved", "@400000 node 5 state 0"}));
}

TEST(NodeGuardingMaster, NeverLosesASlaveWithFactor0) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5, 1s, 0));
  node.run_until(Time(1h));
  EXPECT_EQ(node.take(), Texts());
  EXPECT_EQ(node.sent.size(), 3601U);
}

TEST(NodeGuardingMaster, ReportsAStateThatTheMasterDoesNotExpect) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.receive("705#7F");
  EXPECT_EQ(node.take(), Texts({"@0 node 5 state 127"})) << "any state will do at first";
  node.sut.expect(5, NmtState::operational);
  node.receive("705#FF");
  EXPECT_EQ(node.take(), Texts()) << "asked before the command";
  node.run_for(100ms);
  node.receive("705#7F");
  node.receive("705#FF");
  EXPECT_EQ(node.take(), Texts({"@100000 node 5 wrong state"}));
  node.receive("705#05");
  EXPECT_EQ(node.take(), Texts({"@100000 node 5 state 5", "@100000 node 5 wrong state resolved"}));
  node.receive("705#84");
  EXPECT_EQ(node.take(), Texts({"@100000 node 5 state 4", "@100000 node 5 wrong state"}));
}

TEST(NodeGuardingMaster, ExpectsPreOperationalAfterABootUp) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.sut.expect(5, NmtState::pre_operational);
  node.run_for(100ms);
  node.receive("705#00");
  EXPECT_EQ(node.take(), Texts({"@100000 node 5 state 0"}));
  node.sut.expect(5, NmtState::operational);
  node.run_for(100ms);
  node.receive("705#00");
  EXPECT_EQ(node.take(), Texts({"@200000 node 5 state 0", "@200000 node 5 wrong state"}));
}

TEST(NodeGuardingMaster, IgnoresAndCountsWhatIsNoAnswer) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  for (const char* frame : {"705#", "705#05 00", "705#06", "705#80", "705#00 00 00 00 00 00 00 00"})
    node.receive(frame);
  EXPECT_EQ(node.take(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 5U);
  node.receive("705#R1");
  EXPECT_EQ(node.take(), Texts());
}

TEST(NodeGuardingMaster, KnowsAnAnswerByItsByte) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    GuardingNode node;
    ASSERT_TRUE(node.guard(5));
    node.node.receive(Frame::data_frame(0x705, {static_cast<std::uint8_t>(byte)}), node.now);
    const bool good = byte == 0x00 || byte == 0x04 || byte == 0x05 || byte == 0x7F;
    const bool toggled = byte == 0x84 || byte == 0x85 || byte == 0xFF;
    EXPECT_EQ(node.take().size(), good ? 1U : 0U) << byte;
    EXPECT_EQ(node.node.counters().malformed, good || toggled ? 0U : 1U) << byte;
  }
}

TEST(NodeGuardingMaster, GuardsSeveralNodesApartAndAsManyAsItHasSlots) {
  GuardingNode node;
  EXPECT_TRUE(node.guard(5, 100ms));
  EXPECT_TRUE(node.guard(6, 200ms));
  EXPECT_TRUE(node.guard(127, 300ms));
  EXPECT_FALSE(node.guard(8));
  node.expect({"705#R1", "706#R1", "77F#R1"});
  node.run_until(Time(300ms));
  node.expect(
      {"@100000 705#R1", "@200000 706#R1", "@200000 705#R1", "@300000 77F#R1", "@300000 705#R1"});
  node.sut.release(6);
  EXPECT_TRUE(node.guard(8));
}

TEST(NodeGuardingMaster, RefusesWhatCannotBeGuarded) {
  GuardingNode node;
  EXPECT_FALSE(node.guard(0));
  EXPECT_FALSE(node.guard(128));
  EXPECT_FALSE(node.guard(255));
  EXPECT_FALSE(node.guard(1)) << "itself";
  EXPECT_FALSE(node.guard(5, 0ms));
  EXPECT_FALSE(node.guard(5, -1ms));
  EXPECT_FALSE(node.guard(5, 65'536ms));
  EXPECT_TRUE(node.guard(5, 65'535ms, 255));
  EXPECT_FALSE(node.sut.guards(6));
  EXPECT_TRUE(node.sut.guards(5));
  EXPECT_EQ(node.sut.state(0), RemoteState::unknown);
}

TEST(NodeGuardingMaster, BeginsAnewWhenToldAgain) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.receive("705#05");
  node.run_until(Time(50ms));
  ASSERT_TRUE(node.guard(5, 200ms, 2));
  node.receive("705#05");
  node.run_until(Time(449ms));
  EXPECT_EQ(node.take(), Texts({"@0 node 5 state 5", "@50000 node 5 state 5"}));
  node.run_until(Time(450ms));
  EXPECT_EQ(node.take().size(), 2U);
  node.expect({"@0 705#R1", "@50000 705#R1", "@250000 705#R1", "@450000 705#R1"});
}

TEST(NodeGuardingMaster, EndsByReleaseAndByAResetOfTheMaster) {
  for (const bool by_reset : {false, true}) {
    GuardingNode node;
    ASSERT_TRUE(node.guard(5));
    node.sent.clear();
    if (by_reset) {
      node.receive("000#82 01");
      node.expect({"701#00"});
    } else {
      node.sut.release(5);
    }
    node.receive("705#05");
    node.run_until(Time(1h));
    node.expect({});
    EXPECT_EQ(node.take(), Texts());
    EXPECT_FALSE(node.sut.guards(5));
  }
}

TEST(NodeGuardingMaster, MayBeToldToEndFromItsOwnReport) {
  GuardingNode node;
  auto end = [&](NodeId node_id, RemoteState) { node.sut.release(node_id); };
  node.sut.on_change(Callback<void(NodeId, RemoteState)>::of(end));
  ASSERT_TRUE(node.guard(5));
  node.receive("705#05");
  EXPECT_FALSE(node.sut.guards(5));
  ASSERT_TRUE(node.guard(5));
  node.run_until(Time(1h));
  EXPECT_FALSE(node.sut.guards(5)) << "lost";
}

TEST(NodeGuardingMaster, LeavesOutRequestsThatNobodyHadTimeFor) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  node.now = Time(250ms);
  node.settle();
  node.run_until(Time(350ms));
  node.expect({"@0 705#R1", "@250000 705#R1", "@350000 705#R1"});
}

TEST(NodeGuardingMaster, WaitsForRoomInTheController) {
  GuardingNode node;
  node.full = true;
  while (!node.node.transmitter().full()) node.node.transmitter().send(wire_frame("123#"));
  ASSERT_TRUE(node.guard(5));
  ASSERT_TRUE(node.guard(6));
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 18U);
  EXPECT_EQ(wire_text(node.sent[16].frame), "705#R1");
  EXPECT_EQ(wire_text(node.sent[17].frame), "706#R1");
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
}

TEST(NodeGuardingMaster, MayBeToldToGuardNoMoreByAnAnswerThatComesAtOnce) {
  GuardingNode node;
  node.on_sent = [&](const Frame&) { node.sut.release(5); };
  node.guard(5);
  node.run_until(Time(1s));
  node.expect({"@0 705#R1"});
  EXPECT_FALSE(node.sut.guards(5));
  EXPECT_EQ(node.node.deadline(), never);
  EXPECT_EQ(node.take(), Texts());
}

TEST(NodeGuardingMaster, HearsAnAnswerThatComesAtOnceBeforeTheLifeTimeIsOver) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5, 100ms, 1));
  node.on_sent = [&](const Frame&) { node.node.receive(wire_frame("705#05"), node.now); };
  node.run_until(Time(150ms));
  EXPECT_EQ(node.take(), Texts({"@100000 node 5 state 5"}));
}

// Both ends

/// A master at position 0 of a cable, and two slaves.
struct GuardedCable {
  GuardedCable() {
    for (std::size_t i = 0; i < 3; ++i) cable.connect(i, nodes[i]);
    report.now = &cable.now;
    report.attach(master);
    cable.start_all();
    EXPECT_TRUE(master.guard(10, 100ms, 2));
    EXPECT_TRUE(master.guard(11, 100ms, 2));
  }
  static constexpr DictionaryTables tables = layout.tables();
  Cable cable;
  WireMemory memories[3] = {WireMemory(tables), WireMemory(tables), WireMemory(tables)};
  Node nodes[3] = {{tables, memories[0].spans(), cable.port(0), 1},
                   {tables, memories[1].spans(), cable.port(1), 10},
                   {tables, memories[2].spans(), cable.port(2), 11}};
  NodeGuardingMaster::Slot slots[2];
  NodeGuardingMaster master{nodes[0], slots};
  NodeGuardingSlave slaves[2] = {NodeGuardingSlave(nodes[1]), NodeGuardingSlave(nodes[2])};
  Report report{};
};

TEST(NodeGuarding, OfTwoSlavesByOneMasterNoticesStopsLossesAndRestarts) {
  GuardedCable sut;
  sut.cable.run_for(1s);
  EXPECT_EQ(sut.report.take(), Texts({"@0 node 10 state 127", "@0 node 11 state 127"}));
  sut.cable.send("000#02 0A");
  sut.cable.run_until(Time(2s));
  EXPECT_EQ(sut.report.take(), Texts({"@1100000 node 10 state 4"}));
  sut.cable.cut(2);
  sut.cable.run_until(Time(3s));
  EXPECT_EQ(sut.report.take(), Texts({"@2200000 node 11 time-out", "@2200000 node 11 state 255"}));
  sut.cable.cut(2, false);
  sut.cable.run_until(Time(3s) + 150ms);
  const Texts back = sut.report.take();
  ASSERT_EQ(back.size(), 2U) << "the toggle bits of both may differ by one answer that was lost";
  sut.cable.send("000#81 0A");
  sut.cable.run_until(Time(4s));
  EXPECT_EQ(sut.report.take(), Texts({"@3150000 node 10 state 0", "@3200000 node 10 state 127"}));
}

TEST(NodeGuardingMaster, ReleasesNothingWhereThereIsNoNode) {
  GuardingNode node;
  ASSERT_TRUE(node.guard(5));
  for (const NodeId none : {NodeId{0}, NodeId{128}, NodeId{255}, NodeId{6}}) node.sut.release(none);
  EXPECT_TRUE(node.sut.guards(5));
}

}  // namespace
}  // namespace canvoy::node_guarding_master_test
