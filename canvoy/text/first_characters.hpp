// Text in columns of a terminal.
//
//     first_characters("Zürich HB", 4);    // "Züri"
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace canvoy::text {

/// Returns this many characters of UTF-8, padded with blanks.
inline std::string first_characters(std::string_view text, std::size_t count) {
  std::string made;
  std::size_t have = 0;
  for (const char byte : text) {
    const bool begins = (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    if (begins && ++have > count) break;
    made += byte;
  }
  for (; have < count; ++have) made += ' ';
  return made;
}

}  // namespace canvoy::text
