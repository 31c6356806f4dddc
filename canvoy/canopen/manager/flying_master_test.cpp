// Flying master, alone on the wire with the test: detection, negotiation by priority and node-ID,
// force, loss of the active master (CiA 302-2; 1F90h, CAN-IDs 071h to 076h).
#include "canvoy/canopen/manager/flying_master.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "canvoy/canopen/testing/bit_flips.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::flying_master_test {
namespace {

/// Node 5 with priority 1 and the default times.
struct FlyingNode : BootNetwork {
  explicit FlyingNode(const FlyingMaster::Options& options = {}, std::uint32_t startup_bits = 0x21)
      : BootNetwork(2, {}, 5), flying(node, commands, manager, options) {
    flying.on_change(callback<&FlyingNode::changed>(*this));
    const std::uint32_t timing[] = {100, 500, 1, 1500, 10, 4000};
    for (std::uint8_t sub = 1; sub <= 6; ++sub) stored.store(0x1F90, sub, timing[sub - 1]);
    stored.store(0x1F91, 1, 100);
    startup(startup_bits);
  }
  void changed(FlyingMaster::State state) {
    static constexpr const char* words[] = {"off",         "waiting", "detecting",
                                            "negotiating", "master",  "slave"};
    roles.push_back(words[static_cast<unsigned>(state)]);
  }
  /// Up to the first negotiation, which begins at 1300 ms.
  void negotiate() {
    start();
    run_until(Time(1300ms));
    sent.clear();
  }
  /// Active master since 1300 + 1500 + 5 x 10 ms.
  void win() {
    negotiate();
    run_until(Time(2850ms));
    forget();
    roles.clear();
  }
  void follow() {
    start();
    run_until(Time(500ms));
    receive("071#00 0A");
    forget();
    roles.clear();
  }

  std::vector<std::string> roles;
  FlyingMaster flying;
};

TEST(FlyingMaster, ResetsAllOnceAndNegotiatesWhereThereIsNoMaster) {
  FlyingNode sut;
  sut.start();
  sut.run_until(Time(2850ms));
  sut.expect({"@0 705#00", "@550000 073#", "@650000 000#82 00", "@650000 705#00", "@1200000 073#",
              "@1300000 072#", "@2850000 071#01 05", "@2850000 000#82 00"});
  EXPECT_EQ(sut.roles, (std::vector<std::string>{"waiting", "detecting", "off", "waiting",
                                                 "detecting", "negotiating", "master"}));
  EXPECT_EQ(sut.manager.network(), NetworkBoot::complete);
  EXPECT_EQ(sut.flying.active_master(), 5);
}

TEST(FlyingMaster, NegotiatesAtOnceWhereAllNeedNotBeReset) {
  FlyingNode sut({.resets_all = false});
  sut.start();
  sut.run_until(Time(650ms));
  sut.expect({"@0 705#00", "@550000 073#", "@650000 072#"});
}

TEST(FlyingMaster, WaitsForItsSlotByPriorityAndNodeId) {
  for (const std::uint32_t priority : {0U, 1U, 2U}) {
    FlyingNode sut;
    sut.stored.store(0x1F90, 3, priority);
    sut.negotiate();
    const auto slot = std::chrono::milliseconds(1500 * priority + 50);
    sut.run_until(Time(1300ms + slot - 1us));
    sut.expect({});
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::negotiating);
    sut.run_until(Time(1300ms + slot));
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::master);
  }
}

TEST(FlyingMaster, BecomesASlaveWhenAnActiveMasterAnswers) {
  for (const char* answer : {"071#00 0A", "071#00 01", "071#01 01", "071#01 0A"}) {
    FlyingNode sut;
    sut.start();
    sut.run_until(Time(600ms));
    sut.receive(answer);
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::slave) << answer;
    EXPECT_EQ(sut.flying.active_master(), answer[8] == 'A' ? 10 : 1);
    sut.sent.clear();
    sut.run_until(Time(1h));
    sut.expect({});
    EXPECT_FALSE(sut.manager.is_active());
  }
}

TEST(FlyingMaster, ForcesANegotiationOnAMasterOfLowerPriority) {
  FlyingNode sut;
  sut.start();
  sut.run_until(Time(600ms));
  sut.sent.clear();
  sut.receive("071#02 01");
  sut.expect({"076#"});
  EXPECT_EQ(sut.flying.state(), FlyingMaster::State::negotiating);
}

TEST(FlyingMaster, ForcesANegotiationByItsNodeIdWhereThatIsWanted) {
  FlyingNode sut({.node_id_forces = true});
  sut.start();
  sut.run_until(Time(600ms));
  sut.sent.clear();
  sut.receive("071#01 06");
  sut.expect({"076#"});
  sut.receive("071#01 04");
  EXPECT_EQ(sut.flying.state(), FlyingMaster::State::slave);
}

TEST(FlyingMaster, GivesWayToWhoWasFirstInTheNegotiation) {
  FlyingNode sut;
  sut.negotiate();
  sut.run_until(Time(2s));
  sut.receive("071#01 03");
  EXPECT_EQ(sut.flying.state(), FlyingMaster::State::slave);
  sut.run_until(Time(1h));
  sut.expect({});
}

TEST(FlyingMaster, BeginsToCountWhenAnotherOneCalls) {
  FlyingNode sut;
  sut.start();
  sut.run_until(Time(200ms));
  sut.sent.clear();
  sut.receive("072#");
  sut.expect({});
  sut.run_until(Time(1750ms));
  sut.expect({"@1750000 071#01 05", "@1750000 000#82 00"});
}

TEST(FlyingMaster, AnswersAsTheActiveMasterOnly) {
  FlyingNode master;
  master.win();
  master.receive("073#");
  master.expect({"071#01 05"});
  FlyingNode slave;
  slave.follow();
  slave.receive("073#");
  slave.expect({});
}

TEST(FlyingMaster, LooksForOtherMastersInACycle) {
  FlyingNode sut;
  sut.win();
  sut.run_until(Time(11s));
  sut.expect({"@6850000 076#", "@10850000 076#"});
  FlyingNode quiet;
  quiet.stored.store(0x1F90, 6, 0);
  quiet.win();
  quiet.run_until(Time(1h));
  quiet.expect({});
}

TEST(FlyingMaster, NegotiatesAnewWhenItIsForced) {
  FlyingNode sut;
  sut.win();
  sut.receive("076#");
  sut.expect({"072#"});
  EXPECT_EQ(sut.flying.state(), FlyingMaster::State::negotiating);
  EXPECT_FALSE(sut.manager.is_active());
  FlyingNode slave;
  slave.follow();
  slave.receive("076#");
  slave.expect({});
  EXPECT_EQ(slave.flying.state(), FlyingMaster::State::slave);
}

TEST(FlyingMaster, ThatMeetsAnotherOneGivesWayByPriorityAndThenByNodeId) {
  struct Meeting {
    const char* other;
    bool gives_way;
  };
  for (const Meeting& meeting : {Meeting{"071#00 7F", true}, Meeting{"071#01 04", true},
                                 Meeting{"071#01 06", false}, Meeting{"071#02 01", false}}) {
    FlyingNode sut;
    sut.win();
    sut.receive(meeting.other);
    EXPECT_EQ(sut.flying.state(),
              meeting.gives_way ? FlyingMaster::State::slave : FlyingMaster::State::negotiating)
        << meeting.other;
    sut.expect(meeting.gives_way ? std::vector<std::string>{} : std::vector<std::string>{"076#"});
  }
}

TEST(FlyingMaster, ResetsAllWhenTheActiveMasterIsLostAndNegotiates) {
  FlyingNode sut;
  sut.follow();
  sut.node.raise({.code = 0x8130, .instance = 10, .register_bits = 0x10});
  sut.run_until(Time(1200ms));
  sut.expect({"@550000 000#82 00", "@550000 705#00", "@1100000 073#", "@1200000 072#"});
}

TEST(FlyingMaster, TakesALifeGuardingEventForTheLossOfTheMaster) {
  FlyingNode sut;
  sut.follow();
  sut.node.raise({.code = 0x8130, .instance = 0, .register_bits = 0x10});
  sut.run_until(Time(550ms));
  sut.expect({"@550000 000#82 00", "@550000 705#00"});
}

/// Node 5 waits for its slot, 5 x 10 ms (1F90h:05h), from the loss.
TEST(FlyingMaster, StaysASlaveWhereTheActiveMasterIsHeardAgainBeforeItsSlot) {
  for (const std::uint8_t instance : {std::uint8_t{10}, std::uint8_t{0}}) {
    const Error loss = {.code = 0x8130, .instance = instance, .register_bits = 0x10};
    FlyingNode sut;
    sut.follow();
    sut.node.raise(loss);
    sut.run_until(Time(549ms));
    sut.node.clear(loss);
    sut.run_until(Time(1h));
    sut.expect({});
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::slave);
    EXPECT_EQ(sut.flying.active_master(), 10);
    sut.node.advance(Time(1h));
    sut.node.raise(loss);
    sut.run_until(Time(1h + 50ms));
    sut.expect({"@3600050000 000#82 00", "@3600050000 705#00"});
  }
}

TEST(FlyingMaster, TheReturnOfAnotherNodeBringsNoActiveMasterBack) {
  FlyingNode sut;
  sut.follow();
  sut.node.raise({.code = 0x8130, .instance = 11, .register_bits = 0x10});
  sut.node.raise({.code = 0x8130, .instance = 10, .register_bits = 0x10});
  sut.node.clear({.code = 0x8130, .instance = 11, .register_bits = 0x10});
  sut.run_until(Time(550ms));
  sut.expect({"@550000 000#82 00", "@550000 705#00"});
}

TEST(FlyingMaster, DoesNotCareForTheLossOfOthers) {
  FlyingNode sut;
  sut.follow();
  sut.node.raise({.code = 0x8130, .instance = 11, .register_bits = 0x10});
  sut.node.raise({.code = 0x8110, .instance = 10, .register_bits = 0x10});
  sut.run_until(Time(1h));
  sut.expect({});
}

TEST(FlyingMaster, IsOffWithoutBits0And5Of1F80h) {
  for (const std::uint32_t bits : {0x00U, 0x20U, 0x01U}) {
    FlyingNode sut({}, bits);
    sut.start();
    sut.forget();
    for (const char* frame : {"071#00 0A", "072#", "073#", "076#"}) sut.receive(frame);
    sut.run_until(Time(1h));
    sut.expect({});
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::off);
  }
}

TEST(FlyingMaster, ThatMayBeMasterNoMoreHasNothingLeftToDoAfterAReset) {
  FlyingNode sut;
  sut.win();
  sut.startup(0x20);
  sut.receive("000#82 05");
  EXPECT_EQ(sut.flying.state(), FlyingMaster::State::off);
  EXPECT_EQ(sut.node.deadline(), never);
}

TEST(FlyingMaster, SaysThatItMayBeMasterWhereItIsAsked) {
  FlyingNode sut({}, 0x01);
  sut.start();
  sut.forget();
  sut.receive("075#");
  sut.expect({"074#"});
  FlyingNode other({}, 0x00);
  other.start();
  other.forget();
  other.receive("075#");
  other.expect({});
}

TEST(FlyingMaster, FindsDevicesThatMayBeMaster) {
  FlyingNode sut;
  sut.follow();
  std::vector<bool> found;
  auto note = [&found](bool is_one) { found.push_back(is_one); };
  sut.flying.find_capable(Callback<void(bool)>::of(note));
  sut.expect({"075#"});
  sut.receive("074#");
  sut.receive("074#");
  sut.run_for(100ms);
  sut.receive("074#");
  EXPECT_EQ(found, (std::vector<bool>{true, true, false}));
}

TEST(FlyingMaster, IgnoresAndCountsWhatHasAnotherLength) {
  for (unsigned id = 0x071; id <= 0x076; ++id) {
    for (std::uint8_t length = 0; length <= 8; ++length) {
      if (length == (id == 0x071 ? 2 : 0)) continue;
      FlyingNode sut;
      sut.win();
      Frame frame = Frame::data_frame(id, {});
      frame.length = length;
      sut.node.receive(frame, sut.now);
      sut.settle();
      sut.expect({});
      EXPECT_EQ(sut.flying.state(), FlyingMaster::State::master);
      EXPECT_EQ(sut.node.counters().malformed, 1U);
    }
  }
  for (const char* frame : {"071#00 00", "071#00 80", "071#00 FF"}) {
    FlyingNode sut;
    sut.win();
    sut.receive(frame);
    EXPECT_EQ(sut.flying.state(), FlyingMaster::State::master);
    EXPECT_EQ(sut.node.counters().malformed, 1U);
  }
}

/// Whatever the frame was taken for, it soon is master or slave, and master without other
/// competitors.
void expect_to_live_on(FlyingNode& sut) {
  sut.run_for(1min);
  const bool is_master = sut.flying.state() == FlyingMaster::State::master;
  EXPECT_TRUE(is_master || sut.flying.state() == FlyingMaster::State::slave);
  EXPECT_TRUE(is_node_id(sut.flying.active_master()));
  sut.receive("072#");
  sut.run_for(1min);
  sut.forget();
  sut.receive("073#");
  sut.expect({"071#01 05"});
}

TEST(FlyingMaster, LivesOnAfterEachFlippedBitOfEachFrameInEachRole) {
  const auto detect = [](FlyingNode& node) {
    node.start();
    node.run_until(Time(600ms));
  };
  using Begin = std::function<void(FlyingNode&)>;
  const Begin roles[] = {&FlyingNode::start, detect, &FlyingNode::negotiate, &FlyingNode::win,
                         &FlyingNode::follow};
  for (const Begin& begin : roles) {
    for (const char* golden :
         {"071#00 0A", "071#01 05", "071#02 01", "072#", "073#", "074#", "075#", "076#"}) {
      for (const Frame& frame : bit_flips(wire_frame(golden))) {
        FlyingNode sut;
        begin(sut);
        SCOPED_TRACE(wire_text(frame) + " as " + (sut.roles.empty() ? "none" : sut.roles.back()));
        sut.node.receive(frame, sut.now);
        sut.settle();
        expect_to_live_on(sut);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::flying_master_test
