// LSS slave: every command specifier in every state, every length, each flipped bit.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_slave_exhaustive_test {
namespace {

using Texts = std::vector<std::string>;

/// Expected first bytes of an answer, or nothing if the slave is silent, for a request of zeros
/// after the command specifier.
std::string expected_answer(unsigned command, LssState state, bool unconfigured) {
  const bool here = state == LssState::configuration;
  switch (command) {
    case 0x11:
      return here ? "7E4#11 01" : "";
    case 0x13:
      return here ? "7E4#13 00" : "";
    case 0x5A:
      return here ? "7E4#5A 04 03 02 01" : "";
    case 0x5B:
      return here ? "7E4#5B 14 13 12 11" : "";
    case 0x5C:
      return here ? "7E4#5C 24 23 22 21" : "";
    case 0x5D:
      return here ? "7E4#5D 34 33 32 31" : "";
    case 0x5E:
      return here ? (unconfigured ? "7E4#5E FF" : "7E4#5E 05") : "";
    case 0x4C:
      return unconfigured ? "7E4#50" : "";
    default:  // also parts of a sequence of messages, and store, which waits
      return "";
  }
}

bool is_known(unsigned command) {
  return command == 0x04 || command == 0x11 || command == 0x13 || command == 0x15 ||
         command == 0x17 || (command >= 0x40 && command <= 0x43) ||
         (command >= 0x46 && command <= 0x4C) || command == 0x51 ||
         (command >= 0x5A && command <= 0x5E);
}

/// A node in this NMT state: initialisation means without node-ID.
void bring_to(LssNode& node, NmtState nmt_state, LssState lss_state) {
  node.boot();
  if (nmt_state == NmtState::operational) node.receive("000#01 00");
  if (nmt_state == NmtState::stopped) node.receive("000#02 00");
  ASSERT_EQ(node.node.state(), nmt_state);
  node.receive(lss_state == LssState::waiting ? "7E5#04 00" : "7E5#04 01");
  node.sent.clear();
}

constexpr NmtState nmt_states[] = {NmtState::initialisation, NmtState::pre_operational,
                                   NmtState::operational, NmtState::stopped};
constexpr LssState lss_states[] = {LssState::waiting, LssState::configuration};

NodeId id_in(NmtState state) {
  return state == NmtState::initialisation ? node_id_unconfigured : NodeId{5};
}

TEST(LssSlaveExhaustive, AnswersEachCommandInEachLssStateAndNmtState) {
  for (const NmtState nmt_state : nmt_states) {
    for (const LssState lss_state : lss_states) {
      for (unsigned command = 0; command < 256; ++command) {
        LssNode node(id_in(nmt_state));
        bring_to(node, nmt_state, lss_state);
        Frame frame = wire_frame(lss_frame("7E5#00"));
        frame.data[0] = static_cast<std::uint8_t>(command);
        node.node.receive(frame, node.now);
        std::string answer =
            expected_answer(command, lss_state, nmt_state == NmtState::initialisation);
        const bool scan_from_the_start = command == 0x51 && lss_state == LssState::waiting &&
                                         nmt_state == NmtState::initialisation;
        EXPECT_FALSE(scan_from_the_start && !node.sent.empty()) << "vendor-ID 0 is not ours";
        node.answers(answer.empty() ? Texts{} : Texts{answer});
        EXPECT_EQ(node.node.counters().malformed, is_known(command) ? 0U : 1U) << command;
        EXPECT_EQ(node.node.state(), nmt_state);
        const LssState after = command == 0x04 ? LssState::waiting : lss_state;
        EXPECT_EQ(node.lss.state(), after) << command;
      }
    }
  }
}

TEST(LssSlaveExhaustive, TakesNoOtherLengthThanEightBytes) {
  for (const LssState lss_state : lss_states) {
    for (unsigned command = 0; command < 256; ++command) {
      for (std::uint8_t length = 0; length < 8; ++length) {
        LssNode node(node_id_unconfigured);
        bring_to(node, NmtState::initialisation, lss_state);
        Frame frame = wire_frame("7E5#00 01");
        frame.data[0] = static_cast<std::uint8_t>(command);
        frame.length = length;
        node.node.receive(frame, node.now);
        node.answers({});
        EXPECT_EQ(node.node.counters().malformed, 1U);
        EXPECT_EQ(node.lss.state(), lss_state);
        EXPECT_EQ(node.node.pending_id(), node_id_unconfigured);
      }
    }
  }
}

TEST(LssSlaveExhaustive, HearsDataFramesOf7e5hAlone) {
  LssNode node(node_id_unconfigured);
  node.boot();
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    if (id == 0x7E5) continue;
    Frame frame = wire_frame("000#04 01 00 00 00 00 00 00");
    frame.id = id;
    node.node.receive(frame, node.now);
    ASSERT_EQ(node.lss.state(), LssState::waiting) << id;
  }
  node.node.receive(wire_frame("7E5#R8"), node.now);
  node.node.receive(wire_frame("000007E5#04 01 00 00 00 00 00 00"), node.now);
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.answers({});
}

const Texts golden = {"7E5#04 01",
                      "7E5#04 00",
                      "7E5#40 04 03 02 01",
                      "7E5#41 14 13 12 11",
                      "7E5#42 24 23 22 21",
                      "7E5#43 34 33 32 31",
                      "7E5#11 0A",
                      "7E5#13 00 02",
                      "7E5#15 E8 03",
                      "7E5#17",
                      "7E5#5A",
                      "7E5#5E",
                      "7E5#46 04 03 02 01",
                      "7E5#4B 34 33 32 31",
                      "7E5#4C",
                      "7E5#51 00 00 00 00 80 00 00"};

TEST(LssSlaveExhaustive, LivesOnAfterEachFlippedBitOfEachGoldenFrame) {
  for (const NodeId id : {NodeId{5}, node_id_unconfigured}) {
    for (const LssState lss_state : lss_states) {
      for (const std::string& text : golden) {
        for (unsigned bit = 0; bit < 64; ++bit) {
          LssNode node(id);
          bring_to(node, id == 5 ? NmtState::pre_operational : NmtState::initialisation, lss_state);
          Frame frame = wire_frame(lss_frame(text));
          frame.data[bit / 8] = static_cast<std::uint8_t>(frame.data[bit / 8] ^ 1U << bit % 8);
          node.node.receive(frame, node.now);
          ASSERT_LE(node.sent.size(), 1U) << "one answer at most, or a boot-up message";
          for (const auto& sent : node.sent) ASSERT_EQ(sent.frame.id, 0x7E4U);
          node.run_for(3min);
          node.lss.stored({});
          // From any state it returns to waiting, and can be configured.
          node.sent.clear();
          node.receive_all({"7E5#04 01", "7E5#11 21", "7E5#5A"});
          node.answers({"7E4#11 00", "7E4#5A 04 03 02 01"});
          node.receive_all({"7E5#04 00", "000#82 00"});
          ASSERT_FALSE(node.sent.empty());
          ASSERT_EQ(wire_text(node.sent.back().frame), "721#00") << text << " bit " << bit;
        }
      }
    }
  }
}

TEST(LssSlaveExhaustive, SaysNothingButLssWhileItHasNoNodeId) {
  LssNode node(node_id_unconfigured);
  node.boot();
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    for (std::uint8_t length = 0; length <= 8; ++length) {
      Frame frame = wire_frame("000#81 00 00 00 00 00 00 00");
      frame.id = id;
      frame.length = length;
      node.node.receive(frame, node.now);
    }
  }
  node.node.bus_state(BusState::bus_off, node.now);
  node.node.bus_state(BusState::error_active, node.now);
  node.node.overrun(node.now);
  node.run_for(1h);
  node.answers({});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
}

}  // namespace
}  // namespace canvoy::lss_slave_exhaustive_test
