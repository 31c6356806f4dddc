#include "canvoy/sim/bus/line_texts.hpp"

#include <array>

namespace canvoy::bus {

namespace {

constexpr unsigned first_above_ascii = 0x80;
constexpr unsigned first_letter = 0xC0;

/// The code points of UTF-8; 0xFFFD for what is none.
std::u32string decode(std::string_view text) {
  std::u32string made;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at++]);
    const unsigned more = lead < 0x80    ? 0
                          : lead >= 0xF0 ? 3
                          : lead >= 0xE0 ? 2
                          : lead >= 0xC0 ? 1
                                         : 4;
    constexpr std::array<unsigned, 4> masks = {0x7F, 0x1F, 0x0F, 0x07};
    if (more == 4 || at + more > text.size()) {
      made += U'\uFFFD';
      continue;
    }
    unsigned code = lead & masks[more];
    for (unsigned i = 0; i < more; ++i)
      code = code << 6 | (static_cast<unsigned>(text[at++]) & 0x3F);
    made += static_cast<char32_t>(code);
  }
  return made;
}

/// C0h to FFh of ISO 8859-1 without accents.
constexpr std::string_view plain_letters =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
static_assert(plain_letters.size() == 64);

}  // namespace

std::string to_latin_1(std::string_view utf_8) {
  std::string made;
  for (const char32_t one : decode(utf_8)) {
    if (made.size() == text_octets_max) break;
    const auto code = static_cast<unsigned>(one);
    const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    made += code > 0xFF || is_control ? '?' : static_cast<char>(code);
  }
  return made;
}

std::string to_ascii(std::string_view utf_8) {
  std::string made;
  for (const char one : to_latin_1(utf_8)) {
    const auto code = static_cast<unsigned char>(one);
    made += code < first_above_ascii ? one
            : code >= first_letter   ? plain_letters[code - first_letter]
                                     : '?';
  }
  return made;
}

std::string latin_1_as_utf_8(std::string_view latin_1) {
  std::string made;
  for (const char one : latin_1) {
    const auto code = static_cast<unsigned char>(one);
    if (code < first_above_ascii) {
      made += one;
    } else {
      made += static_cast<char>(0xC0U | code >> 6);
      made += static_cast<char>(0x80U | (code & 0x3FU));
    }
  }
  return made;
}

std::string route_text(const BusLine& line, const BusRoute& route) {
  std::string text = line.name + " to " + route.destination;
  std::string_view separator = ": ";
  for (std::size_t i = 1; i + 1 < route.stops.size(); ++i) {
    const std::string next = std::string(separator) + line.stops[route.stops[i].stop].name;
    // In UTF-8 it is never shorter than in the display.
    if (text.size() + next.size() > text_octets_max) break;
    text += next;
    separator = ", ";
  }
  return text;
}

std::vector<std::uint8_t> octets_of_text(std::string_view text) {
  return {text.begin(), text.end()};
}

}  // namespace canvoy::bus
