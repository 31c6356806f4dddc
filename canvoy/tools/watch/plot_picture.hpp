// Common parts of the pictures of `canvoy plot`.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "canvoy/tools/watch/plot_series.hpp"

namespace canvoy::tools {

struct PlotLimits {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value);
};
PlotLimits value_limits(const std::vector<const PlotSeries*>& panel);
PlotLimits time_limits(std::span<const PlotSeries> series);

/// A number without trailing zeros: `12.5`.
std::string plot_number(double number);

}  // namespace canvoy::tools
