#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "canvoy/tools/load/load_result.hpp"
#include "canvoy/tools/watch/svg_canvas.hpp"

namespace canvoy::tools {

namespace {

constexpr PlotColor met = plot_drawing::colours[0];
constexpr PlotColor late = plot_drawing::colours[1];
constexpr double page_width = 960;
constexpr double names_width = 210;
constexpr double row = 18;
constexpr double margin = 24;

/// Times from left to right, with equal widths for all decades.
class TimeScale {
 public:
  void take(double seconds) {
    if (seconds <= 0) return;
    least_ = std::min(least_, std::floor(std::log10(seconds)));
    most_ = std::max(most_, std::ceil(std::log10(seconds)));
  }
  double x(double seconds) const {
    const double decade = std::clamp(std::log10(std::max(seconds, 1e-12)), least_, most_);
    const double share = (decade - least_) / (most_ - least_);
    return names_width + share * (page_width - names_width - 3 * margin);
  }
  /// The first decade; all decades.
  int first() const { return static_cast<int>(least_); }
  int last() const { return static_cast<int>(most_); }

 private:
  double least_ = -4;
  double most_ = -1;
};

std::string decade_text(int decade) {
  constexpr std::array<std::string_view, 4> units = {"s", "ms", "us", "ns"};
  const int unit = decade >= 0 ? 0 : std::min((2 - decade) / 3, 3);
  return fmt::format("{:g} {}", std::pow(10.0, decade + 3 * unit),
                     units.at(static_cast<std::size_t>(unit)));
}

double seconds_of(timing::Nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

void draw_message(SvgCanvas& canvas, const TimeScale& scale, double y, const LoadedMessage& message,
                  const timing::Response& response) {
  const double end =
      response.is_bounded ? scale.x(seconds_of(response.time)) : page_width - 3 * margin;
  const PlotColor color = response.meets_deadline ? met : late;
  canvas.words({margin, y + row - 6}, PlotAnchor::start, plot_drawing::black,
               fmt::format("{} {}", id_text(message.timing), title(message).substr(0, 18)));
  canvas.box({names_width, y + 3}, {std::max(end, names_width + 1), y + row - 4}, color);
  const double due = scale.x(seconds_of(message.timing.deadline));
  canvas.box({due - 1, y}, {due + 1, y + row - 1}, plot_drawing::black);
  canvas.words(
      {std::max(end, due) + 5, y + row - 6}, PlotAnchor::start, color,
      response.is_bounded ? fmt::format("{:.3f} ms", seconds_of(response.time) * 1e3) : "no bound");
}

}  // namespace

std::string picture_text(const std::vector<LoadedBus>& buses,
                         const std::vector<LoadResult>& results) {
  TimeScale scale;
  double height = 2 * margin;
  for (std::size_t b = 0; b < buses.size(); ++b) {
    height += 3 * row + row * static_cast<double>(buses[b].messages.size());
    for (std::size_t i = 0; i < buses[b].messages.size(); ++i) {
      scale.take(seconds_of(buses[b].messages[i].timing.deadline));
      if (results[b].responses[i].is_bounded) scale.take(seconds_of(results[b].responses[i].time));
    }
  }
  SvgCanvas canvas;
  canvas.begin(page_width, height);
  for (int decade = scale.first(); decade <= scale.last(); ++decade) {
    const double x = scale.x(std::pow(10.0, decade));
    canvas.line({x, margin}, {x, height - margin}, plot_drawing::value_lines);
    canvas.words({x, height - margin + 14}, PlotAnchor::middle, plot_drawing::black,
                 decade_text(decade));
  }
  double y = margin;
  for (std::size_t b = 0; b < buses.size(); ++b) {
    canvas.words(
        {margin, y + row - 4}, PlotAnchor::start, plot_drawing::black,
        fmt::format("{} at {:g} kbit/s, load {:.1f} %: longest response (bar) and deadline (line)",
                    buses[b].name, buses[b].bit_rate / 1e3, results[b].load * 100));
    y += 1.5 * row;
    for (const std::size_t i : by_priority(buses[b])) {
      draw_message(canvas, scale, y, buses[b].messages[i], results[b].responses[i]);
      y += row;
    }
    y += 1.5 * row;
  }
  return canvas.end();
}

}  // namespace canvoy::tools
