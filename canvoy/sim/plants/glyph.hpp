// Characters as dots: those of glyph_table.hpp, and a box for any other character.
//
//     if (glyph_of(U'A').has_dot(3, 5)) ...
#pragma once

#include <array>
#include <cstdint>

namespace canvoy {

inline constexpr unsigned glyph_width = 8;    ///< dots
inline constexpr unsigned glyph_height = 16;  ///< dots
/// Number of the row below the last one of letters without a descender.
inline constexpr unsigned glyph_baseline = 14;

struct Glyph {
  std::array<std::uint8_t, glyph_height> rows;  ///< from the top; the leftmost dot is bit 7

  /// False beyond the edges.
  constexpr bool has_dot(unsigned column, unsigned row) const {
    return column < glyph_width && row < glyph_height && (rows[row] << column & 0x80) != 0;
  }
};

/// Picture of a character; a box if the table does not have it.
Glyph glyph_of(char32_t character);
/// True if the table has the character.
bool has_glyph(char32_t character);

}  // namespace canvoy
