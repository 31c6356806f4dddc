#include "canvoy/sim/plants/paper_picture.hpp"

#include <bit>
#include <utility>

#include "canvoy/sim/plants/glyph.hpp"

namespace canvoy {

namespace {

/// The columns of a glyph that have a dot.
struct Columns {
  unsigned first = 0;
  unsigned count = 0;
};
Columns inked(const Glyph& glyph) {
  unsigned all = 0;
  for (const std::uint8_t row : glyph.rows) all |= row;
  if (all == 0) return {.first = 0, .count = glyph_width / 2};
  const auto first = static_cast<unsigned>(std::countl_zero(static_cast<std::uint8_t>(all)));
  const auto behind = static_cast<unsigned>(std::countr_zero(all));
  return {.first = first, .count = glyph_width - first - behind};
}

}  // namespace

cia447::PrinterPaper PaperPicture::paper() {
  return {.put = callback<&PaperPicture::put>(*this),
          .width = callback<&PaperPicture::width>(*this),
          .put_row = callback<&PaperPicture::put_row>(*this),
          .feed = callback<&PaperPicture::feed>(*this),
          .cut = callback<&PaperPicture::cut>(*this)};
}

/// The columns with ink, and one that is empty.
unsigned PaperPicture::width(char32_t character, const cia447::PrintStyle& style) {
  const unsigned columns = inked(glyph_of(character)).count + 1;
  return std::max(1U, (columns * style.width + glyph_width / 2) / glyph_width);
}

void PaperPicture::put(const cia447::PrintedCharacter& character) {
  const cia447::PrintStyle& style = character.style;
  const Glyph glyph = glyph_of(character.character);
  const unsigned first = style.has_variable_width ? inked(glyph).first : 0;
  // A stroke of bold letters is wider by one dot of the glyph.
  const unsigned stroke = std::max(1U, style.width / glyph_width);
  present_.grow(row_ + style.height);
  for (unsigned y = 0; y < style.height; ++y) {
    const unsigned row = y * glyph_height / style.height;
    // Cursive letters lean to the right by half of their width.
    const unsigned lean =
        style.is_cursive ? (style.height - 1 - y) * style.width / style.height / 2 : 0;
    for (unsigned x = 0; x < style.width; ++x) {
      if (!glyph.has_dot(first + x * glyph_width / style.width, row)) continue;
      const unsigned dots = style.is_bold ? stroke + 1 : 1;
      for (unsigned i = 0; i < dots; ++i) {
        present_.darken(character.left + x + lean + i, row_ + y, {.red = 0, .green = 0, .blue = 0});
      }
    }
  }
}

void PaperPicture::put_row(std::span<const cia447::PrintColor> row) {
  present_.grow(row_ + 1);
  for (std::size_t x = 0; x < row.size(); ++x) present_.darken(x, row_, row[x]);
}

void PaperPicture::feed(unsigned dots) {
  row_ += dots;
  present_.grow(row_);
  if (row_ > rows_max) cut();
}

void PaperPicture::cut() {
  Picture next(present_.width());
  receipts_.push_back(std::exchange(present_, std::move(next)));
  if (receipts_.size() > receipts_max) receipts_.pop_front();
  row_ = 0;
  ++cuts_;
}

}  // namespace canvoy
