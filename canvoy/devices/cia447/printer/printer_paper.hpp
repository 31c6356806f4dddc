// The paper of a printer, for its virtual device (CiA 447-3, 4.2.13): callbacks that print on it
// and move it. The maker of a printer provides the mechanism; a simulation provides a picture
// (canvoy/sim/plants/paper_picture.hpp).
//
//     PaperPicture picture;
//     PrinterUnit printer(node, {.paper = picture.paper()}, {.dots_per_line = 384});
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia447 {

/// Color of a dot; white is the paper.
struct PrintColor {
  std::uint8_t red = 0xFF;    ///< 0 to 255
  std::uint8_t green = 0xFF;  ///< 0 to 255
  std::uint8_t blue = 0xFF;   ///< 0 to 255

  friend constexpr bool operator==(const PrintColor&, const PrintColor&) = default;
};

/// Style of text; sizes in dots.
struct PrintStyle {
  std::uint8_t height = 16;         ///< of a character
  std::uint8_t width = 8;           ///< with variable width: that of an average character
  bool is_bold = false;             ///< heavy strokes
  bool is_cursive = false;          ///< slanted
  bool has_variable_width = false;  ///< each character has its own width

  friend constexpr bool operator==(const PrintStyle&, const PrintStyle&) = default;
};

/// A character at its place in a line.
struct PrintedCharacter {
  char32_t character = U' ';  ///< Unicode
  unsigned left = 0;          ///< dots from the left edge
  PrintStyle style = {};      ///< of the text at that time
};

/// Empty callbacks have no effect.
struct PrinterPaper {
  /// Prints one character; its upper edge is at the position of the paper.
  Callback<void(const PrintedCharacter&)> put = {};
  /// Width in dots of a character of variable width; empty or 0: that of the style.
  Callback<unsigned(char32_t, const PrintStyle&)> width = {};
  /// Prints a row of dots, from the left edge, at the position of the paper.
  Callback<void(std::span<const PrintColor>)> put_row = {};
  /// Moves the paper by this number of dots.
  Callback<void(unsigned)> feed = {};
  /// Cuts the paper at its position.
  Callback<void()> cut = {};
};

/// A picture stored in the printer: rows of dots, the leftmost in the highest bit of the first
/// byte, each row in whole bytes.
struct PrinterLogo {
  unsigned width = 0;                  ///< in dots
  std::span<const std::uint8_t> bits;  ///< 1: black; they outlive the printer

  /// Bytes of a row; the rest of the last one is not printed.
  constexpr std::size_t row_bytes() const { return (width + 7) / 8; }
  /// In dots; an incomplete last row is left out.
  constexpr std::size_t height() const { return width == 0 ? 0 : bits.size() / row_bytes(); }
};

}  // namespace canvoy::cia447
