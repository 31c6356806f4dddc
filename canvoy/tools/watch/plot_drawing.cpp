#include "canvoy/tools/watch/plot_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "canvoy/tools/watch/svg_canvas.hpp"

namespace canvoy::tools {

namespace {

/// The mark of a curve among others: a letter, and a terminal colour.
char curve_mark(std::size_t curve) {
  return static_cast<char>('A' + curve % 26);
}
std::string curve_colour(std::size_t curve) {
  constexpr std::array<unsigned, 6> colours = {36, 33, 35, 32, 34, 31};
  return fmt::format("\x1B[{}m", colours.at(curve % colours.size()));
}
constexpr std::string_view plain_colour = "\x1B[0m";

/// A raster of dots, eight for each character.
class BraillePlot {
 public:
  BraillePlot(std::size_t columns, std::size_t rows)
      : columns_(columns), rows_(rows), cells_(columns * rows), owners_(columns * rows) {}

  /// Sets the curve of the following dots.
  void begin_curve(std::size_t curve) { curve_ = curve; }

  std::size_t width() const { return 2 * columns_; }
  std::size_t height() const { return 4 * rows_; }
  void set(std::size_t x, std::size_t y) {
    constexpr std::array<std::array<unsigned, 2>, 4> bits = {
        {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
    if (x >= width() || y >= height()) return;
    const std::size_t cell = y / 4 * columns_ + x / 2;
    cells_[cell] |= bits.at(y % 4).at(x % 2);
    owners_[cell] = curve_;
  }
  void line(double x0, double y0, double x1, double y1) {
    const auto steps = static_cast<int>(std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1.0}));
    for (int i = 0; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      set(static_cast<std::size_t>(std::max(0.0, x0 + (x1 - x0) * part)),
          static_cast<std::size_t>(std::max(0.0, y0 + (y1 - y0) * part)));
    }
  }
  /// `marked`: with several curves, each has its letter at intervals; and its colour, if requested.
  std::string row(std::size_t row, bool marked, bool coloured) const {
    std::string text;
    std::optional<std::size_t> colour;
    for (std::size_t i = 0; i < columns_; ++i) {
      const unsigned cell = cells_[row * columns_ + i];
      const std::size_t owner = owners_[row * columns_ + i];
      if (marked && coloured && cell != 0 && colour != owner) {
        text += curve_colour(owner);
        colour = owner;
      }
      const bool is_marked = marked && cell != 0 && i % mark_distance == owner % mark_distance;
      if (is_marked) {
        text += curve_mark(owner);
        continue;
      }
      text += static_cast<char>(0xE2);
      text += static_cast<char>(0xA0 | cell >> 6);
      text += static_cast<char>(0x80 | (cell & 0x3F));
    }
    if (colour) text += plain_colour;
    return text;
  }

 private:
  static constexpr std::size_t mark_distance = 12;

  std::size_t columns_;
  std::size_t rows_;
  std::vector<unsigned> cells_;
  std::vector<std::size_t> owners_;
  std::size_t curve_ = 0;
};

void draw_series(BraillePlot& plot, const PlotSeries& series, const PlotLimits& times,
                 const PlotAxis& axis) {
  const double span_s = std::max(times.high - times.low, 1e-9);
  const auto x = [&](double time) {
    return (time - times.low) / span_s * static_cast<double>(plot.width() - 1);
  };
  const auto y = [&](double value) {
    return (1 - axis.place(value)) * static_cast<double>(plot.height() - 1);
  };
  const std::vector<PlotSeries::Span> spans = series.spans();
  for (std::size_t i = 0; i < spans.size(); ++i) {
    plot.line(x(spans[i].time), y(spans[i].least), x(spans[i].time), y(spans[i].most));
    if (i > 0)
      plot.line(x(spans[i - 1].time), y(spans[i - 1].last), x(spans[i].time), y(spans[i].first));
  }
}

}  // namespace

void PlotLimits::add(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

PlotLimits value_limits(const std::vector<const PlotSeries*>& panel) {
  PlotLimits limits;
  for (const PlotSeries* series : panel) {
    for (const PlotSeries::Span& span : series->spans()) {
      limits.add(span.least);
      limits.add(span.most);
    }
  }
  return limits;
}

PlotLimits time_limits(std::span<const PlotSeries> series) {
  PlotLimits limits;
  for (const PlotSeries& each : series) {
    for (const PlotSeries::Span& span : each.spans()) limits.add(span.time);
  }
  return limits;
}

std::string plot_number(double number) {
  return fmt::format("{:.6g}", std::abs(number) < 1e-12 ? 0 : number);
}

std::string plot_svg(std::span<const PlotSeries> series, const std::string& title) {
  SvgCanvas canvas;
  draw_plot(canvas, series, title);
  return canvas.end();
}

std::string plot_text(std::span<const PlotSeries> series, unsigned columns, unsigned rows,
                      bool coloured) {
  constexpr unsigned mark_columns = 10;
  constexpr unsigned rows_least = 4;
  const auto panels = plot_panels(series);
  const PlotLimits times = time_limits(series);
  const std::size_t width = std::max(columns, mark_columns + 10) - mark_columns;
  std::string text;
  for (const auto& panel : panels) {
    const std::size_t room = rows / panels.size();
    const std::size_t height =
        std::max<std::size_t>(room > panel.size() + 1 ? room - panel.size() - 1 : 0, rows_least);
    const PlotLimits limits = value_limits(panel);
    const PlotAxis axis = plot_axis(limits.low, limits.high, 4);
    BraillePlot plot(width, height);
    const bool has_several = panel.size() > 1;
    for (std::size_t curve = 0; curve < panel.size(); ++curve) {
      const PlotSeries& each = *panel[curve];
      const std::string mark = has_several ? fmt::format("{} ", curve_mark(curve)) : "";
      const std::string legend =
          fmt::format("{}{}{}", mark, each.name(), each.unit().empty() ? "" : ", " + each.unit());
      text += has_several && coloured
                  ? fmt::format("{}{}{}\n", curve_colour(curve), legend, plain_colour)
                  : legend + "\n";
      plot.begin_curve(curve);
      draw_series(plot, each, times, axis);
    }
    for (std::size_t row = 0; row < height; ++row) {
      const std::string mark = row == 0            ? plot_number(axis.high)
                               : row + 1 == height ? plot_number(axis.low)
                                                   : "";
      text +=
          fmt::format("{:>{}} {}\n", mark, mark_columns - 1, plot.row(row, has_several, coloured));
    }
  }
  const std::string span = plot_number(times.high - times.low) + " s";
  return text +
         fmt::format("{:>{}}{:>{}}\n", "0 s", mark_columns + 3, span, width > 3 ? width - 3 : 0);
}

}  // namespace canvoy::tools
