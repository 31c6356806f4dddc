#include "canvoy/formats/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canvoy::formats {

namespace {

bool is_between(char32_t character, char32_t first, char32_t last) {
  return character >= first && character <= last;
}

/// C0 and C1, line and paragraph separators, and controls of the direction of writing.
bool is_control(char32_t character) {
  return character < 0x20 || is_between(character, 0x7F, 0x9F) ||
         is_between(character, 0x200E, 0x200F) || is_between(character, 0x2028, 0x202E) ||
         is_between(character, 0x2066, 0x2069);
}

/// A character and its number of bytes; 0: none.
struct Character {
  char32_t code = 0;
  std::size_t length = 0;
};
Character first_of(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
  char32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_one =
      code >= least[length] && code <= 0x10FFFF && !is_between(code, 0xD800, 0xDFFF);
  return is_one ? Character{code, length} : Character{};
}

/// Number of bytes of the first character, if it can be shown; else 0.
std::size_t plain_length(std::string_view text) {
  const Character first = first_of(text);
  return is_control(first.code) ? 0 : first.length;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  return text.empty() ? 0 : first_of(text).length;
}

bool is_plain_text(std::string_view text) {
  const auto is_ascii = [](char c) { return c >= 0x20 && c < 0x7F; };
  if (std::ranges::all_of(text, is_ascii)) return true;
  while (!text.empty()) {
    const std::size_t length = plain_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string plain_text(std::string_view text) {
  if (is_plain_text(text)) return std::string(text);
  std::string plain;
  while (!text.empty()) {
    const std::size_t length = plain_length(text);
    if (length == 0) {
      fmt::format_to(std::back_inserter(plain), "\\x{:02X}", static_cast<std::uint8_t>(text[0]));
    } else {
      plain += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return plain;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string markup_text(std::string_view text) {
  std::string made;
  for (const char each : text) {
    switch (each) {
      case '&':
        made += "&amp;";
        break;
      case '<':
        made += "&lt;";
        break;
      case '>':
        made += "&gt;";
        break;
      case '"':
        made += "&quot;";
        break;
      default:
        made += each;
    }
  }
  return made;
}

std::string hex(std::uint64_t number, unsigned digits) {
  return fmt::format("{:0{}X}", number, digits);
}

}  // namespace canvoy::formats
