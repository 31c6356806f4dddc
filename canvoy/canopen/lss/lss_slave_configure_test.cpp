// LSS slave, configuration services: node-ID, bit timing, activation, storing.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_slave_configure_test {
namespace {

using Texts = std::vector<std::string>;

Frame request(std::initializer_list<std::uint8_t> bytes) {
  Frame frame = Frame::data_frame(0x7E5, bytes);
  frame.length = 8;
  return frame;
}

// Node-ID

TEST(LssConfigureNodeId, LetsANodeBootThatHadNone) {
  LssNode node(node_id_unconfigured);
  node.start();
  node.run_until(Time(10s));
  node.answers({});
  node.receive_all({"7E5#04 01", "7E5#11 20"});
  node.answers({"7E4#11 00 00"});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
  node.receive("7E5#04 00");
  node.answers({"@10000000 720#00"});
  EXPECT_EQ(node.node.state(), NmtState::pre_operational);
  EXPECT_EQ(node.node.id(), 0x20);
  EXPECT_EQ(node.node.dictionary().number(0x1014, 0), 0xA0U) << "defaults follow the node-ID";
}

TEST(LssConfigureNodeId, Takes1To127AndFfh) {
  for (unsigned id = 0; id < 256; ++id) {
    LssNode node(5);
    node.in_configuration();
    node.node.receive(request({0x11, static_cast<std::uint8_t>(id)}), node.now);
    const bool good = (id >= 1 && id <= 127) || id == 0xFF;
    node.answers({good ? "7E4#11 00 00" : "7E4#11 01 00"});
    EXPECT_EQ(node.node.pending_id(), good ? id : 5U);
    EXPECT_EQ(node.node.id(), 5);
  }
}

TEST(LssConfigureNodeId, OfANodeThatHasOneCountsFromResetCommunicationOn) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 06", "7E5#04 00"});
  node.answers({"7E4#11 00"});
  node.receive("000#82 05");
  node.answers({"706#00"});
  EXPECT_EQ(node.node.id(), 6);
  node.receive("000#01 05");
  EXPECT_EQ(node.node.state(), NmtState::pre_operational) << "it is node 5 no more";
  node.receive("000#01 06");
  EXPECT_EQ(node.node.state(), NmtState::operational);
}

TEST(LssConfigureNodeId, ThatWasNotStoredIsGoneWithResetNode) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 06", "7E5#04 00", "000#82 00", "000#81 00"});
  node.answers({"7E4#11 00", "706#00", "705#00"});
  EXPECT_EQ(node.node.pending_id(), 5);
}

TEST(LssConfigureNodeId, FfhTakesTheNodeOffTheBusAtResetCommunication) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 FF", "7E5#04 00", "000#82 00"});
  node.answers({"7E4#11 00"});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
  node.receive_all({"000#01 00", "000#82 00", "7E5#4C"});
  node.answers({"7E4#50"});
  node.receive_all({"7E5#04 01", "7E5#11 07", "7E5#04 00"});
  node.answers({"7E4#11 00", "707#00"});
}

TEST(LssConfigureNodeId, MayBeChangedUntilTheConfigurationEnds) {
  LssNode node(node_id_unconfigured);
  node.in_configuration().receive_all({"7E5#11 07", "7E5#11 00", "7E5#11 08", "7E5#04 01"});
  node.answers({"7E4#11 00", "7E4#11 01", "7E4#11 00"});
  node.receive("7E5#04 00");
  node.answers({"708#00"});
}

TEST(LssConfigureNodeId, LeavesANodeInInitialisationThatWasGivenNone) {
  LssNode node(node_id_unconfigured);
  node.in_configuration().receive_all({"7E5#11 80", "7E5#11 FF", "7E5#04 00"});
  node.answers({"7E4#11 01", "7E4#11 00"});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
}

TEST(LssConfigureNodeId, BringsAutostartAndHeartbeatWithIt) {
  LssNode node(node_id_unconfigured);
  node.in_configuration().receive_all({"7E5#11 08", "7E5#04 00"});
  node.sent.clear();
  node.node.dictionary().write(0x1017, 0, std::array<std::uint8_t, 2>{100, 0}, Source::sdo);
  node.run_for(200ms);
  node.answers({"@0 708#7F", "@100000 708#7F", "@200000 708#7F"});
}

// Bit timing

TEST(LssConfigureBitTiming, IsAskedOfTheApplicationForEachIndexOfTheTable) {
  LssNode node(5);
  node.in_configuration();
  for (unsigned table = 0; table < 256; ++table) {
    for (unsigned index = 0; index < 256; ++index) {
      node.node.receive(request({0x13, 0x00, 0x03}), node.now);
      node.sent.clear();
      node.application.take();
      node.node.receive(
          request({0x13, static_cast<std::uint8_t>(table), static_cast<std::uint8_t>(index)}),
          node.now);
      const bool good = table == 0 && index <= 9 && index != 5;
      node.answers({good ? "7E4#13 00 00" : "7E4#13 01 00"});
      EXPECT_EQ(node.application.take(), good ? Texts{"check " + std::to_string(index)} : Texts{});
      EXPECT_EQ(node.lss.pending_bit_timing(), good ? index : 3U);
    }
  }
}

TEST(LssConfigureBitTiming, TellsWhatTheApplicationHasAgainstIt) {
  LssNode node(5);
  node.in_configuration();
  node.application.answer_to_bit_timing = {.code = 1};
  node.receive("7E5#13 00 00");
  node.application.answer_to_bit_timing = {.code = 0xFF, .specific = 0x42};
  node.receive("7E5#13 00 02");
  node.answers({"7E4#13 01 00", "7E4#13 FF 42"});
  EXPECT_EQ(node.lss.pending_bit_timing(), 4);
}

TEST(LssConfigureBitTiming, IsOutOfRangeWhereTheNodeHasOneBitRateOnly) {
  LssNode node(5, lss_address, false);
  node.in_configuration().receive("7E5#13 00 04");
  node.answers({"7E4#13 01 00"});
}

TEST(LssBitTimingTable, HasTheBitRatesOfTableSelector0) {
  const std::uint32_t expected[] = {1'000'000, 800'000, 500'000, 250'000, 125'000,
                                    0,         50'000,  20'000,  10'000,  0};
  for (std::uint8_t index = 0; index < 10; ++index) {
    EXPECT_EQ(lss_bit_timing::bit_rate(index), expected[index]);
    if (expected[index] == 0) continue;
    EXPECT_EQ(lss_bit_timing::index(expected[index]), index);
  }
  EXPECT_EQ(lss_bit_timing::bit_rate(0xFF), 0U);
  for (const std::uint32_t other : {0U, 1U, 100'000U, 125'001U, 4'000'000'000U}) {
    EXPECT_EQ(lss_bit_timing::index(other), lss_bit_timing::unknown);
  }
}

// Activation

struct Hardware {
  explicit Hardware(LssNode& owner)
      : node(owner), bit_timing(owner.node, callback<&Hardware::switch_to>(*this)) {
    node.application.bit_timing = &bit_timing;
  }
  void switch_to(std::uint8_t index) {
    log.push_back("@" + std::to_string(node.now.time_since_epoch().count()) + " " +
                  std::to_string(index));
  }
  LssNode& node;
  BitTimingSwitch bit_timing;
  Texts log;
};

TEST(LssActivateBitTiming, SwitchesBetweenTwoDelaysOfSilence) {
  LssNode node(5);
  Hardware hardware(node);
  node.up();
  node.node.dictionary().write(0x1017, 0, std::array<std::uint8_t, 2>{100, 0}, Source::sdo);
  node.receive_all({"7E5#04 01", "7E5#13 00 02"});
  node.run_until(Time(150ms));
  node.sent.clear();
  node.receive("7E5#15 FA 00");  // 250 ms
  node.run_until(Time(399ms));
  EXPECT_EQ(hardware.log, Texts{});
  EXPECT_TRUE(hardware.bit_timing.running());
  node.run_until(Time(400ms));
  EXPECT_EQ(hardware.log, Texts{"@400000 2"});
  node.run_until(Time(750ms));
  EXPECT_FALSE(hardware.bit_timing.running());
  node.answers({"@700000 705#7F"});
}

TEST(LssActivateBitTiming, HearsNoLssMeanwhile) {
  LssNode node(5);
  Hardware hardware(node);
  node.in_configuration().receive("7E5#15 0A 00");
  node.receive_all({"7E5#5E", "7E5#11 07", "7E5#04 00"});
  node.run_until(Time(15ms));
  node.receive_all({"7E5#5E", "7E5#4C"});
  node.run_until(Time(20ms));
  node.receive("7E5#5E");
  node.answers({"@20000 7E4#5E 05"});
  EXPECT_EQ(node.node.pending_id(), 5);
}

TEST(LssActivateBitTiming, TakesDelaysOf0To65535Ms) {
  for (const auto& [frame, delay] :
       {std::pair{"7E5#15 00 00", 0ms}, {"7E5#15 01 00", 1ms}, {"7E5#15 FF FF", 65'535ms}}) {
    LssNode node(5);
    Hardware hardware(node);
    node.in_configuration().receive(frame);
    node.run_until(Time(3min));
    EXPECT_EQ(hardware.log, Texts{"@" + std::to_string(Duration(delay).count()) + " 4"});
    EXPECT_FALSE(node.node.transmitter().muted());
    node.answers({});
  }
}

TEST(LssActivateBitTiming, StartsAnewWhenItComesAgain) {
  LssNode node(5);
  Hardware hardware(node);
  node.up();
  hardware.bit_timing.activate(2, 10ms);
  node.run_until(Time(5ms));
  node.node.advance(node.now);
  hardware.bit_timing.activate(3, 10ms);
  node.run_until(Time(1s));
  EXPECT_EQ(hardware.log, Texts{"@15000 3"});
  EXPECT_FALSE(node.node.transmitter().muted());
}

TEST(LssActivateBitTiming, LetsOutWhatWaitedBeforeAndDropsWhatWaitsAtTheSwitch) {
  LssNode node(5);
  Hardware hardware(node);
  node.up();
  node.full = true;
  node.node.transmitter().send(wire_frame("185#01"));
  hardware.bit_timing.activate(2, 10ms);
  node.full = false;
  node.node.tx_ready(node.now);
  node.answers({"185#01"});
  node.full = true;
  node.run_until(Time(25ms));
  node.node.advance(node.now);
  node.node.transmitter().send(wire_frame("185#02"));
  hardware.bit_timing.activate(2, 10ms);
  node.run_until(Time(1s));
  node.full = false;
  node.node.tx_ready(node.now);
  node.answers({});
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
}

TEST(LssActivateBitTiming, IsIgnoredWhereTheApplicationCannot) {
  LssNode node(5, lss_address, false);
  node.in_configuration().receive("7E5#15 0A 00");
  node.receive("7E5#5E");
  node.answers({"7E4#5E 05"});
}

TEST(LssActivateBitTiming, DoesNothingWhereTheBitTimingIsUnknownUntilOneIsConfigured) {
  LssNode node(5, lss_address, true, lss_bit_timing::unknown);
  Hardware hardware(node);
  node.in_configuration().receive("7E5#15 0A 00");
  EXPECT_EQ(node.application.take(), Texts{});
  EXPECT_FALSE(hardware.bit_timing.running());
  node.run_until(Time(1s));
  EXPECT_EQ(hardware.log, Texts{});
  node.receive_all({"7E5#5E", "7E5#13 00 02", "7E5#15 0A 00"});
  node.answers({"7E4#5E 05", "7E4#13 00 00"});
  node.run_until(Time(2s));
  EXPECT_EQ(hardware.log, Texts{"@1010000 2"});
}

// Storing

TEST(LssStore, IsAnsweredWhenTheApplicationHasDoneIt) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 06", "7E5#13 00 03", "7E5#17"});
  EXPECT_EQ(node.application.take(), Texts({"check 3", "store 6, 3"}));
  node.answers({"7E4#11 00", "7E4#13 00"});
  node.run_until(Time(40ms));
  node.receive("7E5#5E");
  node.answers({"@40000 7E4#5E 05"});  // nothing is blocked meanwhile
  node.lss.stored({});
  node.answers({"@40000 7E4#17 00 00"});
}

TEST(LssStore, MakesTheNodeIdThatOfResetNode) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 06", "7E5#17"});
  node.lss.stored({});
  node.receive_all({"7E5#11 07", "7E5#04 00", "000#82 00", "000#81 00"});
  node.answers({"7E4#11 00", "7E4#17 00", "7E4#11 00", "707#00", "706#00"});
}

TEST(LssStore, ThatFailedChangesNothing) {
  for (const auto& [error, answer] : {std::pair{LssError{.code = 2}, "7E4#17 02 00"},
                                      {LssError{.code = 0xFF, .specific = 0x17}, "7E4#17 FF 17"}}) {
    LssNode node(5);
    node.in_configuration().receive_all({"7E5#11 06", "7E5#17"});
    node.lss.stored(error);
    node.receive("000#81 00");
    node.answers({"7E4#11 00", answer, "705#00"});
  }
}

TEST(LssStore, IsNotSupportedWithoutAnApplicationThatDoesIt) {
  LssNode node(5, lss_address, false);
  node.in_configuration().receive("7E5#17");
  node.answers({"7E4#17 01 00"});
}

// Their code is not even linked then.
TEST(LssWithoutAnApplication, RefusesBitTimingsAndStoringAndIgnoresActivation) {
  WireNode node(lss_layout.tables(), 5);
  const LssSlave lss(node.node);
  node.boot();
  for (const char* frame : {"7E5#04 01", "7E5#13 00 04", "7E5#15 0A 00", "7E5#17", "7E5#11 20"}) {
    node.receive(lss_frame(frame));
  }
  node.expect({lss_frame("7E4#13 01"), lss_frame("7E4#17 01"), lss_frame("7E4#11 00")});
  EXPECT_EQ(lss.state(), LssState::configuration);
  EXPECT_EQ(lss.pending_bit_timing(), lss_bit_timing::unknown);
}

TEST(LssStore, IsNotBegunTwice) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#17", "7E5#17"});
  EXPECT_EQ(node.application.take(), Texts{"store 5, 4"});
  node.lss.stored({});
  node.lss.stored({});
  node.answers({"7E4#17 00"});
  node.receive("7E5#17");
  EXPECT_EQ(node.application.take(), Texts{"store 5, 4"});
}

TEST(LssStore, ThatEndsAfterAResetIsKeptButNotAnswered) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 06", "7E5#17", "000#82 00"});
  node.answers({"7E4#11 00", "706#00"});
  node.lss.stored({});
  node.answers({});
  node.receive("000#81 00");
  node.answers({"706#00"});
}

TEST(LssStore, OfNoNodeIdMakesTheNodeWaitForOneAfterResetNode) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#11 FF", "7E5#17"});
  node.lss.stored({});
  node.receive("000#81 00");
  node.answers({"7E4#11 00", "7E4#17 00"});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
}

}  // namespace
}  // namespace canvoy::lss_slave_configure_test
