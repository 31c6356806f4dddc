// Layer setting services (CiA 309-3; frames by CiA 305).
#include <gtest/gtest.h>

#include "canvoy/gateway/testing/wire_gateway.hpp"

namespace canvoy::gateway::lss_access_test {
namespace {

TEST(GatewayLss, SwitchStateGlobalIsNotAnswered) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] lss_switch_glob 1"), "[1] OK");
  EXPECT_EQ(gateway.ask("[2] lss_switch_glob 0"), "[2] OK");
  gateway.expect_frames({"7E5#04 01 00 00 00 00 00 00", "7E5#04 00 00 00 00 00 00 00"});
}

TEST(GatewayLss, SwitchStateSelectiveIsConfirmedByTheSlave) {
  WireGateway gateway;
  gateway.say("[1] lss_switch_sel 0x360 0x11223344 0x00010002 77");
  gateway.expect_frames({"7E5#40 60 03 00 00 00 00 00", "7E5#41 44 33 22 11 00 00 00",
                         "7E5#42 02 00 01 00 00 00 00", "7E5#43 4D 00 00 00 00 00 00"});
  gateway.expect_lines({});
  gateway.receive("7E4#44 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
}

TEST(GatewayLss, NobodyAnswersWithinASecond) {
  WireGateway gateway;
  gateway.say("[1] lss_switch_sel 1 2 3 4");
  gateway.run_until(Time(999'999us));
  gateway.expect_lines({});
  gateway.run_until(Time(1s));
  gateway.expect_lines({"[1] ERROR:103"});
}

TEST(GatewayLss, ANodeIdIsConfigured) {
  WireGateway gateway;
  gateway.say("[1] lss_set_node 10");
  gateway.expect_frames({"7E5#11 0A 00 00 00 00 00 00"});
  gateway.receive("7E4#11 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
  gateway.say("[2] lss_set_node 255");
  gateway.expect_frames({"7E5#11 FF 00 00 00 00 00 00"});
  gateway.receive("7E4#11 01 00 00 00 00 00 00");
  gateway.expect_lines({"[2] ERROR:502"});
  gateway.say("[3] lss_set_node 11");
  gateway.receive("7E4#11 FF 05 00 00 00 00 00");
  gateway.expect_lines({"[3] ERROR:501"});
}

TEST(GatewayLss, ANodeIdThatThereIsNotIsNotSent) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] lss_set_node 128"), "[1] ERROR:502");
  EXPECT_EQ(gateway.ask("[2] lss_set_node 254"), "[2] ERROR:502");
  gateway.expect_frames({});
}

TEST(GatewayLss, ABitRateIsConfiguredAndActivated) {
  WireGateway gateway;
  gateway.say("[1] lss_conf_bitrate 0 4");
  gateway.expect_frames({"7E5#13 00 04 00 00 00 00 00"});
  gateway.receive("7E4#13 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
  gateway.say("[2] lss_conf_bitrate 0 5");
  gateway.receive("7E4#13 01 00 00 00 00 00 00");
  gateway.expect_lines({"[2] ERROR:503"});
  gateway.expect_frames({"7E5#13 00 05 00 00 00 00 00"});
  EXPECT_EQ(gateway.ask("[3] lss_activate_bitrate 1000"), "[3] OK");
  gateway.expect_frames({"7E5#15 E8 03 00 00 00 00 00"});
}

TEST(GatewayLss, StoringIsConfirmedOrRefused) {
  WireGateway gateway;
  for (const auto& [frame, line] : {std::pair{"7E4#17 00 00 00 00 00 00 00", "[1] OK"},
                                    {"7E4#17 01 00 00 00 00 00 00", "[1] ERROR:504"},
                                    {"7E4#17 02 00 00 00 00 00 00", "[1] ERROR:505"},
                                    {"7E4#17 FF 07 00 00 00 00 00", "[1] ERROR:501"}}) {
    gateway.say("[1] lss_store");
    gateway.expect_frames({"7E5#17 00 00 00 00 00 00 00"});
    gateway.receive(frame);
    gateway.expect_lines({line});
  }
}

TEST(GatewayLss, APartOfTheAddressIsInquired) {
  WireGateway gateway;
  gateway.say("[1] lss_inquire_addr 0x5C");
  gateway.expect_frames({"7E5#5C 00 00 00 00 00 00 00"});
  gateway.receive("7E4#5C 02 00 01 00 00 00 00");
  gateway.expect_lines({"[1] 0x00010002"});
  gateway.say("[2] lss_inquire_addr 0");
  gateway.expect_frames({"7E5#5A 00 00 00 00 00 00 00"});
}

TEST(GatewayLss, TheWholeAddressIsInquired) {
  WireGateway gateway;
  gateway.say("[1] lss_inquire_addr");
  gateway.receive("7E4#5A 60 03 00 00 00 00 00");
  gateway.receive("7E4#5B 44 33 22 11 00 00 00");
  gateway.receive("7E4#5C 02 00 01 00 00 00 00");
  gateway.expect_lines({});
  gateway.receive("7E4#5D 4D 00 00 00 00 00 00");
  gateway.expect_lines({"[1] 0x00000360 0x11223344 0x00010002 0x0000004d"});
  gateway.expect_frames({"7E5#5A 00 00 00 00 00 00 00", "7E5#5B 00 00 00 00 00 00 00",
                         "7E5#5C 00 00 00 00 00 00 00", "7E5#5D 00 00 00 00 00 00 00"});
}

TEST(GatewayLss, TheNodeIdIsInquired) {
  WireGateway gateway;
  gateway.say("[1] lss_get_node");
  gateway.expect_frames({"7E5#5E 00 00 00 00 00 00 00"});
  gateway.receive("7E4#5E 0A 00 00 00 00 00 00");
  gateway.expect_lines({"[1] 10"});
}

TEST(GatewayLss, SlavesOfARangeAreIdentified) {
  WireGateway gateway;
  gateway.say("[1] lss_identity 0x360 1 2 3 4 5");
  gateway.expect_frames({"7E5#46 60 03 00 00 00 00 00", "7E5#47 01 00 00 00 00 00 00",
                         "7E5#48 02 00 00 00 00 00 00", "7E5#49 03 00 00 00 00 00 00",
                         "7E5#4A 04 00 00 00 00 00 00", "7E5#4B 05 00 00 00 00 00 00"});
  gateway.receive("7E4#4F 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
}

TEST(GatewayLss, SlavesWithoutNodeIdAreIdentified) {
  WireGateway gateway;
  gateway.say("[1] lss_ident_nonconf");
  gateway.expect_frames({"7E5#4C 00 00 00 00 00 00 00"});
  gateway.receive("7E4#50 00 00 00 00 00 00 00");
  gateway.expect_lines({"[1] OK"});
}

TEST(GatewayLss, FastscanThatNobodyAnswersTimesOut) {
  WireGateway gateway;
  gateway.say("[1] _lss_fastscan 50");
  gateway.run_for(1s);
  gateway.expect_lines({"[1] ERROR:103"});
}

TEST(GatewayLss, FastscanWithAPartOfAMaskIsNotSupported) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] _lss_fastscan 0x360 0xFFFF0000 0 0 0 0 0 0"), "[1] ERROR:100");
}

TEST(GatewayLss, OneServiceIsUnderWayAtATime) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.say("[1] lss_get_node");
  gateway.say(other, "[1] lss_store");
  gateway.expect_frames({"7E5#5E 00 00 00 00 00 00 00"});
  gateway.receive("7E4#5E 0A 00 00 00 00 00 00");
  gateway.expect_frames({"7E5#17 00 00 00 00 00 00 00"});
  gateway.expect_lines({"[1] 10"});
  gateway.receive("7E4#17 00 00 00 00 00 00 00");
  gateway.expect_lines(other, {"[1] OK"});
}

TEST(GatewayLss, ACommandThatTakesTooLongMakesRoomForTheNext) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set command_timeout 10"), "[1] OK");
  gateway.say("[2] _lss_fastscan\r\n[3] lss_store");
  gateway.run_for(10ms);
  gateway.wire.forget_frames();
  gateway.receive("7E4#17 00 00 00 00 00 00 00");
  gateway.expect_lines({"[2] ERROR:103", "[3] OK"});
}

TEST(GatewayLss, InitEndsAScan) {
  WireGateway gateway;
  Session& other = gateway.gateway.open();
  gateway.say(other, "[1] _lss_fastscan\r\n");
  EXPECT_EQ(gateway.ask("[1] init 0"), "[1] OK");
  gateway.expect_lines(other, {"[1] ERROR:102"});
  gateway.run_for(2s);
  gateway.expect_lines(other, {});
}

}  // namespace
}  // namespace canvoy::gateway::lss_access_test
