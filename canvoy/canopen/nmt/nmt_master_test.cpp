#include "canvoy/canopen/nmt/nmt_master.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::nmt_master_test {
namespace {

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
                                std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct MasterNode : WireNode {
  MasterNode() : WireNode(layout.tables(), 127), master(node, nodes) {
    master.on_change(Callback<void(NodeId, RemoteState)>::to<&MasterNode::changed>(*this));
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

constexpr NmtCommand commands[] = {NmtCommand::start, NmtCommand::stop,
                                   NmtCommand::enter_pre_operational, NmtCommand::reset_node,
                                   NmtCommand::reset_communication};

TEST(NmtMaster, commands_one_node) {
  MasterNode sut;
  for (const NmtCommand command : commands) EXPECT_TRUE(sut.master.command(10, command));
  sut.expect({"000#01 0A", "000#02 0A", "000#80 0A", "000#81 0A", "000#82 0A"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(NmtMaster, commands_every_node_id_and_no_other) {
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

TEST(NmtMaster, obeys_itself_when_all_are_meant) {
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

TEST(NmtMaster, obeys_itself_without_a_frame_when_it_is_meant_alone) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.command(127, NmtCommand::start));
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.expect({});
}

TEST(NmtMaster, says_when_a_command_could_not_be_sent_and_does_not_obey_it_then) {
  MasterNode sut;
  sut.full = true;
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(sut.master.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.master.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.master.command(NmtMaster::all_nodes, NmtCommand::start));
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(NmtMaster, does_not_command_before_its_own_boot_up) {
  WireNode wire(layout.tables(), 127);
  NmtMaster::RemoteNode nodes[127];
  NmtMaster sut(wire.node, nodes);
  EXPECT_FALSE(sut.command(10, NmtCommand::start));
  EXPECT_FALSE(sut.command(NmtMaster::all_nodes, NmtCommand::start));
  wire.expect({});
}

TEST(NmtMaster, knows_the_states_of_the_others) {
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

TEST(NmtMaster, hears_all_of_the_127_nodes) {
  MasterNode sut;
  for (unsigned node_id = 1; node_id <= 127; ++node_id) {
    sut.node.receive(Frame::data_frame(0x700 + node_id, {0x05}), sut.now);
  }
  ASSERT_EQ(sut.log.size(), 127U);
  EXPECT_EQ(sut.log.front(), "@0 1 5");
  EXPECT_EQ(sut.log.back(), "@0 127 5");
}

TEST(NmtMaster, reports_each_boot_up) {
  MasterNode sut;
  sut.receive("70A#00");
  sut.receive("70A#00");
  sut.expect_log({"@0 10 0", "@0 10 0"});
}

TEST(NmtMaster, reports_each_message_before_the_change_that_it_brings) {
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

TEST(NmtMaster, takes_a_time_out_that_is_set_from_a_message_at_once) {
  MasterNode sut;
  auto watch = [&sut](NodeId node_id, RemoteState) { sut.master.set_time_out(node_id, 100ms); };
  sut.master.on_message(Callback<void(NodeId, RemoteState)>::of(watch));
  sut.receive("70A#05");
  sut.run_until(Time(1s));
  sut.expect_log({"@0 10 5", "@100 10 255"});
}

TEST(NmtMaster, loses_a_node_after_its_time_out_and_finds_it_again) {
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

TEST(NmtMaster, loses_no_node_without_a_time_out) {
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

TEST(NmtMaster, knows_nobody_after_a_reset) {
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

TEST(NmtMaster, ignores_and_counts_what_is_no_error_control_message) {
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

TEST(NmtMaster, takes_an_answer_to_node_guarding_with_its_toggle_bit) {
  MasterNode sut;
  sut.receive("70A#85");
  sut.receive("70A#05");
  sut.expect_log({"@0 10 5"});
}

}  // namespace
}  // namespace canvoy::nmt_master_test
