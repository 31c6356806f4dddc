#include "canvoy/worlds/bus_line/name_spelling.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "canvoy/sim/plants/sign_reader.hpp"

namespace canvoy::bus_line {

namespace {

/// Letters with a common set of spellings, separated by blanks; `_` is the empty one.
struct Spelling {
  char32_t first;
  char32_t last;
  std::u32string_view spellings;
};
constexpr Spelling spellings[] = {
    // Latin.
    {0xC0, 0xC3, U"a"},
    {0xC4, 0xC4, U"a ae"},
    {0xC5, 0xC5, U"a aa"},
    {0xC6, 0xC6, U"ae"},
    {0xC7, 0xC7, U"c"},
    {0xC8, 0xCB, U"e"},
    {0xCC, 0xCF, U"i"},
    {0xD0, 0xD0, U"d dh"},
    {0xD1, 0xD1, U"n"},
    {0xD2, 0xD5, U"o"},
    {0xD6, 0xD6, U"o oe"},
    {0xD8, 0xD8, U"o oe"},
    {0xD9, 0xDB, U"u"},
    {0xDC, 0xDC, U"u ue"},
    {0xDD, 0xDD, U"y"},
    {0xDE, 0xDE, U"th"},
    {0xDF, 0xDF, U"ss"},
    {0xE0, 0xE3, U"a"},
    {0xE4, 0xE4, U"a ae"},
    {0xE5, 0xE5, U"a aa"},
    {0xE6, 0xE6, U"ae"},
    {0xE7, 0xE7, U"c"},
    {0xE8, 0xEB, U"e"},
    {0xEC, 0xEF, U"i"},
    {0xF0, 0xF0, U"d dh"},
    {0xF1, 0xF1, U"n"},
    {0xF2, 0xF5, U"o"},
    {0xF6, 0xF6, U"o oe"},
    {0xF8, 0xF8, U"o oe"},
    {0xF9, 0xFB, U"u"},
    {0xFC, 0xFC, U"u ue"},
    {0xFD, 0xFD, U"y"},
    {0xFE, 0xFE, U"th"},
    {0xFF, 0xFF, U"y"},
    {0x100, 0x105, U"a"},
    {0x106, 0x10D, U"c"},
    {0x10E, 0x111, U"d dj"},
    {0x112, 0x11B, U"e"},
    {0x11C, 0x123, U"g"},
    {0x124, 0x127, U"h"},
    {0x128, 0x131, U"i"},
    {0x132, 0x133, U"ij"},
    {0x134, 0x135, U"j"},
    {0x136, 0x138, U"k"},
    {0x139, 0x142, U"l"},
    {0x143, 0x14B, U"n ng"},
    {0x14C, 0x151, U"o"},
    {0x152, 0x153, U"oe"},
    {0x154, 0x159, U"r"},
    {0x15A, 0x161, U"s"},
    {0x162, 0x167, U"t"},
    {0x168, 0x173, U"u"},
    {0x174, 0x175, U"w"},
    {0x176, 0x178, U"y"},
    {0x179, 0x17E, U"z"},
    {0x218, 0x219, U"s"},
    {0x21A, 0x21B, U"t"},
    {0x1E9E, 0x1E9E, U"ss"},
    {0x2013, 0x2015, U"-"},
    {0x2018, 0x201A, U"'"},
    {0x201C, 0x201E, U"\""},
    // Greek.
    {0x386, 0x386, U"a"},
    {0x388, 0x388, U"e"},
    {0x389, 0x389, U"i e"},
    {0x38A, 0x38A, U"i"},
    {0x38C, 0x38C, U"o"},
    {0x38E, 0x38E, U"y u i"},
    {0x38F, 0x38F, U"o"},
    {0x390, 0x390, U"i"},
    {0x391, 0x391, U"a"},
    {0x392, 0x392, U"b v"},
    {0x393, 0x393, U"g n"},
    {0x394, 0x394, U"d"},
    {0x395, 0x395, U"e"},
    {0x396, 0x396, U"z"},
    {0x397, 0x397, U"i e"},
    {0x398, 0x398, U"th"},
    {0x399, 0x399, U"i"},
    {0x39A, 0x39A, U"k"},
    {0x39B, 0x39B, U"l"},
    {0x39C, 0x39C, U"m _"},
    {0x39D, 0x39D, U"n _"},
    {0x39E, 0x39E, U"x ks"},
    {0x39F, 0x39F, U"o"},
    {0x3A0, 0x3A0, U"p b"},
    {0x3A1, 0x3A1, U"r rh"},
    {0x3A3, 0x3A3, U"s"},
    {0x3A4, 0x3A4, U"t d"},
    {0x3A5, 0x3A5, U"y u i f v"},
    {0x3A6, 0x3A6, U"f ph"},
    {0x3A7, 0x3A7, U"ch h kh x"},
    {0x3A8, 0x3A8, U"ps"},
    {0x3A9, 0x3A9, U"o"},
    {0x3AA, 0x3AA, U"i"},
    {0x3AB, 0x3AB, U"y u i"},
    {0x3AC, 0x3AC, U"a"},
    {0x3AD, 0x3AD, U"e"},
    {0x3AE, 0x3AE, U"i e"},
    {0x3AF, 0x3AF, U"i"},
    {0x3B0, 0x3B0, U"y u i"},
    {0x3B1, 0x3B1, U"a"},
    {0x3B2, 0x3B2, U"b v"},
    {0x3B3, 0x3B3, U"g n"},
    {0x3B4, 0x3B4, U"d"},
    {0x3B5, 0x3B5, U"e"},
    {0x3B6, 0x3B6, U"z"},
    {0x3B7, 0x3B7, U"i e"},
    {0x3B8, 0x3B8, U"th"},
    {0x3B9, 0x3B9, U"i"},
    {0x3BA, 0x3BA, U"k"},
    {0x3BB, 0x3BB, U"l"},
    {0x3BC, 0x3BC, U"m _"},
    {0x3BD, 0x3BD, U"n _"},
    {0x3BE, 0x3BE, U"x ks"},
    {0x3BF, 0x3BF, U"o"},
    {0x3C0, 0x3C0, U"p b"},
    {0x3C1, 0x3C1, U"r rh"},
    {0x3C2, 0x3C3, U"s"},
    {0x3C4, 0x3C4, U"t d"},
    {0x3C5, 0x3C5, U"y u i f v"},
    {0x3C6, 0x3C6, U"f ph"},
    {0x3C7, 0x3C7, U"ch h kh x"},
    {0x3C8, 0x3C8, U"ps"},
    {0x3C9, 0x3C9, U"o"},
    {0x3CA, 0x3CA, U"i"},
    {0x3CB, 0x3CB, U"y u i"},
    {0x3CC, 0x3CC, U"o"},
    {0x3CD, 0x3CD, U"y u i f v"},
    {0x3CE, 0x3CE, U"o"},
};
/// 430h to 44Fh; capitals are 20h below them.
constexpr std::u32string_view cyrillic[] = {U"a",          U"b",
                                            U"v w",        U"g h",
                                            U"d",          U"e ye je",
                                            U"zh z j",     U"z",
                                            U"i y",        U"y i j",
                                            U"k",          U"l",
                                            U"m",          U"n",
                                            U"o",          U"p",
                                            U"r",          U"s",
                                            U"t",          U"u",
                                            U"f",          U"kh h x ch",
                                            U"ts c tz",    U"ch c",
                                            U"sh s",       U"shch sch sc s",
                                            U"_ \" '",     U"y i",
                                            U"_ '",        U"e",
                                            U"yu iu ju u", U"ya ia ja a"};
/// 450h to 45Fh; capitals are 50h below them.
constexpr std::u32string_view more_cyrillic[] = {
    U"e", U"yo e io jo", U"d dj", U"g gj", U"ye ie e je", U"dz z", U"i",   U"yi i ji",
    U"j", U"lj l",       U"nj n", U"c",    U"k kj",       U"i",    U"u w", U"dz"};

std::u32string_view spellings_of(char32_t letter) {
  if (letter >= 0x401 && letter <= 0x40F) letter += 0x50;
  if (letter >= 0x410 && letter <= 0x42F) letter += 0x20;
  if (letter >= 0x430 && letter <= 0x44F) return cyrillic[letter - 0x430];
  if (letter >= 0x450 && letter <= 0x45F) return more_cyrillic[letter - 0x450];
  if (letter == 0x490 || letter == 0x491) return U"g";
  const auto* const found = std::ranges::find_if(spellings, [letter](const Spelling& each) {
    return letter >= each.first && letter <= each.last;
  });
  return found == std::end(spellings) ? std::u32string_view() : found->spellings;
}

char32_t lower(char32_t one) {
  return one >= U'A' && one <= U'Z' ? one + 0x20 : one;
}

std::u32string in_one_line(std::u32string_view text) {
  std::u32string made;
  for (const char32_t one : text) {
    const bool is_blank = one <= U' ' || one == 0xA0;
    if (!is_blank) {
      made += one;
    } else if (!made.empty() && made.back() != U' ') {
      made += U' ';
    }
  }
  if (!made.empty() && made.back() == U' ') made.pop_back();
  return made;
}

bool has_at(std::u32string_view shown, std::size_t at, std::u32string_view word) {
  return at + word.size() <= shown.size() &&
         std::ranges::equal(shown.substr(at, word.size()), word, {}, lower);
}

}  // namespace

bool is_spelled(std::u32string_view shown_text, std::u32string_view name_text) {
  const std::u32string shown = in_one_line(shown_text);
  const std::u32string name = in_one_line(name_text);
  // Ends of the parts of the text that may spell the letters so far.
  std::set<std::size_t> ends = {0};
  for (const char32_t letter : name) {
    std::set<std::size_t> next;
    const char32_t look = look_of(letter);
    std::u32string_view rest = spellings_of(letter);
    for (const std::size_t at : ends) {
      if (look != unreadable && at < shown.size() && shown[at] == look) next.insert(at + 1);
    }
    while (!rest.empty()) {
      const std::u32string_view word = rest.substr(0, rest.find(U' '));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      for (const std::size_t at : ends) {
        if (word == U"_") {
          next.insert(at);
        } else if (has_at(shown, at, word)) {
          next.insert(at + word.size());
        }
      }
    }
    ends = std::move(next);
  }
  return ends.contains(shown.size());
}

}  // namespace canvoy::bus_line
