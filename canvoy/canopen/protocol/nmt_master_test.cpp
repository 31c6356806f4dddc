#include "canvoy/canopen/nmt/nmt_master.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/network_states.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::nmt_master_test {
namespace {

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
                                std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct MasterNode : WireNode {
  MasterNode() : WireNode(layout.tables(), 127), master(node, nodes) {
    master.on_change(callback<&MasterNode::changed>(*this));
    boot();
  }
  void changed(NodeId node_id, RemoteState state) {
    log.push_back("@" + std::to_string(now.time_since_epoch() / 1ms) + " " +
                  std::to_string(node_id) + " " + std::to_string(static_cast<unsigned>(state)));
  }
  void expect_log(const std::vector<std::string>& expected) {
    EXPECT_EQ(log, expected);
    log.clear();
  }

  std::vector<std::string> log;
  NmtMaster::RemoteNode nodes[127];
  NmtMaster master;
};

/// A node in the same network, without an NMT master.
struct ListeningNode : WireNode {
  ListeningNode() : WireNode(layout.tables(), 5), network(node) {
    network.on_change(callback<&ListeningNode::changed>(*this));
    boot();
  }
  void changed(NodeId node_id, RemoteState state) {
    log.push_back(std::to_string(node_id) + " " + std::to_string(static_cast<unsigned>(state)));
  }

  std::vector<std::string> log;
  NetworkStates network;
};

TEST(NetworkStates, TellsEachChangeAndEachBootUpOfEachNode) {
  ListeningNode sut;
  EXPECT_EQ(sut.network.state(10), RemoteState::unknown);
  for (const char* frame : {"70A#00", "70A#7F", "70A#7F", "77F#05", "701#04", "70A#00", "70A#00"}) {
    sut.receive(frame);
  }
  EXPECT_EQ(sut.log, (std::vector<std::string>{"10 0", "10 127", "127 5", "1 4", "10 0", "10 0"}));
  EXPECT_EQ(sut.network.state(127), RemoteState::operational);
  sut.receive("000#82 05");
  EXPECT_EQ(sut.network.state(127), RemoteState::unknown);
}

TEST(NetworkStates, IgnoresWhatIsNoStateAndNoErrorControl) {
  ListeningNode sut;
  for (const char* frame : {"70A#06", "70A#05 00", "70A#", "700#05", "780#05", "70A#R1"}) {
    sut.receive(frame);
  }
  EXPECT_EQ(sut.log, std::vector<std::string>{});
  EXPECT_EQ(sut.node.counters().malformed, 3U);
}

TEST(NetworkStates, ACommandNeedsNoNmtMaster) {
  ListeningNode sut;
  EXPECT_TRUE(command_node(sut.node, 10, NmtCommand::start));
  sut.expect({"000#01 0A"});
  EXPECT_TRUE(command_node(sut.node, 5, NmtCommand::stop));
  sut.expect({});
  EXPECT_EQ(sut.node.state(), NmtState::stopped);
  EXPECT_FALSE(command_node(sut.node, 128, NmtCommand::start));
}

constexpr NmtCommand commands[] = {NmtCommand::start, NmtCommand::stop,
                                   NmtCommand::enter_pre_operational, NmtCommand::reset_node,
                                   NmtCommand::reset_communication};

TEST(NmtMaster, CommandsOneNode) {
  MasterNode sut;
  for (const NmtCommand command : commands) EXPECT_TRUE(sut.master.command(10, command));
  sut.expect({"000#01 0A", "000#02 0A", "000#80 0A", "000#81 0A", "000#82 0A"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(NmtMaster, CommandsEveryNodeIdAndNoOther) {
  MasterNode sut;
  for (unsigned node_id = 1; node_id <= 126; ++node_id) {
    EXPECT_TRUE(sut.master.command(static_cast<NodeId>(node_id), NmtCommand::start));
  }
  EXPECT_EQ(sut.sent.size(), 126U);
  sut.sent.clear();
  for (unsigned node_id = 128; node_id <= 255; ++node_id) {
    EXPECT_FALSE(sut.master.command(static_cast<NodeId>(node_id), NmtCommand::start));
  }
  sut.expect({});
}

TEST(NmtMaster, ObeysItselfWhenAllAreMeant) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.command(NmtMaster::all_nodes, NmtCommand::start));
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  EXPECT_TRUE(sut.master.command(NmtMaster::all_nodes, NmtCommand::stop));
  EXPECT_EQ(sut.node.state(), NmtState::stopped);
  EXPECT_TRUE(sut.master.command(NmtMaster::all_nodes, NmtCommand::enter_pre_operational));
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  EXPECT_TRUE(sut.master.command(NmtMaster::all_nodes, NmtCommand::reset_communication));
  EXPECT_TRUE(sut.master.command(NmtMaster::all_nodes, NmtCommand::reset_node));
  sut.expect({"000#01 00", "000#02 00", "000#80 00", "000#82 00", "77F#00", "000#81 00", "77F#00"});
}

TEST(NmtMaster, ObeysItselfWithoutAFrameWhenItIsMeantAlone) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.command(127, NmtCommand::start));
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.expect({});
}

TEST(NmtMaster, SaysWhenACommandCouldNotBeSentAndDoesNotObeyItThen) {
  MasterNode sut;
  sut.full = true;
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(sut.master.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.master.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.master.command(NmtMaster::all_nodes, NmtCommand::start));
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(NmtMaster, DoesNotCommandBeforeItsOwnBootUp) {
  WireNode wire(layout.tables(), 127);
  NmtMaster::RemoteNode nodes[127];
  NmtMaster sut(wire.node, nodes);
  EXPECT_FALSE(sut.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.command(NmtMaster::all_nodes, NmtCommand::start));
  wire.expect({});
}

TEST(NmtMaster, KnowsTheStatesOfTheOthers) {
  MasterNode sut;
  EXPECT_EQ(sut.master.remote(10).state(), RemoteState::unknown);
  sut.run_until(Time(7ms));
  sut.receive("70A#00");
  EXPECT_EQ(sut.master.remote(10).state(), RemoteState::boot_up);
  EXPECT_EQ(sut.master.remote(10).seen(), Time(7ms));
  EXPECT_EQ(sut.master.remote(10).id(), 10);
  sut.run_until(Time(1007ms));
  sut.receive("70A#7F");
  sut.receive("70A#7F");
  sut.receive("70A#05");
  sut.receive("70A#04");
  EXPECT_EQ(sut.master.remote(10).state(), RemoteState::stopped);
  EXPECT_EQ(sut.master.remote(10).seen(), Time(1007ms));
  sut.expect_log({"@7 10 0", "@1007 10 127", "@1007 10 5", "@1007 10 4"});
  EXPECT_EQ(sut.master.remote(11).state(), RemoteState::unknown);
}

TEST(NmtMaster, HearsAllOfThe127Nodes) {
  MasterNode sut;
  for (unsigned node_id = 1; node_id <= 127; ++node_id) {
    sut.node.receive(Frame::data_frame(0x700 + node_id, {0x05}), sut.now);
  }
  ASSERT_EQ(sut.log.size(), 127U);
  EXPECT_EQ(sut.log.front(), "@0 1 5");
  EXPECT_EQ(sut.log.back(), "@0 127 5");
}

TEST(NmtMaster, ReportsEachBootUp) {
  MasterNode sut;
  sut.receive("70A#00");
  sut.receive("70A#00");
  sut.expect_log({"@0 10 0", "@0 10 0"});
}

TEST(NmtMaster, ReportsEachMessageBeforeTheChangeThatItBrings) {
  MasterNode sut;
  auto note = [&sut](NodeId node_id, RemoteState state) {
    sut.log.push_back("message " + std::to_string(node_id) + " " +
                      std::to_string(static_cast<unsigned>(state)));
  };
  sut.master.on_message(Callback<void(NodeId, RemoteState)>::of(note));
  sut.receive("70A#05");
  sut.receive("70A#05");
  sut.receive("70A#85");
  sut.receive("70A#01");
  sut.expect_log({"message 10 5", "@0 10 5", "message 10 5", "message 10 5"});
}

TEST(NmtMaster, TakesATimeOutThatIsSetFromAMessageAtOnce) {
  MasterNode sut;
  auto watch = [&sut](NodeId node_id, RemoteState) { sut.master.set_time_out(node_id, 100ms); };
  sut.master.on_message(Callback<void(NodeId, RemoteState)>::of(watch));
  sut.receive("70A#05");
  sut.run_until(Time(1s));
  sut.expect_log({"@0 10 5", "@100 10 255"});
}

TEST(NmtMaster, LosesANodeAfterItsTimeOutAndFindsItAgain) {
  MasterNode sut;
  sut.master.set_time_out(10, 1500ms);
  sut.receive("70A#00");
  sut.run_until(Time(1000ms));
  sut.receive("70A#7F");
  sut.run_until(Time(2499ms));
  sut.expect_log({"@0 10 0", "@1000 10 127"});
  sut.run_until(Time(9s));
  sut.expect_log({"@2500 10 255"});
  EXPECT_EQ(sut.master.remote(10).seen(), Time(1000ms));
  sut.receive("70A#7F");
  sut.expect_log({"@9000 10 127"});
}

TEST(NmtMaster, LosesNoNodeWithoutATimeOut) {
  MasterNode sut;
  sut.receive("70A#05");
  sut.master.set_time_out(11, 100ms);
  sut.receive("70B#05");
  sut.master.set_time_out(11, 0ms);
  sut.master.set_time_out(0, 100ms);
  sut.master.set_time_out(128, 100ms);
  sut.log.clear();
  sut.run_until(Time(1h));
  sut.expect_log({});
}

TEST(NmtMaster, KnowsNobodyAfterAReset) {
  for (const NmtCommand reset : {NmtCommand::reset_node, NmtCommand::reset_communication}) {
    MasterNode sut;
    sut.master.set_time_out(10, 100ms);
    sut.receive("70A#05");
    sut.log.clear();
    sut.master.command(127, reset);
    EXPECT_EQ(sut.master.remote(10).state(), RemoteState::unknown);
    sut.run_for(1h);
    sut.expect_log({});
    sut.receive("70A#05");
    sut.run_for(100ms);
    EXPECT_EQ(sut.master.remote(10).state(), RemoteState::lost) << "the time-out is kept";
  }
}

TEST(NmtMaster, IgnoresAndCountsWhatIsNoErrorControlMessage) {
  MasterNode sut;
  sut.receive("70A#");
  sut.receive("70A#05 05");
  sut.receive("70A#01");
  EXPECT_EQ(sut.node.counters().malformed, 3U);
  sut.receive("70A#R");
  EXPECT_EQ(sut.node.counters().malformed, 3U);
  sut.expect_log({});
  EXPECT_EQ(sut.master.remote(10).state(), RemoteState::unknown);
}

TEST(NmtMaster, TakesAnAnswerToNodeGuardingWithItsToggleBit) {
  MasterNode sut;
  sut.receive("70A#85");
  sut.receive("70A#05");
  sut.expect_log({"@0 10 5"});
}

}  // namespace
}  // namespace canvoy::nmt_master_test
