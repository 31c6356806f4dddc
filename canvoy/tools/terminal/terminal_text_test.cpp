#include "canvoy/tools/terminal/terminal_text.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::terminal_text_test {
namespace {

TEST(TerminalText, WhatIsWrongIsInColourUpToTheEndOfItsLine) {
  EXPECT_EQ(coloured("18A#A0 TPDO1 [!] wrong length => node 10 is new\nplain\n"),
            "18A#A0 TPDO1 \x1B[31m[!] wrong length\x1B[0m => node 10 is new\nplain\n");
  EXPECT_EQ(coloured("5min  FAULT begins: cable-cut\n"),
            "5min  \x1B[33mFAULT begins: cable-cut\x1B[0m\n");
  EXPECT_EQ(coloured("charger: EMERGENCY 8130h: life guard"),
            "charger: \x1B[31mEMERGENCY 8130h: life guard\x1B[0m");
}

TEST(TerminalText, TheFirstThatIsWrongSaysTheColour) {
  EXPECT_EQ(coloured("08A#00 EMCY  FAULT begins [!] reserved"),
            "08A#00 \x1B[31mEMCY  FAULT begins [!] reserved\x1B[0m");
}

TEST(TerminalText, NoLineIsLongerThanARow) {
  EXPECT_EQ(in_rows("12345\n123456\n", 5), "12345\n12345\n  6\n");
  EXPECT_EQ(in_rows("20.0 °C now", 8), "20.0 °C\n    now");
  EXPECT_EQ(in_rows("20.0 °C", 7), "20.0 °C");
  EXPECT_EQ(in_rows("", 5), "");
  EXPECT_EQ(in_rows("12", 1), "1\n2") << "it ends";
  EXPECT_EQ(in_rows("12345   ", 5), "12345") << "blanks make no row";
}

TEST(TerminalText, FurtherRowsBeginWhereTheTextOfTheLineBegins) {
  EXPECT_EQ(in_rows("  PASS  at most 1.2 s, 15 s allowed", 20),
            "  PASS  at most 1.2\n        s, 15 s\n        allowed");
  EXPECT_EQ(in_rows("one two three", 9), "one two\n    three");
}

TEST(TerminalText, ColoursTakeNoRoomAndGoOn) {
  EXPECT_EQ(in_rows("1 \x1B[31m345\x1B[0m", 5), "1 \x1B[31m345\x1B[0m");
  EXPECT_EQ(in_rows("1 \x1B[31m3456\x1B[0m", 5), "1\n  \x1B[31m345\n  6\x1B[0m");
  EXPECT_EQ(in_rows("12345 \x1B[0m", 5), "12345\x1B[0m");
}

TEST(TerminalText, ColourIsAWordOfThree) {
  EXPECT_THROW(use_colour("sometimes"), UsageError);
  use_colour("always");
  EXPECT_TRUE(wants_colour(-1));
  use_colour("never");
  EXPECT_FALSE(wants_colour(-1));
  use_colour("auto");
  EXPECT_FALSE(wants_colour(-1)) << "it is no terminal";
}

}  // namespace
}  // namespace canvoy::tools::terminal_text_test
