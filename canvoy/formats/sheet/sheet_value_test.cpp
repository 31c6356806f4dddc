// Values are typed from CiA 301, 7.1.4: little-endian numbers, two's complement, IEEE 754.
#include "canvoy/formats/sheet/sheet_value.hpp"

#include <gtest/gtest.h>

namespace canvoy::formats::sheet_value_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::optional<Bytes> bytes(DataType type, std::string_view text) {
  return sheet_bytes(type, text, 5);
}

TEST(SheetValue, NumbersAreBytesWithTheLeastSignificantFirst) {
  using enum DataType;
  EXPECT_EQ(bytes(unsigned32, "0x12345678"), (Bytes{0x78, 0x56, 0x34, 0x12}));
  EXPECT_EQ(bytes(unsigned32, "$NODEID+0x180"), (Bytes{0x85, 0x01, 0, 0}));
  EXPECT_EQ(bytes(integer16, "-2"), (Bytes{0xFE, 0xFF}));
  EXPECT_EQ(bytes(integer16, "0xFFFE"), (Bytes{0xFE, 0xFF})) << "the pattern";
  EXPECT_EQ(bytes(unsigned24, "1"), (Bytes{1, 0, 0}));
  EXPECT_EQ(bytes(boolean, "1"), (Bytes{1}));
  EXPECT_EQ(bytes(unsigned64, "0xFFFFFFFFFFFFFFFF"), Bytes(8, 0xFF));
  EXPECT_EQ(bytes(unsigned8, ""), (Bytes{0}));
}

TEST(SheetValue, RealsAreNumbersOrTheirBits) {
  EXPECT_EQ(bytes(DataType::real32, "1.5"), (Bytes{0, 0, 0xC0, 0x3F}));
  EXPECT_EQ(bytes(DataType::real32, "0x3FC00000"), (Bytes{0, 0, 0xC0, 0x3F}));
  EXPECT_EQ(bytes(DataType::real64, "-2"), (Bytes{0, 0, 0, 0, 0, 0, 0, 0xC0}));
}

TEST(SheetValue, StringsAreTheirCharactersAndOctetsTheirDigits) {
  EXPECT_EQ(bytes(DataType::visible_string, "A b"), (Bytes{'A', ' ', 'b'}));
  EXPECT_EQ(bytes(DataType::octet_string, "0A ff10"), (Bytes{0x0A, 0xFF, 0x10}));
  EXPECT_EQ(bytes(DataType::octet_string, ""), Bytes());
}

TEST(SheetValue, WhatIsNoValueOfTheTypeIsNone) {
  using enum DataType;
  EXPECT_FALSE(bytes(unsigned8, "256"));
  EXPECT_FALSE(bytes(unsigned8, "-129"));
  EXPECT_FALSE(bytes(unsigned8, "x"));
  EXPECT_FALSE(bytes(unsigned8, "$NODEID+0xFF")) << "beyond with the node-ID";
  EXPECT_FALSE(bytes(real32, "one"));
  EXPECT_FALSE(bytes(octet_string, "0A 1"));
  EXPECT_FALSE(bytes(octet_string, "0x10"));
  EXPECT_FALSE(bytes(domain, "data"));
}

TEST(SheetValue, WhatIsBeyondTheTypeIsNoneHoweverItIsWritten) {
  using enum DataType;
  EXPECT_FALSE(bytes(unsigned64, "-18446744073709551615")) << "it is not 1";
  EXPECT_FALSE(bytes(integer64, "-9223372036854775809"));
  EXPECT_EQ(bytes(integer64, "-9223372036854775808"), (Bytes{0, 0, 0, 0, 0, 0, 0, 0x80}));
  EXPECT_FALSE(bytes(unsigned8, "0xFFFFFFFFFFFFFFFF")) << "64 bits are not 8";
  EXPECT_FALSE(bytes(integer16, "18446744073709551615"));
  EXPECT_FALSE(bytes(unsigned64, "$NODEID+0x7FFFFFFFFFFFFFFF")) << "no sum of 63 bits";
  EXPECT_FALSE(bytes(unsigned64, "$NODEID+0xFFFFFFFFFFFFFFFF"));
  EXPECT_EQ(bytes(unsigned64, "$NODEID+0x7FFFFFFFFFFFFF80"),
            (Bytes{0x85, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F}));
}

TEST(SheetValue, ARealThatItsTypeCannotHoldIsNone) {
  using enum DataType;
  EXPECT_FALSE(bytes(real32, "1e39")) << "it is not infinite";
  EXPECT_FALSE(bytes(real32, "-3.5e38"));
  EXPECT_EQ(bytes(real32, "3.4028234663852886e38"), (Bytes{0xFF, 0xFF, 0x7F, 0x7F}));
  EXPECT_EQ(bytes(real32, "-inf"), (Bytes{0, 0, 0x80, 0xFF})) << "what is said to be infinite";
  EXPECT_FALSE(bytes(real64, "1e309"));
  EXPECT_FALSE(bytes(real32, "0x1FFFFFFFF")) << "33 bits";
  EXPECT_FALSE(bytes(real32, "-0x1")) << "no pattern has a sign";
}

TEST(SheetValue, TheSameValueMayBeWrittenInSeveralWays) {
  EXPECT_TRUE(same_value(5, "10", "0x0A"));
  EXPECT_TRUE(same_value(2, "-1", "0xFF"));
  EXPECT_TRUE(same_value(7, "$NODEID+0x180", "0x180 + $nodeid"));
  EXPECT_FALSE(same_value(7, "$NODEID+0x180", "0x180"));
  EXPECT_FALSE(same_value(9, "a", "A"));
  EXPECT_FALSE(same_value(0x40, "1", "0x1")) << "of a type that is not known";
}

}  // namespace
}  // namespace canvoy::formats::sheet_value_test
