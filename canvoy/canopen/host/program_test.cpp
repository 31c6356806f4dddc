#include "canvoy/canopen/host/program.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::program_test {
namespace {

TEST(Program, TakesNodeIdsOfOneTo127) {
  EXPECT_EQ(*read_node_id("1"), 1);
  EXPECT_EQ(*read_node_id("127"), 127);
  EXPECT_EQ(*read_node_id("0x7F"), 127);
  EXPECT_EQ(*read_node_id("0X0a"), 10);
}

TEST(Program, SaysInOneLineWhatIsNoNodeId) {
  for (const char* text : {"abc", "0", "128", "-1", "+5", " 5", "5 ", "5x", "0x", "0x80", "1e1",
                           "99999999999999999999"}) {
    const auto id = read_node_id(text);
    ASSERT_FALSE(id) << text;
    EXPECT_EQ(id.error().line(), std::string(text) + ": is no node-ID; give one from 1 to 127");
  }
  EXPECT_EQ(read_node_id(nullptr).error().line(), "node-ID: is no node-ID; give one from 1 to 127");
  EXPECT_EQ(read_node_id("").error().line(), "node-ID: is no node-ID; give one from 1 to 127");
}

TEST(Program, SaysInOneLineWhatIsNoBus) {
  const auto none = open(nullptr);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().line(), "bus: none is named; name one: can0, or udp:239.74.163.2:43113");
  const auto wrong = open("no-such-bus-0");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where.find("no-such-bus-0"), 0U) << wrong.error().line();
  EXPECT_EQ(fail(wrong.error()), 1);
}

}  // namespace
}  // namespace canvoy::program_test
