#include "canvoy/tools/watch/plot_series.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::tools {

namespace {

void join_spans(PlotSeries::Span& one, const PlotSeries::Span& next) {
  if (next.count == 0) return;
  if (one.count == 0) {
    one = next;
    return;
  }
  one.count += next.count;
  one.last = next.last;
  one.least = std::min(one.least, next.least);
  one.most = std::max(one.most, next.most);
}

}  // namespace

/// Doubles the width of the spans.
void PlotSeries::widen() {
  width_ *= 2;
  for (std::size_t i = 0; i < (spans_.size() + 1) / 2; ++i) {
    Span joined = spans_[2 * i];
    if (2 * i + 1 < spans_.size()) join_spans(joined, spans_[2 * i + 1]);
    spans_[i] = joined;
  }
  spans_.resize((spans_.size() + 1) / 2);
}

void PlotSeries::add(double time, double value) {
  if (!std::isfinite(value)) return;
  if (!begin_) begin_ = time;
  const double since = std::max(time - *begin_, 0.0);
  while (since / width_ >= static_cast<double>(spans_max)) widen();
  const auto place = static_cast<std::size_t>(since / width_);
  if (place >= spans_.size()) spans_.resize(place + 1);
  join_spans(spans_[place], {1, *begin_ + since, value, value, value, value});
}

std::vector<PlotSeries::Span> PlotSeries::spans() const {
  std::vector<Span> said;
  std::ranges::copy_if(spans_, std::back_inserter(said),
                       [](const Span& span) { return span.count != 0; });
  return said;
}

PlotAxis plot_axis(double low, double high, unsigned marks) {
  // Beyond this, a step between marks is not representable.
  constexpr double most = 1e300;
  constexpr double least = 1e-300;
  low = std::clamp(low, -most, most);
  high = std::clamp(high, -most, most);
  if (!(high - low > least)) {
    const double room = std::abs(low) <= 10 * least ? 1 : std::abs(low) / 10;
    low -= room;
    high += room;
  }
  const double rough = (high - low) / std::max(marks, 1U);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if (step >= rough) break;
  }
  PlotAxis axis = {
      .low = std::floor(low / step) * step, .high = std::ceil(high / step) * step, .marks = {}};
  const auto count = static_cast<int>(std::round((axis.high - axis.low) / step));
  for (int i = 0; i <= count; ++i) axis.marks.push_back(axis.low + i * step);
  return axis;
}

std::vector<std::vector<const PlotSeries*>> plot_panels(std::span<const PlotSeries> series) {
  std::vector<std::vector<const PlotSeries*>> panels;
  for (const PlotSeries& each : series) {
    const auto same = std::ranges::find_if(
        panels, [&](const auto& panel) { return panel.front()->unit() == each.unit(); });
    if (same == panels.end()) {
      panels.push_back({&each});
    } else {
      same->push_back(&each);
    }
  }
  return panels;
}

}  // namespace canvoy::tools
