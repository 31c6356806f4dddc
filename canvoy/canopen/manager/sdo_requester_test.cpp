// The device that requests SDO connections, node 5, frame by frame (CiA 302-5, as in devices in the
// field). The SDO manager is node 1, the server node 10.
#include "canvoy/canopen/manager/sdo_requester.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_requester_test {
namespace {

struct Device : WireNode {
  Device() : WireNode(detail::requesting_layout.tables(), 5) { boot(); }

  AbortCode connect(NodeId id = 10, std::uint8_t number = 1) {
    node.advance(now);
    return sut.connect(id, number, SdoRequester::Done::to<&Device::done>(*this));
  }
  AbortCode connect_all() { return sut.connect_all(SdoRequester::Done::to<&Device::done>(*this)); }
  void done(SdoEnd end) { answers.push_back(end); }
  /// Writes the channel like the SDO manager.
  void give_manager_channel() {
    receive("605#2F 80 12 03 01 00 00 00");
    receive("605#23 80 12 01 80 06 00 40");
    receive("605#23 80 12 02 81 06 00 40");
    sent.clear();
  }
  void register_it() {
    EXPECT_EQ(connect(), AbortCode::none);
    give_manager_channel();
    receive("605#23 10 1F 00 02 00 80 12");
    receive("681#60 00 1F 00 00 00 00 00");
    sent.clear();
  }
  void give_connection() {
    receive("605#2F 81 12 03 0A 00 00 00");
    receive("605#23 81 12 01 82 06 00 40");
    receive("605#23 81 12 02 83 06 00 40");
    receive("605#23 10 1F 00 06 00 81 12");
    sent.clear();
  }

  SdoServer server{node, 0, {}};
  SdoClient client{node, 1};
  SdoRequester sut{node, {.time_out = 500ms, .calls_max = 2}};
  std::vector<SdoEnd> answers;
};

TEST(SdoRequester, FillsInIts1F10hAndCalls) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.expect({"6E0#"});
  device.receive("605#40 10 1F 00 00 00 00 00");
  device.expect({"585#43 10 1F 00 00 00 80 12"});
  EXPECT_TRUE(device.sut.busy());
  EXPECT_FALSE(device.sut.registered());
}

TEST(SdoRequester, WhenItIsRegisteredItRequestsOnItsOwnChannel) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.expect({"680#23 00 1F 00 0A 05 81 12", "585#60 10 1F 00 00 00 00 00"});
  device.receive("681#60 00 1F 00 00 00 00 00");
  EXPECT_TRUE(device.sut.busy()) << "it was heard, no more";
  device.give_connection();
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  EXPECT_TRUE(device.sut.registered());
}

TEST(SdoRequester, TheConnectionIsThatOfItsClient) {
  Device device;
  device.register_it();
  device.give_connection();
  std::array<std::uint8_t, 4> bytes{};
  ASSERT_EQ(device.client.upload(10, 0x2000, 0, bytes, {}), AbortCode::none);
  device.expect({"682#40 00 20 00 00 00 00 00"});
  device.receive("683#43 00 20 00 78 56 34 12");
  EXPECT_EQ(bytes[3], 0x12);
}

TEST(SdoRequester, OnceRegisteredItNeedsNotCallAgain) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.expect({"680#23 00 1F 00 0B 05 82 12"});
}

TEST(SdoRequester, CallsTwiceAndThenGivesUp) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.run_for(999ms);
  device.expect({"@0 6E0#", "@500000 6E0#"});
  EXPECT_TRUE(device.answers.empty());
  device.run_for(1ms);
  device.expect({});
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::no_answer()});
  EXPECT_FALSE(device.sut.busy());
  EXPECT_EQ(device.connect(), AbortCode::none) << "and may try again";
  device.expect({"6E0#"});
}

TEST(SdoRequester, AManagerThatComesLaterIsTakenAtTheNextRequest) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.run_for(1s);
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.expect({"585#60 10 1F 00 00 00 00 00"});
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.expect({"680#23 00 1F 00 0A 05 81 12"});
}

TEST(SdoRequester, AnErrorCodeRefusesTheRegistration) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.receive("605#23 10 1F 00 00 01 80 12");
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::by_server(AbortCode::no_sdo_connection)});
  EXPECT_EQ(device.sut.error(), DynamicSdoError::no_cob_id);
}

TEST(SdoRequester, AnErrorCodeRefusesTheConnection) {
  Device device;
  device.register_it();
  device.receive("605#23 10 1F 00 00 02 81 12");
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::by_server(AbortCode::no_sdo_connection)});
  EXPECT_EQ(device.sut.error(), DynamicSdoError::no_server_channel);
  EXPECT_TRUE(device.sut.registered());
}

TEST(SdoRequester, AnAbortOfTheManagerRefusesTheConnection) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.receive("681#80 00 1F 00 23 00 0A 06");
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::by_server(AbortCode::no_sdo_connection)});
  EXPECT_FALSE(device.sut.busy());
}

/// A manager that answers 0504 0000h is present: no new registration is needed.
TEST(SdoRequester, ATimeOutThatTheManagerTellsIsNoSilenceOfTheManager) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.sent.clear();
  device.receive("681#80 00 1F 00 00 00 04 05");
  device.expect({});
  EXPECT_EQ(device.answers, (std::vector{SdoEnd(), SdoEnd::by_server(AbortCode::time_out)}));
}

TEST(SdoRequester, ARegistrationWithoutAChannelIsNone) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.receive("605#23 10 1F 00 02 00 80 12");
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{AbortCode::no_sdo_connection});
}

TEST(SdoRequester, AConnectionThatDoesNotComeTimesOut) {
  Device device;
  device.register_it();
  device.run_for(500ms);
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::no_answer()});
  device.expect({"@500000 680#23 01 1F 00 0A 05 81 12"});  // a later connection is returned
  device.receive("681#60 01 1F 00 00 00 00 00");
  EXPECT_FALSE(device.sut.busy());
  device.run_for(1min);
  EXPECT_EQ(device.answers.size(), 1u);
}

// A manager that has lost the registration

TEST(SdoRequester, RegistersAnewWhenTheManagerOfBeforeIsSilent) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.sent.clear();
  device.run_for(500ms);
  ASSERT_FALSE(device.sent.empty());
  EXPECT_EQ(wire_text(device.sent.back().frame), "6E0#");
  EXPECT_EQ(device.answers.size(), 1u) << "that of the first connect()";
  device.sent.clear();
  device.receive("605#40 10 1F 00 00 00 00 00");
  device.expect({"585#43 10 1F 00 00 00 80 12"});
  device.receive("605#40 80 12 01 00 00 00 00");
  device.expect({"585#43 80 12 01 00 00 00 80"});
  device.receive("605#40 80 12 02 00 00 00 00");
  device.expect({"585#43 80 12 02 00 00 00 80"});
  // Other COB-IDs than before.
  device.receive("605#23 80 12 01 86 06 00 40");
  device.receive("605#23 80 12 02 87 06 00 40");
  device.sent.clear();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.expect({"686#23 00 1F 00 0B 05 82 12", "585#60 10 1F 00 00 00 00 00"});
}

TEST(SdoRequester, RegistersAnewWhenItIsRefusedWith08000022hButOnlyOnce) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.sent.clear();
  device.receive("681#80 00 1F 00 22 00 00 08");
  device.expect({"6E0#"});
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.sent.clear();
  device.receive("681#80 00 1F 00 22 00 00 08");
  device.expect({});
  EXPECT_EQ(device.answers, (std::vector{SdoEnd(), SdoEnd::by_server(AbortCode::device_state)}));
}

TEST(SdoRequester, OtherRefusalsSayNothingOfTheRegistration) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.sent.clear();
  device.receive("681#80 00 1F 00 23 00 0A 06");
  device.expect({});
  EXPECT_EQ(device.answers,
            (std::vector{SdoEnd(), SdoEnd::by_server(AbortCode::no_sdo_connection)}));
  EXPECT_TRUE(device.sut.registered());
}

TEST(SdoRequester, ItsRequestIn1F10hOutlivesWhatElseTheManagerSaysThere) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.receive("605#23 10 1F 00 00 06 81 12");
  device.sent.clear();
  device.receive("605#40 10 1F 00 00 00 00 00");
  device.expect({"585#43 10 1F 00 00 00 80 12"});
}

TEST(SdoRequester, A1F10hOfSomethingElseIsNoAnswer) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  for (const char* value :
       {"02 00 81 12", "06 00 80 12", "04 00 80 12", "00 00 80 12", "00 00 00 00", "FF FF FF FF"}) {
    device.receive(std::string("605#23 10 1F 00 ") + value);
  }
  EXPECT_TRUE(device.answers.empty());
  EXPECT_TRUE(device.sut.busy());
}

TEST(SdoRequester, AllDefaultChannelsAreRequestedWithBit0) {
  Device device;
  EXPECT_EQ(device.connect_all(), AbortCode::none);
  device.receive("605#40 10 1F 00 00 00 00 00");
  device.expect({"6E0#", "585#43 10 1F 00 01 00 80 12"});
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 05 00 80 12");
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  device.sent.clear();
  EXPECT_TRUE(device.sut.leave());
  device.expect({"680#23 01 1F 00 00 05 00 00"});
}

TEST(SdoRequester, GivesAConnectionBack) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_TRUE(device.sut.release(1));
  device.expect({"680#23 01 1F 00 0A 05 81 12"});
  EXPECT_TRUE(device.sut.busy());
  device.receive("681#60 01 1F 00 00 00 00 00");
  EXPECT_FALSE(device.sut.busy());
  EXPECT_EQ(device.answers.size(), 1u) << "that of connect()";
}

TEST(SdoRequester, GivesNothingBackWhileARequestIsUnderWay) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_EQ(device.connect(11), AbortCode::none);
  device.expect({"680#23 00 1F 00 0B 05 81 12"});
  EXPECT_FALSE(device.sut.release(1));
  EXPECT_FALSE(device.sut.leave());
  device.receive("681#60 00 1F 00 00 00 00 00");
  device.expect({});
  device.receive("605#23 10 1F 00 06 00 81 12");
  EXPECT_EQ(device.answers, (std::vector{SdoEnd(), SdoEnd()}));
}

TEST(SdoRequester, HasNothingToGiveBackWithoutARegistration) {
  Device device;
  EXPECT_FALSE(device.sut.release(1));
  EXPECT_FALSE(device.sut.leave());
  device.register_it();
  device.give_connection();
  EXPECT_FALSE(device.sut.release(2)) << "never connected";
  device.receive("605#23 80 12 01 00 00 00 C0");
  EXPECT_FALSE(device.sut.registered()) << "the manager closed the channel";
  device.sent.clear();
  EXPECT_FALSE(device.sut.release(1));
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.expect({"6E0#"});
}

TEST(SdoRequester, RefusesWhatItCannotAskFor) {
  Device device;
  EXPECT_EQ(device.connect(0, 1), AbortCode::no_sdo_connection);
  EXPECT_EQ(device.connect(5, 1), AbortCode::no_sdo_connection) << "itself";
  EXPECT_EQ(device.connect(128, 1), AbortCode::no_sdo_connection);
  EXPECT_EQ(device.connect(10, 0), AbortCode::no_sdo_connection) << "the manager's channel";
  EXPECT_EQ(device.connect(10, 3), AbortCode::no_sdo_connection) << "no 1283h";
  EXPECT_EQ(device.connect(10, 255), AbortCode::no_sdo_connection);
  device.expect({});
  EXPECT_EQ(device.connect(), AbortCode::none);
  EXPECT_EQ(device.connect(11, 2), AbortCode::device_state) << "one at a time";
  EXPECT_EQ(device.connect_all(), AbortCode::device_state);
  EXPECT_FALSE(device.sut.leave());
}

TEST(SdoRequester, ADeviceWithout1F10hAsksNobody) {
  WireNode wire({}, 5);
  SdoRequester sut(wire.node, {});
  wire.boot();
  EXPECT_FALSE(sut.available());
  EXPECT_EQ(sut.connect(10, 1, {}), AbortCode::no_sdo_connection);
  EXPECT_EQ(sut.connect_all({}), AbortCode::no_sdo_connection);
  wire.expect({});
}

TEST(SdoRequester, ANodeWithoutANodeIdOrAChannelToTheManagerAsksNobody) {
  WireNode nameless(detail::requesting_layout.tables(), node_id_unconfigured);
  SdoRequester unnamed(nameless.node, {});
  nameless.boot();
  EXPECT_FALSE(unnamed.available());
  EXPECT_EQ(unnamed.connect_all({}), AbortCode::no_sdo_connection);
  nameless.expect({});
  WireNode wire(detail::requesting_layout.tables(), 5);
  SdoRequester sut(wire.node, {.manager_client = 3});  // it has 1280h to 1282h
  wire.boot();
  EXPECT_FALSE(sut.available());
  EXPECT_EQ(sut.connect(10, 1, {}), AbortCode::no_sdo_connection);
  wire.expect({});
}

TEST(SdoRequester, AsksInNmtStateOperationalAsWell) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.receive("000#01 05");
  EXPECT_TRUE(device.sut.busy()) << "the state has SDO too";
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.expect({"680#23 00 1F 00 0A 05 81 12", "585#60 10 1F 00 00 00 00 00"});
  device.receive("681#60 00 1F 00 00 00 00 00");
  device.give_connection();
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.expect({"680#23 00 1F 00 0B 05 82 12"});
}

TEST(SdoRequester, WhatTheApplicationWritesInto1F10hIsNoAnswer) {
  Device device;
  device.register_it();
  const std::array<std::uint8_t, 4> connected{0x06, 0x00, 0x81, 0x12};
  EXPECT_EQ(device.node.dictionary().write(0x1F10, 0, connected, Source::application),
            AbortCode::none);
  EXPECT_TRUE(device.sut.busy());
  EXPECT_TRUE(device.answers.empty());
}

TEST(SdoRequester, ARegistrationIsNoAnswerToARequestForAllOrForAConnection) {
  Device all;
  EXPECT_EQ(all.connect_all(), AbortCode::none);
  all.give_manager_channel();
  all.receive("605#23 10 1F 00 02 00 80 12");
  EXPECT_TRUE(all.sut.busy());
  EXPECT_TRUE(all.answers.empty());
  Device one;
  one.register_it();
  one.receive("605#23 10 1F 00 02 00 81 12");
  EXPECT_TRUE(one.sut.busy());
  EXPECT_TRUE(one.answers.empty());
}

TEST(SdoRequester, RefusesWhileTheManagerHasNotConfirmedTheRequestBefore) {
  Device device;
  EXPECT_EQ(device.connect(), AbortCode::none);
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.give_connection();
  ASSERT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd()});
  EXPECT_EQ(device.connect(11, 2), AbortCode::no_sdo_connection);
  EXPECT_FALSE(device.sut.release(1));
  EXPECT_FALSE(device.sut.leave());
  EXPECT_FALSE(device.sut.busy());
  device.expect({});
  device.receive("681#60 00 1F 00 00 00 00 00");
  EXPECT_EQ(device.connect(11, 2), AbortCode::none);
  device.expect({"680#23 00 1F 00 0B 05 82 12"});
}

TEST(SdoRequester, WhoAsksAgainAtOnceKeepsWhatComesLate) {
  struct Persistent : Device {
    void again(SdoEnd end) {
      answers.push_back(end);
      if (answers.size() == 1) {
        EXPECT_EQ(sut.connect(10, 1, SdoRequester::Done::to<&Persistent::again>(*this)),
                  AbortCode::none);
      }
    }
  } device;
  ASSERT_EQ(device.sut.connect(10, 1, SdoRequester::Done::to<&Persistent::again>(device)),
            AbortCode::none);
  device.give_manager_channel();
  device.receive("605#23 10 1F 00 02 00 80 12");
  device.receive("681#60 00 1F 00 00 00 00 00");
  device.sent.clear();
  device.run_for(500ms);
  EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::no_answer()});
  device.expect({"@500000 680#23 00 1F 00 0A 05 81 12"});  // and no release behind it
}

TEST(SdoRequester, NmtStateStoppedEndsAReleaseWithoutAnAnswer) {
  Device device;
  device.register_it();
  device.give_connection();
  EXPECT_TRUE(device.sut.release(1));
  device.receive("000#02 05");
  EXPECT_FALSE(device.sut.busy());
  EXPECT_EQ(device.answers.size(), 1u) << "that of connect()";
}

TEST(SdoRequester, NmtStateStoppedAndResetsEndARequest) {
  for (const char* command : {"000#02 05", "000#81 05", "000#82 05"}) {
    Device device;
    EXPECT_EQ(device.connect(), AbortCode::none);
    device.receive(command);
    EXPECT_EQ(device.answers, std::vector<SdoEnd>{SdoEnd::cancelled(AbortCode::device_state)})
        << command;
    device.sent.clear();
    device.run_for(10s);
    device.expect({});
  }
  Device device;
  device.receive("000#02 05");
  EXPECT_EQ(device.connect(), AbortCode::device_state);
}

}  // namespace
}  // namespace canvoy::sdo_requester_test
