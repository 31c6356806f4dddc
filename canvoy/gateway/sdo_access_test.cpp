// SDO access services (CiA 309-3): read, write, set sdo_timeout.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

#include "canvoy/gateway/testing/wire_gateway.hpp"

namespace canvoy::gateway::sdo_access_test {
namespace {

TEST(GatewayRead, AValueIsUploadedAndAnswered) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1017 0 u16");
  gateway.expect_frames({"605#40 17 10 00 00 00 00 00"});
  gateway.expect_lines({});
  gateway.receive("585#4B 17 10 00 F4 01 00 00");
  gateway.expect_lines({"[1] 500"});
  gateway.expect_frames({});
}

TEST(GatewayRead, TheNameMayBeWrittenInFullAndInCapitals) {
  WireGateway gateway;
  gateway.say("[1] 5 READ 4119 0 U16");
  gateway.expect_frames({"605#40 17 10 00 00 00 00 00"});
}

TEST(GatewayRead, ANetworkMayStandBeforeTheNode) {
  WireGateway gateway;
  gateway.say("[1] 1 5 read 0x1018 0x04 u32");
  gateway.expect_frames({"605#40 18 10 04 00 00 00 00"});
}

TEST(GatewayRead, WithoutATypeTheBytesAreAnswered) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1018 1");
  gateway.receive("585#43 18 10 01 60 03 00 AB");
  gateway.expect_lines({"[1] 60 03 00 AB"});
}

TEST(GatewayRead, AStringComesInSegments) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1008 0 vs");
  gateway.receive("585#41 08 10 00 0A 00 00 00");
  gateway.receive("585#00 48 65 6C 6C 6F 2C 20");
  gateway.receive("585#19 22 42 22 00 00 00 00");
  gateway.expect_lines({"[1] \"Hello, \"\"B\"\"\""});
}

TEST(GatewayRead, AnAbortOfTheServerIsAnsweredWithItsCode) {
  WireGateway gateway;
  gateway.say("[7] 5 r 0x2000 0 u8");
  gateway.receive("585#80 00 20 00 00 00 02 06");
  gateway.expect_lines({"[7] ERROR:0x06020000"});
}

TEST(GatewayRead, AValueOfAnotherLengthThanTheTypeIsAnError) {
  WireGateway gateway;
  gateway.say("[7] 5 r 0x1017 0 u32");
  gateway.receive("585#4B 17 10 00 F4 01 00 00");
  gateway.expect_lines({"[7] ERROR:0x06070010"});
}

TEST(GatewayRead, ANodeThatDoesNotAnswerTimesOutAfterASecond) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1000 0 u32");
  gateway.expect_frames({"@0 605#40 00 10 00 00 00 00 00"});
  gateway.run_until(Time(999'999us));
  gateway.expect_lines({});
  gateway.run_until(Time(1s));
  gateway.expect_lines({"[1] ERROR:0x05040000"});
  gateway.expect_frames({"@1000000 605#80 00 10 00 00 00 04 05"});
}

TEST(GatewayRead, TheTimeOutCanBeSet) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set sdo_timeout 250"), "[1] OK");
  gateway.say("[2] 5 r 0x1000 0 u32");
  gateway.run_until(Time(249'999us));
  gateway.expect_lines({});
  gateway.run_until(Time(250ms));
  gateway.expect_lines({"[2] ERROR:0x05040000"});
}

TEST(GatewayWrite, AValueIsDownloadedAndConfirmed) {
  WireGateway gateway;
  gateway.say("[1] 5 w 0x1017 0 u16 500");
  gateway.expect_frames({"605#2B 17 10 00 F4 01 00 00"});
  gateway.expect_lines({});
  gateway.receive("585#60 17 10 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
}

TEST(GatewayWrite, AStringGoesInSegments) {
  WireGateway gateway;
  gateway.say("[1] 5 write 0x2020 0 vs \"Hello #1\"  # a comment");
  gateway.expect_frames({"605#21 20 20 00 08 00 00 00"});
  gateway.receive("585#60 20 20 00 00 00 00 00");
  gateway.expect_frames({"605#00 48 65 6C 6C 6F 20 23"});
  gateway.receive("585#20 00 00 00 00 00 00 00");
  gateway.expect_frames({"605#1D 31 00 00 00 00 00 00"});
  gateway.receive("585#30 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
}

TEST(GatewayWrite, AnAbortOfTheServerIsAnsweredWithItsCode) {
  WireGateway gateway;
  gateway.say("[3] 5 w 0x1018 1 u32 1");
  gateway.receive("585#80 18 10 01 02 00 01 06");
  gateway.expect_lines({"[3] ERROR:0x06010002"});
}

TEST(GatewayWrite, AValueThatTheTypeHasNoRoomForIsNotSent) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[3] 5 w 0x1017 0 u16 65536"), "[3] ERROR:101");
  EXPECT_EQ(gateway.ask("[4] 5 w 0x1017 0 u16"), "[4] ERROR:101");
  EXPECT_EQ(gateway.ask("[5] 5 w 0x1017 0 500"), "[5] ERROR:101");
  EXPECT_EQ(gateway.ask("[6] 5 w 0x1017 0 u16 500 600"), "[6] ERROR:101");
  gateway.expect_frames({});
}

TEST(GatewaySdo, RequestsToOneNodeWaitForEachOther) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1000 0 u32\r\n[2] 5 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 00 10 00 00 00 00 00"});
  gateway.receive("585#43 00 10 00 A3 01 00 00");
  gateway.expect_frames({"605#40 01 10 00 00 00 00 00"});
  gateway.receive("585#4F 01 10 00 00 00 00 00");
  gateway.expect_lines({"[1] 419", "[2] 0"});
}

TEST(GatewaySdo, RequestsToSeveralNodesAreUnderWayAtOnceAndAnsweredInTheirOrder) {
  WireGateway gateway;
  gateway.say("[1] 5 r 0x1001 0 u8\r\n[2] 6 r 0x1001 0 u8\r\n[3] 7 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 01 10 00 00 00 00 00", "606#40 01 10 00 00 00 00 00",
                         "607#40 01 10 00 00 00 00 00"});
  gateway.receive("587#4F 01 10 00 03 00 00 00");
  gateway.receive("586#4F 01 10 00 02 00 00 00");
  gateway.expect_lines({});
  gateway.receive("585#4F 01 10 00 01 00 00 00");
  gateway.expect_lines({"[1] 1", "[2] 2", "[3] 3"});
}

TEST(GatewaySdo, SixteenNodesAreAskedAtATimeAndTheOthersInTheirTurn) {
  WireGateway gateway({}, {.pending_max = 100});
  std::vector<std::string> frames;
  for (int node = 1; node <= 17; ++node) {
    gateway.say("[1] " + std::to_string(node) + " r 0x1001 0 u8");
    char frame[40];
    std::snprintf(frame, sizeof frame, "6%02X#40 01 10 00 00 00 00 00",
                  static_cast<unsigned>(node));
    frames.emplace_back(frame);
  }
  const std::string last = frames.back();
  frames.pop_back();
  gateway.expect_frames(frames);
  gateway.receive("583#4F 01 10 00 00 00 00 00");
  gateway.expect_frames({last});
}

// CiA 301, 7.2.4.3.9: C6h begins a download in blocks, with a checksum and the size.
TEST(GatewaySdo, LongValuesGoInBlocksWhereTheClientWantsThat) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set sdo_block 1"), "[1] OK");
  gateway.say("[2] 5 w 0x2020 0 vs \"" + std::string(100, 'x') + "\"");
  gateway.expect_frames({"605#C6 20 20 00 64 00 00 00"});
}

TEST(GatewaySdo, AServerThatForbidsItInItsPresentStateIsQuoted) {
  WireGateway gateway({.node_id = 9});
  gateway.say("[1] 5 r 0x1001 0 u8");
  gateway.receive("585#80 01 10 00 22 00 00 08");
  gateway.expect_lines({"[1] ERROR:0x08000022"});
}

TEST(GatewaySdo, ClientsShareANodeOneAfterTheOther) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.say("[1] 5 r 0x1000 0 u32");
  gateway.say(other, "[1] 5 r 0x1001 0 u8");
  gateway.expect_frames({"605#40 00 10 00 00 00 00 00"});
  gateway.receive("585#43 00 10 00 A3 01 00 00");
  gateway.expect_lines({"[1] 419"});
  gateway.expect_lines(other, {});
  gateway.receive("585#4F 01 10 00 81 00 00 00");
  gateway.expect_lines(other, {"[1] 129"});
}

TEST(GatewaySdo, AClientThatLeavesTakesItsRequestsAlong) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.say(other, "[1] 5 r 0x1000 0 u32\r\n[2] 5 r 0x1018 1 u32");
  gateway.say("[1] 5 r 0x1001 0 u8");
  gateway.gateway.close(other);
  gateway.expect_frames({"605#40 00 10 00 00 00 00 00", "605#80 00 10 00 00 00 00 08",
                         "605#40 01 10 00 00 00 00 00"});
  gateway.receive("585#4F 01 10 00 81 00 00 00");
  gateway.expect_lines({"[1] 129"});
}

/// A node on a bus that answers during the transmission of a request, if it answers at all.
struct PromptBus {
  static bool take(void* context, const Frame& frame) {
    PromptBus& self = *static_cast<PromptBus*>(context);
    if (self.answers && frame.data[0] == 0x40) {
      self.node.receive(wire_frame("5A0#4F 01 10 00 07 00 00 00"), Time{});
    }
    return true;
  }
  Operation& begin(std::uint32_t server) {
    Request request;
    request.command = Command::read;
    request.node = server;
    request.index = 0x1001;
    operations.push_back(std::make_unique<Operation>(std::move(request), budget));
    access.begin(*operations.back(), 1s);
    return *operations.back();
  }

  bool answers = false;
  std::array<Router::Route, 20> routes{};
  std::array<Frame, 20> backlog{};
  Budget budget{1000};
  Node node{DictionaryTables{},
            {.values = {}, .states = {}, .routes = routes, .backlog = backlog},
            {this, &PromptBus::take, nullptr},
            node_id_unconfigured};
  std::vector<std::unique_ptr<Operation>> operations;
  SdoAccess access{node, Version::v3_0};
};

// The second request to node 32 is older than the cancelled one, but queues again behind it when
// the first is done.
TEST(GatewaySdo, ARequestThatIsDoneAtOnceWhenACancelledOneMakesRoomIsAnswered) {
  PromptBus bus;
  Operation& first = bus.begin(32);
  Operation& second = bus.begin(32);
  for (std::uint32_t server = 33; server <= 47; ++server) bus.begin(server);
  Operation& last = bus.begin(48);
  bus.node.receive(wire_frame("5A0#4F 01 10 00 00 00 00 00"), Time{});
  ASSERT_TRUE(first.answer);
  ASSERT_FALSE(second.answer);
  bus.answers = true;
  EXPECT_TRUE(bus.access.cancel(last));
  ASSERT_TRUE(second.answer);
  EXPECT_EQ(second.answer->text, "07");
  EXPECT_FALSE(bus.access.cancel(last)) << "it is gone";
  bus.access.fail_all(Answer::ok());
}

TEST(GatewaySdo, TheObjectsOfTheGatewayItselfAreReadAndWrittenWithoutAFrame) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 9 r 0x1018 2 u32"), "[1] 309");
  EXPECT_EQ(gateway.ask("[2] 9 w 0x1006 0 u32 0"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] 9 w 0x1018 2 u32 1"), "[3] ERROR:0x06010002");
  EXPECT_EQ(gateway.ask("[4] 9 r 0x5000 2 u32"), "[4] ERROR:0x06020000");
  EXPECT_EQ(gateway.ask("[5] 9 r 0x1018 9 u32"), "[5] ERROR:0x06090011");
  gateway.expect_frames({});
}

TEST(GatewaySdo, NodesThatThereCannotBeAreRefused) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 0 r 0x1000 0 u32"), "[1] ERROR:107");
  EXPECT_EQ(gateway.ask("[2] 128 r 0x1000 0 u32"), "[2] ERROR:107");
  gateway.expect_frames({});
}

TEST(GatewaySdo, WhatAClientMayHoldIsBounded) {
  WireGateway gateway({}, {.held_bytes_max = 10});
  gateway.say("[1] 5 r 0x1021 0 d");
  gateway.receive("585#41 21 10 00 00 10 00 00");
  gateway.receive("585#00 48 65 6C 6C 6F 2C 20");
  gateway.receive("585#10 48 65 6C 6C 6F 2C 20");
  gateway.expect_lines({"[1] ERROR:600"});
  gateway.say("[2] 5 r 0x1008 0 vs");
  gateway.receive("585#41 08 10 00 08 00 00 00");
  gateway.receive("585#00 48 65 6C 6C 6F 2C 20");
  gateway.receive("585#1D 21 00 00 00 00 00 00");
  gateway.expect_lines({"[2] \"Hello, !\""});
}

}  // namespace
}  // namespace canvoy::gateway::sdo_access_test
