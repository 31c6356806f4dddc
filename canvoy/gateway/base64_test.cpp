#include "canvoy/gateway/base64.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace canvoy::gateway::base64_test {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

// RFC 4648, 10.
TEST(Base64, TheVectorsOfTheRfc) {
  EXPECT_EQ(to_base64(bytes_of("")), "");
  EXPECT_EQ(to_base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(to_base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(to_base64(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(to_base64(bytes_of("foob")), "Zm9vYg==");
  EXPECT_EQ(to_base64(bytes_of("fooba")), "Zm9vYmE=");
  EXPECT_EQ(to_base64(bytes_of("foobar")), "Zm9vYmFy");
}

TEST(Base64, EveryDigitIsReadAndWritten) {
  const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto bytes = from_base64(all);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->size(), 48U);
  EXPECT_EQ(to_base64(*bytes), all);
}

TEST(Base64, WhatIsNoneIsRefused) {
  for (const char* text : {"A", "AA", "AAA", "AAA*", "====", "A===", "AA=A",
                           "Zg==Zg==", "Zh==", "Zm9=", "Zm 9", "Zm9v\n", "AAAAA"}) {
    EXPECT_FALSE(from_base64(text)) << text;
  }
}

RC_GTEST_PROP(Base64, WhatIsWrittenIsReadAgain, (const std::vector<std::uint8_t>& bytes)) {
  RC_ASSERT(from_base64(to_base64(bytes)) == bytes);
}

RC_GTEST_PROP(Base64, WhatIsReadIsWrittenTheSame, (const std::string& text)) {
  const auto bytes = from_base64(text);
  if (bytes) RC_ASSERT(to_base64(*bytes) == text);
}

}  // namespace
}  // namespace canvoy::gateway::base64_test
