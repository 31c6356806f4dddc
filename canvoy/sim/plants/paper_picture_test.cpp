// Prints of a printer as a person sees them: the expected dots are typed from the shape of the
// letters.
#include "canvoy/sim/plants/paper_picture.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/devices/cia447/printer/print_stream.hpp"

namespace canvoy::paper_picture_test {
namespace {

using cia447::PrinterMode;
using cia447::PrintStream;

/// Rows of a picture as letters: '#' black, '.' white, 'o' any other.
std::string drawn(const Picture& picture, std::size_t width, std::size_t first, std::size_t rows) {
  std::string text;
  for (std::size_t y = first; y < first + rows; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const Picture::Color dot = picture.at(x, y);
      text += dot == Picture::Color{} ? '.' : dot == Picture::Color{0, 0, 0} ? '#' : 'o';
    }
    text += '\n';
  }
  return text;
}

void write(PrintStream& stream, std::string_view bytes) {
  for (const char byte : bytes) stream.write(static_cast<std::uint8_t>(byte));
}

class Paper : public testing::Test {
 protected:
  PaperPicture paper{64};
  PrintStream stream{paper.paper(), {.dots_per_line = 64}};
};

TEST_F(Paper, ALetterLooksLikeOne) {
  write(stream, "L\n");
  EXPECT_EQ(drawn(paper.present(), 8, 4, 10),
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".#......\n"
            ".######.\n");
  EXPECT_EQ(paper.present().height(), 16u);
  EXPECT_EQ(paper.present().width(), 64u);
}

TEST_F(Paper, LettersStandSideBySideAndLinesBelowEachOther) {
  write(stream, " L\n  L\n");
  EXPECT_EQ(drawn(paper.present(), 24, 13, 1), ".........######.........\n");
  EXPECT_EQ(drawn(paper.present(), 24, 29, 1), ".................######.\n");
  EXPECT_EQ(paper.present().height(), 32u);
}

TEST_F(Paper, LettersAreStretched) {
  stream.set_style({.height = 32, .width = 16}, 4);
  write(stream, "L\n");
  EXPECT_EQ(drawn(paper.present(), 16, 8, 2), "..##............\n..##............\n");
  EXPECT_EQ(drawn(paper.present(), 16, 26, 2), "..############..\n..############..\n");
  EXPECT_EQ(drawn(paper.present(), 16, 28, 1), "................\n");
}

TEST_F(Paper, BoldLettersHaveWiderStrokes) {
  stream.set_style({.is_bold = true}, 8);
  write(stream, "L");
  EXPECT_EQ(drawn(paper.present(), 8, 4, 1), ".##.....\n");
}

TEST_F(Paper, CursiveLettersLean) {
  stream.set_style({.is_cursive = true}, 8);
  write(stream, "L");
  // By 11 * 8 / 16 / 2 dots in the fifth of 16 rows, by none near the foot.
  EXPECT_EQ(drawn(paper.present(), 8, 4, 1), "...#....\n");
  EXPECT_EQ(drawn(paper.present(), 8, 12, 1), ".#......\n");
}

TEST_F(Paper, OfVariableWidthLettersTakeWhatTheyNeed) {
  stream.set_style({.has_variable_width = true}, 99);
  write(stream, "LL");
  // Six columns with ink, and one that is empty.
  EXPECT_EQ(drawn(paper.present(), 16, 13, 1), "######.######...\n");
}

TEST_F(Paper, LettersOfLatin1AndTheEuroAreThere) {
  for (const std::string_view text : {"ä", "ß", "ÿ", "é", "£", "€", "~"}) {
    PaperPicture one(8);
    PrintStream line(one.paper(), {.dots_per_line = 8});
    write(line, text);
    PaperPicture unknown(8);
    PrintStream other(unknown.paper(), {.dots_per_line = 8});
    write(other, "\u4E2D");
    EXPECT_NE(one.present().bytes(), unknown.present().bytes()) << text;
    EXPECT_NE(drawn(one.present(), 8, 0, 16).find('#'), std::string::npos) << text;
  }
}

TEST_F(Paper, WhatHasNoPictureIsABox) {
  write(stream, "\u4E2D");
  EXPECT_EQ(drawn(paper.present(), 8, 3, 2), ".######.\n.#....#.\n");
}

TEST_F(Paper, DotsOfAllColorsAreThere) {
  stream.set_mode(PrinterMode::graphics_rgb);
  write(stream, std::string_view("\xFF\x00\x00\x00\x00\x00\x1B\x0A", 8));
  EXPECT_EQ(paper.present().at(0, 0), (Picture::Color{0xFF, 0, 0}));
  EXPECT_EQ(drawn(paper.present(), 4, 0, 1), "o#..\n");
  EXPECT_EQ(paper.present().bytes()[0], 0xFF);
  EXPECT_EQ(paper.present().bytes()[1], 0x00);
}

TEST_F(Paper, ARowOfDotsIsNoHigherThanADot) {
  stream.set_mode(PrinterMode::graphics_rgb);
  write(stream, std::string_view("\xFF\x00\x00\x00\x00\x00\x1B\x0A", 8));
  EXPECT_EQ(paper.present().height(), 1u);
}

TEST_F(Paper, WhatIsCutIsAReceipt) {
  write(stream, "L\n\x04L");
  ASSERT_EQ(paper.receipts().size(), 1u);
  EXPECT_EQ(paper.receipts()[0].height(), 16u);
  EXPECT_EQ(drawn(paper.present(), 8, 13, 1), ".######.\n");
  write(stream, "\x04\x04");
  EXPECT_EQ(paper.cuts(), 3u);
  EXPECT_EQ(paper.receipts()[2].height(), 0u);
}

TEST_F(Paper, LongReceiptsTearAndOldOnesAreThrownAway) {
  for (int i = 0; i < 1'251; ++i) write(stream, "\n");
  EXPECT_EQ(paper.cuts(), 1u) << "1250 lines have 20 000 dots";
  for (int i = 0; i < 100; ++i) write(stream, "\x04");
  EXPECT_EQ(paper.cuts(), 101u);
  EXPECT_EQ(paper.receipts().size(), 64u);
}

TEST_F(Paper, NothingIsDrawnBesideThePaper) {
  stream.set_style({.height = 255, .width = 255, .is_bold = true, .is_cursive = true}, 9);
  write(stream, "WW\n");
  EXPECT_EQ(paper.present().bytes().size(), 64u * 510u * 3u);
  EXPECT_EQ(paper.present().at(64, 0), Picture::Color{});
}

}  // namespace
}  // namespace canvoy::paper_picture_test
