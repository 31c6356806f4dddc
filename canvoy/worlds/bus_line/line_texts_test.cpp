// Texts in the octets of character sets, by the tables of ISO 8859.
#include "canvoy/worlds/bus_line/line_texts.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::bus_line::line_texts_test {
namespace {

constexpr std::array<std::uint16_t, 4> some_sets = {1, 2, 5, 7};

std::string encoded(std::string_view utf_8, std::span<const std::uint16_t> sets = some_sets) {
  const EncodedText text = encode(utf_8, sets);
  return std::to_string(text.character_set) + " " + text.octets;
}

TEST(LineTexts, ASetIsChosenThatHasAllLetters) {
  EXPECT_EQ(encoded("Harbour"), "1 Harbour");
  EXPECT_EQ(encoded("Z\u00FCrich"), "1 Z\xFCrich");
  EXPECT_EQ(encoded("\u0141\u00F3d\u017A"),
            "2 \xA3\xF3"
            "d\xBC");
  EXPECT_EQ(encoded("\u041F\u0430\u0440\u043A"), "5 \xBF\xD0\xE0\xDA");
  EXPECT_EQ(encoded("\u0391\u03B8"), "7 \xC1\xE8");
}

TEST(LineTexts, OfThoseThatAreOfferedAlone) {
  constexpr std::array<std::uint16_t, 2> two = {2, 1};
  EXPECT_EQ(encoded("\u041F\u0430\u0440\u043A", two), "1 Park");
  EXPECT_EQ(encoded("\u0141\u00F3d\u017A", {}), "0 Lodz");
  EXPECT_EQ(encoded("Harbour", {}), "0 Harbour");
  constexpr std::array<std::uint16_t, 1> eastern = {2};
  EXPECT_EQ(encoded("Z\u00FCrich", eastern), "2 Z\xFCrich");
}

TEST(LineTexts, WhereNoneFitsLettersAreLatinOnes) {
  EXPECT_EQ(encoded("\u0141 \u0416"), "1 L Zh") << "Polish and Russian";
  EXPECT_EQ(encoded("\u00F6 \u0416"), "1 \xF6 Zh") << "those of ISO 8859-1 stay";
  EXPECT_EQ(to_ascii("Stra\u00DFe, \u017Di\u017Ekov, \u00C6r\u00F8"), "Strasse, Zizkov, AEro");
  EXPECT_EQ(to_ascii("\u041F\u043B\u043E\u0449\u0430\u0434\u044C"), "Ploshchad");
  EXPECT_EQ(to_ascii("\u0391\u03B8\u03AE\u03BD\u03B1"), "Athina");
  EXPECT_EQ(to_ascii("O\u2019Connell \u2013 \u201CMain\u201D"), "O'Connell - \"Main\"");
  EXPECT_EQ(to_latin_1("\u0141\u00F3d\u017A"),
            "L\xF3"
            "dz");
}

TEST(LineTexts, WhatNoTableHasIsAQuestionMark) {
  EXPECT_EQ(to_ascii("\u5317"), "?");
  EXPECT_EQ(to_ascii("\x80"), "?") << "no UTF-8";
  EXPECT_EQ(to_ascii("a\nb"), "a?b");
  EXPECT_EQ(encoded("a\nb"), "1 a?b");
}

TEST(LineTexts, OctetsAreAtMost128) {
  const std::string long_text(130, 'x');
  EXPECT_EQ(encode(long_text, some_sets).octets.size(), 128u);
  EXPECT_EQ(to_ascii(long_text).size(), 128u);
  std::string cyrillic;
  for (int i = 0; i < 100; ++i) cyrillic += "\u0429";
  EXPECT_EQ(encode(cyrillic, some_sets).octets.size(), 100u) << "an octet each";
  EXPECT_EQ(to_ascii(cyrillic).size(), 128u) << "Shch each";
}

TEST(LineTexts, TheRouteHasAsManyStopsAsThereIsRoomFor) {
  BusLine line = built_in_line();
  for (BusStop& stop : line.stops) stop.name = std::string(40, 'n');
  // "407 to Harbour: " has 16 characters, two names and a comma have 82: a third name would end at
  // the 140th.
  EXPECT_EQ(route_text(line, line.routes[0], "Harbour", some_sets),
            "407 to Harbour: " + std::string(40, 'n') + ", " + std::string(40, 'n'));
}

TEST(LineTexts, ANameThatWouldTakeMostOfTheRouteIsLeftOutOfIt) {
  BusLine line = built_in_line();
  line.stops[2].name = std::string(180, 'n');
  EXPECT_EQ(route_text(line, line.routes[0], "Harbour", some_sets),
            "407 to Harbour: Market Square, Old Bridge, School, Hospital, Garden City");
  line.routes[0].other_line = LineNames{.number = 8, .name = "N8"};
  EXPECT_EQ(route_text(line, line.routes[0], "Pier", some_sets).substr(0, 11), "N8 to Pier:");
}

}  // namespace
}  // namespace canvoy::bus_line::line_texts_test
