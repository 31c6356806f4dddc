// NMT services, supervision, the gateway's own settings, and events of the network (CiA 309-3).
#include <gtest/gtest.h>

#include "canvoy/gateway/testing/wire_gateway.hpp"

namespace canvoy::gateway::network_test {
namespace {

TEST(GatewayNmt, EachCommandIsOneFrame) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 start"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] 5 stop"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] 5 preop"), "[3] OK");
  EXPECT_EQ(gateway.ask("[4] 5 reset node"), "[4] OK");
  EXPECT_EQ(gateway.ask("[5] 5 reset comm"), "[5] OK");
  gateway.expect_frames({"000#01 05", "000#02 05", "000#80 05", "000#81 05", "000#82 05"});
}

TEST(GatewayNmt, NodeZeroIsAllNodes) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 0 start"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] 1 0 reset node"), "[2] OK");
  gateway.expect_frames({"000#01 00", "000#81 00"});
}

TEST(GatewayNmt, ACommandToAllNodesLeavesTheGatewayAlone) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 0 stop"), "[1] OK");
  gateway.say("[2] 5 r 0x1001 0 u8");
  gateway.expect_frames({"000#02 00", "605#40 01 10 00 00 00 00 00"});
}

TEST(GatewayNmt, TheGatewayObeysWhereItIsAddressedItself) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 9 reset comm"), "[1] OK");
  gateway.expect_frames({"000#82 09", "709#00"});
  EXPECT_EQ(gateway.ask("[2] 9 stop"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] 5 r 0x1001 0 u8"), "[3] ERROR:102");
  gateway.expect_frames({"000#02 09"});
}

TEST(GatewayNmt, AFrameThatCannotBeSentIsAnError) {
  WireGateway gateway;
  gateway.wire.full = true;
  for (int i = 0; i < 16; ++i) EXPECT_EQ(gateway.ask("[1] 5 start"), "[1] OK") << i;
  EXPECT_EQ(gateway.ask("[1] 5 start"), "[1] ERROR:102");
}

TEST(GatewayHeartbeat, ALostNodeIsToldOfAndSoIsOneThatComes) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 enable heartbeat 100"), "[1] OK");
  gateway.run_for(1s);
  gateway.expect_lines({});
  gateway.receive("705#05");
  gateway.expect_lines({"1 5 ERROR 202"});
  gateway.run_for(90ms);
  gateway.receive("705#05");
  gateway.run_for(99'999us);
  gateway.expect_lines({});
  gateway.run_for(1us);
  gateway.expect_lines({"1 5 ERROR 203"});
  gateway.receive("705#7F");
  gateway.expect_lines({"1 5 ERROR 202"});
}

TEST(GatewayHeartbeat, CanBeDisabled) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 enable heartbeat 100"), "[1] OK");
  gateway.receive("705#05");
  gateway.expect_lines({"1 5 ERROR 202"});
  EXPECT_EQ(gateway.ask("[2] 5 disable heartbeat"), "[2] OK");
  gateway.run_for(1s);
  gateway.receive("705#05");
  gateway.expect_lines({});
}

TEST(GatewayHeartbeat, EnabledOnceMoreItTellsOnceMoreWhoComes) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 enable heartbeat 100"), "[1] OK");
  gateway.receive("705#05");
  gateway.expect_lines({"1 5 ERROR 202"});
  EXPECT_EQ(gateway.ask("[2] 5 enable heartbeat 200"), "[2] OK");
  gateway.receive("705#05");
  gateway.expect_lines({"1 5 ERROR 202"});
}

TEST(GatewayHeartbeat, AllNodesAtOnceHaveNone) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 0 enable heartbeat 100"), "[1] ERROR:107");
}

TEST(GatewayHeartbeat, ALossDoesNotStopTheGateway) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 5 enable heartbeat 100"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] set tpdo 1 0x202 event 1 u8"), "[2] OK");
  gateway.receive("705#05");
  gateway.run_for(100ms);
  gateway.expect_lines({"1 5 ERROR 202", "1 5 ERROR 203"});
  EXPECT_EQ(gateway.ask("[3] w p 1 1 5"), "[3] OK");
  gateway.expect_frames({"089#30 81 11 05 00 00 00 00", "202#05"});
}

TEST(GatewayGuarding, ANodeIsAskedByRemoteFramesAndToldOfWhenItIsLost) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 5 enable guarding 100 2"), "[1] OK");
  gateway.receive("705#7F");
  gateway.run_until(Time(100ms));
  gateway.receive("705#FF");
  gateway.run_until(Time(299'999us));
  gateway.expect_lines({});
  gateway.run_until(Time(300ms));
  gateway.expect_lines({"1 5 ERROR 200"});
  gateway.expect_frames({"@0 705#R1", "@100000 705#R1", "@200000 705#R1", "@300000 705#R1"});
}

TEST(GatewayGuarding, ANodeThatDoesNotFollowACommandIsToldOf) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 5 enable guarding 100 2"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] 0 start"), "[2] OK");
  gateway.run_until(Time(100ms));
  gateway.receive("705#7F");
  gateway.expect_lines({"1 5 ERROR 204"});
}

TEST(GatewayGuarding, CanBeDisabled) {
  WireGateway gateway({.node_id = 9});
  for (const char* line :
       {"[2] 5 disable guarding", "[2] 5 enable guarding 0 2", "[2] 5 enable guarding 100 0"}) {
    EXPECT_EQ(gateway.ask("[1] 5 enable guarding 100 2"), "[1] OK");
    EXPECT_EQ(gateway.ask(line), "[2] OK");
    gateway.expect_frames({"705#R1"});
    gateway.run_for(1s);
    gateway.expect_frames({});
    gateway.expect_lines({});
  }
}

TEST(GatewayGuarding, TheGatewayDoesNotGuardItself) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 9 enable guarding 100 2"), "[1] ERROR:107");
  EXPECT_EQ(gateway.ask("[2] 0 enable guarding 100 2"), "[2] ERROR:107");
}

TEST(GatewayGuarding, NeedsANodeIdOfTheGateway) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] 5 enable guarding 100 2"), "[1] ERROR:102");
}

TEST(GatewayOwnNode, SendsHeartbeatsAsItIsTold) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] set heartbeat 50"), "[1] OK");
  gateway.wire.forget_frames();
  gateway.run_for(100ms);
  gateway.expect_frames({"@50000 709#05", "@100000 709#05"});
}

TEST(GatewayOwnNode, WithoutANodeIdSendsNothingByItself) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set heartbeat 50"), "[1] ERROR:102");
  gateway.run_for(1s);
  gateway.expect_frames({});
}

TEST(GatewayOwnNode, TakesItsNodeIdWithInit) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set id 9"), "[1] OK");
  gateway.expect_frames({});
  EXPECT_EQ(gateway.ask("[2] init 4"), "[2] OK");
  gateway.expect_frames({"709#00"});
  EXPECT_EQ(gateway.ask("[3] 9 r 0x1018 2 u32"), "[3] 309");
  EXPECT_EQ(gateway.ask("[4] set id 128"), "[4] ERROR:107");
}

TEST(GatewayOwnNode, ForgetsItsSettingsWithInit) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] set rpdo 1 0x182 event 1 u8"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] 5 enable heartbeat 100"), "[2] OK");
  EXPECT_EQ(gateway.ask("[3] set sdo_timeout 10"), "[3] OK");
  EXPECT_EQ(gateway.ask("[4] init 0"), "[4] OK");
  gateway.receive("182#05");
  gateway.receive("705#05");
  gateway.say("[5] 6 r 0x1001 0 u8");
  gateway.run_for(999ms);
  gateway.expect_lines({});
  gateway.run_for(1ms);
  gateway.expect_lines({"[5] ERROR:0x05040000"});
}

TEST(GatewayOwnNode, InitEndsWhatOthersHaveUnderWay) {
  WireGateway gateway({.node_id = 9});
  Session& other = gateway.gateway.open();
  gateway.say(other, "[1] 5 r 0x1000 0 u32\r\n[2] 5 r 0x1001 0 u8");
  EXPECT_EQ(gateway.ask("[1] init 0"), "[1] OK");
  // The second request was held back by the first, and begins here.
  gateway.expect_lines(other, {"[1] ERROR:102"});
  gateway.receive("585#4F 01 10 00 00 00 00 00");
  gateway.expect_lines(other, {"[2] 0"});
}

TEST(GatewayOwnNode, InitSetsTheBitRateWhereItCan) {
  std::vector<unsigned> asked;
  WireGateway gateway({.set_bit_rate = [&](unsigned index) {
    asked.push_back(index);
    return index == 2;
  }});
  EXPECT_EQ(gateway.ask("[1] init 2"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] init 3"), "[2] ERROR:304");
  EXPECT_EQ(gateway.ask("[3] init 5"), "[3] ERROR:101") << "the index is reserved";
  EXPECT_EQ(asked, (std::vector<unsigned>{2, 3}));
}

TEST(GatewayOwnNode, TellsItsIdentityClassAndVersions) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] info version"), "[1] 0 309 0.0 0 3 3.0 0.1");
  WireGateway old({.version = Version::v2_1}, {.style = {.version = Version::v2_1}});
  EXPECT_EQ(old.ask("[1] 1 info version"), "[1] 0 309 0.0 0 3 2.1 0.1");
}

TEST(GatewayEvent, AnEmergencyIsToldWithAllOfItsBytes) {
  WireGateway gateway;
  gateway.receive("085#30 81 11 01 02 03 04 FF");
  gateway.expect_lines({"1 5 EMCY 8130 11 1 2 3 4 255"});
}

TEST(GatewayEvent, WhatOnlyLooksLikeAnEmergencyIsNot) {
  WireGateway gateway;
  for (const char* frame : {"080#", "080#05", "085#30 81 11", "085#R8",
                            "00000085#30 81 11 0 0 0 0 0", "100#00 00 00 00 00 00"}) {
    gateway.receive(frame);
  }
  gateway.expect_lines({});
}

TEST(GatewayEvent, ABootUpIsToldUntilItIsDisabled) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.receive("705#00");
  gateway.expect_lines({"1 5 BOOT_UP"});
  gateway.expect_lines(other, {"1 5 BOOT_UP"});
  EXPECT_EQ(gateway.ask("[1] boot_up_indication disable"), "[1] OK");
  gateway.receive("705#00");
  gateway.expect_lines({});
  gateway.expect_lines(other, {"1 5 BOOT_UP"});
  EXPECT_EQ(gateway.ask("[2] boot_up_indication Enable"), "[2] OK");
  gateway.receive("77F#00");
  gateway.expect_lines({"1 127 BOOT_UP"});
}

TEST(GatewayEvent, HeartbeatsAreNoBootUps) {
  WireGateway gateway;
  for (const char* frame : {"705#05", "705#7F", "705#00 00", "705#", "700#00", "705#R1"}) {
    gateway.receive(frame);
  }
  gateway.expect_lines({});
}

TEST(GatewayEvent, TheStateOfTheCanControllerIsToldOfNodeZero) {
  WireGateway gateway;
  gateway.wire.network.bus_state(BusState::error_passive, gateway.now);
  gateway.wire.network.bus_state(BusState::error_passive, gateway.now);
  gateway.wire.network.bus_state(BusState::bus_off, gateway.now);
  gateway.wire.network.bus_state(BusState::error_active, gateway.now);
  gateway.expect_lines({"1 0 ERROR 300", "1 0 ERROR 301", "1 0 ERROR 305"});
}

TEST(GatewayEvent, AWarningOfTheCanControllerIsErrorActive) {
  WireGateway gateway;
  gateway.wire.network.bus_state(BusState::error_warning, gateway.now);
  gateway.expect_lines({});
  gateway.wire.network.bus_state(BusState::error_passive, gateway.now);
  gateway.wire.network.bus_state(BusState::error_warning, gateway.now);
  gateway.wire.network.bus_state(BusState::error_active, gateway.now);
  gateway.expect_lines({"1 0 ERROR 300", "1 0 ERROR 305"});
}

TEST(GatewayEvent, LostFramesAreToldOfNodeZero) {
  WireGateway gateway;
  gateway.wire.network.overrun(gateway.now);
  gateway.wire.network.overrun(gateway.now);
  gateway.expect_lines({"1 0 ERROR 303", "1 0 ERROR 303"});
}

TEST(GatewayEvent, AMasterThatGuardsTheGatewayAndIsGoneIsALostConnection) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 9 w 0x100C 0 u16 100"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] 9 w 0x100D 0 u8 2"), "[2] OK");
  gateway.run_for(1h);
  gateway.expect_lines({});
  gateway.receive("709#R1");
  gateway.run_for(199'999us);
  gateway.expect_lines({});
  gateway.run_for(1us);
  gateway.expect_lines({"1 9 ERROR 201"});
  gateway.receive("709#R1");
  gateway.run_for(1s);
  gateway.expect_lines({"1 9 ERROR 201"});
}

TEST(GatewayEvent, TheEndOfABootUpProcedureIsToldByItsLetterOrState) {
  WireGateway gateway;
  gateway.wire.network.boot_ended(5, BootError::vendor_id, NmtState::initialisation);
  gateway.wire.network.boot_ended(6, BootError::none, NmtState::operational);
  gateway.wire.network.boot_ended(7, BootError::none, NmtState::pre_operational);
  gateway.wire.network.boot_ended(8, BootError::already_operational, NmtState::operational);
  gateway.expect_lines(
      {"1 5 USER BOOT D", "1 6 USER BOOT OPER", "1 7 USER BOOT PREOP", "1 8 USER BOOT L"});
}

TEST(GatewayEvent, TheEndOfABootUpProcedureIsExplainedInVersion21) {
  WireGateway gateway({.version = Version::v2_1}, {.style = {.version = Version::v2_1}});
  gateway.wire.network.boot_ended(5, BootError::no_answer, NmtState::initialisation);
  gateway.expect_lines({"1 5 USER BOOT B (no answer)"});
}

TEST(GatewayNetwork, LivesThroughEveryIdentifierAndLength) {
  WireGateway gateway({.node_id = 9});
  EXPECT_EQ(gateway.ask("[1] 5 enable heartbeat 100"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] set rpdo 1 0x182 event 1 u8"), "[2] OK");
  gateway.say("[3] 5 r 0x1000 0 u32");
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    for (std::uint8_t length = 0; length <= 8; ++length) {
      gateway.wire.network.receive(Frame::remote_frame(id, length), gateway.now);
      if (id == 0) continue;  // it would stop or reset the gateway
      for (const std::uint8_t byte : std::to_array<std::uint8_t>({0x00, 0x40, 0x80, 0xFF})) {
        const std::array<std::uint8_t, 8> bytes{byte, byte, byte, byte, byte, byte, byte, byte};
        gateway.wire.network.receive(Frame::data_frame(id, std::span(bytes).first(length)),
                                     gateway.now);
      }
    }
  }
  take_lines(gateway.client);
  gateway.run_for(2s);
  take_lines(gateway.client);
  gateway.wire.forget_frames();
  gateway.say("[9] 6 r 0x1001 0 u8");
  gateway.receive("586#4F 01 10 00 07 00 00 00");
  gateway.expect_lines({"[9] 7"});
}

}  // namespace
}  // namespace canvoy::gateway::network_test
