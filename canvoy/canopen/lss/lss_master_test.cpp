// LSS master: each service, frame by frame.
#include "canvoy/canopen/lss/lss_master.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/lss/lss_fastscan.hpp"
#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_master_test {
namespace {

using Texts = std::vector<std::string>;
using Outcome = LssMaster::Outcome;

class MasterNode : public WireNode {
 public:
  MasterNode() : WireNode(lss_layout.tables(), node_id_unconfigured), master(node) {}

  LssMaster::Done done() { return LssMaster::Done::to<&MasterNode::note>(*this); }
  void receive(std::string_view frame) { WireNode::receive(lss_frame(frame)); }
  void requests(const Texts& frames) {
    Texts filled;
    for (const std::string& frame : frames) filled.push_back(lss_frame(frame));
    expect(filled);
  }
  std::vector<LssMaster::Reply> take() { return std::exchange(replies_, {}); }
  /// The only reply.
  LssMaster::Reply reply() {
    EXPECT_EQ(replies_.size(), 1U);
    return replies_.empty() ? LssMaster::Reply{} : take().front();
  }

  LssMaster master;

 private:
  void note(const LssMaster::Reply& reply) { replies_.push_back(reply); }
  std::vector<LssMaster::Reply> replies_;
};

TEST(LssMasterSwitch, GlobalHasNoAnswer) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.switch_global(LssState::configuration));
  EXPECT_TRUE(sut.master.switch_global(LssState::waiting));
  sut.requests({"7E5#04 01", "7E5#04 00"});
  EXPECT_TRUE(sut.master.idle());
}

TEST(LssMasterSwitch, SelectiveSendsTheAddressInFourMessages) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.select(lss_address, sut.done()));
  sut.requests(
      {"7E5#40 04 03 02 01", "7E5#41 14 13 12 11", "7E5#42 24 23 22 21", "7E5#43 34 33 32 31"});
  sut.receive("7E4#44");
  EXPECT_EQ(sut.reply().outcome, Outcome::answered);
}

TEST(LssMasterConfigure, NodeIdIsAnsweredWellOrRefused) {
  MasterNode sut;
  sut.master.configure_node_id(0x0A, sut.done());
  sut.receive("7E4#11 00");
  EXPECT_EQ(sut.reply().outcome, Outcome::answered);
  sut.master.configure_node_id(0xFF, sut.done());
  sut.receive("7E4#11 01");
  LssMaster::Reply reply = sut.reply();
  EXPECT_EQ(reply.outcome, Outcome::refused);
  EXPECT_EQ(reply.error, LssError{.code = 1});
  sut.master.configure_node_id(0x7F, sut.done());
  sut.receive("7E4#11 FF 2A");
  reply = sut.reply();
  EXPECT_EQ(reply.outcome, Outcome::refused);
  EXPECT_EQ(reply.error, (LssError{.code = 0xFF, .specific = 0x2A}));
  sut.requests({"7E5#11 0A", "7E5#11 FF", "7E5#11 7F"});
}

TEST(LssMasterConfigure, BitTimingNamesTableAndIndex) {
  MasterNode sut;
  sut.master.configure_bit_timing(3, sut.done());
  sut.receive("7E4#13 00");
  EXPECT_TRUE(sut.reply().ok());
  sut.master.configure_bit_timing(7, sut.done(), 0x80);
  sut.receive("7E4#13 01");
  EXPECT_EQ(sut.reply().error.code, LssError::out_of_range);
  sut.requests({"7E5#13 00 03", "7E5#13 80 07"});
}

TEST(LssMasterConfigure, ActivationHasNoAnswerAnd16BitsOfDelay) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.activate_bit_timing(1s));
  EXPECT_TRUE(sut.master.activate_bit_timing(65'535ms));
  EXPECT_TRUE(sut.master.activate_bit_timing(65'536ms));
  EXPECT_TRUE(sut.master.activate_bit_timing(-1ms));
  sut.requests({"7E5#15 E8 03", "7E5#15 FF FF", "7E5#15 FF FF", "7E5#15 00 00"});
  EXPECT_TRUE(sut.master.idle());
}

TEST(LssMasterConfigure, StoringIsAnsweredWellOrRefused) {
  MasterNode sut;
  for (const auto& [answer, code] :
       {std::pair{"7E4#17 00", 0}, {"7E4#17 01", 1}, {"7E4#17 02", 2}}) {
    sut.master.store(sut.done());
    sut.receive(answer);
    const LssMaster::Reply reply = sut.reply();
    EXPECT_EQ(reply.ok(), code == 0);
    EXPECT_EQ(reply.error.code, code);
  }
  sut.requests({"7E5#17", "7E5#17", "7E5#17"});
}

TEST(LssMasterInquire, EachPartAndTheNodeId) {
  MasterNode sut;
  for (std::size_t part = 0; part < 4; ++part) {
    sut.master.inquire(part, sut.done());
    Frame answer = wire_frame("7E4#5A 78 56 34 12 00 00 00");
    answer.data[0] = static_cast<std::uint8_t>(0x5A + part);
    sut.node.receive(answer, sut.now);
    const LssMaster::Reply reply = sut.reply();
    EXPECT_TRUE(reply.ok());
    EXPECT_EQ(reply.value, 0x1234'5678U);
  }
  sut.master.inquire_node_id(sut.done());
  sut.receive("7E4#5E FF");
  EXPECT_EQ(sut.reply().value, 0xFFU);
  sut.requests({"7E5#5A", "7E5#5B", "7E5#5C", "7E5#5D", "7E5#5E"});
}

TEST(LssMasterIdentify, SendsVendorProductAndTheEndsOfBothRanges) {
  MasterNode sut;
  sut.master.identify({.low = {{1, 2, 3, 5}}, .high = {{9, 9, 4, 0xFFFF'FFFF}}}, sut.done());
  sut.requests(
      {"7E5#46 01", "7E5#47 02", "7E5#48 03", "7E5#49 04", "7E5#4A 05", "7E5#4B FF FF FF FF"});
  sut.receive("7E4#4F");
  EXPECT_TRUE(sut.reply().ok());
  sut.receive("7E4#4F");
  EXPECT_EQ(sut.take().size(), 0U) << "further nodes tell nothing new";
}

TEST(LssMasterIdentify, AsksForNodesWithoutNodeId) {
  MasterNode sut;
  sut.master.identify_unconfigured(sut.done());
  sut.requests({"7E5#4C"});
  sut.receive("7E4#50");
  EXPECT_TRUE(sut.reply().ok());
}

/// Counts the ends of a search.
struct SearchEnd {
  void take(const LssFastscan::Result& /*result*/) { ++calls; }
  int calls = 0;
};

TEST(LssMasterFastscan, OfASearchThatIsStoppedSendsNothingMore) {
  MasterNode sut;
  SearchEnd end;
  LssFastscan search(sut.node, sut.master);
  search.cancel();
  ASSERT_TRUE(search.find({}, LssFastscan::Done::to<&SearchEnd::take>(end)));
  sut.requests({"7E5#51 00 00 00 00 80"});
  EXPECT_FALSE(search.find({}, LssFastscan::Done::to<&SearchEnd::take>(end))) << "one at a time";
  search.cancel();
  EXPECT_FALSE(search.running());
  EXPECT_TRUE(sut.master.idle());
  sut.receive("7E4#4F");
  sut.run_for(10s);
  sut.requests({});
  EXPECT_EQ(end.calls, 0);
  EXPECT_TRUE(search.find({}, LssFastscan::Done::to<&SearchEnd::take>(end)));
  search.cancel();
}

TEST(LssMasterFastscan, SendsNumberBitSubAndNext) {
  MasterNode sut;
  sut.master.fastscan({.id_number = 0x1234'5678, .bit_checked = 5, .sub = 2, .next = 3}, 10ms, {},
                      sut.done());
  sut.requests({"7E5#51 78 56 34 12 05 02 03"});
  sut.run_until(Time(3ms));
  sut.receive("7E4#4F");
  const LssMaster::Reply reply = sut.reply();
  EXPECT_TRUE(reply.ok());
  EXPECT_EQ(reply.last_answer, Duration(3ms));
}

TEST(LssMasterFastscan, MayWaitForAllAnswersAndCountThem) {
  MasterNode sut;
  sut.master.fastscan({}, 10ms, 10ms, sut.done());
  sut.run_until(Time(2ms));
  sut.receive("7E4#4F");
  sut.run_until(Time(7ms));
  sut.receive("7E4#4F");
  EXPECT_EQ(sut.take().size(), 0U);
  sut.run_until(Time(10ms));
  const LssMaster::Reply reply = sut.reply();
  EXPECT_TRUE(reply.ok());
  EXPECT_EQ(reply.answers, 2);
  EXPECT_EQ(reply.first_answer, Duration(2ms));
  EXPECT_EQ(reply.last_answer, Duration(7ms));
}

TEST(LssMasterFastscan, WaitsForSlowerSlavesAfterTheFirstAnswer) {
  MasterNode sut;
  sut.master.fastscan({}, 100ms, 3ms, sut.done());
  sut.run_until(Time(2ms));
  sut.receive("7E4#4F");
  sut.run_until(Time(4ms));
  sut.receive("7E4#4F");
  EXPECT_EQ(sut.take().size(), 0U);
  sut.run_until(Time(5ms));
  EXPECT_EQ(sut.reply().answers, 2);
}

TEST(LssMaster, GivesUpAfterItsTimeOut) {
  MasterNode sut;
  sut.master.inquire_node_id(sut.done());
  sut.run_until(Time(999'999us));
  EXPECT_FALSE(sut.master.idle());
  sut.run_until(Time(1s));
  EXPECT_EQ(sut.reply().outcome, Outcome::time_out);
  EXPECT_TRUE(sut.master.idle());
  sut.master.set_time_out(20ms);
  sut.master.select(lss_address, sut.done());
  sut.run_until(Time(1'020ms));
  EXPECT_EQ(sut.reply().outcome, Outcome::time_out);
  sut.receive("7E4#44");
  EXPECT_EQ(sut.take().size(), 0U) << "too late";
}

TEST(LssMaster, TakesTheAnswerThatBelongsToTheRequestAndNoOther) {
  for (unsigned command = 0; command < 256; ++command) {
    MasterNode sut;
    sut.master.store(sut.done());
    Frame answer = wire_frame("7E4#00 00 00 00 00 00 00 00");
    answer.data[0] = static_cast<std::uint8_t>(command);
    sut.node.receive(answer, sut.now);
    EXPECT_EQ(sut.take().size(), command == 0x17 ? 1U : 0U) << command;
  }
}

TEST(LssMaster, TakesNoAnswerOfAnotherLength) {
  for (std::uint8_t length = 0; length < 8; ++length) {
    MasterNode sut;
    sut.master.store(sut.done());
    Frame answer = wire_frame("7E4#17");
    answer.length = length;
    sut.node.receive(answer, sut.now);
    EXPECT_EQ(sut.take().size(), 0U);
    EXPECT_EQ(sut.node.counters().malformed, 1U);
  }
}

TEST(LssMaster, DoesOneServiceAtATime) {
  MasterNode sut;
  EXPECT_TRUE(sut.master.store(sut.done()));
  EXPECT_FALSE(sut.master.select(lss_address, sut.done()));
  EXPECT_FALSE(sut.master.identify(LssRange::exactly(lss_address), sut.done()));
  EXPECT_FALSE(sut.master.inquire(0, sut.done()));
  EXPECT_FALSE(sut.master.identify_unconfigured(sut.done()));
  EXPECT_FALSE(sut.master.fastscan({}, 1s, {}, sut.done()));
  sut.requests({"7E5#17"});
  sut.master.cancel();
  EXPECT_TRUE(sut.master.idle());
  sut.run_for(5s);
  EXPECT_EQ(sut.take().size(), 0U) << "what was given up is not reported";
}

TEST(LssMaster, MayGoOnFromItsCallback) {
  struct Chain {
    MasterNode sut;
    int steps = 0;
    void next(const LssMaster::Reply&) {
      if (++steps == 3) return;
      EXPECT_TRUE(sut.master.store(LssMaster::Done::to<&Chain::next>(*this)));
    }
  } chain;
  chain.next({});
  chain.sut.receive("7E4#17 00");
  chain.sut.receive("7E4#17 02");
  EXPECT_EQ(chain.steps, 3);
  EXPECT_TRUE(chain.sut.master.idle());
}

/// A node with a controller that delivers the answer in send(), like a loopback or a gateway.
struct PromptNode : private WireMemory {
  PromptNode()
      : WireMemory(lss_layout.tables()),
        node(lss_layout.tables(), spans(), {this, &PromptNode::take, nullptr},
             node_id_unconfigured),
        master(node) {}
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<PromptNode*>(context);
    self.requests.push_back(wire_text(frame));
    if (frame.data[0] == self.answered) {
      self.node.receive(wire_frame(lss_frame(self.answer)), Time{});
    }
    return true;
  }
  void note(const LssMaster::Reply& reply) { replies.push_back(reply); }
  LssMaster::Done done() { return LssMaster::Done::to<&PromptNode::note>(*this); }
  /// `request` is the command specifier of the answered message.
  void answers(std::uint8_t request, std::string frame) {
    answered = request;
    answer = std::move(frame);
    replies.clear();
  }
  void expect_answered() const {
    EXPECT_TRUE(master.idle());
    ASSERT_EQ(replies.size(), 1U);
    EXPECT_EQ(replies[0].outcome, Outcome::answered);
  }

  std::uint8_t answered = 0;
  std::string answer;
  Texts requests;
  std::vector<LssMaster::Reply> replies;
  Node node;
  LssMaster master;
};

TEST(LssMaster, TakesAnAnswerThatComesWhileItSends) {
  PromptNode sut;
  sut.answers(0x17, "7E4#17 00");
  EXPECT_TRUE(sut.master.store(sut.done()));
  sut.expect_answered();
  sut.answers(0x43, "7E4#44");
  EXPECT_TRUE(sut.master.select(lss_address, sut.done()));
  sut.expect_answered();
  sut.answers(0x4B, "7E4#4F");
  EXPECT_TRUE(sut.master.identify(LssRange::exactly(lss_address), sut.done()));
  sut.expect_answered();
  sut.answers(0x51, "7E4#4F");
  EXPECT_TRUE(sut.master.fastscan({}, 10ms, {}, sut.done()));
  sut.expect_answered();
  EXPECT_EQ(sut.requests.size(), 1U + 4U + 6U + 1U);
}

TEST(LssMaster, TakesNoAnswerBeforeItsLastMessage) {
  PromptNode sut;
  sut.answers(0x42, "7E4#44");
  EXPECT_TRUE(sut.master.select(lss_address, sut.done()));
  sut.answers(0x4A, "7E4#4F");
  EXPECT_FALSE(sut.master.idle());
  sut.master.cancel();
  EXPECT_TRUE(sut.master.identify(LssRange::exactly(lss_address), sut.done()));
  EXPECT_FALSE(sut.master.idle());
  EXPECT_EQ(sut.requests.size(), 4U + 6U);
  EXPECT_EQ(sut.replies.size(), 0U);
}

TEST(LssMaster, SaysSoWhereTheControllerTakesNoMore) {
  MasterNode sut;
  sut.full = true;
  int taken = 0;
  while (sut.master.switch_global(LssState::waiting)) ++taken;
  EXPECT_EQ(taken, 16) << "the room of the test's backlog";
  EXPECT_FALSE(sut.master.store(sut.done()));
  EXPECT_FALSE(sut.master.select(lss_address, sut.done()));
  EXPECT_FALSE(sut.master.identify(LssRange::exactly(lss_address), sut.done()));
  EXPECT_FALSE(sut.master.fastscan({}, 1s, {}, sut.done()));
  EXPECT_TRUE(sut.master.idle());
  sut.run_for(5s);
  EXPECT_EQ(sut.take().size(), 0U);
}

}  // namespace
}  // namespace canvoy::lss_master_test
