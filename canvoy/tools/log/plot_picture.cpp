#include "canvoy/tools/log/plot_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace canvoy::tools {

namespace {

constexpr double picture_width = 960;
constexpr double panel_height = 260;
constexpr double left = 80;
constexpr double right = 20;
constexpr double above = 40;
constexpr double between = 40;
constexpr double below = 40;
/// Colours that those who see red and green alike can tell apart (Okabe and Ito).
constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000"};

std::string xml_text(std::string_view text) {
  std::string made;
  for (const char each : text) {
    if (each == '&')
      made += "&amp;";
    else if (each == '<')
      made += "&lt;";
    else if (each == '>')
      made += "&gt;";
    else if (each == '"')
      made += "&quot;";
    else
      made += each;
  }
  return made;
}

class SvgPlot {
 public:
  SvgPlot(std::span<const PlotSeries> series, const std::string& title)
      : panels_(plot_panels(series)) {
    const PlotLimits times = time_limits(series);
    begin_ = times.low;
    time_ = plot_axis(0, times.high - times.low, 8);
    height_ =
        above + static_cast<double>(panels_.size()) * (panel_height + between) - between + below;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n"
        "<text x=\"{2}\" y=\"20\" font-size=\"14\">{3}</text>\n",
        picture_width, height_, left, xml_text(title));
  }

  std::string draw() {
    double top = above;
    for (const auto& panel : panels_) {
      draw_panel(panel, top);
      top += panel_height + between;
    }
    draw_times(top - between);
    return text_ + "</svg>\n";
  }

 private:
  double x(double time) const {
    return left + time_.place(time - begin_) * (picture_width - left - right);
  }

  void draw_panel(const std::vector<const PlotSeries*>& panel, double top) {
    const PlotLimits limits = value_limits(panel);
    const PlotAxis axis = plot_axis(limits.low, limits.high, 5);
    const auto y = [&](double value) { return top + (1 - axis.place(value)) * panel_height; };
    for (const double mark : axis.marks) {
      text_ += fmt::format(
          "<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>"
          "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
          left, picture_width - right, y(mark), y(mark), left - 6, y(mark) + 4, plot_number(mark));
    }
    text_ += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", 4, top - 6,
                         xml_text(panel.front()->unit()));
    double name_at = left;
    for (std::size_t i = 0; i < panel.size(); ++i) {
      const char* colour = colours.at(i % colours.size());
      text_ += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", name_at,
                           top - 6, colour, xml_text(panel[i]->name()));
      name_at += 7.0 * static_cast<double>(panel[i]->name().size()) + 20;
      draw_line(*panel[i], colour, y);
    }
  }

  template <class Place>
  void draw_line(const PlotSeries& series, const char* colour, const Place& y) {
    text_ +=
        fmt::format(R"(<polyline fill="none" stroke="{}" stroke-width="1.2" points=")", colour);
    for (const PlotSeries::Span& span : series.spans()) {
      std::vector<double> values = {span.first};
      if (span.count > 1) values = {span.first, span.least, span.most, span.last};
      const auto same = std::ranges::unique(values);
      values.erase(same.begin(), same.end());
      for (const double value : values)
        text_ += fmt::format("{:.1f},{:.1f} ", x(span.time), y(value));
    }
    text_ += "\"/>\n";
  }

  void draw_times(double bottom) {
    for (const double mark : time_.marks) {
      const double at = left + time_.place(mark) * (picture_width - left - right);
      text_ += fmt::format(
          "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#eee\"/>"
          "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4} s</text>\n",
          at, above, bottom, bottom + 18, plot_number(mark));
    }
  }

  std::vector<std::vector<const PlotSeries*>> panels_;
  double begin_ = 0;
  PlotAxis time_;
  double height_ = 0;
  std::string text_;
};

/// A raster of dots, of which eight are one character.
class BraillePlot {
 public:
  BraillePlot(std::size_t columns, std::size_t rows)
      : columns_(columns), rows_(rows), cells_(columns * rows) {}

  std::size_t width() const { return 2 * columns_; }
  std::size_t height() const { return 4 * rows_; }
  void set(std::size_t x, std::size_t y) {
    constexpr std::array<std::array<unsigned, 2>, 4> bits = {
        {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
    if (x < width() && y < height()) cells_[y / 4 * columns_ + x / 2] |= bits.at(y % 4).at(x % 2);
  }
  void line(double x0, double y0, double x1, double y1) {
    const auto steps = static_cast<int>(std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1.0}));
    for (int i = 0; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      set(static_cast<std::size_t>(std::max(0.0, x0 + (x1 - x0) * part)),
          static_cast<std::size_t>(std::max(0.0, y0 + (y1 - y0) * part)));
    }
  }
  std::string row(std::size_t row) const {
    std::string text;
    for (std::size_t i = 0; i < columns_; ++i) {
      const unsigned cell = cells_[row * columns_ + i];
      text += static_cast<char>(0xE2);
      text += static_cast<char>(0xA0 | cell >> 6);
      text += static_cast<char>(0x80 | (cell & 0x3F));
    }
    return text;
  }

 private:
  std::size_t columns_;
  std::size_t rows_;
  std::vector<unsigned> cells_;
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
  return SvgPlot(series, title).draw();
}

std::string plot_text(std::span<const PlotSeries> series, unsigned columns, unsigned rows) {
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
    for (const PlotSeries* each : panel) {
      text += fmt::format("{}{}\n", each->name(), each->unit().empty() ? "" : ", " + each->unit());
      draw_series(plot, *each, times, axis);
    }
    for (std::size_t row = 0; row < height; ++row) {
      const std::string mark = row == 0            ? plot_number(axis.high)
                               : row + 1 == height ? plot_number(axis.low)
                                                   : "";
      text += fmt::format("{:>{}} {}\n", mark, mark_columns - 1, plot.row(row));
    }
  }
  const std::string span = plot_number(times.high - times.low) + " s";
  return text +
         fmt::format("{:>{}}{:>{}}\n", "0 s", mark_columns + 3, span, width > 3 ? width - 3 : 0);
}

}  // namespace canvoy::tools
