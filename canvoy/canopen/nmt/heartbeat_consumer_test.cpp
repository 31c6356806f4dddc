#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::heartbeat_consumer_test {
namespace {

// 1016h with three entries, the first of them node 10 within 300 ms by default.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1016, .entry_count = 3}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 3},
         {.sub_first = 1,
          .sub_last = 1,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 0x000A'012C},
         {.sub_first = 2, .sub_last = 3, .type = DataType::unsigned32, .access = Access::rw}}));

struct ConsumingNode : WireNode {
  explicit ConsumingNode(HeartbeatConsumer::Start start = HeartbeatConsumer::Start::first_heartbeat)
      : WireNode(layout.tables(), 5), consumer(node, slots, start) {
    consumer.on_change(callback<&ConsumingNode::changed>(*this));
    service.error_changed = callback<&ConsumingNode::error_changed>(*this);
    node.attach(service);
    boot();
  }

  AbortCode write(std::uint8_t sub, std::uint32_t value) {
    std::uint8_t bytes[4];
    store(bytes, value);
    node.advance(now);
    const AbortCode answer = node.dictionary().write(0x1016, sub, bytes, Source::sdo);
    settle();
    return answer;
  }

  void changed(NodeId node_id, RemoteState state) {
    note("node " + std::to_string(node_id) + " state " +
         std::to_string(static_cast<unsigned>(state)));
  }
  void error_changed(const Error& error, bool present) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %04X/%u bits %02X", present ? "raise" : "clear",
                  error.code, error.instance, error.register_bits);
    note(text);
  }
  void note(const std::string& text) {
    log.push_back("@" + std::to_string(now.time_since_epoch() / 1ms) + " " + text);
  }
  /// Compares the reports since the last call.
  void expect_log(const std::vector<std::string>& expected) {
    EXPECT_EQ(log, expected);
    log.clear();
  }

  std::vector<std::string> log;
  HeartbeatConsumer::Slot slots[3];
  HeartbeatConsumer consumer;
  Service service;
};

TEST(HeartbeatConsumer, DoesNotWatchBeforeTheFirstHeartbeat) {
  ConsumingNode sut;
  sut.run_until(Time(1h));
  sut.expect_log({});
  EXPECT_EQ(sut.consumer.state(10), RemoteState::unknown);
}

TEST(HeartbeatConsumer, ReportsEachStateOfTheProducerOnce) {
  ConsumingNode sut;
  for (const char* heartbeat : {"70A#7F", "70A#7F", "70A#05", "70A#05", "70A#04", "70A#7F"}) {
    sut.receive(heartbeat);
    sut.run_for(100ms);
  }
  sut.expect_log({"@0 node 10 state 127", "@200 node 10 state 5", "@400 node 10 state 4",
                  "@500 node 10 state 127"});
}

TEST(HeartbeatConsumer, Raises8130hWhenTheTimeIsOverAndNotBefore) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(200ms));
  sut.receive("70A#05");
  sut.log.clear();
  sut.run_until(Time(500ms) - 1us);
  sut.expect_log({});
  EXPECT_EQ(sut.consumer.state(10), RemoteState::operational);
  sut.run_until(Time(500ms));
  sut.expect_log({"@500 raise 8130/10 bits 10", "@500 node 10 state 255"});
  EXPECT_EQ(sut.consumer.state(10), RemoteState::lost);
  sut.run_until(Time(1h));
  sut.expect_log({});
}

TEST(HeartbeatConsumer, Clears8130hWhenTheProducerIsHeardAgainAndWatchesOn) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(1000ms));
  sut.log.clear();
  sut.receive("70A#05");
  sut.expect_log({"@1000 clear 8130/10 bits 10", "@1000 node 10 state 5"});
  sut.run_until(Time(1300ms));
  sut.expect_log({"@1300 raise 8130/10 bits 10", "@1300 node 10 state 255"});
}

TEST(HeartbeatConsumer, ReportsABootUpButDoesNotBeginToWatchByIt) {
  ConsumingNode sut;
  sut.receive("70A#00");
  sut.run_until(Time(1h));
  sut.receive("70A#00");
  sut.expect_log({"@0 node 10 state 0", "@3600000 node 10 state 0"});
  EXPECT_EQ(sut.consumer.state(10), RemoteState::boot_up);
  sut.receive("70A#7F");
  sut.run_for(300ms);
  sut.expect_log({"@3600000 node 10 state 127", "@3600300 raise 8130/10 bits 10",
                  "@3600300 node 10 state 255"});
}

TEST(HeartbeatConsumer, GoesOnWatchingANodeThatBootsAgain) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(200ms));
  sut.receive("70A#00");
  sut.run_until(Time(600ms));
  sut.expect_log({"@0 node 10 state 5", "@200 node 10 state 0", "@500 raise 8130/10 bits 10",
                  "@500 node 10 state 255"});
}

TEST(HeartbeatConsumer, TakesABootUpForTheReturnOfALostNode) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(400ms));
  sut.log.clear();
  sut.receive("70A#00");
  sut.expect_log({"@400 clear 8130/10 bits 10", "@400 node 10 state 0"});
  sut.run_until(Time(700ms));
  sut.expect_log({"@700 raise 8130/10 bits 10", "@700 node 10 state 255"});
}

TEST(HeartbeatConsumer, WatchesFromTheConfigurationOnWhereTheOwnerAsksForIt) {
  ConsumingNode sut(HeartbeatConsumer::Start::configuration);
  sut.run_until(Time(300ms));
  sut.expect_log({"@300 raise 8130/10 bits 10", "@300 node 10 state 255"});
  EXPECT_EQ(sut.write(2, 0x000B'0064), AbortCode::none);
  sut.run_until(Time(400ms));
  sut.expect_log({"@400 raise 8130/11 bits 10", "@400 node 11 state 255"});
}

TEST(HeartbeatConsumer, HearsHeartbeatsInEveryNmtStateAfterBootUp) {
  ConsumingNode sut;
  for (const char* command : {"000#01 05", "000#02 05", "000#80 05"}) {
    sut.receive(command);
    sut.receive("70A#05");
    sut.receive("70A#7F");
    EXPECT_EQ(sut.consumer.state(10), RemoteState::pre_operational) << command;
  }
  sut.receive("000#02 05");
  sut.log.clear();
  sut.run_for(300ms);
  sut.expect_log({"@300 raise 8130/10 bits 10", "@300 node 10 state 255"});
}

TEST(HeartbeatConsumer, HearsAHeartbeatWhateverItsReservedBit7Is) {
  ConsumingNode sut;
  sut.receive("70A#85");
  sut.run_until(Time(200ms));
  sut.receive("70A#05");
  sut.run_until(Time(400ms));
  sut.receive("70A#FF");
  sut.expect_log({"@0 node 10 state 5", "@400 node 10 state 127"});
}

TEST(HeartbeatConsumer, IsDeafToAGuardingRequest) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(200ms));
  sut.receive("70A#R1");
  sut.run_until(Time(300ms));
  sut.expect_log({"@0 node 10 state 5", "@300 raise 8130/10 bits 10", "@300 node 10 state 255"});
}

TEST(HeartbeatConsumer, SurvivesAProducerThatComesAndGoes) {
  ConsumingNode sut;
  for (int i = 0; i < 3; ++i) {
    sut.receive("70A#00");
    sut.receive("70A#7F");
    sut.run_for(290ms);
    sut.receive("70A#05");
    sut.run_for(410ms);
  }
  sut.expect_log({"@0 node 10 state 0", "@0 node 10 state 127", "@290 node 10 state 5",
                  "@590 raise 8130/10 bits 10", "@590 node 10 state 255",
                  "@700 clear 8130/10 bits 10", "@700 node 10 state 0", "@700 node 10 state 127",
                  "@990 node 10 state 5", "@1290 raise 8130/10 bits 10", "@1290 node 10 state 255",
                  "@1400 clear 8130/10 bits 10", "@1400 node 10 state 0", "@1400 node 10 state 127",
                  "@1690 node 10 state 5", "@1990 raise 8130/10 bits 10",
                  "@1990 node 10 state 255"});
}

TEST(HeartbeatConsumer, WatchesSeveralNodesApart) {
  ConsumingNode sut;
  EXPECT_EQ(sut.write(2, 0x000B'01F4), AbortCode::none);
  EXPECT_EQ(sut.write(3, 0x007F'0001), AbortCode::none);
  sut.receive("70A#05");
  sut.receive("70B#7F");
  sut.receive("77F#04");
  sut.run_until(Time(1s));
  sut.expect_log({"@0 node 10 state 5", "@0 node 11 state 127", "@0 node 127 state 4",
                  "@1 raise 8130/127 bits 10", "@1 node 127 state 255",
                  "@300 raise 8130/10 bits 10", "@300 node 10 state 255",
                  "@500 raise 8130/11 bits 10", "@500 node 11 state 255"});
}

TEST(HeartbeatConsumer, LeavesAnEntryUnusedWithNodeId0OrAbove127OrTime0) {
  ConsumingNode sut;
  for (const std::uint32_t value : {0x0000'0064U, 0x0080'0064U, 0x00FF'0064U, 0x000B'0000U, 0U}) {
    EXPECT_EQ(sut.write(2, value), AbortCode::none) << value;
    sut.receive("70B#05");
    sut.receive("700#05");
    sut.receive("780#05");
    sut.run_for(1s);
  }
  sut.expect_log({});
  EXPECT_EQ(sut.consumer.state(0), RemoteState::unknown);
}

TEST(HeartbeatConsumer, RefusesASecondTimeForANode) {
  ConsumingNode sut;
  EXPECT_EQ(sut.write(2, 0x000A'0001), AbortCode::parameter_incompatible);
  EXPECT_EQ(sut.node.dictionary().number(0x1016, 2), 0U);
  EXPECT_EQ(sut.write(2, 0x000A'0000), AbortCode::none);
  EXPECT_EQ(sut.write(1, 0x000A'0064), AbortCode::none);
  EXPECT_EQ(sut.write(1, 0), AbortCode::none);
  EXPECT_EQ(sut.write(3, 0x000A'0001), AbortCode::none);
}

TEST(HeartbeatConsumer, RefusesAnEntryForWhichThereIsNoSlot) {
  WireNode wire(layout.tables(), 5);
  HeartbeatConsumer::Slot slots[2];
  HeartbeatConsumer sut(wire.node, slots);
  wire.boot();
  const std::uint8_t value[] = {0x64, 0x00, 0x0B, 0x00};
  EXPECT_EQ(wire.node.dictionary().write(0x1016, 2, value, Source::sdo), AbortCode::none);
  const std::uint8_t other[] = {0x64, 0x00, 0x0C, 0x00};
  EXPECT_EQ(wire.node.dictionary().write(0x1016, 3, other, Source::sdo), AbortCode::out_of_memory);
  const std::uint8_t unused[] = {0x00, 0x00, 0x0C, 0x00};
  EXPECT_EQ(wire.node.dictionary().write(0x1016, 3, unused, Source::sdo), AbortCode::none);
}

TEST(HeartbeatConsumer, ForgetsANodeWhenItsEntryIsRewritten) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.log.clear();
  EXPECT_EQ(sut.write(1, 0x000B'0064), AbortCode::none);
  sut.receive("70A#04");
  sut.run_until(Time(1s));
  sut.expect_log({});
  EXPECT_EQ(sut.consumer.state(10), RemoteState::unknown);
  sut.receive("70B#04");
  sut.expect_log({"@1000 node 11 state 4"});
}

TEST(HeartbeatConsumer, KnowsANodeStillWhoseTimeIsWrittenAnew) {
  for (const std::uint32_t entry : {0x000A'012CU, 0x000A'01F4U, 0x000A'0064U}) {
    ConsumingNode sut;
    sut.receive("70A#04");
    sut.run_until(Time(200ms));
    sut.log.clear();
    EXPECT_EQ(sut.write(1, entry), AbortCode::none);
    EXPECT_EQ(sut.consumer.state(10), RemoteState::stopped);
    const unsigned lost_at = 200 + (entry & 0xFFFF);
    sut.run_until(Time(std::chrono::milliseconds(lost_at)) - 1us);
    sut.expect_log({});
    sut.run_for(1us);
    const std::string at = "@" + std::to_string(lost_at);
    sut.expect_log({at + " raise 8130/10 bits 10", at + " node 10 state 255"});
  }
}

TEST(HeartbeatConsumer, ALostNodeStaysLostUntilItIsHeardWhateverItsTimeIs) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(300ms));
  sut.log.clear();
  EXPECT_EQ(sut.write(1, 0x000A'03E8), AbortCode::none);
  EXPECT_EQ(sut.consumer.state(10), RemoteState::lost);
  sut.run_until(Time(10s));
  sut.expect_log({});
  sut.receive("70A#05");
  sut.run_until(Time(11s));
  sut.expect_log({"@10000 clear 8130/10 bits 10", "@10000 node 10 state 5",
                  "@11000 raise 8130/10 bits 10", "@11000 node 10 state 255"});
}

TEST(HeartbeatConsumer, DoesNotBeginToWatchBecauseTheTimeIsWrittenAnew) {
  ConsumingNode sut;
  EXPECT_EQ(sut.write(1, 0x000A'0064), AbortCode::none);
  sut.run_until(Time(1h));
  sut.expect_log({});
}

TEST(HeartbeatConsumer, ClearsTheErrorOfALostNodeThatIsNoLongerToBeWatched) {
  ConsumingNode sut;
  sut.receive("70A#05");
  sut.run_until(Time(300ms));
  sut.log.clear();
  EXPECT_EQ(sut.write(1, 0), AbortCode::none);
  sut.expect_log({"@300 clear 8130/10 bits 10"});
}

TEST(HeartbeatConsumer, BeginsAnewByAReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    ConsumingNode sut;
    EXPECT_EQ(sut.write(2, 0x000B'0064), AbortCode::none);
    sut.receive("70A#05");
    sut.receive("70B#05");
    sut.log.clear();
    sut.receive(reset);
    EXPECT_EQ(sut.consumer.state(10), RemoteState::unknown);
    sut.run_until(Time(1s));
    sut.receive("70B#05");
    sut.expect_log({});
    sut.receive("70A#05");
    sut.run_until(Time(1300ms));
    sut.expect_log(
        {"@1000 node 10 state 5", "@1300 raise 8130/10 bits 10", "@1300 node 10 state 255"});
  }
}

TEST(HeartbeatConsumer, IgnoresAndCountsWhatIsNoHeartbeat) {
  ConsumingNode sut;
  sut.receive("70A#");
  sut.receive("70A#05 00");
  sut.receive("70A#00 00 00 00 00 00 00 00");
  sut.receive("70A#06");
  EXPECT_EQ(sut.node.counters().malformed, 4U);
  sut.receive("70A#R1");
  sut.receive("0000070A#05");
  EXPECT_EQ(sut.node.counters().malformed, 4U);
  sut.run_until(Time(1s));
  sut.expect_log({});
}

TEST(HeartbeatConsumer, KnowsTheFourStatesAndNoOthers) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    const unsigned state = byte & 0x7F;
    const bool exists = state == 0x00 || state == 0x04 || state == 0x05 || state == 0x7F;
    EXPECT_EQ(remote_state(static_cast<std::uint8_t>(byte)),
              exists ? static_cast<RemoteState>(state) : RemoteState::unknown)
        << byte;
  }
}

TEST(HeartbeatConsumer, IsRestartedByAHeartbeatInTheVeryLastMicrosecond) {
  ConsumingNode sut;
  for (int i = 0; i < 5; ++i) {
    sut.receive("70A#05");
    sut.run_for(300ms - 1us);
  }
  EXPECT_EQ(sut.consumer.state(10), RemoteState::operational);
  sut.run_for(1us);
  EXPECT_EQ(sut.consumer.state(10), RemoteState::lost);
}

}  // namespace
}  // namespace canvoy::heartbeat_consumer_test
