// The connector of an SDO manager in node 1: device 5 gets a channel of server 10 (CiA 302-5, as in
// devices in the field).
#include "canvoy/canopen/manager/sdo_connector.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"

namespace canvoy::sdo_connector_test {
namespace {

constexpr std::uint32_t in_use = 0x690;
constexpr std::uint32_t is_free = 0x8000'0000;

struct Hand : WireNode {
  Hand() : WireNode(dynamic_sdo_manager(), 1) { boot(); }

  void note(const SdoConnection* connection) { ended.push_back(connection); }
  /// Reports sub-index 01h of 1200h + `channel`, as the server.
  void notify(unsigned channel, std::uint32_t value) {
    char frame[40];
    std::snprintf(frame, sizeof frame, "58A#43 %02X 12 01 %02X %02X %02X %02X", channel,
                  value & 0xFFU, value >> 8U & 0xFFU, value >> 16U & 0xFFU, value >> 24U);
    receive(frame);
  }
  void expect_to_ask(unsigned channel) {
    char frame[40];
    std::snprintf(frame, sizeof frame, "60A#40 %02X 12 01 00 00 00 00", channel);
    expect({frame});
  }
  static SdoConnection of_5_to_10() {
    return {
        .state = SdoConnection::State::requested, .client = 5, .client_channel = 1, .server = 10};
  }

  std::array<SdoConnection, 2> memory{};
  SdoConnections connections{memory};
  SdoCobIds cob_ids{node.dictionary(), connections};
  SdoClient client{node};
  SdoConnector sut{node, client, cob_ids, {}, SdoConnector::Ended::to<&Hand::note>(*this)};
  std::vector<const SdoConnection*> ended;
  SdoConnection& wanted = *connections.add(of_5_to_10());
};

struct OpeningHand : Hand {
  OpeningHand() { sut.open(wanted); }
};

// CiA 301, 7.5.2.33: server channels beside the default one are 1201h to 127Fh.
TEST(SdoConnector, LooksAtAllChannelsOfTheServerUpTo127Fh) {
  OpeningHand hand;
  for (unsigned channel = 1; channel <= 0x7F; ++channel) {
    hand.expect_to_ask(channel);
    hand.notify(channel, in_use);
  }
  hand.expect({});
  EXPECT_EQ(hand.wanted.error, DynamicSdoError::no_server_channel);
  EXPECT_FALSE(hand.sut.busy());
}

TEST(SdoConnector, TriesEachChannelAsOftenAsTheFirst) {
  OpeningHand hand;
  hand.run_until(Time(500ms));
  hand.notify(1, in_use);
  hand.run_until(Time(1249ms));
  EXPECT_TRUE(hand.ended.empty()) << "three times 250 ms are not over";
  hand.run_until(Time(1250ms));
  EXPECT_EQ(hand.wanted.error, DynamicSdoError::server_silent);
}

/// 0800 0022h does not determine the number of channels.
TEST(SdoConnector, TakesAnyOtherAbortThanThatOfAnAbsentChannelForARefusal) {
  OpeningHand hand;
  hand.receive("58A#80 01 12 01 22 00 00 08");
  EXPECT_EQ(hand.wanted.error, DynamicSdoError::server_refused);
}

/// Bytes of an earlier answer after its one byte do not belong to it.
TEST(SdoConnector, TakesNoChannelForFreeWhoseCobIdIsCutShort) {
  OpeningHand hand;
  hand.notify(1, is_free);
  hand.receive("58A#60 01 12 03 00 00 00 00");
  hand.receive("58A#80 01 12 02 22 00 00 08");  // it has ended
  hand.wanted = Hand::of_5_to_10();
  hand.sut.open(hand.wanted);
  hand.sent.clear();
  hand.receive("58A#4F 01 12 01 90 00 00 00");
  hand.expect_to_ask(2);
}

TEST(SdoConnector, KeepsTheReasonOfAConnectionThatIsLostWhileItsServerIsAsked) {
  OpeningHand hand;
  hand.connections.lose(10);
  hand.run_for(750ms);
  EXPECT_EQ(hand.ended.size(), 1U);
  EXPECT_EQ(hand.wanted.error, DynamicSdoError::connection_lost);
}

/// It was written completely: both ends must be closed again.
TEST(SdoConnector, DoesNotGiveAConnectionThatIsReleasedWhileItIsWritten) {
  OpeningHand hand;
  hand.notify(1, is_free);
  hand.connections.release({.device = 5, .server = 10});
  for (const char* written : {"58A#60 01 12 03", "58A#60 01 12 02", "58A#60 01 12 01",
                              "585#60 81 12 03", "585#60 81 12 01", "585#60 81 12 02"}) {
    hand.receive(std::string(written) + " 00 00 00 00");
  }
  hand.receive("585#60 10 1F 00 00 00 00 00");
  EXPECT_EQ(hand.ended, std::vector<const SdoConnection*>{&hand.wanted});
  EXPECT_EQ(hand.wanted.state, SdoConnection::State::ending);
  hand.sent.clear();
  hand.sut.close(hand.wanted);
  hand.expect({"60A#23 01 12 01 00 00 00 C0"});
}

TEST(SdoConnector, ClosesAConnectionOfWhichBothEndsAreGoneWithoutAWord) {
  Hand hand;
  hand.wanted.server_channel = 1;
  hand.wanted.request = 0x680;
  hand.wanted.response = 0x681;
  hand.connections.lose(10);
  hand.connections.lose(5);
  hand.sut.close(hand.wanted);
  hand.expect({});
  EXPECT_FALSE(hand.sut.busy());
  EXPECT_EQ(hand.wanted.state, SdoConnection::State::unused);
  EXPECT_EQ(hand.cob_ids.free_can_id(), 0x680) << "they are free again";
}

TEST(SdoConnector, RefusesADeviceThatDoesNotListenThreeTimesAndIsFree) {
  Hand hand;
  hand.wanted.error = DynamicSdoError::no_manager_channel;
  hand.sut.refuse(hand.wanted);
  hand.run_until(Time(749ms));
  EXPECT_TRUE(hand.sut.busy());
  hand.run_until(Time(750ms));
  hand.expect({"@0 605#23 10 1F 00 00 05 81 12", "@250000 605#80 10 1F 00 00 00 04 05",
               "@250000 605#23 10 1F 00 00 05 81 12", "@500000 605#80 10 1F 00 00 00 04 05",
               "@500000 605#23 10 1F 00 00 05 81 12", "@750000 605#80 10 1F 00 00 00 04 05"});
  EXPECT_EQ(hand.ended, std::vector<const SdoConnection*>{nullptr});
}

}  // namespace
}  // namespace canvoy::sdo_connector_test
