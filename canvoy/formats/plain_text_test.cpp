// Control characters are from ECMA-48 and Unicode; UTF-8 is from RFC 3629.
#include "canvoy/formats/plain_text.hpp"

#include <gtest/gtest.h>

namespace canvoy::formats::plain_text_test {
namespace {

TEST(PlainText, WhatCanBeShownStays) {
  for (const char* text : {"", "Device type", "Prüfer", "20 °C", "門", "\U0001F6AA", "C:\\x1B"}) {
    EXPECT_TRUE(is_plain_text(text));
    EXPECT_EQ(plain_text(text), text);
  }
}

TEST(PlainText, WhatCommandsATerminalIsWrittenAsItsBytes) {
  EXPECT_EQ(plain_text("a\x1B[2Jb"), "a\\x1B[2Jb");
  EXPECT_EQ(plain_text("a\r\nb\tc\x7F"), "a\\x0D\\x0Ab\\x09c\\x7F");
  EXPECT_EQ(plain_text("\xC2\x9B"
                       "2J"),
            "\\xC2\\x9B2J")
      << "CSI of C1";
  EXPECT_EQ(plain_text("\xE2\x80\xAE"
                       "abc"),
            "\\xE2\\x80\\xAE"
            "abc")
      << "right to left";
  EXPECT_EQ(plain_text(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(PlainText, WhatIsNoUtf8IsWrittenAsItsBytes) {
  EXPECT_EQ(plain_text("Pr\xFC"
                       "fer"),
            "Pr\\xFC"
            "fer")
      << "ISO 8859-1";
  EXPECT_EQ(plain_text("\xC0\x9B"), "\\xC0\\x9B") << "longer than needed";
  EXPECT_EQ(plain_text("\xE0\x82\x9B"), "\\xE0\\x82\\x9B");
  EXPECT_EQ(plain_text("\xED\xA0\x80"), "\\xED\\xA0\\x80") << "half of a pair";
  EXPECT_EQ(plain_text("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80") << "beyond Unicode";
  EXPECT_EQ(plain_text("a\xE2\x82"), "a\\xE2\\x82") << "cut";
  EXPECT_EQ(plain_text("\x9B"), "\\x9B");
}

TEST(PlainText, IsTrimmedOfBlanks) {
  EXPECT_EQ(trimmed(" \t a b\r"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \v\f "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(PlainText, StandsInMarkup) {
  EXPECT_EQ(markup_text(R"(<a b="1"> & 'c')"), "&lt;a b=&quot;1&quot;&gt; &amp; 'c'");
}

}  // namespace
}  // namespace canvoy::formats::plain_text_test
