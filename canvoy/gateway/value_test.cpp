#include "canvoy/gateway/value.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::gateway::value_test {
namespace {

std::optional<Bytes> bytes_of(std::string_view type, std::string_view text) {
  const auto words = split(text);
  return words ? parse_value(*parse_type(type), *words) : std::nullopt;
}
std::string text_of(std::string_view type, const Bytes& bytes, Version version = Version::v3_0) {
  return value_text(*parse_type(type), bytes, version).value_or("(none)");
}
Bytes pattern(std::uint64_t number, std::size_t size) {
  Bytes bytes(8);
  store(bytes.data(), number);
  bytes.resize(size);
  return bytes;
}

TEST(GatewayValue, UnsignedIntegersFillTheirLength) {
  for (unsigned size = 1; size <= 8; ++size) {
    const std::string type = "u" + std::to_string(size * 8);
    const std::uint64_t highest = ~std::uint64_t{0} >> (64 - size * 8);
    const std::string text = std::to_string(highest);
    EXPECT_EQ(bytes_of(type, text), Bytes(size, 0xFF)) << type;
    EXPECT_EQ(text_of(type, Bytes(size, 0xFF)), text);
    EXPECT_EQ(bytes_of(type, "0"), Bytes(size, 0)) << type;
    EXPECT_FALSE(bytes_of(type, "-1")) << type;
    if (size < 8) {
      EXPECT_FALSE(bytes_of(type, std::to_string(highest + 1))) << type;
    }
  }
  EXPECT_FALSE(bytes_of("u64", "18446744073709551616"));
}

TEST(GatewayValue, SignedIntegersReachFromTheirLowestToTheirHighest) {
  for (unsigned size = 1; size <= 8; ++size) {
    const std::string type = "i" + std::to_string(size * 8);
    const std::uint64_t half = std::uint64_t{1} << (size * 8 - 1);
    const std::string lowest = "-" + std::to_string(half);
    EXPECT_EQ(bytes_of(type, lowest), pattern(half, size)) << type;
    EXPECT_EQ(text_of(type, pattern(half, size)), lowest);
    EXPECT_EQ(bytes_of(type, std::to_string(half - 1)), pattern(half - 1, size)) << type;
    EXPECT_EQ(text_of(type, Bytes(size, 0xFF)), "-1");
    EXPECT_FALSE(bytes_of(type, std::to_string(half))) << type;
    EXPECT_FALSE(bytes_of(type, "-" + std::to_string(half + 1))) << type;
  }
}

TEST(GatewayValue, NumbersAreDecimalOrHexadecimalAndNeverOctal) {
  EXPECT_EQ(bytes_of("u16", "0x1F4"), (Bytes{0xF4, 0x01}));
  EXPECT_EQ(bytes_of("u16", "0X1f4"), (Bytes{0xF4, 0x01}));
  EXPECT_EQ(bytes_of("i8", "-0x80"), (Bytes{0x80}));
  for (const char* text : {"010", "00", "0x", "0x10000", "1e3", "1.0", "+1", "--1", "1h", "five"}) {
    EXPECT_FALSE(bytes_of("u16", text)) << text;
  }
}

TEST(GatewayValue, ABooleanIsZeroOrOne) {
  EXPECT_EQ(bytes_of("b", "1"), Bytes{1});
  EXPECT_EQ(bytes_of("b", "0"), Bytes{0});
  EXPECT_FALSE(bytes_of("b", "2"));
  EXPECT_EQ(text_of("b", {1}), "1");
  EXPECT_EQ(text_of("b", {1}, Version::v2_1), "1");
}

TEST(GatewayValue, Version21AnswersUnsignedIntegersInHexadecimalAsLelyDoes) {
  EXPECT_EQ(text_of("u32", {0x60, 0x03, 0, 0}, Version::v2_1), "0x00000360");
  EXPECT_EQ(text_of("u8", {0x0A}, Version::v2_1), "0x0a");
  EXPECT_EQ(text_of("i8", {0xFF}, Version::v2_1), "-1");
}

TEST(GatewayValue, TheAdditionsOfCanopennode) {
  EXPECT_EQ(text_of("x8", {0x0A}), "0x0a");
  EXPECT_EQ(text_of("x16", {0xF4, 0x01}), "0x01f4");
  EXPECT_EQ(text_of("x32", {0, 0, 0, 0}), "0x00000000");
  EXPECT_EQ(text_of("x64", pattern(0x123456789ABCDEF0, 8)), "0x123456789abcdef0");
  EXPECT_EQ(bytes_of("x16", "500"), (Bytes{0xF4, 0x01}));
  EXPECT_EQ(bytes_of("hex", "01 2AFF"), (Bytes{0x01, 0x2A, 0xFF}));
  EXPECT_EQ(text_of("hex", {0x01, 0x2A, 0xFF}), "01 2A FF");
  EXPECT_EQ(text_of("hex", {}), "");
  for (const char* text : {"", "1", "0x01", "01 2", "0G", "-1"}) {
    EXPECT_FALSE(bytes_of("hex", text)) << text;
  }
}

// IEEE 754: 3.14159274101257324219 is 40490FDBh.
TEST(GatewayValue, RealsAreWrittenAsShortAsTheyAreReadBack) {
  EXPECT_EQ(bytes_of("r32", "3.14159274101257324219"), (Bytes{0xDB, 0x0F, 0x49, 0x40}));
  EXPECT_EQ(text_of("r32", {0xDB, 0x0F, 0x49, 0x40}), "3.1415927");
  EXPECT_EQ(bytes_of("r64", "-2.5e-1"), (Bytes{0, 0, 0, 0, 0, 0, 0xD0, 0xBF}));
  EXPECT_EQ(text_of("r64", {0, 0, 0, 0, 0, 0, 0xD0, 0xBF}), "-0.25");
  EXPECT_EQ(text_of("r32", {0, 0, 0x80, 0x7F}), "inf");
  EXPECT_EQ(bytes_of("r32", "-inf"), (Bytes{0, 0, 0x80, 0xFF}));
  EXPECT_EQ(bytes_of("r32", "7"), (Bytes{0, 0, 0xE0, 0x40}));
  for (const char* text : {"1,5", "1e99", "0x1", "pi", "1.5 2"}) {
    EXPECT_FALSE(bytes_of("r32", text)) << text;
  }
}

// CiA 301, 7.1.6.6: milliseconds in 28 bits, then days in 16.
TEST(GatewayValue, ATimeIsDaysAndMilliseconds) {
  const Bytes noon_after_a_year = {0x00, 0x2E, 0x93, 0x02, 0x6D, 0x01};
  EXPECT_EQ(bytes_of("t", "365 43200000"), noon_after_a_year);
  EXPECT_EQ(bytes_of("td", "365 43200000"), noon_after_a_year);
  EXPECT_EQ(text_of("t", noon_after_a_year), "365 43200000");
  EXPECT_EQ(text_of("td", {0x00, 0x2E, 0x93, 0xF2, 0x6D, 0x01}), "365 43200000")
      << "the four bits above are reserved";
  EXPECT_EQ(bytes_of("t", "65535 268435455"), (Bytes{0xFF, 0xFF, 0xFF, 0x0F, 0xFF, 0xFF}));
  for (const char* text : {"365", "65536 0", "0 268435456", "1 2 3", "-1 0"}) {
    EXPECT_FALSE(bytes_of("t", text)) << text;
  }
}

TEST(GatewayValue, OctetStringsUnicodeStringsAndDomainsAreBase64) {
  const Bytes bytes = {0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF};
  for (const char* type : {"os", "us", "d"}) {
    EXPECT_EQ(bytes_of(type, "ASNFZ4mrze8="), bytes);
    EXPECT_EQ(text_of(type, bytes), "ASNFZ4mrze8=");
    EXPECT_FALSE(bytes_of(type, "ASNF Z4mr"));
    EXPECT_FALSE(bytes_of(type, "*"));
  }
}

TEST(GatewayValue, AVisibleStringIsQuotedAndStaysOnOneLine) {
  const std::string hello = "Hello, \"World\"!";
  EXPECT_EQ(bytes_of("vs", R"("Hello, ""World""!")"), Bytes(hello.begin(), hello.end()));
  EXPECT_EQ(text_of("vs", Bytes(hello.begin(), hello.end())), R"("Hello, ""World""!")");
  EXPECT_EQ(bytes_of("vs", "word"), (Bytes{'w', 'o', 'r', 'd'}));
  EXPECT_EQ(bytes_of("vs", R"("")"), Bytes{});
  EXPECT_EQ(text_of("vs", {}), R"("")");
  EXPECT_EQ(text_of("vs", {'a', '\r', '\n', '\\', 0, 0x1B, 0x7F, 'b'}),
            R"("a\r\n\\\000\033\177b")");
  EXPECT_EQ(bytes_of("vs", R"("a\r\n\\\000\033\177b")"),
            (Bytes{'a', '\r', '\n', '\\', 0, 0x1B, 0x7F, 'b'}));
  EXPECT_EQ(bytes_of("vs", R"("\x41\"\'\?\0")"), (Bytes{'A', '"', '\'', '?', 0}));
  EXPECT_EQ(text_of("vs", {0xC3, 0xA4}), "\"\xC3\xA4\"") << "UTF-8 stays as it is";
}

TEST(GatewayValue, WhatIsNoVisibleStringIsRefused) {
  for (const char* text : {R"("open)", R"("a"b)", R"("\q")", R"("\x")", R"("\777")", R"("\)",
                           "two words", R"("a" "b")"}) {
    EXPECT_FALSE(bytes_of("vs", text)) << text;
  }
}

TEST(GatewayValue, AnotherLengthThanThatOfTheTypeIsNoValue) {
  EXPECT_EQ(text_of("u16", {1}), "(none)");
  EXPECT_EQ(text_of("u16", {1, 2, 3}), "(none)");
  EXPECT_EQ(text_of("b", {}), "(none)");
  EXPECT_EQ(text_of("t", {1, 2, 3, 4}), "(none)");
}

TEST(GatewayValue, UnknownTypesAreRefused) {
  for (const char* type : {"", "u", "u7", "u72", "i0", "r16", "x24", "s", "vss", "hexx"}) {
    EXPECT_FALSE(parse_type(type)) << type;
  }
  EXPECT_TRUE(parse_type("U16"));
}

/// NaN has many bit patterns and one text.
bool is_nan(const ValueType& type, const Bytes& bytes) {
  if (type.type == DataType::real32) return std::isnan(load<float>(bytes.data()));
  return type.type == DataType::real64 && std::isnan(load<double>(bytes.data()));
}

RC_GTEST_PROP(GatewayValue, WhatIsWrittenIsReadAgain, (Bytes bytes)) {
  constexpr std::array names = {"b",   "i8",  "i16", "i24", "i32", "i40", "i48", "i56", "i64", "u8",
                                "u16", "u24", "u32", "u40", "u48", "u56", "u64", "r32", "r64", "x8",
                                "x16", "x32", "x64", "vs",  "os",  "us",  "d",   "hex"};
  const ValueType type = *parse_type(*rc::gen::elementOf(names));
  if (byte_length(type.type) != 0) bytes.resize(byte_length(type.type));
  if (type.type == DataType::boolean) bytes[0] &= 1;
  if (is_nan(type, bytes) || (bytes.empty() && type.type != DataType::visible_string)) return;
  for (const Version version : {Version::v2_1, Version::v3_0}) {
    const std::string text = *value_text(type, bytes, version);
    RC_ASSERT(text.find('\n') == std::string::npos);
    const auto words = split(text);
    RC_ASSERT(words.has_value());
    RC_ASSERT(parse_value(type, *words) == bytes);
  }
}

}  // namespace
}  // namespace canvoy::gateway::value_test
