// Clients of the gateway: defaults, order, limits, and the effects of one on the others (CiA
// 309-3).
#include "canvoy/gateway/session.hpp"

#include <gtest/gtest.h>

#include "canvoy/gateway/testing/wire_gateway.hpp"

namespace canvoy::gateway::session_test {
namespace {

TEST(GatewaySession, TheOnlyNetworkIsTheDefaultOne) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 start"), "[1] OK");
  gateway.expect_frames({"000#01 05"});
}

TEST(GatewaySession, WithSeveralNetworksOneHasToBeNamedOrSet) {
  WireGateway gateway;
  WireNetwork second(gateway.now, 7);
  gateway.gateway.add(second.network);
  EXPECT_EQ(gateway.ask("[1] 5 start"), "[1] ERROR:104");
  EXPECT_EQ(gateway.ask("[2] 7 5 start"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] 1 6 start"), "[3] OK");
  EXPECT_EQ(gateway.ask("[4] set network 7"), "[4] OK");
  EXPECT_EQ(gateway.ask("[5] 8 start"), "[5] OK");
  gateway.expect_frames({"000#01 06"});
  second.expect_frames({"000#01 05", "000#01 08"});
}

TEST(GatewaySession, UnknownNetworksAreRefused) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 2 5 start"), "[1] ERROR:106");
  EXPECT_EQ(gateway.ask("[2] set network 2"), "[2] ERROR:106");
  EXPECT_EQ(gateway.ask("[3] 2 lss_store"), "[3] ERROR:106");
}

TEST(GatewaySession, ANodeHasToBeNamedOrSet) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] start"), "[1] ERROR:105");
  EXPECT_EQ(gateway.ask("[2] set node 5"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] start"), "[3] OK");
  gateway.expect_frames({"000#01 05"});
  EXPECT_EQ(gateway.ask("[4] set node 0"), "[4] ERROR:107") << "it would be all of them";
  EXPECT_EQ(gateway.ask("[5] set node 128"), "[5] ERROR:107");
}

TEST(GatewaySession, EachClientHasDefaultsOfItsOwn) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  EXPECT_EQ(gateway.ask("[1] set node 5"), "[1] OK");
  gateway.say(other, "[1] start");
  gateway.expect_lines(other, {"[1] ERROR:105"});
}

TEST(GatewaySession, ADefaultHoldsForTheNextLineAlreadyWhileOthersAreUnderWay) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1000 0 u32\r\n[2] set node 6\r\n[3] r 0x1001 0 u8");
  gateway.expect_frames({"605#40 00 10 00 00 00 00 00", "606#40 01 10 00 00 00 00 00"});
  gateway.receive("586#4F 01 10 00 01 00 00 00");
  gateway.expect_lines({});
  gateway.receive("585#43 00 10 00 A3 01 00 00");
  gateway.expect_lines({"[1] 419", "[2] OK", "[3] 1"});
}

TEST(GatewaySession, ACommandToANodeWaitsForThoseBeforeItToThatNode) {
  WireGateway gateway;
  gateway.say("[1] 5 w 0x1017 0 u16 500\r\n[2] 5 start\r\n[3] 6 start");
  gateway.expect_frames({"605#2B 17 10 00 F4 01 00 00", "000#01 06"});
  gateway.receive("585#60 17 10 00 00 00 00 00");
  gateway.expect_frames({"000#01 05"});
  gateway.expect_lines({"[1] OK", "[2] OK", "[3] OK"});
}

TEST(GatewaySession, ACommandForTheWholeNetworkWaitsForAllBeforeItAndHoldsUpAllBehindIt) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1001 0 u8\r\n[2] 0 start\r\n[3] 6 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 01 10 00 00 00 00 00"});
  gateway.receive("585#4F 01 10 00 01 00 00 00");
  gateway.expect_frames({"000#01 00", "606#40 01 10 00 00 00 00 00"});
  gateway.expect_lines({"[1] 1", "[2] OK"});
}

TEST(GatewaySession, NetworksDoNotWaitForEachOther) {
  WireGateway gateway;
  WireNetwork second(gateway.now, 2);
  gateway.gateway.add(second.network);
  gateway.say("[1] 1 5 r 0x1001 0 u8\r\n[2] 2 0 start");
  second.expect_frames({"000#01 00"});
}

TEST(GatewaySession, ACommandThatTakesTooLongIsEndedAndAnswered) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set command_timeout 100"), "[1] OK");
  gateway.say("[2] 5 r 0x1000 0 u32\r\n[3] 5 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 00 10 00 00 00 00 00"});
  gateway.run_for(99'999us);
  gateway.expect_lines({});
  gateway.run_for(1us);
  gateway.expect_lines({"[2] ERROR:103"});
  gateway.expect_frames({"605#80 00 10 00 00 00 00 08", "605#40 01 10 00 00 00 00 00"});
  gateway.receive("585#43 00 10 00 A3 01 00 00");
  gateway.expect_lines({});
  gateway.receive("585#4F 01 10 00 01 00 00 00");
  gateway.expect_lines({"[3] 1"});
}

TEST(GatewaySession, ALineThatIsTooLongIsAnsweredAndTheNextOneIsHeard) {
  WireGateway gateway({}, {.command_size = 64});
  gateway.say("[7] 5 w 0x2020 0 vs \"" + std::string(100, 'x') + "\"");
  gateway.expect_lines({"[7] ERROR:600"});
  gateway.expect_frames({});
  EXPECT_EQ(gateway.ask("[8] 5 start"), "[8] OK");
}

TEST(GatewaySession, TheSizeOfACommandCanBeSetWithinALimit) {
  WireGateway gateway({}, {.command_size = 64, .command_size_max = 1000});
  EXPECT_EQ(gateway.ask("[1] set command_size 1000"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] set command_size 1001"), "[2] ERROR:600");
  EXPECT_EQ(gateway.ask("[3] set command_size 63"), "[3] ERROR:600");
  EXPECT_EQ(gateway.ask("[4] 5 w 0x2020 0 vs \"" + std::string(900, 'x') + "\" nonsense"),
            "[4] ERROR:101");
}

TEST(GatewaySession, LinesMayBeCutAnywhere) {
  const std::string text = "[1] 5 start\r\n[2] 6 stop\r\n";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    WireGateway gateway;
    gateway.client.receive(text.substr(0, cut));
    gateway.gateway.settle(gateway.now);
    gateway.client.receive(text.substr(cut));
    gateway.gateway.settle(gateway.now);
    gateway.expect_frames({"000#01 05", "000#02 06"});
    gateway.expect_lines({"[1] OK", "[2] OK"});
  }
}

TEST(GatewaySession, ALineWithoutItsEndIsNoCommandUntilTheInputEnds) {
  WireGateway gateway;
  gateway.client.receive("[1] 5 start");
  gateway.gateway.settle(gateway.now);
  gateway.expect_frames({});
  gateway.client.end_input();
  gateway.gateway.settle(gateway.now);
  gateway.expect_frames({"000#01 05"});
}

TEST(GatewaySession, NoMoreThanSoManyCommandsAreUnderWay) {
  WireGateway gateway({}, {.pending_max = 2});
  gateway.say("[1] 5 r 0x1001 0 u8\r\n[2] 6 r 0x1001 0 u8\r\n[3] 7 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 01 10 00 00 00 00 00", "606#40 01 10 00 00 00 00 00"});
  EXPECT_FALSE(gateway.client.wants_input());
  gateway.receive("585#4F 01 10 00 01 00 00 00");
  gateway.expect_frames({"607#40 01 10 00 00 00 00 00"});
  gateway.expect_lines({"[1] 1"});
}

TEST(GatewaySession, AClientThatDoesNotReadItsAnswersIsNotHeardAnyMore) {
  WireGateway gateway({}, {.output_max = 20});
  for (int i = 0; i < 100; ++i) gateway.client.receive("[1] 5 start\r\n");
  gateway.gateway.settle(gateway.now);
  EXPECT_LT(gateway.client.output().size(), 30U);
  EXPECT_FALSE(gateway.client.wants_input());
  EXPECT_FALSE(gateway.client.is_too_slow());
  std::size_t answers = 0;
  while (!gateway.client.output().empty()) {
    answers += take_lines(gateway.client).size();
    gateway.gateway.settle(gateway.now);
    gateway.wire.network.advance(gateway.now);
  }
  EXPECT_EQ(answers, 100U);
}

TEST(GatewaySession, AClientThatDoesNotReadItsEventsIsTooSlow) {
  WireGateway gateway({}, {.event_bytes_max = 100});
  for (int i = 0; i < 7; ++i) gateway.receive("705#00");
  EXPECT_FALSE(gateway.client.is_too_slow());
  gateway.receive("705#00");
  EXPECT_TRUE(gateway.client.is_too_slow());
  for (int i = 0; i < 1000; ++i) gateway.receive("705#00");
  EXPECT_LE(gateway.client.output().size(), 100U);
}

TEST(GatewaySession, AClientThatReadsIsNeverTooSlow) {
  WireGateway gateway({}, {.event_bytes_max = 100});
  for (int i = 0; i < 1000; ++i) {
    gateway.receive("705#00");
    gateway.expect_lines({"1 5 BOOT_UP"});
  }
  EXPECT_FALSE(gateway.client.is_too_slow());
}

TEST(GatewaySession, AClientIsNotIdleWhileThereAreLinesThatItHasNoRoomToAnswer) {
  WireGateway gateway({}, {.output_max = 1});
  gateway.client.receive("[1] 5 start\r\n[2] 6 start\r\n[3] 7 start\r\n");
  std::vector<std::string> answers;
  for (int turn = 0; turn < 10 && !(turn > 0 && gateway.client.idle()); ++turn) {
    gateway.gateway.settle(gateway.now);
    for (std::string& line : take_lines(gateway.client)) answers.push_back(std::move(line));
  }
  EXPECT_EQ(answers, (std::vector<std::string>{"[1] OK", "[2] OK", "[3] OK"}));
  EXPECT_TRUE(gateway.client.idle());
}

/// A network with nodes that answer requests for 1000h while these are being sent.
struct PromptGateway : WireGateway {
  PromptGateway() {
    wire.on_sent = [this](const Frame& frame) {
      if (!answers || frame.data[0] != 0x40) return;
      const std::uint32_t node = frame.id - 0x600;
      Frame answer = wire_frame("580#43 00 10 00 A3 01 00 00");
      answer.id += node;
      wire.network.receive(answer, now);
    };
    gateway.on_settled([this] {
      EXPECT_EQ(++depth, 1) << "sessions are settled by two at a time";
      --depth;
    });
  }
  bool answers = true;
  int depth = 0;
};

TEST(GatewaySession, AnswersMayComeWhileTheRequestIsBeingSent) {
  PromptGateway gateway;
  gateway.say("[1] 5 r 0x1000 0 u32\r\n[2] 5 r 0x1000 0 u32\r\n[3] 6 r 0x1000 0 u32");
  gateway.expect_lines({"[1] 419", "[2] 419", "[3] 419"});
}

TEST(GatewaySession, ATimeOutMayLetTheNextCommandHaveItsAnswerAtOnce) {
  PromptGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.ask("[1] set command_timeout 100");
  gateway.answers = false;
  gateway.say("[2] 5 r 0x1000 0 u32\r\n[3] 5 r 0x1000 0 u32");
  gateway.say(other, "[1] 5 r 0x1000 0 u32");
  gateway.answers = true;
  gateway.run_for(100ms);
  gateway.expect_lines({"[2] ERROR:103", "[3] 419"});
  gateway.expect_lines(other, {"[1] 419"});
}

TEST(GatewaySession, AClientThatLeavesMayLetTheNextOneHaveItsAnswerAtOnce) {
  PromptGateway gateway;
  Session& leaving = gateway.gateway.open();
  Session& other = gateway.gateway.open();
  gateway.answers = false;
  gateway.say(leaving, "[1] 5 r 0x1000 0 u32");
  gateway.say(other, "[1] 5 r 0x1000 0 u32");
  gateway.answers = true;
  gateway.gateway.close(leaving);
  gateway.expect_lines(other, {"[1] 419"});
}

TEST(GatewaySession, ErrorsAreCounted) {
  WireGateway gateway;
  gateway.ask("[1] 5 start");
  EXPECT_EQ(gateway.client.failures(), 0U);
  gateway.ask("[2] nonsense");
  gateway.ask("[3] start");
  EXPECT_EQ(gateway.client.failures(), 2U);
}

TEST(GatewaySession, ErrorsMayCarryTheirMeaningAsAComment) {
  WireGateway gateway({}, {.style = {.explain = true}});
  EXPECT_EQ(gateway.ask("[1] nonsense"), "[1] ERROR:100 #not supported");
  gateway.say("[2] 5 r 0x2000 0 u8");
  gateway.receive("585#80 00 20 00 00 00 02 06");
  gateway.expect_lines({"[2] ERROR:0x06020000 #the object does not exist in the dictionary"});
}

TEST(GatewaySession, AnswersFollowVersion21WhereThatIsAskedFor) {
  WireGateway gateway({.version = Version::v2_1}, {.style = {.version = Version::v2_1}});
  EXPECT_EQ(gateway.ask("[1] nonsense"), "[1] ERROR: 100 (not supported)");
  gateway.say("[2] 5 r 0x2000 0 u8\r\n[3] 6 r 0x1018 1 u32");
  gateway.receive("585#80 00 20 00 00 00 02 06");
  gateway.receive("586#43 18 10 01 60 03 00 00");
  gateway.expect_lines(
      {"[2] ERROR: 06020000 (the object does not exist in the dictionary)", "[3] 0x00000360"});
  EXPECT_EQ(gateway.ask("[4] 5 enable heartbeat 100"), "[4] OK");
  gateway.receive("705#05");
  gateway.expect_lines({"1 5 ERROR 202 (heartbeat began)"});
}

TEST(GatewaySession, GarbageIsAnsweredLineByLine) {
  WireGateway gateway;
  std::string garbage;
  for (int byte = 0; byte < 256; ++byte) {
    garbage += std::string(3, static_cast<char>(byte)) + "\n";
  }
  gateway.client.receive(garbage);
  gateway.gateway.settle(gateway.now);
  std::size_t answers = 0;
  while (!gateway.client.output().empty()) {
    for (const std::string& line : take_lines(gateway.client)) {
      EXPECT_EQ(line, "[0] ERROR:101");
      ++answers;
    }
    gateway.gateway.settle(gateway.now);
  }
  // Blanks, tabs, ends of lines, and comments are no commands.
  EXPECT_EQ(answers, 256U - 4);
  gateway.expect_frames({});
}

}  // namespace
}  // namespace canvoy::gateway::session_test
