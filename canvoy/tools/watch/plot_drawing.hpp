// Layout of a picture of `canvoy plot`, for any canvas: a diagram for each unit, the names of its
// curves above it, and the time axis at the bottom.
//
//     SvgCanvas canvas;   // begin, line, words, curve
//     draw_plot(canvas, series, "night.log");
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "canvoy/tools/watch/plot_series.hpp"

namespace canvoy::tools {

// Common parts of the pictures of `canvoy plot`.

struct PlotLimits {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value);
};
PlotLimits value_limits(const std::vector<const PlotSeries*>& panel);
PlotLimits time_limits(std::span<const PlotSeries> series);

/// A number without trailing zeros: `12.5`.
std::string plot_number(double number);

/// In dots from the upper left corner.
struct PlotPoint {
  double x = 0;
  double y = 0;
};
struct PlotColor {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};
/// The point of a text that is placed; vertically it is the baseline.
enum class PlotAnchor : std::uint8_t { start, middle, end };

namespace plot_drawing {

inline constexpr double width = 960;
inline constexpr double panel_height = 260;
inline constexpr double left = 110;
inline constexpr double right = 40;
inline constexpr double above = 48;
inline constexpr double between = 40;
inline constexpr double below = 40;
/// Maximum width of a character, and height of a row of names.
inline constexpr double letter_width = 8;
inline constexpr double row_height = 16;
inline constexpr PlotColor black = {};
inline constexpr PlotColor value_lines = {0xDD, 0xDD, 0xDD};
inline constexpr PlotColor time_lines = {0xEE, 0xEE, 0xEE};
/// Colours that people with red-green colour blindness can distinguish (Okabe and Ito).
inline constexpr std::array<PlotColor, 7> colours = {{{0x00, 0x72, 0xB2},
                                                      {0xD5, 0x5E, 0x00},
                                                      {0x00, 0x9E, 0x73},
                                                      {0xCC, 0x79, 0xA7},
                                                      {0xE6, 0x9F, 0x00},
                                                      {0x56, 0xB4, 0xE9},
                                                      {0x00, 0x00, 0x00}}};

/// Number of UTF-8 characters.
inline double letters(std::string_view text) {
  return static_cast<double>(
      std::ranges::count_if(text, [](char each) { return (each & 0xC0) != 0x80; }));
}

/// Shortens a title at its start: it is a path, with the significant part at its end.
inline std::string shortened(std::string_view title, double room) {
  if (letters(title) * letter_width <= room) return std::string(title);
  const std::string dots = "...";
  while (!title.empty() && letters(title) * letter_width > room - 3 * letter_width) {
    do {
      title.remove_prefix(1);
    } while (!title.empty() && (title.front() & 0xC0) == 0x80);
  }
  return dots + std::string(title);
}

using Panel = std::vector<const PlotSeries*>;

/// Positions of the names of curves, relative to the left end of the lowest row; rows go upwards.
struct Names {
  std::vector<PlotPoint> places;
  double height = 0;  ///< of all rows except the lowest
};
inline Names place_names(const Panel& panel) {
  Names names;
  PlotPoint next;
  for (const PlotSeries* series : panel) {
    const double room = letter_width * letters(series->name());
    if (next.x > 0 && left + next.x + room > width) next = {0, next.y + row_height};
    names.places.push_back(next);
    next.x += room + 20;
  }
  names.height = next.y;
  for (PlotPoint& place : names.places) place.y -= names.height;
  return names;
}

template <class Canvas>
class Drawing {
 public:
  Drawing(Canvas& canvas, std::span<const PlotSeries> series)
      : canvas_(canvas), panels_(plot_panels(series)) {
    const PlotLimits times = time_limits(series);
    begin_ = times.low;
    time_ = plot_axis(0, times.high - times.low, 8);
  }

  void draw(const std::string& title) {
    double height = above;
    for (const Panel& panel : panels_) height += place_names(panel).height + panel_height + between;
    const double bottom = height - between;
    canvas_.begin(width, bottom + below);
    canvas_.words({left, 16}, PlotAnchor::start, black, shortened(title, width - left));
    draw_times(bottom);
    double top = above;
    for (const Panel& panel : panels_) {
      const Names names = place_names(panel);
      top += names.height;
      draw_panel(panel, names, top);
      top += panel_height + between;
    }
  }

 private:
  double x(double time) const { return left + time_.place(time - begin_) * (width - left - right); }

  void draw_panel(const Panel& panel, const Names& names, double top) {
    const PlotLimits limits = value_limits(panel);
    const PlotAxis axis = plot_axis(limits.low, limits.high, 5);
    const auto y = [&](double value) { return top + (1 - axis.place(value)) * panel_height; };
    for (const double mark : axis.marks) {
      canvas_.line({left, y(mark)}, {width - right, y(mark)}, value_lines);
      canvas_.words({left - 6, y(mark) + 4}, PlotAnchor::end, black, plot_number(mark));
    }
    canvas_.words({4, top - 8}, PlotAnchor::start, black, panel.front()->unit());
    for (std::size_t i = 0; i < panel.size(); ++i) {
      const PlotColor color = colours.at(i % colours.size());
      const PlotPoint& place = names.places[i];
      canvas_.words({left + place.x, top - 8 + place.y}, PlotAnchor::start, color,
                    panel[i]->name());
      canvas_.curve(points_of(*panel[i], y), color);
    }
  }

  template <class Place>
  std::vector<PlotPoint> points_of(const PlotSeries& series, const Place& y) const {
    std::vector<PlotPoint> points;
    for (const PlotSeries::Span& span : series.spans()) {
      std::vector<double> values = {span.first};
      if (span.count > 1) values = {span.first, span.least, span.most, span.last};
      const auto same = std::ranges::unique(values);
      values.erase(same.begin(), same.end());
      for (const double value : values) points.push_back({x(span.time), y(value)});
    }
    return points;
  }

  void draw_times(double bottom) {
    for (const double mark : time_.marks) {
      const double at = left + time_.place(mark) * (width - left - right);
      canvas_.line({at, above}, {at, bottom}, time_lines);
      canvas_.words({at, bottom + 20}, PlotAnchor::middle, black, plot_number(mark) + " s");
    }
  }

  Canvas& canvas_;
  std::vector<Panel> panels_;
  double begin_ = 0;
  PlotAxis time_;
};

}  // namespace plot_drawing

/// Calls begin() of `canvas` with its size, and then line(), words() and curve(); the canvas clips
/// at its edges.
template <class Canvas>
void draw_plot(Canvas& canvas, std::span<const PlotSeries> series, const std::string& title) {
  plot_drawing::Drawing(canvas, series).draw(title);
}

}  // namespace canvoy::tools
