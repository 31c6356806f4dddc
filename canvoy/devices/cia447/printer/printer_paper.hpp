// The paper of a printer, as its virtual device drives it (CiA 447-3, 4.2.13): what puts marks on
// it and moves it. The maker of a printer gives the mechanism; a simulation gives a picture
// (canvoy/sim/plants/paper_picture.hpp).
//
//     PaperPicture picture;
//     PrinterUnit printer(node, {.paper = picture.paper()}, {.dots_per_line = 384});
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia447 {

/// Of a dot; white is the paper.
struct PrintColor {
  std::uint8_t red = 0xFF;
  std::uint8_t green = 0xFF;
  std::uint8_t blue = 0xFF;

  friend constexpr bool operator==(const PrintColor&, const PrintColor&) = default;
};

/// How text is to look; sizes in dots.
struct PrintStyle {
  std::uint8_t height = 16;
  std::uint8_t width = 8;  ///< of variable width: of a usual character
  bool is_bold = false;
  bool is_cursive = false;
  bool has_variable_width = false;

  friend constexpr bool operator==(const PrintStyle&, const PrintStyle&) = default;
};

struct PrintedCharacter {
  char32_t character = U' ';
  unsigned left = 0;  ///< dots from the left edge
  PrintStyle style = {};
};

/// What is empty is not done.
struct PrinterPaper {
  /// Prints one character; its upper edge is where the paper stands.
  Callback<void(const PrintedCharacter&)> put = {};
  /// How many dots wide a character of variable width is; empty or 0: as wide as the style says.
  Callback<unsigned(char32_t, const PrintStyle&)> width = {};
  /// Prints a row of dots, from the left edge, where the paper stands.
  Callback<void(std::span<const PrintColor>)> put_row = {};
  /// Moves the paper by so many dots.
  Callback<void(unsigned)> feed = {};
  Callback<void()> cut = {};
};

/// A picture that the printer has in store: rows of dots, the leftmost in the highest bit of the
/// first byte, each row in whole bytes.
struct PrinterLogo {
  unsigned width = 0;
  std::span<const std::uint8_t> bits;

  constexpr std::size_t row_bytes() const { return (width + 7) / 8; }
  constexpr std::size_t height() const { return width == 0 ? 0 : bits.size() / row_bytes(); }
};

}  // namespace canvoy::cia447
