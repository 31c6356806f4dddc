#include "canvoy/worlds/bus_line/latin_letters.hpp"

#include <algorithm>
#include <iterator>

namespace canvoy::bus_line {

namespace {

/// Letters for the characters from `first` on, one each.
struct Run {
  char32_t first;
  std::string_view letters;
};
constexpr Run runs[] = {
    {0xC0, "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"},
    {0x100,
     "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRr"
     "SsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs"},
    {0x218, "SsTt"},
    {0x386, "A"},
    {0x388, "EII"},
    {0x38C, "O"},
    {0x38E, "YOiAVGDEZITIKLMNXOPR"},
    {0x3A3, "STYFCPOIYaeiiyavgdeziti"},
    {0x3BA, "klmnxoprsstyfcpoiyoyo"},
    {0x1E02, "Bb"},
    {0x1E0A, "Dd"},
    {0x1E1E, "Ff"},
    {0x1E40, "Mm"},
    {0x1E56, "Pp"},
    {0x1E60, "Ss"},
    {0x1E6A, "Tt"},
    {0x1E80, "WwWwWw"},
    {0x1EF2, "Yy"},
    {0x2010, "------"},
    {0x2018, "''''\"\"\"\""},
    {0xA0, " "},
};
static_assert(runs[0].letters.size() == 0x40 && runs[1].letters.size() == 0x80);

/// Several letters for a character, or none.
struct Letters {
  char32_t character;
  std::string_view letters;
};
constexpr Letters groups[] = {
    {0xC6, "AE"},    {0xDE, "Th"},    {0xDF, "ss"},    {0xE6, "ae"},  {0xFE, "th"},
    {0x132, "IJ"},   {0x133, "ij"},   {0x152, "OE"},   {0x153, "oe"}, {0x398, "Th"},
    {0x3A7, "Ch"},   {0x3A8, "Ps"},   {0x3B8, "th"},   {0x3C7, "ch"}, {0x3C8, "ps"},
    {0x401, "Yo"},   {0x402, "Dj"},   {0x403, "G"},    {0x404, "Ye"}, {0x405, "Dz"},
    {0x406, "I"},    {0x407, "Yi"},   {0x408, "J"},    {0x409, "Lj"}, {0x40A, "Nj"},
    {0x40B, "C"},    {0x40C, "K"},    {0x40E, "U"},    {0x40F, "Dz"}, {0x410, "A"},
    {0x411, "B"},    {0x412, "V"},    {0x413, "G"},    {0x414, "D"},  {0x415, "E"},
    {0x416, "Zh"},   {0x417, "Z"},    {0x418, "I"},    {0x419, "Y"},  {0x41A, "K"},
    {0x41B, "L"},    {0x41C, "M"},    {0x41D, "N"},    {0x41E, "O"},  {0x41F, "P"},
    {0x420, "R"},    {0x421, "S"},    {0x422, "T"},    {0x423, "U"},  {0x424, "F"},
    {0x425, "Kh"},   {0x426, "Ts"},   {0x427, "Ch"},   {0x428, "Sh"}, {0x429, "Shch"},
    {0x42A, ""},     {0x42B, "Y"},    {0x42C, ""},     {0x42D, "E"},  {0x42E, "Yu"},
    {0x42F, "Ya"},   {0x430, "a"},    {0x431, "b"},    {0x432, "v"},  {0x433, "g"},
    {0x434, "d"},    {0x435, "e"},    {0x436, "zh"},   {0x437, "z"},  {0x438, "i"},
    {0x439, "y"},    {0x43A, "k"},    {0x43B, "l"},    {0x43C, "m"},  {0x43D, "n"},
    {0x43E, "o"},    {0x43F, "p"},    {0x440, "r"},    {0x441, "s"},  {0x442, "t"},
    {0x443, "u"},    {0x444, "f"},    {0x445, "kh"},   {0x446, "ts"}, {0x447, "ch"},
    {0x448, "sh"},   {0x449, "shch"}, {0x44A, ""},     {0x44B, "y"},  {0x44C, ""},
    {0x44D, "e"},    {0x44E, "yu"},   {0x44F, "ya"},   {0x451, "yo"}, {0x452, "dj"},
    {0x453, "g"},    {0x454, "ye"},   {0x455, "dz"},   {0x456, "i"},  {0x457, "yi"},
    {0x458, "j"},    {0x459, "lj"},   {0x45A, "nj"},   {0x45B, "c"},  {0x45C, "k"},
    {0x45E, "u"},    {0x45F, "dz"},   {0x490, "G"},    {0x491, "g"},  {0x1E9E, "SS"},
    {0x2026, "..."}, {0x20AC, "EUR"}, {0x2116, "No."},
};

}  // namespace

std::string_view latin_letters(char32_t character) {
  const auto* const group = std::ranges::find(groups, character, &Letters::character);
  if (group != std::end(groups)) return group->letters;
  for (const Run& run : runs) {
    const bool is_in = character >= run.first && character - run.first < run.letters.size();
    if (is_in) return run.letters.substr(character - run.first, 1);
  }
  return "?";
}

}  // namespace canvoy::bus_line
