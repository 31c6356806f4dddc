#include "canvoy/sim/plants/glyph.hpp"

#include <cstddef>
#include <optional>

#include "canvoy/sim/plants/glyph_table.hpp"

namespace canvoy {

namespace {

constexpr Glyph box = {{0x00, 0x00, 0x00, 0x7E, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42,
                        0x42, 0x7E, 0x00, 0x00}};

/// Place in the table; empty where the character is not in it.
std::optional<std::size_t> place_of(char32_t character) {
  std::size_t place = 0;
  for (const GlyphRange& range : glyph_ranges) {
    if (character >= range.first && character <= range.last) {
      return place + (character - range.first);
    }
    place += range.last - range.first + 1;
  }
  return std::nullopt;
}

}  // namespace

Glyph glyph_of(char32_t character) {
  const std::optional<std::size_t> place = place_of(character);
  return place ? Glyph{glyph_table[*place]} : box;
}

bool has_glyph(char32_t character) {
  return place_of(character).has_value();
}

}  // namespace canvoy
