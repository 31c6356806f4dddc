#include "canvoy/tools/argument/node_argument.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::node_argument_test {
namespace {

TEST(NodeArgument, WhatIsPrintedIsAccepted) {
  for (const char* text :
       {"10", "0x0A", "0xa", "0Ah", "Ah", "10 (0Ah)", "node 10 (0Ah)", "node 10"}) {
    EXPECT_EQ(find_node_id(text), 10) << text;
  }
}

TEST(NodeArgument, WhatIsNoNodeIsNone) {
  for (const char* text : {"", "0", "128", "0x80", "80h", "-1", "1.5", "h", "0x", "10 (0Bh)",
                           "10 (0Ah", "10 0Ah", "node", "ten", "10 "}) {
    EXPECT_EQ(find_node_id(text), std::nullopt) << text;
  }
}

TEST(NodeArgument, NamesAreThoseOfAnyNetworkFile) {
  const host::TemporaryFile file(
      "[master]\nnode = 127\n"
      "[[slave]]\nnode = 5\nname = \"pump\"\n[[slave]]\nnode = 6\n"
      "[terminal]\nnode = 7\n"
      "[[node]]\nbus = \"lift1\"\nid = 8\ndevice = \"lift-drive\"\n"
      "[[node]]\nbus = \"lift1\"\nid = 9\ndevice = \"lift-door\"\n"
      "[[node]]\nbus = \"lift1\"\nid = 10\ndevice = \"lift-door\"\n"
      "[[node]]\nid = 300\nname = \"none\"\n");
  use_network_file(file.path());
  EXPECT_EQ(parse_node_id("pump"), 5);
  EXPECT_EQ(parse_node_id("Pump"), 5);
  EXPECT_EQ(parse_node_id("terminal"), 7);
  EXPECT_EQ(parse_node_id("lift_drive"), 8);
  EXPECT_EQ(parse_node_id("master"), 127);
  EXPECT_EQ(parse_node_id("0Ah"), 10) << "numbers go on";
  EXPECT_THROW(parse_node_id("none"), UsageError);
  EXPECT_THROW(parse_node_id("pmup"), UsageError);
  try {
    parse_node_id("lift-door");
    FAIL() << "there are two of them";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(),
                 "'lift-door' is several: lift-door: node 9 (09h), lift-door: node 10 (0Ah); give "
                 "the number");
  }
  EXPECT_EQ(parse_node_id("drive"), 8) << "a part of one name";
  EXPECT_EQ(parse_node_id("term"), 7);
  try {
    parse_node_id("lift");
    FAIL() << "it is a part of three";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(),
                 "'lift' is several: lift-drive: node 8 (08h), lift-door: node 9 (09h), lift-door: "
                 "node 10 (0Ah); give the number");
  }
  try {
    parse_node_id("crane");
    FAIL() << "nobody is called so";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("or a name: ")) << "the choices are told";
    EXPECT_THAT(error.what(), testing::HasSubstr("pump: node 5 (05h)"));
  }
  use_network_file("");
  EXPECT_THROW(parse_node_id("pump"), UsageError);
}

}  // namespace
}  // namespace canvoy::tools::node_argument_test
