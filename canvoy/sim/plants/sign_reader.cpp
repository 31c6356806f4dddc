#include "canvoy/sim/plants/sign_reader.hpp"

#include <map>

#include "canvoy/sim/plants/glyph.hpp"
#include "canvoy/sim/plants/glyph_table.hpp"

namespace canvoy {

namespace {

using Rows = std::array<std::uint8_t, glyph_height>;

std::map<Rows, char32_t> make_looks() {
  std::map<Rows, char32_t> looks;
  for (const GlyphRange& range : glyph_ranges) {
    for (char32_t one = range.first; one <= range.last; ++one) {
      looks.emplace(glyph_of(one).rows, one);
    }
  }
  return looks;
}

char32_t look(const Rows& rows) {
  static const std::map<Rows, char32_t> looks = make_looks();
  const auto found = looks.find(rows);
  return found == looks.end() ? unreadable : found->second;
}

Rows cell(const Picture& picture, std::size_t left, std::size_t top) {
  Rows rows{};
  for (unsigned y = 0; y < glyph_height; ++y) {
    for (unsigned x = 0; x < glyph_width; ++x) {
      const bool has_dot = picture.at(left + x, top + y).red == 0;
      rows.at(y) |= static_cast<std::uint8_t>(has_dot ? 0x80U >> x : 0U);
    }
  }
  return rows;
}

}  // namespace

std::u32string read_sign(const Picture& picture) {
  std::u32string text;
  for (std::size_t top = 0; top + glyph_height <= picture.height(); top += glyph_height) {
    std::u32string line;
    for (std::size_t left = 0; left + glyph_width <= picture.width(); left += glyph_width) {
      line += look(cell(picture, left, top));
    }
    line.erase(line.find_last_not_of(U' ') + 1);
    if (!line.empty()) text += (text.empty() ? U"" : U"\n") + line;
  }
  return text;
}

char32_t look_of(char32_t character) {
  return look(glyph_of(character).rows);
}

}  // namespace canvoy
