// Checks whether a text has room on a display, by its lines, columns, and maximum number of
// characters (CiA 447-3, 6096h and 609Bh).
//
//     TextArea{.lines = 2, .columns = 16, .characters = 32}.fits("Fare\n12,40 EUR");  // true
#pragma once

#include <string_view>

namespace canvoy::cia447 {

/// Each is 1 to 254.
struct TextArea {
  unsigned lines = 4;     ///< 1 to 254
  unsigned columns = 20;  ///< of each line, 1 to 254
  /// Of eight bits, as printed: a character with several bytes in UTF-8 counts several times. Line
  /// feeds do not count.
  unsigned characters = 80;

  /// The text is UTF-8. A line ends with a line feed, or at its last column, and the rest continues
  /// in the next line. False for control characters and invalid UTF-8.
  constexpr bool fits(std::string_view text) const;
};

namespace detail {

/// Length in bytes of the first UTF-8 character of `text`; 0 if there is none.
constexpr unsigned character_length(std::string_view text) {
  const auto byte = [&](unsigned i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const unsigned length = first >= 0xF0 ? 4U : first >= 0xE0 ? 3U : 2U;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (unsigned i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong, a UTF-16 surrogate, or above 10 FFFFh.
  const unsigned second = byte(1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return length;
}

}  // namespace detail

constexpr bool TextArea::fits(std::string_view text) const {
  unsigned line = 1;
  unsigned column = 0;
  unsigned count = 0;
  while (!text.empty()) {
    const unsigned length = detail::character_length(text);
    const char first = text.front();
    const bool is_control = length == 1 && (first >= 0 && first < ' ');
    if (length == 0 || first == 0x7F || (is_control && first != '\n')) return false;
    text.remove_prefix(length);
    if (first == '\n') {
      // A line feed at the very end starts no line.
      line += text.empty() ? 0U : 1U;
      column = 0;
      continue;
    }
    count += length;
    if (++column > columns) {
      ++line;
      column = 1;
    }
  }
  return line <= lines && count <= characters;
}

}  // namespace canvoy::cia447
