// Producer of multiplexed PDOs in destination address mode, frame by frame (CiA 301, 7.2.3).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::mpdo_destination_producer_test {
namespace {

using enum AbortCode;
constexpr unsigned destination = 0xFF;
constexpr auto send_at_start = Tpdos::AtStart::send;
constexpr std::array<std::uint8_t, 5> value = {0x11, 0x22, 0x33, 0x44, 0x55};

/// Like MpdoProducer::send, but with `size` bytes of `value`.
bool send(MpdoNode& node, std::uint16_t number, NodeId consumer, std::size_t size = 1) {
  node.node.advance(node.now);
  return node.mpdo_producer.send(number, consumer, 0x6401, 2, std::span(value).first(size));
}

TEST(DamProducer, SendsNodeIdWithBit7ThenIndexSubIndexAndData) {
  MpdoNode node;
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  EXPECT_TRUE(send(node, 2, 10, 4));
  node.expect({"285#8A 01 64 02 11 22 33 44"});
  EXPECT_TRUE(send(node, 2, 127, 2));
  node.expect({"285#FF 01 64 02 11 22 00 00"});
  EXPECT_TRUE(send(node, 2, 0, 1)) << "to all nodes";
  node.expect({"285#80 01 64 02 11 00 00 00"});
  EXPECT_TRUE(send(node, 2, 5, 0));
  node.expect({"285#85 01 64 02 00 00 00 00"});
}

TEST(DamProducer, RefusesWhatNoFrameCanSay) {
  MpdoNode node;
  node.use_tpdo(2, 0x285, destination);
  EXPECT_FALSE(send(node, 2, 10)) << "not in pre-operational";
  node.operate();
  EXPECT_FALSE(send(node, 2, 128)) << "no node-ID";
  EXPECT_FALSE(send(node, 2, 255));
  EXPECT_FALSE(send(node, 2, 10, 5)) << "more than four bytes";
  EXPECT_FALSE(send(node, 1, 10)) << "not multiplexed";
  EXPECT_FALSE(send(node, 0, 10));
  EXPECT_FALSE(send(node, 4, 10));
  ASSERT_EQ(node.write(0x1801, 1, 0x8000'0285), none);
  EXPECT_FALSE(send(node, 2, 10)) << "invalid";
  node.use_tpdo(2, 0x285, 0xFE);
  EXPECT_FALSE(send(node, 2, 10)) << "in source address mode";
  node.expect({});
}

TEST(DamProducer, KeepsTheInhibitTimeAndLosesNothing) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1801, 3, 100), none);
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  for (NodeId consumer = 1; consumer <= 5; ++consumer) EXPECT_TRUE(send(node, 2, consumer));
  EXPECT_FALSE(send(node, 2, 6)) << "one is sent, and four fill the queue";
  node.run_until(Time(1s));
  node.expect({"@0 285#81 01 64 02 11 00 00 00", "@10000 285#82 01 64 02 11 00 00 00",
               "@20000 285#83 01 64 02 11 00 00 00", "@30000 285#84 01 64 02 11 00 00 00",
               "@40000 285#85 01 64 02 11 00 00 00"});
  EXPECT_TRUE(send(node, 2, 6));
  node.expect({"@1000000 285#86 01 64 02 11 00 00 00"});
}

TEST(DamProducer, OfTwoTpdosEachKeepsItsOwnInhibitTimeAndOrder) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1801, 3, 100), none);
  ASSERT_EQ(node.write(0x1802, 3, 40), none);
  node.use_tpdo(2, 0x285, destination);
  node.use_tpdo(3, 0x385, destination);
  node.operate();
  for (NodeId consumer = 1; consumer <= 3; ++consumer) {
    EXPECT_TRUE(send(node, 2, consumer));
    EXPECT_TRUE(send(node, 3, consumer));
  }
  node.run_until(Time(1s));
  node.expect({"@0 285#81 01 64 02 11 00 00 00", "@0 385#81 01 64 02 11 00 00 00",
               "@4000 385#82 01 64 02 11 00 00 00", "@8000 385#83 01 64 02 11 00 00 00",
               "@10000 285#82 01 64 02 11 00 00 00", "@20000 285#83 01 64 02 11 00 00 00"});
}

TEST(DamProducer, ThatFindsNoRoomSendsLater) {
  MpdoNode node;
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  node.full = true;
  unsigned taken = 0;
  while (send(node, 2, static_cast<NodeId>(taken + 1))) ++taken;
  EXPECT_EQ(taken, 8U + 4U) << "half of the backlog, and the queue";
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 12U);
  for (std::size_t i = 0; i < node.sent.size(); ++i) {
    EXPECT_EQ(node.sent[i].frame.data[0], 0x81 + i);
  }
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
}

TEST(DamProducer, ForgetsWhatWaitsWhenOperationalEndsOrThePdoBecomesInvalid) {
  for (const bool made_invalid : {false, true}) {
    MpdoNode node;
    ASSERT_EQ(node.write(0x1801, 3, 100), none);
    ASSERT_EQ(node.write(0x1802, 3, 100), none);
    node.use_tpdo(2, 0x285, destination);
    node.use_tpdo(3, 0x385, destination);
    node.operate();
    for (const std::uint16_t number : std::to_array<std::uint16_t>({3, 2, 3, 2}))
      EXPECT_TRUE(send(node, number, 9));
    node.expect({"385#89 01 64 02 11 00 00 00", "285#89 01 64 02 11 00 00 00"});
    if (made_invalid) {
      ASSERT_EQ(node.write(0x1801, 1, 0x8000'0285), none);
      ASSERT_EQ(node.write(0x1801, 1, 0x285), none);
    } else {
      node.receive("000#80 00");
      node.operate();
    }
    node.run_until(Time(1s));
    if (made_invalid) {
      node.expect({"@10000 385#89 01 64 02 11 00 00 00"});
    } else {
      node.expect({});
    }
  }
}

TEST(DamProducer, IsSentForNothingElse) {
  MpdoNode node(send_at_start);
  ASSERT_EQ(node.write(0x1801, 5, 10), none);
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  node.set(0x2000, 1, 1);
  EXPECT_FALSE(node.tpdos.trigger(2));
  node.receive("285#R8");
  node.run_until(Time(1s));
  node.expect({});
}

TEST(DamProducer, IsEventDriven) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 252) continue;
    MpdoNode node;
    ASSERT_EQ(node.write(0x1800, 2, type), none);
    ASSERT_EQ(node.write(0x1A00, 0, destination), none);
    EXPECT_EQ(node.write(0x1800, 1, 0x185), type >= 254 ? none : parameter_incompatible) << type;
    EXPECT_EQ(node.tpdos[1].is_active(), type >= 254);
  }
  MpdoNode node;
  node.use_tpdo(1, 0x185, destination);
  EXPECT_EQ(node.write(0x1800, 2, 1), parameter_incompatible);
  EXPECT_EQ(node.write(0x1800, 2, 254), none);
}

TEST(DamProducer, IsHeardByTheConsumerThatItNames) {
  MpdoNode producer;
  MpdoNode consumer(Tpdos::AtStart::wait_for_event, 10);
  MpdoNode other(Tpdos::AtStart::wait_for_event, 11);
  producer.use_tpdo(1, 0x185, destination);
  producer.operate();
  for (MpdoNode* node : {&consumer, &other}) {
    node->use_rpdo(1, 0x185, destination);
    node->operate();
  }
  ASSERT_TRUE(producer.mpdo_producer.send(1, 10, 0x2020, 3, std::span(value).first(4)));
  ASSERT_EQ(producer.sent.size(), 1U);
  for (MpdoNode* node : {&consumer, &other}) node->receive(wire_text(producer.sent[0].frame));
  EXPECT_EQ(consumer.number(0x2020, 3), 0x44332211U);
  EXPECT_EQ(other.number(0x2020, 3), 0U);
}

TEST(DamProducer, IsEndedByAnAnswerThatComesAtOnce) {
  MpdoNode node;
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  node.on_sent = [&](const Frame&) { node.node.receive(wire_frame("000#80 00"), node.now); };
  EXPECT_TRUE(send(node, 2, 9));
  node.expect({"285#89 01 64 02 11 00 00 00"});
  EXPECT_FALSE(send(node, 2, 9));
  node.operate();
  EXPECT_TRUE(send(node, 2, 10));
  node.expect({"285#8A 01 64 02 11 00 00 00"});
}

TEST(DamProducer, SendsTheNextMessageFromWithinTheOneBeforeAndEachOnce) {
  MpdoNode node;
  node.use_tpdo(2, 0x285, destination);
  node.operate();
  node.on_sent = [&](const Frame& frame) {
    if (frame.data[0] == 0x83) return;
    const auto next = static_cast<NodeId>((frame.data[0] & 0x7F) + 1);
    EXPECT_TRUE(node.mpdo_producer.send(2, next, 0x6401, 2, std::span(value).first(1)));
  };
  EXPECT_TRUE(send(node, 2, 1));
  node.expect({"285#81 01 64 02 11 00 00 00", "285#82 01 64 02 11 00 00 00",
               "285#83 01 64 02 11 00 00 00"});
}

}  // namespace
}  // namespace canvoy::mpdo_destination_producer_test
