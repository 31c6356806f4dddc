// The transport on paper: table 381 of 4.2.13.10, byte by byte.
#include "canvoy/devices/cia447/printer/print_stream.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/can/random.hpp"

namespace canvoy::cia447::print_stream_test {
namespace {

/// Writes down what is done: "A@0" a character at dot 0, "+16" a feed, "|" a cut, and of rows a
/// letter for each dot.
struct Paper {
  std::string done;
  std::vector<PrintColor> last_row;
  unsigned variable = 0;

  void put(const PrintedCharacter& one) {
    const bool is_ascii = one.character < 0x7F;
    done += is_ascii ? std::string(1, static_cast<char>(one.character))
                     : "u" + std::to_string(static_cast<unsigned>(one.character));
    done += "@" + std::to_string(one.left) + (one.style.is_bold ? "b" : "") +
            (one.style.is_cursive ? "c" : "") + " ";
  }
  unsigned width(char32_t character, const PrintStyle&) { return character == U'i' ? 4 : variable; }
  void put_row(std::span<const PrintColor> row) {
    last_row.assign(row.begin(), row.end());
    for (const PrintColor& dot : row) {
      done += dot == PrintColor{} ? '.' : dot == PrintColor{0, 0, 0} ? '#' : 'o';
    }
  }
  void feed(unsigned dots) { done += "+" + std::to_string(dots) + " "; }
  void cut() { done += "| "; }

  PrinterPaper paper() {
    return {.put = callback<&Paper::put>(*this),
            .width = callback<&Paper::width>(*this),
            .put_row = callback<&Paper::put_row>(*this),
            .feed = callback<&Paper::feed>(*this),
            .cut = callback<&Paper::cut>(*this)};
  }
  std::string take() { return std::exchange(done, ""); }
};

class PrintStreamTest : public testing::Test {
 protected:
  void write(std::string_view bytes) {
    for (const char byte : bytes) sut.write(static_cast<std::uint8_t>(byte));
  }
  static constexpr std::uint8_t square_bits[] = {0b11'000000, 0b10'000000};
  static constexpr std::uint8_t bar_bits[] = {0xFF, 0xFF};
  static constexpr PrinterLogo logos[] = {{.width = 2, .bits = square_bits},
                                          {.width = 16, .bits = bar_bits}};

  Paper paper;
  PrintStream sut{paper.paper(), {.dots_per_line = 12, .logos = logos}};
};

// Mode 00h.

class TextOnPaper : public PrintStreamTest {
 protected:
  TextOnPaper() { sut.set_style({.height = 6, .width = 4}, 3); }
};

TEST_F(TextOnPaper, CharactersStandSideBySide) {
  write("ab");
  EXPECT_EQ(paper.take(), "a@0 b@4 ");
  write("\n");
  EXPECT_EQ(paper.take(), "+6 ");
  write("c");
  EXPECT_EQ(paper.take(), "c@0 ");
  EXPECT_EQ(sut.fed(), 6u);
}

TEST_F(TextOnPaper, ALineThatIsFullIsEndedByTheNextCharacter) {
  write("abc");
  EXPECT_EQ(paper.take(), "a@0 b@4 c@8 ");
  write("\nd");
  EXPECT_EQ(paper.take(), "+6 d@0 ") << "one new line, not two";
  write("efg");
  EXPECT_EQ(paper.take(), "e@4 f@8 +6 g@0 ");
}

TEST_F(TextOnPaper, FewerCharactersOfALineThanItHasRoomFor) {
  sut.set_style({.height = 6, .width = 4}, 2);
  write("abc");
  EXPECT_EQ(paper.take(), "a@0 b@4 +6 c@0 ");
}

TEST_F(TextOnPaper, WideCharactersEndTheLineEarlier) {
  sut.set_style({.height = 6, .width = 7}, 3);
  write("ab");
  EXPECT_EQ(paper.take(), "a@0 +6 b@0 ");
  sut.set_style({.height = 6, .width = 20}, 3);
  write("\ncd");
  EXPECT_EQ(paper.take(), "+6 c@0 +6 d@0 ") << "wider than the paper";
}

TEST_F(TextOnPaper, ACarriageReturnGoesBackOnTheSameLine) {
  write("ab\r_\n");
  EXPECT_EQ(paper.take(), "a@0 b@4 _@0 +6 ");
  write("abc\rdef\r\n");
  EXPECT_EQ(paper.take(), "a@0 b@4 c@8 d@0 e@4 f@8 +6 ");
}

TEST_F(TextOnPaper, ALineIsAsHighAsItsHighestCharacter) {
  write("a");
  sut.set_style({.height = 20, .width = 4, .is_bold = true}, 3);
  write("b");
  sut.set_style({.height = 6, .width = 4, .is_cursive = true}, 3);
  write("c\n\n");
  EXPECT_EQ(paper.take(), "a@0 b@4b c@8c +20 +6 ");
}

TEST_F(TextOnPaper, TheCharactersOfVariableWidthAreAsWideAsThePaperSays) {
  sut.set_style({.height = 6, .width = 5, .has_variable_width = true}, 99);
  write("ai.");
  EXPECT_EQ(paper.take(), "a@0 i@5 +6 .@0 ") << "5 + 4 + 5 is more than 12";
  paper.variable = 1;
  write("\nabi");
  EXPECT_EQ(paper.take(), "+6 a@0 b@1 i@2 ");
}

TEST_F(TextOnPaper, TextIsUtf8InAnyPieces) {
  write("\xC3");
  EXPECT_EQ(paper.take(), "");
  write("\xA4");
  EXPECT_EQ(paper.take(), "u228@0 ");
  write("\xE2\x82");
  write("\xAC");
  EXPECT_EQ(paper.take(), "u8364@4 ");
}

TEST_F(TextOnPaper, WhatIsNoUtf8IsToldToBeSo) {
  write("\xC3x");
  EXPECT_EQ(paper.take(), "u65533@0 x@4 ");
  write("\x80");
  EXPECT_EQ(paper.take(), "u65533@8 ");
  write("\n\xE2\x82\n");
  EXPECT_EQ(paper.take(), "+6 u65533@0 +6 ");
  write("\xF0\x9F");
  sut.end();
  EXPECT_EQ(paper.take(), "u65533@0 ");
  sut.end();
  EXPECT_EQ(paper.take(), "");
}

TEST_F(TextOnPaper, ALineGoesOnInTheNextTransport) {
  write("a");
  sut.end();
  write("b");
  EXPECT_EQ(paper.take(), "a@0 b@4 ");
}

TEST_F(TextOnPaper, ACutEndsALine) {
  write("\x04");
  EXPECT_EQ(paper.take(), "| ");
  write("a\x04");
  EXPECT_EQ(paper.take(), "a@0 +6 | ");
  write("b");
  EXPECT_EQ(paper.take(), "b@0 ");
}

TEST_F(TextOnPaper, AnEscapeIsAByteLikeOthersAndHasNoPicture) {
  write("\x1B\x04\x1B\x0A\x1B");
  EXPECT_EQ(paper.take(), "| +6 ");
  EXPECT_EQ(sut.ignored(), 3u);
  write("\x09\x7F\xC2\x85\xEF\xBB\xBF");
  EXPECT_EQ(paper.take(), "");
  EXPECT_EQ(sut.ignored(), 7u);
}

TEST_F(TextOnPaper, LinesCanBeFed) {
  write("a");
  sut.feed_lines(2);
  EXPECT_EQ(paper.take(), "a@0 +6 +6 ");
}

// Modes 01h to 04h.

class Graphics : public PrintStreamTest {
 protected:
  Graphics() { sut.set_mode(PrinterMode::graphics_black); }
};

TEST_F(Graphics, OfBlackOnesTheHighestBitIsLeft) {
  write("\xA0\xF0\x1B\x0A");
  EXPECT_EQ(paper.take(), "#.#.....####+1 ") << "of the second byte four bits lie beside it";
  write("\x01\x1B\x0A");
  EXPECT_EQ(paper.take(), ".......#....+1 ");
  EXPECT_EQ(sut.fed(), 2u);
}

TEST_F(Graphics, ARowThatIsFullIsEndedByTheNextDot) {
  write("\xFF\xFF");
  EXPECT_EQ(paper.take(), "");
  write("\x80");
  EXPECT_EQ(paper.take(), "############+1 ");
  sut.end();
  EXPECT_EQ(paper.take(), "#...........+1 ") << "a transport leaves no row open";
  sut.end();
  EXPECT_EQ(paper.take(), "");
}

TEST_F(Graphics, AnEmptyRowFeeds) {
  write("\x1B\x0A\x1B\x0A");
  EXPECT_EQ(paper.take(), "+1 +1 ");
}

TEST_F(Graphics, AnEscapeIsSentTwice) {
  write("\x1B\x1B\x1B\x0A");
  EXPECT_EQ(paper.take(), "...##.##....+1 ") << "1Bh is 0001 1011b";
}

TEST_F(Graphics, WithoutEscapeTheBytesOfCommandsAreDots) {
  write(std::string_view("\x04\x0A\x1B\x0D\x0D\x1B\x0A", 7));
  // 04h 0Ah side by side, then 0Dh over the first of them.
  EXPECT_EQ(paper.take(), "....##.#....+1 ");
}

TEST_F(Graphics, ACarriageReturnPrintsOver) {
  write("\xF0\x1B\x0D\x0F\x1B\x0A");
  EXPECT_EQ(paper.take(), "########....+1 ");
  write("\xF0\x1B\x0D");
  sut.end();
  EXPECT_EQ(paper.take(), "####........+1 ") << "what was printed is there, wherever it goes on";
}

TEST_F(Graphics, ACutEndsTheRow) {
  write("\x80\x1B\x04\x80\x1B\x0A");
  EXPECT_EQ(paper.take(), "#...........+1 | #...........+1 ");
}

TEST_F(Graphics, UnknownEscapesAreNothing) {
  write("\x1BZ\x80\x1B\x0A");
  EXPECT_EQ(paper.take(), "#...........+1 ");
  EXPECT_EQ(sut.ignored(), 1u);
  write("\x1B");
  sut.end();
  write("\x0A\x1B\x0A");
  EXPECT_EQ(paper.take(), "....#.#.....+1 ") << "an escape does not reach into the next transport";
}

TEST_F(Graphics, OfGrayOnesFFhIsBlack) {
  sut.set_mode(PrinterMode::graphics_gray);
  write(std::string_view("\x00\x80\xFF\x1B\x1B\x1B\x0A", 7));
  EXPECT_EQ(paper.take(), ".o#o........+1 ");
  EXPECT_EQ(paper.last_row[1], (PrintColor{0x7F, 0x7F, 0x7F}));
  EXPECT_EQ(paper.last_row[3], (PrintColor{0xE4, 0xE4, 0xE4})) << "FFh - 1Bh";
}

TEST_F(Graphics, OfRgbRedIsFirst) {
  sut.set_mode(PrinterMode::graphics_rgb);
  write(
      std::string_view("\xFF\x10\x20"
                       "\x00\x00\x00"
                       "\x1B\x1B\x01\x02"
                       "\xFF\xFF\xFF\x1B\x0A",
                       15));
  EXPECT_EQ(paper.take(), "o#o.........+1 ");
  EXPECT_EQ(paper.last_row[0], (PrintColor{0xFF, 0x10, 0x20}));
  EXPECT_EQ(paper.last_row[2], (PrintColor{0x1B, 0x01, 0x02}));
}

TEST_F(Graphics, OfCmykCyanIsFirst) {
  sut.set_mode(PrinterMode::graphics_cmyk);
  const char dots[] =
      "\x00\x00\x00\x00"
      "\xFF\x00\x00\x00"
      "\x00\xFF\x00\x00"
      "\x00\x00\xFF\x00"
      "\x00\x00\x00\xFF"
      "\x00\xFF\x00\x80\x1B\x0A";
  write(std::string_view(dots, sizeof dots - 1));
  EXPECT_EQ(paper.take(), ".ooo#o......+1 ");
  EXPECT_EQ(paper.last_row[1], (PrintColor{0x00, 0xFF, 0xFF})) << "cyan";
  EXPECT_EQ(paper.last_row[2], (PrintColor{0xFF, 0x00, 0xFF})) << "magenta";
  EXPECT_EQ(paper.last_row[3], (PrintColor{0xFF, 0xFF, 0x00})) << "yellow";
  EXPECT_EQ(paper.last_row[5], (PrintColor{0x7F, 0x00, 0x7F})) << "half black above magenta";
}

TEST_F(Graphics, HalfADotComesToNothing) {
  sut.set_mode(PrinterMode::graphics_rgb);
  write(std::string_view("\x00\x00\x1B\x0A", 4));
  EXPECT_EQ(paper.take(), "+1 ");
  write(std::string_view("\x00\x00", 2));
  sut.end();
  write(std::string_view("\x00\x00\x00\x1B\x0A", 5));
  EXPECT_EQ(paper.take(), "#...........+1 ");
}

TEST_F(Graphics, AnotherModeEndsTheRow) {
  write("\x80");
  sut.set_mode(PrinterMode::text);
  EXPECT_EQ(paper.take(), "#...........+1 ");
  sut.set_style({.height = 6, .width = 4}, 3);
  write("a");
  sut.set_mode(PrinterMode::text);
  write("b");
  EXPECT_EQ(paper.take(), "a@0 b@4 ") << "the same mode ends nothing";
  sut.set_mode(PrinterMode::graphics_black);
  EXPECT_EQ(paper.take(), "+6 ");
}

// Mode 05h.

class Logos : public PrintStreamTest {
 protected:
  Logos() { sut.set_mode(PrinterMode::logo); }
};

TEST_F(Logos, TheFirstOneIs20h) {
  write("\x20");
  EXPECT_EQ(paper.take(), "##..........+1 #...........+1 ");
}

TEST_F(Logos, WhatIsWiderThanThePaperIsCut) {
  write("\x21");
  EXPECT_EQ(paper.take(), "############+1 ");
}

TEST_F(Logos, OnesThatAreNotThereAreNothing) {
  write(std::string_view("\x22\x33\x34\x1F\x1B\x00\xFF", 7));
  EXPECT_EQ(paper.take(), "");
  EXPECT_EQ(sut.ignored(), 7u);
}

TEST_F(Logos, ANewLineIsOneDotHigh) {
  write("\n\r\x04");
  EXPECT_EQ(paper.take(), "+1 | ");
}

TEST(PrintStream, APrinterWithoutAKnifeEndsTheLineOnly) {
  Paper paper;
  PrintStream sut(paper.paper(), {.dots_per_line = 12, .can_cut = false});
  sut.write('a');
  sut.write(0x04);
  EXPECT_EQ(paper.take(), "a@0 +16 ");
  EXPECT_EQ(sut.ignored(), 1u);
}

TEST(PrintStream, WhatComesIsSurvivedInEveryMode) {
  Random random(60);
  Paper paper;
  PrintStream sut(paper.paper(), {.dots_per_line = 9});
  for (int i = 0; i < 200'000; ++i) {
    if (random.below(50) == 0) sut.set_mode(static_cast<PrinterMode>(random.below(6)));
    if (random.below(50) == 0) sut.end();
    if (random.below(50) == 0) {
      sut.set_style({.height = static_cast<std::uint8_t>(random.below(256)),
                     .width = static_cast<std::uint8_t>(random.below(256))},
                    random.below(256));
    }
    sut.write(static_cast<std::uint8_t>(random.below(256)));
    paper.take();
    ASSERT_LE(paper.last_row.size(), 9u);
  }
  EXPECT_GT(sut.fed(), 1000u);
}

}  // namespace
}  // namespace canvoy::cia447::print_stream_test
