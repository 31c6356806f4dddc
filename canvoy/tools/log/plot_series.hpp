// Values over time, in as little room for a year as for a second: what a picture has no room for is
// kept as the least and the most of a span.
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
  /// What was said within one span of time.
  struct Span {
    std::uint64_t count = 0;  ///< 0: nothing
    double time = 0;          ///< of the first value
    double first = 0;
    double last = 0;
    double least = 0;
    double most = 0;
  };

  PlotSeries(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  /// `time` in seconds; one that is before the first is taken as that.
  void add(double time, double value);

  const std::string& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }
  const std::string& unit() const { return unit_; }
  /// Those in which something was said, in order.
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

/// From the least to the most that is shown, and where its marks stand.
struct PlotAxis {
  double low = 0;
  double high = 1;
  std::vector<double> marks;

  /// 0 at `low` and below, 1 at `high` and above.
  double place(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0); }
};
/// With round numbers at both ends of the values, `marks` of them or a few more.
PlotAxis plot_axis(double low, double high, unsigned marks);

/// A picture of its own, one diagram for each unit; times count from `begin`.
std::string plot_svg(std::span<const PlotSeries> series, const std::string& title);
/// The same as dots, for a PNG.
Picture plot_dots(std::span<const PlotSeries> series, const std::string& title);
/// The same in characters of Braille, for a terminal.
std::string plot_text(std::span<const PlotSeries> series, unsigned columns, unsigned rows,
                      bool coloured = false);

/// Those of one unit together, in the order in which the units come first.
std::vector<std::vector<const PlotSeries*>> plot_panels(std::span<const PlotSeries> series);

}  // namespace canvoy::tools
