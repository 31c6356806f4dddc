// A picture in memory: rows of dots of 8 bits red, green and blue, from the top.
//
//     Picture picture(384);
//     picture.grow(16);
//     picture.darken(0, 0, {.red = 0, .green = 0, .blue = 0});
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"

namespace canvoy {

class Picture {
 public:
  /// 8 bits each of red, green and blue; white by default.
  using Color = cia447::PrintColor;
  static constexpr std::size_t bytes_of_dot = 3;  ///< red, green and blue

  /// Makes a picture of no rows; `width` is in dots.
  explicit Picture(std::size_t width) : width_(width) {}

  /// Dots in a row.
  std::size_t width() const { return width_; }
  /// Rows.
  std::size_t height() const { return width_ == 0 ? 0 : bytes_.size() / (width_ * bytes_of_dot); }
  /// Red, green and blue of each dot, without gaps.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  /// Extends the picture to at least this many rows; new ones are white.
  void grow(std::size_t height) {
    const std::size_t size = height * width_ * bytes_of_dot;
    if (bytes_.size() < size) bytes_.resize(size, 0xFF);
  }
  /// Color of a dot; white beyond the edges.
  Color at(std::size_t x, std::size_t y) const {
    if (x >= width_ || y >= height()) return {};
    const std::uint8_t* dot = &bytes_[(y * width_ + x) * bytes_of_dot];
    return {.red = dot[0], .green = dot[1], .blue = dot[2]};
  }
  /// Adds ink to the dot. Does nothing beyond the edges.
  void darken(std::size_t x, std::size_t y, const Color& color) {
    if (x >= width_ || y >= height()) return;
    std::uint8_t* dot = &bytes_[(y * width_ + x) * bytes_of_dot];
    dot[0] = std::min(dot[0], color.red);
    dot[1] = std::min(dot[1], color.green);
    dot[2] = std::min(dot[2], color.blue);
  }

 private:
  std::size_t width_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace canvoy
