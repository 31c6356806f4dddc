// Characters are from The Unicode Standard, those of Windows-1252 from its table at unicode.org.
#include "canvoy/formats/encoding.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::formats::encoding_test {
namespace {

using namespace std::literals;

TEST(Encoding, Utf8StaysAsItIs) {
  const DecodedText text = decode_text("Verz\xC3\xB6gerung\n");
  EXPECT_EQ(text.text, "Verz\xC3\xB6gerung\n");
  EXPECT_EQ(text.remark(), "");
}

TEST(Encoding, WhatIsNoUtf8IsWindows1252AndSaysSo) {
  const DecodedText text = decode_text("Verz\xF6gerung \x80 \x99 \x81\n");
  EXPECT_EQ(text.text, "Verz\xC3\xB6gerung \xE2\x82\xAC \xE2\x84\xA2 \xEF\xBF\xBD\n");
  EXPECT_TRUE(text.remark().starts_with("it is no UTF-8: read as Windows-1252"));
}

TEST(Encoding, ByteOrderMarksSayWhichItIs) {
  EXPECT_EQ(decode_text("\xEF\xBB\xBF[A]\n").text, "[A]\n");
  EXPECT_EQ(decode_text("\xEF\xBB\xBF\xF6\n").text, "\xC3\xB6\n") << "the mark may be wrong";
  EXPECT_EQ(decode_text("\xFF\xFE[\0\xF6\0]\0\r\0\n\0"sv).text, "[\xC3\xB6]\n");
  EXPECT_EQ(decode_text("\xFE\xFF\0[\0\xF6\0]\0\r\0\n"sv).text, "[\xC3\xB6]\n");
  EXPECT_EQ(decode_text("\xFF\xFE\x3D\xD8\x00\xDE"sv).text, "\xF0\x9F\x98\x80")
      << "a pair: U+1F600";
  EXPECT_EQ(decode_text("\xFF\xFE\x3D\xD8"sv).text, "\xEF\xBF\xBD") << "half a pair";
  EXPECT_EQ(decode_text("\xFF\xFE\x00\xDE"sv).text, "\xEF\xBF\xBD");
  EXPECT_EQ(decode_text("\xFF\xFE\x41\x00\x42"sv).text, "A") << "half a character";
  EXPECT_EQ(decode_text("\xFF\xFE\xAC\x20"sv).text, "\xE2\x82\xAC");
}

TEST(Encoding, ACarriageReturnEndsALine) {
  EXPECT_EQ(decode_text("a\rb\r\nc\n\rd").text, "a\nb\nc\n\nd");
}

TEST(Encoding, RefusesWhatIsNoUtf8) {
  for (const std::string_view wrong :
       {"\xC0\x80", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5", "\x80"}) {
    EXPECT_FALSE(is_utf8(wrong)) << wrong;
  }
  EXPECT_TRUE(is_utf8("\xF0\x9F\x98\x80\x01"));
}

TEST(Encoding, Utf16InPiecesIsTheSame) {
  constexpr std::string_view whole = "A\0\x3D\xD8\x00\xDE\xF6\0"sv;
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    std::string text;
    std::array<char, 4> room{};
    std::string_view piece = whole.substr(0, cut);
    bool is_last = false;
    while (true) {
      const RecodeStep step = recode_utf16(piece, false, is_last, room);
      text.append(room.data(), step.made);
      piece = whole.substr(static_cast<std::size_t>(piece.data() - whole.data()) + step.taken,
                           piece.size() - step.taken);
      if (step.taken != 0) continue;
      if (is_last) break;
      is_last = true;
      piece = whole.substr(static_cast<std::size_t>(piece.data() - whole.data()));
    }
    EXPECT_EQ(text, "A\xF0\x9F\x98\x80\xC3\xB6") << cut;
  }
}

}  // namespace
}  // namespace canvoy::formats::encoding_test
