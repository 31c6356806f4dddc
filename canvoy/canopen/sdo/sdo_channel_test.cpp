#include "canvoy/canopen/sdo/sdo_channel.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_channel_test {
namespace {

constexpr std::uint32_t request_id = 0x6C0;
constexpr std::uint32_t response_id = 0x540;

AbortCode write(WireNode& wire, std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
  std::array<std::uint8_t, 4> bytes;
  store(bytes.data(), value);
  return wire.node.dictionary().write(index, sub, std::span(bytes).first(sub == 3 ? 1 : 4),
                                      Source::sdo);
}

/// Servers 0 and 1 of node 5.
class SdoServerChannelTest : public testing::Test {
 protected:
  SdoServerChannelTest() { wire.boot(); }

  AbortCode set(std::uint8_t sub, std::uint32_t value) { return write(wire, 0x1201, sub, value); }
  WireNode wire{sdo_objects(), 5};
  SdoServer server0{wire.node, 0, {}};
  SdoServer server1{wire.node, 1, {}};
};

TEST_F(SdoServerChannelTest, ASecondChannelIsOffUntilBothOfItsCobIdsAreValid) {
  const std::string request = "6C0#40 00 10 00 00 00 00 00";
  wire.receive(request);
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  wire.receive(request);
  wire.expect({});
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive(request);
  wire.expect({"540#43 00 10 00 A2 01 02 00"});
  EXPECT_EQ(set(2, 0x8000'0000), AbortCode::none);
  wire.receive(request);
  wire.expect({});
}

TEST_F(SdoServerChannelTest, ChannelsDoNotDisturbEachOther) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive("6C0#40 13 20 00 00 00 00 00");
  wire.receive("605#40 13 20 00 00 00 00 00");
  wire.receive("6C0#60 00 00 00 00 00 00 00");
  wire.receive("605#60 00 00 00 00 00 00 00");
  wire.receive("605#70 00 00 00 00 00 00 00");
  wire.receive("6C0#70 00 00 00 00 00 00 00");
  wire.expect({"540#41 13 20 00 0B 00 00 00", "585#41 13 20 00 0B 00 00 00",
               "540#00 43 61 6E 76 6F 79 20", "585#00 43 61 6E 76 6F 79 20",
               "585#17 6E 6F 64 65 00 00 00", "540#17 6E 6F 64 65 00 00 00"});
}

TEST_F(SdoServerChannelTest, ACanIdChangesOnlyWhileTheCobIdIsInvalid) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(1, request_id + 1), AbortCode::value_range);
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(1, 0x8000'0000 | request_id), AbortCode::none);
  EXPECT_EQ(set(1, request_id + 1), AbortCode::none);
}

TEST_F(SdoServerChannelTest, A29BitCanIdIsRefused) {
  EXPECT_EQ(set(1, 0x2000'06C0), AbortCode::value_range);
  EXPECT_EQ(set(1, 0x0000'0800), AbortCode::value_range);
  EXPECT_EQ(set(2, 0x3FFF'FFFF), AbortCode::value_range);
}

TEST_F(SdoServerChannelTest, RestrictedCanIdsAreRefused) {
  unsigned refused = 0;
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    const bool restricted = id < 0x080 || (id > 0x100 && id < 0x180) ||
                            (id > 0x580 && id < 0x600) || (id > 0x600 && id < 0x680) ||
                            (id >= 0x6E0 && id < 0x700) || id > 0x700;
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
      EXPECT_EQ(set(sub, id), restricted ? AbortCode::value_range : AbortCode::none) << id;
      EXPECT_EQ(set(sub, 0x8000'0000), AbortCode::none);
    }
    refused += restricted ? 1U : 0U;
  }
  EXPECT_GT(refused, 0U);
}

TEST_F(SdoServerChannelTest, TheDynamicBitIsAllowed) {
  EXPECT_EQ(set(1, 0x4000'0000 | request_id), AbortCode::none);
  EXPECT_EQ(set(2, 0x4000'0000 | response_id), AbortCode::none);
  wire.receive("6C0#40 00 10 00 00 00 00 00");
  wire.expect({"540#43 00 10 00 A2 01 02 00"});
}

TEST_F(SdoServerChannelTest, AChannelMayBeSwitchedOffThroughItselfAndStillConfirms) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive("6C0#23 01 12 01 C0 06 00 80");
  wire.expect({"540#60 01 12 01 00 00 00 00"});
  wire.receive("6C0#40 00 10 00 00 00 00 00");
  wire.expect({});
}

TEST_F(SdoServerChannelTest, AChannelThatIsSwitchedOffForgetsItsTransfer) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive("6C0#40 13 20 00 00 00 00 00");
  EXPECT_TRUE(server1.busy());
  EXPECT_EQ(set(1, 0x8000'0000), AbortCode::none);
  EXPECT_FALSE(server1.busy());
  wire.sent.clear();
  wire.run_for(5s);
  wire.expect({});
}

TEST_F(SdoServerChannelTest, ResetCommunicationSwitchesASecondChannelOff) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive("000#82 05");
  wire.receive("6C0#40 00 10 00 00 00 00 00");
  wire.receive("605#40 00 10 00 00 00 00 00");
  wire.expect({"705#00", "585#43 00 10 00 A2 01 02 00"});
}

TEST_F(SdoServerChannelTest, AChannelWithoutObjectIsOff) {
  SdoServer server(wire.node, 127, {});
  wire.receive("000#82 05");
  wire.receive("605#40 00 10 00 00 00 00 00");
  wire.expect({"705#00", "585#43 00 10 00 A2 01 02 00"});
}

TEST_F(SdoServerChannelTest, AChannelForWhichTheNodeHasNoRouteLeftIsRefused) {
  auto ignore = [](const Frame&, Time) {};
  while (!wire.node.router().full()) {
    EXPECT_TRUE(wire.node.router().add(0x700, Router::Receiver::of(ignore)));
  }
  EXPECT_EQ(set(1, request_id), AbortCode::out_of_memory);
  EXPECT_EQ(set(2, response_id), AbortCode::out_of_memory);
  EXPECT_EQ(set(1, 0x8000'0000 | request_id), AbortCode::none);
  EXPECT_EQ(set(3, 5), AbortCode::none);
  wire.node.router().remove(0x700, Router::Receiver::of(ignore));
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  wire.receive("6C0#40 00 10 00 00 00 00 00");
  wire.expect({"540#43 00 10 00 A2 01 02 00"});
  EXPECT_EQ(set(1, 0x8000'0000), AbortCode::none);
}

/// Clients of node 1.
class SdoClientChannelTest : public testing::Test {
 protected:
  SdoClientChannelTest() { wire.boot(); }

  AbortCode set(std::uint8_t sub, std::uint32_t value) { return write(wire, 0x1280, sub, value); }
  void done(SdoClient::Outcome result) { outcome = result; }
  AbortCode ask(NodeId server) {
    return sut.upload(server, 0x1000, 0, bytes,
                      SdoClient::Done::to<&SdoClientChannelTest::done>(*this));
  }

  WireNode wire{sdo_objects(), 1};
  SdoClient sut{wire.node, 0};
  std::optional<SdoClient::Outcome> outcome;
  std::array<std::uint8_t, 4> bytes{};
};

TEST_F(SdoClientChannelTest, TheObjectSaysOnWhichCanIdsTheClientTalksAndToWhom) {
  EXPECT_EQ(ask(5), AbortCode::no_sdo_connection);
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  EXPECT_EQ(ask(5), AbortCode::no_sdo_connection);
  EXPECT_EQ(set(3, 5), AbortCode::none);
  EXPECT_EQ(ask(6), AbortCode::no_sdo_connection);
  EXPECT_EQ(ask(5), AbortCode::none);
  wire.expect({"6C0#40 00 10 00 00 00 00 00"});
  wire.receive("540#43 00 10 00 A2 01 00 00");
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->abort(), AbortCode::none);
}

TEST_F(SdoClientChannelTest, AClientMayUseTheDefaultChannelOfItsServer) {
  EXPECT_EQ(set(1, 0x605), AbortCode::none);
  EXPECT_EQ(set(2, 0x585), AbortCode::none);
  EXPECT_EQ(set(3, 5), AbortCode::none);
  EXPECT_EQ(ask(5), AbortCode::none);
  wire.expect({"605#40 00 10 00 00 00 00 00"});
}

TEST_F(SdoClientChannelTest, RestrictedCanIdsAreRefusedButForThoseOfDefaultChannels) {
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    const bool refused =
        id < 0x080 || (id > 0x100 && id < 0x180) || (id >= 0x6E0 && id < 0x700) || id > 0x700;
    const bool is_response = id > 0x580 && id < 0x600;
    const bool is_request = id > 0x600 && id < 0x680;
    EXPECT_EQ(set(1, id), refused || is_response ? AbortCode::value_range : AbortCode::none) << id;
    EXPECT_EQ(set(2, id), refused || is_request ? AbortCode::value_range : AbortCode::none) << id;
    EXPECT_EQ(set(1, 0x8000'0000), AbortCode::none);
    EXPECT_EQ(set(2, 0x8000'0000), AbortCode::none);
  }
}

TEST_F(SdoClientChannelTest, ACanIdChangesOnlyWhileTheCobIdIsInvalid) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(1, request_id + 1), AbortCode::value_range);
  EXPECT_EQ(set(1, 0x2000'06C0), AbortCode::value_range);
}

TEST_F(SdoClientChannelTest, AChangedChannelEndsARequestAndServesTheNext) {
  EXPECT_EQ(set(1, request_id), AbortCode::none);
  EXPECT_EQ(set(2, response_id), AbortCode::none);
  EXPECT_EQ(set(3, 5), AbortCode::none);
  EXPECT_EQ(ask(5), AbortCode::none);
  wire.sent.clear();
  EXPECT_EQ(set(1, 0x8000'0000), AbortCode::none);
  wire.expect({"6C0#80 00 10 00 23 00 0A 06"});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->abort(), AbortCode::no_sdo_connection);
  EXPECT_EQ(ask(5), AbortCode::no_sdo_connection);
  EXPECT_EQ(set(1, 0x6C1), AbortCode::none);
  EXPECT_EQ(ask(5), AbortCode::none);
  wire.expect({"6C1#40 00 10 00 00 00 00 00"});
}

TEST_F(SdoClientChannelTest, WithoutItsObjectAClientUsesDefaultChannels) {
  SdoClient client(wire.node, 7);
  EXPECT_EQ(client.upload(9, 0x1000, 0, bytes, {}), AbortCode::none);
  wire.expect({"609#40 00 10 00 00 00 00 00"});
}

TEST(SdoChannel, IsValidWhereBothCobIdsAre) {
  WireNode wire(sdo_objects(), 5);
  const Dictionary& dictionary = wire.node.dictionary();
  EXPECT_FALSE(sdo_channel(dictionary, 0x1205).valid());
  EXPECT_FALSE(sdo_channel(dictionary, 0x1201).valid());
  EXPECT_EQ(write(wire, 0x1201, 1, 0x6C0), AbortCode::none);
  EXPECT_FALSE(sdo_channel(dictionary, 0x1201).valid());
  EXPECT_EQ(write(wire, 0x1201, 2, 0x540), AbortCode::none);
  EXPECT_EQ(sdo_channel(dictionary, 0x1201), (SdoChannel{0x6C0, 0x540}));
  wire.node.dictionary().set_number(0x1201, 1, 0x2000'06C0);  // an invalid description
  EXPECT_FALSE(sdo_channel(dictionary, 0x1201).valid());
  EXPECT_EQ(default_sdo_channel(127), (SdoChannel{0x67F, 0x5FF}));
}

}  // namespace
}  // namespace canvoy::sdo_channel_test
