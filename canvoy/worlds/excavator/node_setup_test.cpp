#include "canvoy/worlds/excavator/node_setup.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::excavator::node_setup_test {
namespace {

/// Node 1 sets up node 10, which is the test.
class NodeSetupTest : public testing::Test {
 protected:
  NodeSetupTest() {
    wire.boot();
    sut.on_done(callback<&NodeSetupTest::told>(*this));
    sut.begin();
  }
  void told(NodeId node, bool is_done) {
    EXPECT_EQ(node, 10);
    EXPECT_FALSE(done) << "told twice";
    done = is_done;
  }
  void run_for(Duration duration) { wire.run_until(wire.now + duration); }

  WireNode wire{sdo_objects(), 1};
  NodeSetup sut{wire.node,
                10,
                {{.index = 0x1017, .value = 200, .bytes = 2},
                 {.index = 0x6423, .value = 1, .bytes = 1, .may_be_missing = true},
                 {.index = 0x6424, .sub = 2, .value = 0x12345678}}};
  std::optional<bool> done;
  const std::string first = "60A#2B 17 10 00 C8 00 00 00";
  const std::string second = "60A#2F 23 64 00 01 00 00 00";
  const std::string third = "60A#23 24 64 02 78 56 34 12";
};

TEST_F(NodeSetupTest, WritesOneValueAfterTheOther) {
  wire.expect({first});
  wire.receive("58A#60 17 10 00 00 00 00 00");
  wire.expect({second});
  wire.receive("58A#60 23 64 00 00 00 00 00");
  wire.expect({third});
  EXPECT_EQ(done, std::nullopt);
  wire.receive("58A#60 24 64 02 00 00 00 00");
  wire.expect({});
  EXPECT_EQ(done, true);
}

TEST_F(NodeSetupTest, ASilentNodeIsToldEachValueThreeTimes) {
  const std::string abort = "60A#80 17 10 00 00 00 04 05";
  run_for(200ms);
  wire.expect({first, abort, first, abort, first});
  wire.receive("58A#60 17 10 00 00 00 00 00");
  wire.sent.clear();
  run_for(200ms);
  wire.receive("58A#60 23 64 00 00 00 00 00");
  EXPECT_EQ(done, std::nullopt);
  wire.sent.clear();
  run_for(299ms);
  EXPECT_EQ(done, std::nullopt);
  run_for(1ms);
  EXPECT_EQ(done, false);
}

TEST_F(NodeSetupTest, AnObjectThatMayBeMissingMayBeRefused) {
  wire.receive("58A#60 17 10 00 00 00 00 00");
  wire.sent.clear();
  wire.receive("58A#80 23 64 00 00 00 02 06");
  wire.expect({third});
  wire.receive("58A#80 24 64 02 00 00 02 06");
  EXPECT_EQ(done, false);
}

TEST_F(NodeSetupTest, ItBeginsAnewFromTheFirst) {
  wire.receive("58A#60 17 10 00 00 00 00 00");
  wire.sent.clear();
  sut.begin();
  ASSERT_FALSE(wire.sent.empty());
  EXPECT_EQ(wire_text(wire.sent.back().frame), first);
}

}  // namespace
}  // namespace canvoy::excavator::node_setup_test
