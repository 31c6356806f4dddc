// Fonts of a printer with paper of 384 dots.
#include "canvoy/devices/cia447/printer/printer_font.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::printer_font_test {
namespace {

constexpr PrinterFontLimits limits = {.dots_per_line = 384};

TEST(PrinterFont, IsTheSmallestOneAtFirst) {
  const PrinterFont sut(limits);
  EXPECT_EQ(sut.style(), (PrintStyle{.height = 16, .width = 8}));
  EXPECT_EQ(sut.characters_per_line(), 48u);
  EXPECT_EQ(limits.characters_max(), 48u);
  EXPECT_EQ(limits.characters_min(), 12u);
}

TEST(PrinterFont, AWidthSaysHowManyCharactersALineHas) {
  PrinterFont sut(limits);
  sut.set_width(12);
  sut.set_height(24);
  EXPECT_EQ(sut.style(), (PrintStyle{.height = 24, .width = 12}));
  EXPECT_EQ(sut.characters_per_line(), 32u);
  sut.set_width(0);
  EXPECT_EQ(sut.characters_per_line(), 48u);
}

TEST(PrinterFont, WantedCharactersSayTheWidth) {
  PrinterFont sut(limits);
  sut.set_characters(32);
  EXPECT_EQ(sut.style().width, 12);
  EXPECT_EQ(sut.characters_per_line(), 32u);
  sut.set_characters(5);
  EXPECT_EQ(sut.style().width, 32) << "as wide as there is";
  EXPECT_EQ(sut.characters_per_line(), 5u);
}

TEST(PrinterFont, OfBothTheWidthGoesFirst) {
  PrinterFont sut(limits);
  sut.set_width(16);
  sut.set_characters(20);
  EXPECT_EQ(sut.style().width, 16);
  EXPECT_EQ(sut.characters_per_line(), 20u);
  sut.set_characters(40);
  EXPECT_EQ(sut.characters_per_line(), 24u) << "no more have room";
}

TEST(PrinterFont, KnowsWhatThePrinterCannotDo) {
  const PrinterFont sut(limits);
  EXPECT_TRUE(sut.allows_height(0));
  EXPECT_FALSE(sut.allows_height(15));
  EXPECT_TRUE(sut.allows_height(16));
  EXPECT_TRUE(sut.allows_height(64));
  EXPECT_FALSE(sut.allows_height(65));
  EXPECT_TRUE(sut.allows_width(0));
  EXPECT_FALSE(sut.allows_width(7));
  EXPECT_TRUE(sut.allows_width(8));
  EXPECT_TRUE(sut.allows_width(32));
  EXPECT_FALSE(sut.allows_width(33));
  EXPECT_TRUE(sut.allows_characters(0));
  EXPECT_TRUE(sut.allows_characters(48));
  EXPECT_FALSE(sut.allows_characters(49));
}

TEST(PrinterFont, OnNarrowPaperThereIsOneCharacterAtLeast) {
  PrinterFont sut({.dots_per_line = 4});
  EXPECT_EQ(sut.characters_per_line(), 1u);
}

}  // namespace
}  // namespace canvoy::cia447::printer_font_test
