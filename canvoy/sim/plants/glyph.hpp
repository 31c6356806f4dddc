// A character as dots: those of glyph_table.hpp, and a box for one that is not there.
//
//     if (glyph_of(U'A').has_dot(3, 5)) ...
#pragma once

#include <array>
#include <cstdint>

namespace canvoy {

inline constexpr unsigned glyph_width = 8;
inline constexpr unsigned glyph_height = 16;
/// The row behind the last one of letters that do not go below the line.
inline constexpr unsigned glyph_baseline = 14;

struct Glyph {
  std::array<std::uint8_t, glyph_height> rows;

  /// None beyond the edges.
  constexpr bool has_dot(unsigned column, unsigned row) const {
    return column < glyph_width && row < glyph_height && (rows[row] << column & 0x80) != 0;
  }
};

Glyph glyph_of(char32_t character);

}  // namespace canvoy
