// A simulated node takes the values that a configuration tool would write after its boot-up.
#include "canvoy/sim/node_configuration.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/heartbeat_producer.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::node_configuration_test {
namespace {

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>(
                {{.index = 0x1000, .entry_count = 1}, {.index = 0x1017, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32},
                 {.type = DataType::unsigned16, .access = Access::rw, .initial = 1000}}));

const NodeValue heartbeat_200_ms{.index = 0x1017, .bytes = {0xC8, 0x00}};

struct ConfiguredNode : WireNode {
  explicit ConfiguredNode(const std::vector<NodeValue>& wanted)
      : WireNode(layout.tables(), 5), producer(node), values(wanted), configuration(node, values) {}

  HeartbeatProducer producer;
  std::vector<NodeValue> values;
  NodeConfiguration configuration;
};

// A written heartbeat time starts a new period at once.
TEST(NodeConfiguration, AValueHoldsFromTheBootUpOn) {
  ConfiguredNode sut(std::vector{heartbeat_200_ms});
  sut.start();
  sut.run_until(Time(500ms));
  sut.expect({"@0 705#00", "@0 705#7F", "@200000 705#7F", "@400000 705#7F"});
  EXPECT_FALSE(sut.configuration.refusal());
}

TEST(NodeConfiguration, AResetBringsTheValueBack) {
  ConfiguredNode sut(std::vector{heartbeat_200_ms});
  sut.boot();
  sut.receive("000#82 05");
  EXPECT_EQ(sut.node.dictionary().number(0x1017, 0), 200U);
  sut.receive("000#81 05");
  EXPECT_EQ(sut.node.dictionary().number(0x1017, 0), 200U);
}

TEST(NodeConfiguration, WhatAnotherWritesStaysUntilTheNextBootUp) {
  ConfiguredNode sut(std::vector{heartbeat_200_ms});
  sut.boot();
  const std::uint8_t other[] = {0x2C, 0x01};
  ASSERT_EQ(sut.node.dictionary().write(0x1017, 0, other, Source::sdo), AbortCode::none);
  sut.receive("000#01 05");
  sut.receive("000#80 05");
  EXPECT_EQ(sut.node.dictionary().number(0x1017, 0), 300U);
}

TEST(NodeConfiguration, TheFirstRefusedValueIsToldAndTheOthersAreWritten) {
  const std::vector<NodeValue> values = {
      {.index = 0x1000, .bytes = {0, 0, 0, 0}}, {.index = 0x2000, .bytes = {1}}, heartbeat_200_ms};
  ConfiguredNode sut(values);
  sut.boot();
  ASSERT_TRUE(sut.configuration.refusal());
  EXPECT_EQ(sut.configuration.refusal()->value.index, 0x1000);
  EXPECT_EQ(sut.configuration.refusal()->reason, AbortCode::read_only);
  EXPECT_EQ(sut.node.dictionary().number(0x1017, 0), 200U);
}

}  // namespace
}  // namespace canvoy::node_configuration_test
