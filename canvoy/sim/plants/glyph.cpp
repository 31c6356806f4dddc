#include "canvoy/sim/plants/glyph.hpp"

#include "canvoy/sim/plants/glyph_table.hpp"

namespace canvoy {

namespace {

constexpr Glyph box = {{0x00, 0x00, 0x00, 0x7E, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42, 0x42,
                        0x42, 0x7E, 0x00, 0x00}};

}  // namespace

Glyph glyph_of(char32_t character) {
  std::size_t place = 0;
  for (const GlyphRange& range : glyph_ranges) {
    if (character >= range.first && character <= range.last) {
      return {glyph_table[place + (character - range.first)]};
    }
    place += range.last - range.first + 1;
  }
  return box;
}

}  // namespace canvoy
