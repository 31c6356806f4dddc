// Values over time in constant memory for any duration: values that a picture cannot resolve are
// kept as the minimum and maximum of a span.
//
//     PlotSeries series("charger_state_of_charge", "%");
//     series.add(12.5, 80);
//     write(plot_svg({series}));
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy::tools {

class PlotSeries {
 public:
  /// Values within one span of time.
  struct Span {
    std::uint64_t count = 0;  ///< 0: none
    double time = 0;          ///< of the first value
    double first = 0;
    double last = 0;
    double least = 0;
    double most = 0;
  };

  PlotSeries(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  /// Adds a value. `time` in seconds; a time before the first one is taken as the first.
  void add(double time, double value);

  const std::string& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }
  const std::string& unit() const { return unit_; }
  /// Spans with values, in order.
  std::vector<Span> spans() const;

 private:
  static constexpr std::size_t spans_max = 2048;

  void widen();

  std::string name_;
  std::string unit_;
  std::optional<double> begin_;
  double width_ = 1e-3;
  std::vector<Span> spans_;
};

/// Range of an axis, and the positions of its marks.
struct PlotAxis {
  double low = 0;
  double high = 1;
  std::vector<double> marks;

  /// 0 at `low` and below, 1 at `high` and above.
  double place(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0); }
};
/// An axis with round numbers at both ends, and `marks` marks or a few more.
PlotAxis plot_axis(double low, double high, unsigned marks);

/// An SVG image with one diagram for each unit; times count from `begin`.
std::string plot_svg(std::span<const PlotSeries> series, const std::string& title);
/// The picture of plot_svg() as pixels, for a PNG.
Picture plot_dots(std::span<const PlotSeries> series, const std::string& title);
/// The picture of plot_svg() in Braille characters, for a terminal.
std::string plot_text(std::span<const PlotSeries> series, unsigned columns, unsigned rows,
                      bool coloured = false);

/// Groups the series by unit, in order of the first series of each unit.
std::vector<std::vector<const PlotSeries*>> plot_panels(std::span<const PlotSeries> series);

}  // namespace canvoy::tools
