// The picture of `canvoy plot` as pixels: lines with soft edges, letters of glyph_table.hpp.
#include <algorithm>
#include <cmath>

#include "canvoy/devices/cia447/printer/utf8_stream.hpp"
#include "canvoy/sim/plants/glyph.hpp"
#include "canvoy/tools/watch/plot_drawing.hpp"

namespace canvoy::tools {

namespace {

constexpr double curve_width = 1.6;

class DotCanvas {
 public:
  void begin(double width, double height) {
    picture_ = Picture(static_cast<std::size_t>(width));
    picture_.grow(static_cast<std::size_t>(height));
  }

  /// A horizontal or vertical line, one pixel wide.
  void line(PlotPoint from, PlotPoint to, PlotColor color) {
    const double steps = std::round(std::max(to.x - from.x, to.y - from.y));
    for (double i = 0; i <= steps; ++i) {
      const bool is_row = from.y == to.y;
      set(std::floor(from.x) + (is_row ? i : 0), std::floor(from.y) + (is_row ? 0 : i), color, 1);
    }
  }

  void words(PlotPoint at, PlotAnchor anchor, PlotColor color, std::string_view words) {
    const double width = plot_drawing::letters(words) * glyph_width;
    double x = std::round(at.x);
    if (anchor == PlotAnchor::middle) x -= std::round(width / 2);
    if (anchor == PlotAnchor::end) x -= width;
    const double top = std::round(at.y) - glyph_baseline;
    const auto put = [&](char32_t character) {
      put_glyph(x, top, color, glyph_of(character));
      x += glyph_width;
    };
    cia447::Utf8Stream stream;
    for (const char each : words) stream.push(static_cast<std::uint8_t>(each), put);
    stream.end(put);
  }

  void curve(std::span<const PlotPoint> points, PlotColor color) {
    if (points.size() == 1) stroke(points[0], points[0], color);
    for (std::size_t i = 1; i < points.size(); ++i) stroke(points[i - 1], points[i], color);
  }

  Picture end() { return std::move(picture_); }

 private:
  /// Colours this part of the pixel.
  void set(double x, double y, PlotColor color, double part) {
    if (x < 0 || y < 0 || part <= 0) return;
    const auto mixed = [part](std::uint8_t shade) {
      return static_cast<std::uint8_t>(0xFF - std::lround((0xFF - shade) * std::min(part, 1.0)));
    };
    picture_.darken(static_cast<std::size_t>(x), static_cast<std::size_t>(y),
                    {mixed(color.red), mixed(color.green), mixed(color.blue)});
  }

  void put_glyph(double left, double top, PlotColor color, const Glyph& glyph) {
    for (unsigned row = 0; row < glyph_height; ++row) {
      for (unsigned column = 0; column < glyph_width; ++column) {
        if (glyph.has_dot(column, row)) set(left + column, top + row, color, 1);
      }
    }
  }

  /// Steps along the longer side, with the pixels across the line.
  void stroke(PlotPoint from, PlotPoint to, PlotColor color) {
    const bool is_steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    if (is_steep) {
      std::swap(from.x, from.y);
      std::swap(to.x, to.y);
    }
    if (from.x > to.x) std::swap(from, to);
    const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0;
    const double half = curve_width / 2 * std::sqrt(1 + slope * slope);
    const double last = std::floor(to.x);
    for (double along = std::floor(from.x); along <= last; ++along) {
      const double across = from.y + slope * (std::clamp(along + 0.5, from.x, to.x) - from.x);
      for (double dot = std::floor(across - half); dot < across + half; ++dot) {
        const double part = std::min(dot + 1, across + half) - std::max(dot, across - half);
        set(is_steep ? dot : along, is_steep ? along : dot, color, part);
      }
    }
  }

  Picture picture_{0};
};

}  // namespace

Picture plot_dots(std::span<const PlotSeries> series, const std::string& title) {
  DotCanvas canvas;
  draw_plot(canvas, series, title);
  return canvas.end();
}

}  // namespace canvoy::tools
