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
  unsigned dots_per_line = 384;
  std::uint8_t height_min = 16;
  std::uint8_t height_max = 64;
  std::uint8_t width_min = 8;
  std::uint8_t width_max = 32;

  /// Within the range of the objects: 253 at most.
  constexpr unsigned characters_max() const { return told(dots_per_line / width_min); }
  constexpr unsigned characters_min() const { return told(dots_per_line / width_max); }

 private:
  static constexpr unsigned told(unsigned count) { return std::clamp(count, 1U, 0xFDU); }
};

class PrinterFont {
 public:
  constexpr explicit PrinterFont(const PrinterFontLimits& limits) : limits_(limits) {}

  // 0: not set. The values are not checked here: see allows_*.

  constexpr bool allows_height(unsigned dots) const {
    return dots == 0 || (dots >= limits_.height_min && dots <= limits_.height_max);
  }
  constexpr bool allows_width(unsigned dots) const {
    return dots == 0 || (dots >= limits_.width_min && dots <= limits_.width_max);
  }
  constexpr bool allows_characters(unsigned count) const {
    return count <= limits_.characters_max();
  }
  constexpr void set_height(unsigned dots) { height_ = static_cast<std::uint8_t>(dots); }
  constexpr void set_width(unsigned dots) { width_ = static_cast<std::uint8_t>(dots); }
  constexpr void set_characters(unsigned count) { characters_ = static_cast<std::uint8_t>(count); }
  constexpr std::uint8_t height() const { return height_; }
  constexpr std::uint8_t width() const { return width_; }
  constexpr std::uint8_t characters() const { return characters_; }

  bool is_bold = false;
  bool is_cursive = false;
  bool has_variable_width = false;
  ColorSpace color_space = ColorSpace::rgb;

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
