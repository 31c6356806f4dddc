// The SDO manager in node 1, frame by frame (CiA 302-5, as in devices in the field). Device 5 sends
// requests, node 10 is the server.
#include "canvoy/canopen/manager/sdo_manager.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_manager_test {
namespace {

struct Manager : WireNode {
  Manager() : WireNode(dynamic_sdo_manager(), 1) { boot(); }

  void heard(NodeId id, RemoteState state = RemoteState::operational) {
    node.advance(now);
    sut.remote_changed(id, state);
    settle();
  }
  /// A frame with numbers in it, formatted like printf.
  template <class... Numbers>
  void receive_made(const char* frame, Numbers... numbers) {
    char text[40];
    std::snprintf(text, sizeof text, frame, static_cast<unsigned>(numbers)...);
    receive(text);
  }
  /// Confirms, as node `id`, a write to object index:sub.
  void confirm(NodeId id, std::uint16_t index, unsigned sub) {
    receive_made("%03X#60 %02X %02X %02X 00 00 00 00", 0x580U + id, index & 0xFFU, index >> 8U,
                 sub);
  }
  /// Registers device 5 with its client 1280h.
  void register_5() {
    heard(5);
    receive("6E0#");
    receive("585#43 10 1F 00 00 00 80 12");
    for (const unsigned sub : {3U, 1U, 2U}) confirm(5, 0x1280, sub);
    confirm(5, 0x1F10, 0);
    sent.clear();
  }
  /// Gives device 5 a connection of one of its client channels to node `server`, which has 1201h
  /// free.
  void connect_5_to(NodeId server, std::uint16_t client) {
    receive_made("680#23 00 1F 00 %02X 05 %02X %02X", server, client & 0xFFU, client >> 8U);
    receive_made("%03X#43 01 12 01 00 00 00 80", 0x580U + server);
    for (const unsigned sub : {3U, 2U, 1U}) confirm(server, 0x1201, sub);
    for (const unsigned sub : {3U, 1U, 2U}) confirm(5, client, sub);
    confirm(5, 0x1F10, 0);
    sent.clear();
  }
  void connect_5_to_10() { connect_5_to(10, 0x1281); }
  void connect_5_to_11() { connect_5_to(11, 0x1282); }
  std::uint64_t listed(std::uint8_t sub) { return node.dictionary().number(0x1F03, sub); }
  std::uint64_t own_channel(std::uint16_t index) { return node.dictionary().number(index, 1); }

  SdoServer servers[3] = {SdoServer(node, 0, {}), SdoServer(node, 1, {}), SdoServer(node, 2, {})};
  std::array<SdoConnection, 3> connections;
  SdoManager sut{node, connections, {}};
};

TEST(SdoManagerRegistration, ADeviceThatCallsIsFoundByIts1F10hAndGetsAChannel) {
  Manager manager;
  manager.heard(5);
  manager.receive("6E0#");
  manager.expect({"605#40 10 1F 00 00 00 00 00"});
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.expect({"605#2F 80 12 03 01 00 00 00"});
  manager.confirm(5, 0x1280, 3);
  manager.expect({"605#23 80 12 01 80 06 00 40"});
  manager.confirm(5, 0x1280, 1);
  manager.expect({"605#23 80 12 02 81 06 00 40"});
  manager.confirm(5, 0x1280, 2);
  manager.expect({"605#23 10 1F 00 02 00 80 12"});
  manager.confirm(5, 0x1F10, 0);
  manager.expect({});
  EXPECT_EQ(manager.own_channel(0x1201), 0x4000'0680u) << "its own end, given dynamically";
  EXPECT_EQ(manager.node.dictionary().number(0x1201, 2), 0x4000'0681u);
  EXPECT_EQ(manager.node.dictionary().number(0x1201, 3), 5u);
  EXPECT_EQ(manager.listed(1), 0x0500'0101u);
}

TEST(SdoManagerRegistration, NodesThatWereHeardAreAskedFirstAndAllOfThem) {
  Manager manager;
  manager.heard(9);
  manager.heard(5);
  manager.receive("6E0#");
  manager.expect({"605#40 10 1F 00 00 00 00 00"});
  manager.receive("585#80 10 1F 00 00 00 02 06");
  manager.expect({"609#40 10 1F 00 00 00 00 00"});
  manager.receive("589#43 10 1F 00 00 00 80 12");
  manager.expect({"609#2F 80 12 03 01 00 00 00"});
}

TEST(SdoManagerRegistration, WithoutARequestAmongThemTheOthersAreAskedFor50MsEach) {
  Manager manager;
  manager.heard(2);
  manager.receive("6E0#");
  manager.receive("582#43 10 1F 00 00 00 00 00");
  manager.expect({"602#40 10 1F 00 00 00 00 00", "603#40 10 1F 00 00 00 00 00"});
  manager.run_for(50ms);
  manager.expect({"@50000 603#80 10 1F 00 00 00 04 05", "@50000 604#40 10 1F 00 00 00 00 00"});
  manager.run_for(10s);
  EXPECT_EQ(manager.sent.back().frame.id, 0x67Fu) << "the last one";
  EXPECT_EQ(manager.sent.back().at, Time(125 * 50ms));
  manager.sent.clear();
  manager.run_for(1min);
  manager.expect({});
}

TEST(SdoManagerRegistration, ACallThatComesWhileThereIsNoRouteDoesNoHarmToTheNext) {
  Manager manager;
  manager.heard(5);
  const Router::Receiver nobody;
  std::vector<std::uint16_t> taken;
  for (std::uint16_t id = 0x301; manager.node.router().add(id, nobody); ++id) taken.push_back(id);
  manager.receive("6E0#");
  manager.expect({});
  for (const std::uint16_t id : taken) manager.node.router().remove(id, nobody);
  manager.receive("6E0#");
  manager.expect({"605#40 10 1F 00 00 00 00 00"});
}

TEST(SdoManagerRegistration, ADeviceThatIsAnsweredAlreadyDoesNotAsk) {
  for (const char* state :
       {"585#43 10 1F 00 02 00 80 12", "585#43 10 1F 00 06 00 81 12", "585#43 10 1F 00 00 01 80 12",
        "585#43 10 1F 00 00 00 00 12", "585#43 10 1F 00 00 00 00 13", "585#4B 10 1F 00 00 00 80 12",
        "585#4F 10 1F 00 00 00 80 12"}) {
    Manager manager;
    manager.heard(5);
    manager.receive("6E0#");
    manager.sent.clear();
    manager.receive(state);
    manager.expect({"602#40 10 1F 00 00 00 00 00"});
  }
}

TEST(SdoManagerRegistration, ACallWithDataIsIgnoredAndCounted) {
  Manager manager;
  manager.heard(5);
  for (const char* call : {"6E0#00", "6E0#00 00 00 00 00 00 00 00"}) manager.receive(call);
  manager.expect({});
  EXPECT_EQ(manager.node.counters().malformed, 2u);
  manager.receive("6E0#R");
  manager.expect({});
}

TEST(SdoManagerRegistration, InNmtStateStoppedNobodyIsHeard) {
  Manager manager;
  manager.heard(5);
  manager.receive("000#02 01");
  manager.receive("6E0#");
  manager.receive("000#01 01");
  manager.expect({});
}

TEST(SdoManagerRegistration, ADeviceThatDoesNotAnswerIsAskedThreeTimesAndDropped) {
  Manager manager;
  manager.heard(5);
  manager.receive("6E0#");
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.sent.clear();
  manager.run_for(10s);
  const std::size_t tries = static_cast<std::size_t>(std::ranges::count_if(
      manager.sent, [](const WireNode::Sent& sent) { return sent.frame.data[0] == 0x2F; }));
  EXPECT_EQ(tries + 1, 3u) << "the first one was before";
  EXPECT_EQ(manager.own_channel(0x1201) & 0x8000'0000, 0x8000'0000u) << "its own end is closed";
  EXPECT_EQ(manager.connections[0].state, SdoConnection::State::unused);
}

TEST(SdoManagerRegistration, ADeviceThatRefusesItsChannelIsToldError7) {
  Manager manager;
  manager.heard(5);
  manager.receive("6E0#");
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.sent.clear();
  manager.receive("585#80 80 12 03 00 00 02 06");
  manager.receive("585#80 80 12 01 00 00 02 06");
  manager.receive("585#80 80 12 02 00 00 02 06");
  manager.expect({"605#23 80 12 01 00 00 00 C0", "605#23 80 12 02 00 00 00 C0",
                  "605#23 10 1F 00 00 07 80 12"});
}

TEST(SdoManagerRegistration, WithoutTwoCobIdsTheDeviceIsToldError1) {
  Manager manager;
  for (std::uint8_t sub = 1; sub <= 4; ++sub) {
    manager.node.dictionary().set_number(0x1F02, sub, 0x8000'0680);
  }
  manager.heard(5);
  manager.receive("6E0#");
  manager.sent.clear();
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.expect({"605#23 10 1F 00 00 01 80 12"});
  manager.confirm(5, 0x1F10, 0);
  EXPECT_EQ(manager.connections[0].state, SdoConnection::State::unused);
}

TEST(SdoManagerRegistration, WithoutAServerOfItsOwnTheDeviceIsToldError5) {
  Manager manager;
  manager.node.dictionary().set_number(0x1201, 1, 0x690);
  manager.node.dictionary().set_number(0x1202, 1, 0x692);
  manager.heard(5);
  manager.receive("6E0#");
  manager.sent.clear();
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.expect({"605#23 10 1F 00 00 05 80 12"});
}

TEST(SdoManagerRegistration, ADeviceThatCallsAnewLosesWhatItHad) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("6E0#");
  manager.receive("585#43 10 1F 00 00 00 80 12");
  // The registration: only its own end here; the connection: both ends.
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1280, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.expect({"605#40 10 1F 00 00 00 00 00", "605#23 80 12 01 00 00 00 C0",
                  "605#23 80 12 02 00 00 00 C0", "60A#23 01 12 01 00 00 00 C0",
                  "60A#23 01 12 02 00 00 00 C0", "605#23 81 12 01 00 00 00 C0",
                  "605#23 81 12 02 00 00 00 C0", "605#2F 80 12 03 01 00 00 00"});
}

TEST(SdoManagerRegistration, ADeviceThatCallsAnewFindsThePlaceOfWhatItHad) {
  Manager manager;
  manager.node.dictionary().set_number(0x1F02, 6, 0x685);
  manager.register_5();
  manager.connect_5_to_10();
  manager.connect_5_to_11();
  for (const SdoConnection& connection : manager.connections) {
    EXPECT_EQ(connection.state, SdoConnection::State::given) << "no place is left";
  }
  manager.receive("6E0#");
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.expect({"605#40 10 1F 00 00 00 00 00", "605#23 80 12 01 00 00 00 C0"});
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1280, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(11, 0x1201, sub);
  manager.confirm(5, 0x1282, 1);
  manager.sent.clear();
  manager.confirm(5, 0x1282, 2);
  manager.expect({"605#40 10 1F 00 00 00 00 00"});
  manager.receive("585#43 10 1F 00 00 00 80 12");
  manager.expect({"605#2F 80 12 03 01 00 00 00"});
}

TEST(SdoManagerRegistration, AllDefaultChannelsMayBeGivenAndAllElseWaits) {
  Manager manager;
  manager.heard(5);
  manager.receive("6E0#");
  manager.receive("585#43 10 1F 00 01 00 80 12");
  for (const unsigned sub : {3U, 1U, 2U}) manager.confirm(5, 0x1280, sub);
  manager.expect({"605#40 10 1F 00 00 00 00 00", "605#2F 80 12 03 01 00 00 00",
                  "605#23 80 12 01 80 06 00 40", "605#23 80 12 02 81 06 00 40",
                  "605#23 10 1F 00 05 00 80 12"});
  manager.confirm(5, 0x1F10, 0);
  manager.receive("6E0#");
  manager.run_for(10s);
  manager.expect({});
  manager.receive("680#23 01 1F 00 00 05 00 00");
  manager.expect({"681#60 01 1F 00 00 00 00 00", "605#23 80 12 01 00 00 00 C0"});
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1280, sub);
  manager.expect({"605#23 80 12 02 00 00 00 C0", "605#40 10 1F 00 00 00 00 00"});
}

// 1F00h: request of a connection

TEST(SdoManagerRequest, TheServerIsAskedForAFreeChannelAndBothEndsAreWritten) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.expect({"681#60 00 1F 00 00 00 00 00", "60A#40 01 12 01 00 00 00 00"});
  manager.receive("58A#43 01 12 01 00 00 00 80");
  manager.expect({"60A#2F 01 12 03 05 00 00 00"});
  manager.confirm(10, 0x1201, 3);
  manager.expect({"60A#23 01 12 02 83 06 00 40"});
  manager.confirm(10, 0x1201, 2);
  manager.expect({"60A#23 01 12 01 82 06 00 40"});
  manager.confirm(10, 0x1201, 1);
  manager.expect({"605#2F 81 12 03 0A 00 00 00"});
  manager.confirm(5, 0x1281, 3);
  manager.expect({"605#23 81 12 01 82 06 00 40"});
  manager.confirm(5, 0x1281, 1);
  manager.expect({"605#23 81 12 02 83 06 00 40"});
  manager.confirm(5, 0x1281, 2);
  manager.expect({"605#23 10 1F 00 06 00 81 12"});
  manager.confirm(5, 0x1F10, 0);
  manager.expect({});
  EXPECT_EQ(manager.listed(2), 0x0501'0A01u);
}

TEST(SdoManagerRequest, AChannelInUseIsPassedOver) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 90 06 00 00");
  manager.receive("58A#43 02 12 01 00 00 00 80");
  manager.expect({"681#60 00 1F 00 00 00 00 00", "60A#40 01 12 01 00 00 00 00",
                  "60A#40 02 12 01 00 00 00 00", "60A#2F 02 12 03 05 00 00 00"});
}

TEST(SdoManagerRequest, TheNodeIdOfTheClientIsAnOptionalEntryOfTheServer) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 00 00 00 80");
  manager.sent.clear();
  manager.receive("58A#80 01 12 03 11 00 09 06");
  manager.expect({"60A#23 01 12 02 83 06 00 40"});
}

TEST(SdoManagerRequest, AServerWithoutAFreeChannelIsError2) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 90 06 00 00");
  manager.sent.clear();
  manager.receive("58A#80 02 12 01 00 00 02 06");
  manager.expect({"605#23 10 1F 00 00 02 81 12"});
  manager.confirm(5, 0x1F10, 0);
  EXPECT_EQ(manager.connections[1].state, SdoConnection::State::unused);
}

TEST(SdoManagerRequest, AServerThatIsSilentIsError3AfterThreeTries) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.sent.clear();
  manager.run_for(750ms);
  manager.expect({"@250000 60A#80 01 12 01 00 00 04 05", "@250000 60A#40 01 12 01 00 00 00 00",
                  "@500000 60A#80 01 12 01 00 00 04 05", "@500000 60A#40 01 12 01 00 00 00 00",
                  "@750000 60A#80 01 12 01 00 00 04 05", "@750000 605#23 10 1F 00 00 03 81 12"});
}

TEST(SdoManagerRequest, AServerThatRefusesIsError4AndItsChannelIsClosedAgain) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 00 00 00 80");
  manager.confirm(10, 0x1201, 3);
  manager.sent.clear();
  manager.receive("58A#80 01 12 02 30 00 09 06");
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.expect({"60A#23 01 12 01 00 00 00 C0", "60A#23 01 12 02 00 00 00 C0",
                  "605#23 81 12 01 00 00 00 C0", "605#23 81 12 02 00 00 00 C0",
                  "605#23 10 1F 00 00 04 81 12"});
}

TEST(SdoManagerRequest, WithoutTwoCobIdsIsError1) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 00 1F 00 0B 05 82 12");
  manager.expect({"681#60 00 1F 00 00 00 00 00", "605#23 10 1F 00 00 01 82 12"});
}

TEST(SdoManagerRequest, TheSameAgainIsWrittenAgainWithTheSameCobIds) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  for (const unsigned sub : {3U, 2U, 1U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {3U, 1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.expect({"681#60 00 1F 00 00 00 00 00", "60A#2F 01 12 03 05 00 00 00",
                  "60A#23 01 12 02 83 06 00 40", "60A#23 01 12 01 82 06 00 40",
                  "605#2F 81 12 03 0A 00 00 00", "605#23 81 12 01 82 06 00 40",
                  "605#23 81 12 02 83 06 00 40", "605#23 10 1F 00 06 00 81 12"});
}

TEST(SdoManagerRequest, WhatMakesNoSenseIsRefused) {
  Manager manager;
  manager.register_5();
  for (const char* value :
       {"00 05 81 12", "05 05 81 12", "80 05 81 12", "01 05 81 12", "0A 00 81 12", "0A 80 81 12",
        "0A 05 7F 12", "0A 05 00 13", "0A 05 00 00", "FF FF FF FF"}) {
    manager.receive(std::string("680#23 00 1F 00 ") + value);
    manager.expect({"681#80 00 1F 00 30 00 09 06"});
  }
}

TEST(SdoManagerRequest, ADeviceThatIsNotRegisteredIsRefused) {
  Manager manager;
  manager.receive("601#23 00 1F 00 0A 05 81 12");
  manager.expect({"581#80 00 1F 00 22 00 00 08"});
}

TEST(SdoManagerRequest, AClientChannelInUseIsRefused) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 00 1F 00 0B 05 81 12");
  manager.expect({"681#80 00 1F 00 22 00 00 08"});
  manager.receive("680#23 00 1F 00 0B 05 80 12");
  manager.expect({"681#80 00 1F 00 22 00 00 08"});
}

TEST(SdoManagerRequest, MoreThanItHasRoomForIsRefused) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 00 1F 00 0B 05 82 12");
  manager.sent.clear();
  manager.receive("680#23 00 1F 00 0C 05 83 12");
  manager.expect({"681#80 00 1F 00 23 00 0A 06"});
}

// 1F01h: release

TEST(SdoManagerRelease, ClosesBothEndsOfAConnection) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 01 1F 00 0A 05 81 12");
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.expect({"681#60 01 1F 00 00 00 00 00", "60A#23 01 12 01 00 00 00 C0",
                  "60A#23 01 12 02 00 00 00 C0", "605#23 81 12 01 00 00 00 C0",
                  "605#23 81 12 02 00 00 00 C0"});
  EXPECT_EQ(manager.listed(2), 0u);
  EXPECT_EQ(manager.listed(1), 0x0500'0101u) << "the registration stays";
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 00 00 00 C0");
  manager.confirm(10, 0x1201, 3);
  manager.expect({"681#60 00 1F 00 00 00 00 00", "60A#40 01 12 01 00 00 00 00",
                  "60A#2F 01 12 03 05 00 00 00", "60A#23 01 12 02 83 06 00 40"});
}

TEST(SdoManagerRelease, Index0MeansAllConnectionsToTheServer) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 01 1F 00 0A 05 00 00");
  manager.expect({"681#60 01 1F 00 00 00 00 00", "60A#23 01 12 01 00 00 00 C0"});
  EXPECT_EQ(manager.connections[0].state, SdoConnection::State::given);
}

TEST(SdoManagerRelease, ThatNmtStateStoppedInterruptsGoesOnAfterwards) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 01 1F 00 0A 05 81 12");
  manager.expect({"681#60 01 1F 00 00 00 00 00", "60A#23 01 12 01 00 00 00 C0"});
  manager.receive("000#02 01");
  manager.run_for(10s);
  manager.sent.clear();
  EXPECT_EQ(manager.connections[1].request, 0x682) << "nobody was told that it is free";
  EXPECT_EQ(manager.listed(2), 0x0501'0A01u);
  manager.receive("000#01 01");
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.expect({"60A#23 01 12 01 00 00 00 C0", "60A#23 01 12 02 00 00 00 C0",
                  "605#23 81 12 01 00 00 00 C0", "605#23 81 12 02 00 00 00 C0"});
  EXPECT_EQ(manager.connections[1].state, SdoConnection::State::unused);
  EXPECT_EQ(manager.listed(2), 0u);
}

TEST(SdoManagerRelease, Server0MeansTheRegistrationAndAllWithIt) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.receive("680#23 01 1F 00 00 05 00 00");
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1280, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  for (const SdoConnection& connection : manager.connections) {
    EXPECT_EQ(connection.state, SdoConnection::State::unused);
  }
  EXPECT_EQ(manager.own_channel(0x1201), 0xC000'0000u);
}

TEST(SdoManagerRelease, WhatMakesNoSenseIsRefused) {
  Manager manager;
  manager.register_5();
  for (const char* value :
       {"0A 00 81 12", "0A 80 81 12", "80 05 81 12", "0A 05 7F 12", "0A 05 00 13"}) {
    manager.receive(std::string("680#23 01 1F 00 ") + value);
    manager.expect({"681#80 01 1F 00 30 00 09 06"});
  }
  manager.receive("601#23 01 1F 00 0A 06 81 12");
  manager.expect({"581#80 01 1F 00 22 00 00 08"});
}

// Nodes that are lost, or restart

TEST(SdoManagerLoss, OfTheDeviceClosesTheServersEnd) {
  for (const RemoteState state : {RemoteState::lost, RemoteState::boot_up}) {
    Manager manager;
    manager.register_5();
    manager.connect_5_to_10();
    manager.heard(5, state);
    for (const unsigned sub : {1U, 2U}) manager.confirm(10, 0x1201, sub);
    manager.expect({"60A#23 01 12 01 00 00 00 C0", "60A#23 01 12 02 00 00 00 C0"});
    EXPECT_EQ(manager.own_channel(0x1201), 0xC000'0000u);
    EXPECT_EQ(manager.listed(1), 0u);
    EXPECT_EQ(manager.listed(2), 0u);
  }
}

TEST(SdoManagerLoss, OfTheServerClosesTheDevicesEndAndIsError6) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.heard(10, RemoteState::lost);
  for (const unsigned sub : {1U, 2U}) manager.confirm(5, 0x1281, sub);
  manager.confirm(5, 0x1F10, 0);
  manager.expect({"605#23 81 12 01 00 00 00 C0", "605#23 81 12 02 00 00 00 C0",
                  "605#23 10 1F 00 00 06 81 12"});
  EXPECT_EQ(manager.connections[0].state, SdoConnection::State::given);
}

TEST(SdoManagerLoss, InTheMiddleOfARequestEndsIt) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("58A#43 01 12 01 00 00 00 80");
  manager.heard(5, RemoteState::lost);
  manager.run_for(10s);
  for (const SdoConnection& connection : manager.connections) {
    EXPECT_EQ(connection.state, SdoConnection::State::unused);
  }
  EXPECT_FALSE(manager.sut.busy());
}

TEST(SdoManagerLoss, OfOthersChangesNothing) {
  Manager manager;
  manager.register_5();
  manager.connect_5_to_10();
  manager.heard(11, RemoteState::lost);
  manager.heard(5, RemoteState::pre_operational);
  manager.heard(10, RemoteState::stopped);
  manager.heard(0, RemoteState::lost);
  manager.heard(255, RemoteState::lost);
  manager.expect({});
}

TEST(SdoManagerLoss, AResetOfTheManagerForgetsAll) {
  Manager manager;
  manager.register_5();
  manager.receive("680#23 00 1F 00 0A 05 81 12");
  manager.receive("000#82 01");
  manager.run_for(10s);
  for (const SdoConnection& connection : manager.connections) {
    EXPECT_EQ(connection.state, SdoConnection::State::unused);
  }
  EXPECT_FALSE(manager.sut.busy());
  EXPECT_EQ(manager.own_channel(0x1201), 0x8000'0000u);
}

// 1F02h: COB-IDs

TEST(SdoManagerCobIds, MayNotChangeWhileTheyAreGiven) {
  Manager manager;
  manager.register_5();
  manager.receive("601#23 02 1F 01 00 00 00 80");
  manager.expect({"581#80 02 1F 01 22 00 00 08"});
  manager.receive("601#23 02 1F 01 80 06 00 00");
  manager.expect({"581#60 02 1F 01 00 00 00 00"});
  manager.receive("601#23 02 1F 03 00 00 00 80");
  manager.expect({"581#60 02 1F 03 00 00 00 00"});
}

TEST(SdoManagerCobIds, AreDifferentAndNeitherRestrictedNorOf29Bits) {
  Manager manager;
  for (const char* value : {"00 00 00 00", "05 06 00 00", "85 05 00 00", "E0 06 00 00",
                            "05 07 00 00", "90 06 00 20", "90 06 01 00"}) {
    manager.receive(std::string("601#23 02 1F 06 ") + value);
    manager.expect({"581#80 02 1F 06 30 00 09 06"});
  }
  manager.receive("601#23 02 1F 06 80 06 00 00");
  manager.expect({"581#80 02 1F 06 43 00 04 06"});
  manager.receive("601#23 02 1F 06 85 06 00 00");
  manager.expect({"581#60 02 1F 06 00 00 00 00"});
}

}  // namespace
}  // namespace canvoy::sdo_manager_test
