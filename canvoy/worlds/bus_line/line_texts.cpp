#include "canvoy/worlds/bus_line/line_texts.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace canvoy::bus_line {

namespace {

// Spells letters that a display does not have in those of ISO 646-US: without accents, Cyrillic by
// BGN/PCGN, Greek by ELOT 743. It is a table and needs no library, so that the simulator can be
// embedded without one.
//
//     latin_letters(U'\u00DF')     // ss

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

/// A question mark for an unknown character; empty for letters that are not written.
std::string_view latin_letters(char32_t character) {
  const auto* const group = std::ranges::find(groups, character, &Letters::character);
  if (group != std::end(groups)) return group->letters;
  for (const Run& run : runs) {
    const bool is_in = character >= run.first && character - run.first < run.letters.size();
    if (is_in) return run.letters.substr(character - run.first, 1);
  }
  return "?";
}

constexpr char32_t ascii_end = 0x80;
constexpr char32_t latin_1_end = 0x100;

bool is_control(char32_t one) {
  return one < 0x20 || (one >= 0x7F && one < 0xA0);
}

/// Empty where the set does not have all characters, or is unknown.
std::optional<std::string> in_set(std::string_view utf_8, std::uint16_t set) {
  const std::string name = set == us_ascii ? "US-ASCII" : "ISO-8859-" + std::to_string(set);
  void* const converter = iconv_open(name.c_str(), "UTF-8");
  if (converter == iconv_t(-1)) return std::nullopt;  // NOLINT(performance-no-int-to-ptr)
  std::string text(utf_8);
  std::string made(text.size() + 1, '\0');
  char* from = text.data();
  std::size_t left = text.size();
  char* to = made.data();
  std::size_t room = made.size();
  const bool is_made = iconv(converter, &from, &left, &to, &room) == 0 && left == 0;
  iconv_close(converter);
  if (!is_made) return std::nullopt;
  made.resize(made.size() - room);
  return made;
}

/// Keeps the characters below `end`, and spells the others in Latin letters.
std::string in_latin_letters(std::string_view utf_8, char32_t end) {
  std::string made;
  for (const char32_t one : code_points(utf_8)) {
    if (is_control(one)) {
      made += '?';
    } else if (one < end) {
      made += static_cast<char>(one);
    } else {
      made += latin_letters(one);
    }
  }
  return made;
}

/// Encodes a text of any length.
EncodedText encode_whole(std::string_view utf_8, std::span<const std::uint16_t> offered) {
  const bool has_latin_1 = std::ranges::find(offered, latin_1) != offered.end();
  const bool has_control = std::ranges::any_of(code_points(utf_8), is_control);
  if (!(has_latin_1 && is_latin_1(utf_8)) && !has_control) {
    std::vector<std::uint16_t> sets = {us_ascii};
    sets.insert(sets.end(), offered.begin(), offered.end());
    for (const std::uint16_t set : sets) {
      std::optional<std::string> octets = in_set(utf_8, set);
      if (octets) return {set, *std::move(octets)};
    }
  }
  if (has_latin_1) return {latin_1, in_latin_letters(utf_8, latin_1_end)};
  return {us_ascii, in_latin_letters(utf_8, ascii_end)};
}

}  // namespace

std::u32string code_points(std::string_view utf_8) {
  std::u32string made;
  for (std::size_t at = 0; at < utf_8.size();) {
    const auto lead = static_cast<unsigned char>(utf_8[at++]);
    const unsigned more = lead < 0x80    ? 0
                          : lead >= 0xF0 ? 3
                          : lead >= 0xE0 ? 2
                          : lead >= 0xC0 ? 1
                                         : 4;
    constexpr std::array<unsigned, 4> masks = {0x7F, 0x1F, 0x0F, 0x07};
    if (more == 4 || at + more > utf_8.size()) {
      made += U'\uFFFD';
      continue;
    }
    unsigned code = lead & masks[more];
    for (unsigned i = 0; i < more; ++i)
      code = code << 6 | (static_cast<unsigned>(utf_8[at++]) & 0x3F);
    made += static_cast<char32_t>(code);
  }
  return made;
}

bool is_latin_1(std::string_view utf_8) {
  return std::ranges::all_of(code_points(utf_8), [](char32_t one) { return one <= 0xFF; });
}

std::string to_latin_1(std::string_view utf_8) {
  return in_latin_letters(utf_8, latin_1_end).substr(0, text_octets_max);
}

std::string to_ascii(std::string_view utf_8) {
  return in_latin_letters(utf_8, ascii_end).substr(0, text_octets_max);
}

EncodedText encode(std::string_view utf_8, std::span<const std::uint16_t> offered) {
  EncodedText text = encode_whole(utf_8, offered);
  text.octets.resize(std::min(text.octets.size(), text_octets_max));
  return text;
}

std::string route_text(const BusLine& line, const BusRoute& route, std::string_view destination,
                       std::span<const std::uint16_t> offered) {
  const auto octets_of = [offered](const std::string& text) {
    return encode_whole(text, offered).octets.size();
  };
  std::string text = line.names_of(route).name + " to " + std::string(destination);
  const std::size_t room = text_octets_max - std::min(octets_of(text), text_octets_max);
  std::string_view separator = ": ";
  for (std::size_t i = 1; i + 1 < route.stops.size(); ++i) {
    const std::string& name = line.stops[route.stops[i].stop].name;
    if (octets_of(name) > room / 2) continue;
    const std::string longer = text + std::string(separator) + name;
    if (octets_of(longer) > text_octets_max) break;
    text = longer;
    separator = ", ";
  }
  return text;
}

std::vector<std::uint8_t> octets_of_text(std::string_view text) {
  return {text.begin(), text.end()};
}

}  // namespace canvoy::bus_line
