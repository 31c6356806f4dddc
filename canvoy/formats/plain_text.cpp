#include "canvoy/formats/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace canvoy::formats {

namespace {

bool is_between(char32_t character, char32_t first, char32_t last) {
  return character >= first && character <= last;
}

/// C0 and C1, line and paragraph separators, and what turns the direction of writing.
bool is_control(char32_t character) {
  return character < 0x20 || is_between(character, 0x7F, 0x9F) ||
         is_between(character, 0x200E, 0x200F) || is_between(character, 0x2028, 0x202E) ||
         is_between(character, 0x2066, 0x2069);
}

/// How many bytes the character at the start takes, where it can be shown; else 0.
std::size_t plain_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return is_control(first) ? 0 : 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  char32_t character = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
    character = character << 6 | (byte(i) & 0x3FU);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_character =
      character >= least[length] && character <= 0x10FFFF && !is_between(character, 0xD800, 0xDFFF);
  return is_character && !is_control(character) ? length : 0;
}

}  // namespace

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

std::string hex(std::uint64_t number, unsigned digits) {
  return fmt::format("{:0{}X}", number, digits);
}

}  // namespace canvoy::formats
