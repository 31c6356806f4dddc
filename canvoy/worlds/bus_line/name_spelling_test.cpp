// Texts that a person reads as a name, and others.
#include "canvoy/worlds/bus_line/name_spelling.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::name_spelling_test {
namespace {

TEST(NameSpelling, ANameIsItself) {
  EXPECT_TRUE(is_spelled(U"Main Street", U"Main Street"));
  EXPECT_TRUE(is_spelled(U"Main\nStreet", U"Main Street"));
  EXPECT_TRUE(is_spelled(U"", U""));
  EXPECT_FALSE(is_spelled(U"Main", U"Main Street")) << "cut";
  EXPECT_FALSE(is_spelled(U"Main Stree", U"Main Street")) << "cut";
  EXPECT_FALSE(is_spelled(U"Main Street 2", U"Main Street"));
  EXPECT_FALSE(is_spelled(U"", U"Main Street"));
}

TEST(NameSpelling, LettersLoseTheirAccents) {
  EXPECT_TRUE(is_spelled(U"Lodz", U"\u0141\u00F3d\u017A"));
  EXPECT_TRUE(is_spelled(U"\u0141\u00F3d\u017A", U"\u0141\u00F3d\u017A"));
  EXPECT_TRUE(is_spelled(U"Zizkov", U"\u017Di\u017Ekov"));
  EXPECT_TRUE(is_spelled(U"Hauptstrasse", U"Hauptstra\u00DFe"));
  EXPECT_FALSE(is_spelled(U"Hauptstrase", U"Hauptstra\u00DFe"));
  EXPECT_TRUE(is_spelled(U"Lowenplatz", U"L\u00F6wenplatz"));
  EXPECT_TRUE(is_spelled(U"Loewenplatz", U"L\u00F6wenplatz"));
}

TEST(NameSpelling, QuestionMarksAndBoxesAreNoLetters) {
  EXPECT_FALSE(is_spelled(U"?od?", U"\u0141\u00F3d\u017A"));
  EXPECT_FALSE(is_spelled(U"\uFFFDod\uFFFD", U"\u0141\u00F3d\u017A"));
  EXPECT_FALSE(is_spelled(U"\uFFFD", U"\u4E2D")) << "a box is not what the sign has no picture of";
  EXPECT_TRUE(is_spelled(U"Quo vadis?", U"Quo vadis?"));
}

TEST(NameSpelling, CyrillicAndGreekHaveSpellingsInUse) {
  const std::u32string_view square = U"\u041F\u043B\u043E\u0449\u0430\u0434\u044C";
  EXPECT_TRUE(is_spelled(U"Ploshchad'", square)) << "BGN";
  EXPECT_TRUE(is_spelled(U"Ploschad", square));
  EXPECT_FALSE(is_spelled(U"Plad", square));
  const std::u32string_view athens = U"\u0391\u03B8\u03AE\u03BD\u03B1";
  EXPECT_TRUE(is_spelled(U"Athina", athens)) << "ELOT 743";
  EXPECT_FALSE(is_spelled(U"Patra", athens));
}

/// The first and the last letter of each block: U+0401, 040F, 0410, 042F and their small letters.
TEST(NameSpelling, CyrillicLettersAtTheEndsOfTheirRowsAreThemselves) {
  EXPECT_TRUE(is_spelled(U"Yolka", U"\u0401\u043B\u043A\u0430"));
  EXPECT_TRUE(is_spelled(U"Dzep", U"\u040F\u0435\u043F"));
  EXPECT_TRUE(is_spelled(U"odzak", U"\u043E\u045F\u0430\u043A"));
  EXPECT_TRUE(is_spelled(U"Art", U"\u0410\u0440\u0442"));
  EXPECT_TRUE(is_spelled(U"Yalta", U"\u042F\u043B\u0442\u0430"));
  EXPECT_FALSE(is_spelled(U"Ert", U"\u0410\u0440\u0442"));
  EXPECT_FALSE(is_spelled(U"Sed", U"\u0421\u0430\u0434")) << "a garden is no e";
}

}  // namespace
}  // namespace canvoy::bus_line::name_spelling_test
