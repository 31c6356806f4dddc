// Texts that have room on a display, and others.
#include "canvoy/devices/cia447/terminal/text_area.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::cia447::text_area_test {
namespace {

constexpr TextArea small = {.lines = 2, .columns = 4, .characters = 7};

TEST(TextArea, TakesAsManyCharactersAsItSays) {
  EXPECT_TRUE(small.fits(""));
  EXPECT_TRUE(small.fits("abcdefg"));
  EXPECT_FALSE(small.fits("abcdefgh")) << "there is a place on the second line, but 7 is the most";
}

TEST(TextArea, ALineEndsWithALineFeed) {
  EXPECT_TRUE(small.fits("a\nb"));
  EXPECT_TRUE(small.fits("a\nb\n")) << "nothing follows on a third line";
  EXPECT_FALSE(small.fits("a\nb\nc"));
  EXPECT_FALSE(small.fits("\n\n\n"));
}

TEST(TextArea, ALongLineGoesOnInTheNext) {
  EXPECT_TRUE(small.fits("abcd\nef"));
  EXPECT_TRUE(small.fits("abcde"));
  EXPECT_FALSE(small.fits("abcde\nf")) << "the first takes two lines";
  EXPECT_FALSE((TextArea{.lines = 1, .columns = 4, .characters = 80}.fits("abcde")));
}

TEST(TextArea, AColumnIsACharacterOfAnyLength) {
  constexpr TextArea one = {.lines = 1, .columns = 3, .characters = 20};
  EXPECT_TRUE(one.fits("äöü"));
  EXPECT_TRUE(one.fits("€€€"));
  EXPECT_TRUE(one.fits("\U0001F695\U0001F695"));
  EXPECT_FALSE(one.fits("äöüß"));
}

TEST(TextArea, TheMostIsCountedInCharactersOfEightBits) {
  constexpr TextArea six = {.lines = 1, .columns = 20, .characters = 6};
  EXPECT_TRUE(six.fits("äöü"));
  EXPECT_FALSE(six.fits("äöüx"));
  EXPECT_TRUE(six.fits("€€"));
}

TEST(TextArea, WhatIsNoUtf8HasNoPlace) {
  constexpr TextArea wide = {.lines = 1, .columns = 20, .characters = 20};
  for (const std::string text :
       {"\x80", "\xC3", "\xC3(", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "ab\xE2\x82"}) {
    EXPECT_FALSE(wide.fits(text));
  }
  EXPECT_TRUE(wide.fits("\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF")) << "the last ones that are";
}

TEST(TextArea, ControlCharactersHaveNoPlace) {
  for (const char control : {'\r', '\t', '\x1B', '\x7F', '\x01'}) {
    EXPECT_FALSE(small.fits(std::string(1, control)));
  }
  EXPECT_FALSE(small.fits(std::string_view("\0", 1)));
}

TEST(TextArea, TheLargestDisplayTakes254Characters) {
  constexpr TextArea largest = {.lines = 254, .columns = 254, .characters = 254};
  EXPECT_TRUE(largest.fits(std::string(254, 'x')));
  EXPECT_FALSE(largest.fits(std::string(255, 'x')));
}

}  // namespace
}  // namespace canvoy::cia447::text_area_test
