#include "canvoy/worlds/bus_line/line_texts.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "canvoy/worlds/bus_line/latin_letters.hpp"

namespace canvoy::bus_line {

namespace {

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
