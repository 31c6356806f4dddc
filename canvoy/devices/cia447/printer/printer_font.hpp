// Font and color settings of a printer (CiA 447-3, 60E5h and 60E6h; errata Z15, Z16): the requested
// ones, and those that result on paper with a given number of dots.
//
//     PrinterFont font({.dots_per_line = 384});
//     font.set_width(16);
//     font.characters_per_line();  // 24
//
// The command has two codes without a request. "Don't care" leaves a setting as it is, and so does
// "no command" (0) where another number can be requested. For bold, cursive and variable width, "no
// command" is read as "not": otherwise they could never be switched off.
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// In dots.
struct PrinterFontLimits {
  unsigned dots_per_line = 384;  ///< of the paper
  std::uint8_t height_min = 16;  ///< of a character
  std::uint8_t height_max = 64;  ///< of a character
  std::uint8_t width_min = 8;    ///< of a character
  std::uint8_t width_max = 32;   ///< of a character

  /// Within the range of the objects: 253 at most.
  constexpr unsigned characters_max() const { return told(dots_per_line / width_min); }
  /// Fewest characters of a line, by the widest of them.
  constexpr unsigned characters_min() const { return told(dots_per_line / width_max); }

 private:
  static constexpr unsigned told(unsigned count) { return std::clamp(count, 1U, 0xFDU); }
};

class PrinterFont {
 public:
  /// Makes a font of the least size.
  constexpr explicit PrinterFont(const PrinterFontLimits& limits) : limits_(limits) {}

  // 0: not set. The values are not checked here: see allows_*.

  /// True for a height that can be printed.
  constexpr bool allows_height(unsigned dots) const {
    return dots == 0 || (dots >= limits_.height_min && dots <= limits_.height_max);
  }
  /// True for a width that can be printed.
  constexpr bool allows_width(unsigned dots) const {
    return dots == 0 || (dots >= limits_.width_min && dots <= limits_.width_max);
  }
  /// True for a number of characters in a line that can be printed.
  constexpr bool allows_characters(unsigned count) const {
    return count <= limits_.characters_max();
  }
  /// Asks for a height, in dots; 0: none.
  constexpr void set_height(unsigned dots) { height_ = static_cast<std::uint8_t>(dots); }
  /// Asks for a width, in dots; 0: none.
  constexpr void set_width(unsigned dots) { width_ = static_cast<std::uint8_t>(dots); }
  /// Asks for a number of characters in a line; 0: none.
  constexpr void set_characters(unsigned count) { characters_ = static_cast<std::uint8_t>(count); }
  /// Requested height, in dots.
  constexpr std::uint8_t height() const { return height_; }
  /// Requested width, in dots.
  constexpr std::uint8_t width() const { return width_; }
  /// Requested number of characters in a line.
  constexpr std::uint8_t characters() const { return characters_; }

  bool is_bold = false;                      ///< heavy strokes
  bool is_cursive = false;                   ///< slanted
  bool has_variable_width = false;           ///< each character has its own width
  ColorSpace color_space = ColorSpace::rgb;  ///< of the color

  /// The resulting style: without a set width, one with which the requested characters have room.
  constexpr PrintStyle style() const {
    return {.height = height_ != 0 ? height_ : limits_.height_min,
            .width = style_width(),
            .is_bold = is_bold,
            .is_cursive = is_cursive,
            .has_variable_width = has_variable_width};
  }
  /// The requested number, but not more than have room.
  constexpr unsigned characters_per_line() const {
    const unsigned room = std::max(1U, limits_.dots_per_line / style_width());
    const unsigned count = characters_ != 0 ? std::min<unsigned>(characters_, room) : room;
    return std::min(count, limits_.characters_max());
  }

 private:
  constexpr std::uint8_t style_width() const {
    if (width_ != 0) return width_;
    if (characters_ == 0) return limits_.width_min;
    return static_cast<std::uint8_t>(std::clamp<unsigned>(limits_.dots_per_line / characters_,
                                                          limits_.width_min, limits_.width_max));
  }

  PrinterFontLimits limits_;
  std::uint8_t height_ = 0;
  std::uint8_t width_ = 0;
  std::uint8_t characters_ = 0;
};

}  // namespace canvoy::cia447
