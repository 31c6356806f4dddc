#include "canvoy/tools/network/lss_argument.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/bit_rate_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::lss_argument_test {
namespace {

TEST(LssArgument, ReadsAddressesWholeAndInPart) {
  EXPECT_EQ(parse_lss_address("0x2F0:419:1:77"), (LssAddress{{0x2F0, 419, 1, 77}}));
  EXPECT_EQ(parse_lss_address("4294967295:0xFFFFFFFF:0:0"),
            (LssAddress{{0xFFFF'FFFF, 0xFFFF'FFFF, 0, 0}}));
  const LssAddress printed = {{0x2F0, 0x1A3, 0x10001, 0}};
  EXPECT_EQ(parse_lss_address("2F0h:000001A3h:10001h:0"), printed);
  EXPECT_EQ(parse_lss_address(lss_address_text(printed)), printed) << "as it is printed";
  const LssPattern pattern = parse_lss_pattern("0x2F0:419");
  EXPECT_EQ(pattern.address, (LssAddress{{0x2F0, 419, 0, 0}}));
  EXPECT_EQ(pattern.known, (std::array<bool, 4>{true, true, false, false}));
}

TEST(LssArgument, RefusesWhatIsNoAddress) {
  for (const char* text : {"", "1:2:3:4:5", "1::3:4", "a:2:3:4", "1:2:3:-4", "4294967296:0:0:0",
                           "1:2:3:4 ", "0x:1:1:1", "0x1h:1:1:1", "h:1:1:1",
                           "vendor 1h, serial 2h, revision 0h, product 0h", "vendor 1, 2, 3, 4"}) {
    EXPECT_THROW(parse_lss_address(text), UsageError) << text;
    EXPECT_THROW(parse_lss_pattern(text), UsageError) << text;
  }
  EXPECT_THROW(parse_lss_address("1:2:3"), UsageError);
}

TEST(LssArgument, ReadsListsOfNodeIds) {
  EXPECT_EQ(parse_node_ids("10"), (std::vector<NodeId>{10}));
  EXPECT_EQ(parse_node_ids("10-12,0x20,5-5"), (std::vector<NodeId>{10, 11, 12, 32, 5}));
  EXPECT_EQ(parse_node_ids("1-127").size(), 127U);
  for (const char* text : {"", "0", "128", "12-10", "10-", "-10", "10,", "10,10", "8-12,10"}) {
    EXPECT_THROW(parse_node_ids(text), UsageError) << text;
  }
}

TEST(LssArgument, ReadsBitRatesOfTheTable) {
  EXPECT_EQ(parse_bit_timing("1000000"), 0);
  EXPECT_EQ(parse_bit_timing("1M"), 0);
  EXPECT_EQ(parse_bit_timing("125k"), 4);
  EXPECT_EQ(parse_bit_timing("10000"), 8);
  EXPECT_EQ(parse_bit_timing("250"), 3) << "no CAN bus has 250 bit/s";
  EXPECT_EQ(parse_bit_timing("auto"), 9);
  for (const char* text : {"", "0", "k", "100k", "1000M", "4295092", "4294968k", "fast"}) {
    EXPECT_THROW(parse_bit_timing(text), UsageError) << text;
  }
}

TEST(LssArgument, BitRatesAreReadAsTheToolsOfTheFieldWriteThem) {
  for (const char* text : {"125", "125k", "125K", "125000", "125kbit/s", "125 kBit/s", "125 kbps",
                           "125kBaud", "0.125M", "0.125 Mbit/s", "125000 bit/s", "125000bps"}) {
    EXPECT_EQ(parse_bit_rate(text), 125'000U) << text;
  }
  EXPECT_EQ(parse_bit_rate("83.333k"), 83'333U);
  EXPECT_EQ(parse_bit_rate("1000"), 1'000'000U);
  EXPECT_EQ(parse_bit_rate("5000"), 5'000U);
  for (const char* text : {"", "0", "-125", "1001", "4999", "1000001", "2M", "125x", "125 k k",
                           "nan", "inf", "1e9", "0.0001k", "fast", "k125"}) {
    EXPECT_FALSE(parse_bit_rate(text)) << text;
  }
}

TEST(LssArgument, SaysWhyANodeRefused) {
  EXPECT_EQ(lss_error_text(lss::Command::store, {.code = 1}), "the node cannot store");
  EXPECT_EQ(lss_error_text(lss::Command::store, {.code = 2}), "its storage does not work");
  EXPECT_EQ(lss_error_text(lss::Command::configure_node_id, {.code = 1}),
            "the node does not take this node-ID");
  EXPECT_EQ(lss_error_text(lss::Command::configure_bit_timing, {.code = 1}),
            "the node does not have this bit rate");
  EXPECT_EQ(lss_error_text(lss::Command::configure_bit_timing, {.code = 0xFF, .specific = 0x2A}),
            "refused for a reason of the manufacturer, 2Ah");
  EXPECT_EQ(lss_error_text(lss::Command::configure_node_id, {.code = 7}), "refused with error 07h");
}

TEST(LssArgument, WritesAddressesAndBitRates) {
  EXPECT_EQ(lss_address_text({{0x2F0, 0x1A3, 0x10001, 0}}),
            "vendor 2F0h, product 1A3h, revision 10001h, serial 0h");
  EXPECT_EQ(bit_timing_text(4), "125000 bit/s");
  EXPECT_EQ(bit_timing_text(9), "automatic");
}

}  // namespace
}  // namespace canvoy::tools::lss_argument_test
