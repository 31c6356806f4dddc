// Draws lines, boxes and words of a picture as elements of SVG.
//
//     SvgCanvas canvas;
//     canvas.begin(960, 480);
//     canvas.line({10, 10}, {20, 10}, plot_drawing::black);
//     const std::string svg = canvas.end();
#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/watch/plot_drawing.hpp"

namespace canvoy::tools {

/// A canvas that writes elements of SVG.
class SvgCanvas {
 public:
  void begin(double width, double height) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n",
        width, height);
  }
  void line(PlotPoint from, PlotPoint to, PlotColor color) {
    text_ += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", from.x,
        to.x, from.y, to.y, color_text(color));
  }
  void words(PlotPoint at, PlotAnchor anchor, PlotColor color, std::string_view words) {
    constexpr std::array<const char*, 3> anchors = {"start", "middle", "end"};
    text_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                    at.x, at.y, anchors.at(static_cast<std::size_t>(anchor)), color_text(color),
                    formats::markup_text(words));
  }
  void box(PlotPoint from, PlotPoint to, PlotColor color) {
    text_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
        from.x, from.y, to.x - from.x, to.y - from.y, color_text(color));
  }
  void curve(std::span<const PlotPoint> points, PlotColor color) {
    text_ += fmt::format(R"(<polyline fill="none" stroke="{}" stroke-width="1.2" points=")",
                         color_text(color));
    for (const PlotPoint& point : points) text_ += fmt::format("{:.1f},{:.1f} ", point.x, point.y);
    text_ += "\"/>\n";
  }
  std::string end() { return text_ + "</svg>\n"; }

 private:
  static std::string color_text(PlotColor color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
  }

  std::string text_;
};

}  // namespace canvoy::tools
