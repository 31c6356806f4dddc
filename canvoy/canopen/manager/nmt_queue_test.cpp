// NMT commands of a master: order, NMT inhibit time (CiA 301, 102Ah), full controllers.
#include "canvoy/canopen/manager/nmt_queue.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"
#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/canopen/testing/prompt_bus.hpp"

namespace canvoy::nmt_queue_test {
namespace {

/// Node 127, which is no master by 1F80h.
struct QueueingNode : BootNetwork {
  explicit QueueingNode(std::uint32_t inhibit = 0) {
    startup(0);
    stored.store(0x102A, 0, inhibit);
    start();
    forget();
  }
  void add(NodeId slave, NmtCommand command, bool spares_master = false) {
    node.advance(now);
    EXPECT_TRUE(commands.add({slave, command, spares_master}));
  }
};

TEST(NmtQueue, SendsEachCommandAtOnceWithoutAnInhibitTime) {
  QueueingNode sut;
  for (const NmtCommand command :
       {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
        NmtCommand::reset_node, NmtCommand::reset_communication}) {
    EXPECT_TRUE(sut.commands.add({10, command}));
  }
  sut.expect({});
  sut.settle();
  sut.expect({"000#01 0A", "000#02 0A", "000#80 0A", "000#81 0A", "000#82 0A"});
}

TEST(NmtQueue, KeepsTheInhibitTimeBetweenTwoCommands) {
  QueueingNode sut(25);
  for (NodeId slave = 1; slave <= 3; ++slave) sut.add(slave, NmtCommand::start);
  sut.run_until(Time(3ms));
  sut.add(4, NmtCommand::start);
  sut.run_until(Time(20ms));
  sut.add(5, NmtCommand::start);
  sut.run_until(Time(21ms));
  sut.add(6, NmtCommand::start);
  sut.run_until(Time(1s));
  sut.expect({"@0 000#01 01", "@2500 000#01 02", "@5000 000#01 03", "@7500 000#01 04",
              "@20000 000#01 05", "@22500 000#01 06"});
}

TEST(NmtQueue, IsSentToAllAndObeyedByTheMasterUnlessItIsSpared) {
  QueueingNode sut;
  sut.add(0, NmtCommand::start, true);
  sut.settle();
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  sut.add(0, NmtCommand::start);
  sut.settle();
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.add(0, NmtCommand::reset_communication);
  sut.settle();
  sut.expect({"000#01 00", "000#01 00", "000#82 00", "77F#00"});
}

TEST(NmtQueue, SendsNoFrameToTheMasterItselfAndWaitsForNone) {
  QueueingNode sut(10000);
  sut.add(10, NmtCommand::start);
  sut.settle();
  sut.add(127, NmtCommand::start);
  sut.run_until(Time(1s));
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.expect({"000#01 0A"});
}

TEST(NmtQueue, ForgetsWhatWaitsWhenTheMasterIsReset) {
  QueueingNode sut;
  EXPECT_TRUE(sut.commands.add({0, NmtCommand::reset_node}));
  EXPECT_TRUE(sut.commands.add({10, NmtCommand::start}));
  sut.run_for(1s);
  sut.expect({"000#81 00", "77F#00"});
  EXPECT_TRUE(sut.commands.empty());
}

TEST(NmtQueue, WaitsForTheControllerAndLosesNothing) {
  QueueingNode sut;
  sut.full = true;
  for (NodeId slave = 1; slave <= 40; ++slave) sut.add(slave, NmtCommand::start);
  sut.run_until(Time(1s));
  sut.expect({});
  sut.full = false;
  sut.node.tx_ready(sut.now);
  sut.settle();
  ASSERT_EQ(sut.sent.size(), 40U);
  for (NodeId slave = 1; slave <= 40; ++slave) {
    EXPECT_EQ(sut.sent[slave - 1U].frame.data[1], slave);
  }
  EXPECT_EQ(sut.node.transmitter().lost(), 0U);
}

TEST(NmtQueue, SaysWhenItHasNoRoom) {
  QueueingNode sut;
  for (int i = 0; i < 128; ++i) EXPECT_TRUE(sut.commands.add({10, NmtCommand::start}));
  EXPECT_FALSE(sut.commands.add({10, NmtCommand::start}));
  sut.settle();
  EXPECT_EQ(sut.sent.size(), 128U);
  EXPECT_TRUE(sut.commands.add({10, NmtCommand::start}));
}

TEST(NmtQueue, RefusesWhatIsNoNode) {
  QueueingNode sut;
  for (unsigned id = 128; id <= 255; ++id) {
    EXPECT_FALSE(sut.commands.add({static_cast<NodeId>(id), NmtCommand::start}));
  }
  sut.settle();
  sut.expect({});
}

/// Another master answers the first command at once: waiting commands are discarded.
TEST(NmtQueue, IsEmptyWhereItsNodeIsResetWhileACommandLeaves) {
  PromptBus bus(dynamic_sdo_manager(), 1);
  std::array<NmtQueue::Request, 4> memory;
  NmtQueue sut(bus.node, memory);
  bus.sent.clear();
  bus.answers = [](const Frame& frame) -> std::optional<Frame> {
    if (frame.id != 0) return std::nullopt;
    return wire_frame("000#82 01");
  };
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{7}}) {
    EXPECT_TRUE(sut.add({slave, NmtCommand::start}));
  }
  bus.run_for(Duration::zero());
  EXPECT_EQ(bus.sent, (std::vector<std::string>{"000#01 05", "701#00"}));
  EXPECT_TRUE(sut.empty());
}

}  // namespace
}  // namespace canvoy::nmt_queue_test
