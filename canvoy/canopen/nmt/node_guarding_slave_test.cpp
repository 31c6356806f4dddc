#include "canvoy/canopen/nmt/node_guarding_slave.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/error_behaviour.hpp"
#include "canvoy/canopen/nmt/heartbeat_producer.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::node_guarding_slave_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

// 100Ch, 100Dh, 1017h; 1029h: a communication error changes nothing.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x100C, .entry_count = 1},
                              {.index = 0x100D, .entry_count = 1},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x1029, .entry_count = 2}}),
    std::to_array<EntryRow>({{.type = DataType::unsigned16, .access = Access::rw},
                             {.type = DataType::unsigned8, .access = Access::rw},
                             {.type = DataType::unsigned16, .access = Access::rw},
                             {.access = Access::const_, .initial = 1},
                             {.sub_first = 1, .sub_last = 1, .access = Access::rw, .initial = 1}}));
constexpr auto layout_without =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct GuardedNode : WireNode {
  explicit GuardedNode(const DictionaryTables& tables = layout.tables(), NodeId id = 5)
      : WireNode(tables, id), heartbeat(node), sut(node), behaviour(node) {
    service.error_changed = callback<&GuardedNode::error_changed>(*this);
    node.attach(service);
    boot();
  }

  void write(std::uint16_t index, std::uint16_t value, std::uint8_t sub = 0) {
    std::uint8_t bytes[2];
    store(bytes, value);
    const std::size_t length = index == 0x100D || index == 0x1029 ? 1 : 2;
    node.advance(now);
    ASSERT_EQ(node.dictionary().write(index, sub, std::span(bytes).first(length), Source::sdo),
              none);
    settle();
  }
  /// Life guarding within guard time x factor.
  void set_life_time(std::uint16_t guard_time_ms, std::uint16_t factor) {
    write(0x100C, guard_time_ms);
    write(0x100D, factor);
  }
  void request() { receive("705#R1"); }

  void error_changed(const Error& error, bool present) {
    char text[64];
    std::snprintf(text, sizeof text, "@%lld %s %04X/%u bits %02X",
                  static_cast<long long>(now.time_since_epoch() / 1ms), present ? "raise" : "clear",
                  error.code, error.instance, error.register_bits);
    log.emplace_back(text);
  }
  Texts take() { return std::exchange(log, {}); }

  Texts log;
  HeartbeatProducer heartbeat;
  NodeGuardingSlave sut;
  ErrorBehaviour behaviour;
  Service service;
};

// Node guarding

TEST(NodeGuardingSlave, AnswersWithItsStateAndAToggleBitThatIs0First) {
  GuardedNode node;
  for (int i = 0; i < 3; ++i) node.request();
  node.expect({"705#7F", "705#FF", "705#7F"});
}

TEST(NodeGuardingSlave, TellsEachNmtState) {
  GuardedNode node;
  node.request();
  node.receive("000#01 05");
  node.request();
  node.receive("000#02 05");
  node.request();
  node.receive("000#80 05");
  node.request();
  node.expect({"705#7F", "705#85", "705#04", "705#FF"});
}

TEST(NodeGuardingSlave, BeginsItsToggleBitAnewByEachReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    GuardedNode node;
    node.request();
    node.receive(reset);
    node.request();
    node.request();
    node.expect({"705#7F", "705#00", "705#7F", "705#FF"});
  }
}

TEST(NodeGuardingSlave, BeginsItsToggleBitAnewWhenGuardingTakesOverFromHeartbeat) {
  GuardedNode node;
  node.request();
  node.write(0x1017, 100);
  node.write(0x1017, 0);
  node.sent.clear();
  node.request();
  node.request();
  node.expect({"705#7F", "705#FF"});
}

TEST(NodeGuardingSlave, KeepsItsToggleBitWhereOtherParametersAreWritten) {
  GuardedNode node;
  node.request();
  node.write(0x100C, 100);
  node.write(0x1017, 0);
  node.request();
  node.expect({"705#7F", "705#FF"});
}

TEST(NodeGuardingSlave, AnswersARemoteFrameOfAnyLengthWithOneByte) {
  for (std::uint8_t length = 0; length <= 8; ++length) {
    GuardedNode node;
    node.node.receive(Frame::remote_frame(0x705, length), node.now);
    node.expect({"705#7F"});
  }
}

TEST(NodeGuardingSlave, AnswersNoOtherFrame) {
  GuardedNode node;
  node.receive("705#7F");
  node.receive("705#");
  node.receive("706#R1");
  node.receive("700#R1");
  node.receive("00000705#R1");
  node.receive("605#R8");
  node.expect({});
}

TEST(NodeGuardingSlave, AnswersWithoutGuardTimeAndWatchesNobodyThen) {
  GuardedNode node;
  node.request();
  node.run_for(24h);
  EXPECT_EQ(node.take(), Texts());
  EXPECT_FALSE(node.sut.is_master_lost());
}

TEST(NodeGuardingSlave, AnswersWithoutItsObjects) {
  GuardedNode node(layout_without.tables());
  node.request();
  node.run_for(1h);
  node.expect({"705#7F"});
  EXPECT_EQ(node.take(), Texts());
}

TEST(NodeGuardingSlave, IsSilentWithoutANodeId) {
  GuardedNode node(layout.tables(), node_id_unconfigured);
  for (unsigned id = 0x700; id <= 0x7FF; ++id) {
    node.node.receive(Frame::remote_frame(id, 1), node.now);
  }
  node.expect({});
}

// Heartbeat against guarding

TEST(NodeGuardingSlave, LeavesErrorControlToTheHeartbeat) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.write(0x1017, 1000);
  node.request();
  node.run_until(Time(1s));
  node.expect({"@0 705#7F", "@1000000 705#7F"});
  EXPECT_EQ(node.take(), Texts());
  node.write(0x1017, 0);
  node.request();
  node.expect({"705#7F"});
}

TEST(NodeGuardingSlave, EndsLifeGuardingWhenTheHeartbeatBegins) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.request();
  node.run_until(Time(200ms));
  node.write(0x1017, 1000);
  node.run_until(Time(1h));
  EXPECT_EQ(node.take(), Texts());
  node.write(0x1017, 0);
  node.run_for(1h);
  EXPECT_EQ(node.take(), Texts()) << "not before the master asks again";
}

TEST(NodeGuardingSlave, ResolvesItsEventWhenTheHeartbeatBegins) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.request();
  node.run_until(Time(300ms));
  EXPECT_EQ(node.take(), Texts({"@300 raise 8130/0 bits 10"}));
  node.write(0x1017, 1000);
  EXPECT_EQ(node.take(), Texts({"@300 clear 8130/0 bits 10"}));
}

// Life guarding

TEST(LifeGuarding, BeginsWithTheFirstRequest) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.run_until(Time(1h));
  EXPECT_EQ(node.take(), Texts());
  node.request();
  node.run_for(300ms - 1us);
  EXPECT_EQ(node.take(), Texts());
  EXPECT_FALSE(node.sut.is_master_lost());
  node.run_for(1us);
  EXPECT_EQ(node.take(), Texts({"@3600300 raise 8130/0 bits 10"}));
  EXPECT_TRUE(node.sut.is_master_lost());
}

TEST(LifeGuarding, IsGuardTimeTimesLifeTimeFactor) {
  for (const auto& [guard_time, factor] : {std::pair{1, 1}, {1, 255}, {65535, 1}, {65535, 255}}) {
    GuardedNode node;
    node.set_life_time(static_cast<std::uint16_t>(guard_time), static_cast<std::uint16_t>(factor));
    node.request();
    const Duration life_time = 1ms * guard_time * factor;
    node.run_until(Time(life_time) - 1us);
    EXPECT_EQ(node.take(), Texts());
    node.run_until(Time(life_time));
    EXPECT_EQ(node.take().size(), 1U);
  }
}

TEST(LifeGuarding, IsOffWhileOneOfBothIs0) {
  for (const auto& [guard_time, factor] : {std::pair{0, 3}, {100, 0}, {0, 0}}) {
    GuardedNode node;
    node.set_life_time(static_cast<std::uint16_t>(guard_time), static_cast<std::uint16_t>(factor));
    node.request();
    node.run_until(Time(24h));
    EXPECT_EQ(node.take(), Texts());
  }
}

TEST(LifeGuarding, IsContentWithARequestInTheVeryLastMicrosecond) {
  GuardedNode node;
  node.set_life_time(100, 3);
  for (int i = 0; i < 5; ++i) {
    node.request();
    node.run_for(300ms - 1us);
  }
  EXPECT_EQ(node.take(), Texts());
}

TEST(LifeGuarding, ResolvesByTheNextRequestAndGoesOn) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.request();
  node.run_until(Time(10s));
  EXPECT_EQ(node.take(), Texts({"@300 raise 8130/0 bits 10"})) << "it is told once";
  node.request();
  EXPECT_FALSE(node.sut.is_master_lost());
  node.run_until(Time(20s));
  EXPECT_EQ(node.take(), Texts({"@10000 clear 8130/0 bits 10", "@10300 raise 8130/0 bits 10"}));
  node.expect({"@0 705#7F", "@10000000 705#FF"});
}

TEST(LifeGuarding, GoesOnInEveryNmtState) {
  for (const char* command : {"000#01 05", "000#02 05", "000#80 05"}) {
    GuardedNode node;
    node.set_life_time(100, 3);
    node.receive(command);
    node.request();
    node.run_until(Time(300ms));
    EXPECT_EQ(node.take(), Texts({"@300 raise 8130/0 bits 10"})) << command;
  }
}

TEST(LifeGuarding, ChangesTheNmtStateBy1029h) {
  struct Case {
    std::uint16_t reaction;
    NmtState state;
  };
  constexpr Case cases[] = {
      {0, NmtState::pre_operational}, {1, NmtState::operational}, {2, NmtState::stopped}};
  for (const Case& a : cases) {
    GuardedNode node;
    node.write(0x1029, a.reaction, 1);
    node.set_life_time(100, 3);
    node.receive("000#01 05");
    node.request();
    node.run_until(Time(1s));
    EXPECT_EQ(node.node.state(), a.state) << a.reaction;
  }
}

TEST(LifeGuarding, TakesOtherTimesFromNowOn) {
  GuardedNode node;
  node.set_life_time(100, 3);
  node.request();
  node.run_until(Time(200ms));
  node.write(0x100C, 50);
  node.run_until(Time(350ms) - 1us);
  EXPECT_EQ(node.take(), Texts());
  node.run_until(Time(350ms));
  EXPECT_EQ(node.take(), Texts({"@350 raise 8130/0 bits 10"}));
  node.write(0x100C, 60);
  node.run_until(Time(10s));
  EXPECT_EQ(node.take(), Texts()) << "what has occurred does not occur again";
  node.write(0x100D, 0);
  EXPECT_EQ(node.take(), Texts({"@10000 clear 8130/0 bits 10"}));
}

TEST(LifeGuarding, EndsByAReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    for (const bool lost : {false, true}) {
      GuardedNode node;
      node.set_life_time(100, 3);
      node.request();
      node.run_until(lost ? Time(300ms) : Time(200ms));
      node.take();
      node.receive(reset);
      EXPECT_EQ(node.take(), lost ? Texts({"@300 clear 8130/0 bits 10"}) : Texts());
      node.set_life_time(100, 3);
      node.run_until(Time(1h));
      EXPECT_EQ(node.take(), Texts());
    }
  }
}

}  // namespace
}  // namespace canvoy::node_guarding_slave_test
