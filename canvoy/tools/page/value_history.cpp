#include "canvoy/tools/page/value_history.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Largest-Triangle-Three-Buckets (Steinarsson, 2013): of each bucket the sample that makes the
/// largest triangle with the one kept before and the mean of the next bucket. First and last stay.
template <class Sample>
std::vector<Sample> thinned(const std::vector<Sample>& all, std::size_t count) {
  std::vector<Sample> kept{all.front()};
  const double width = static_cast<double>(all.size() - 2) / static_cast<double>(count - 2);
  const auto edge = [&](std::size_t bucket) {
    return std::min(all.size() - 1,
                    1 + static_cast<std::size_t>(static_cast<double>(bucket) * width));
  };
  for (std::size_t bucket = 0; bucket + 2 < count; ++bucket) {
    double time = 0;
    double value = 0;
    const std::size_t next = edge(bucket + 1);
    const std::size_t after = std::max(next + 1, edge(bucket + 2));
    for (std::size_t i = next; i < after; ++i) {
      time += all[i].time / static_cast<double>(after - next);
      value += all[i].value / static_cast<double>(after - next);
    }
    const Sample& last = kept.back();
    const auto area = [&](const Sample& it) {
      return std::abs((last.time - time) * (it.value - last.value) -
                      (last.time - it.time) * (value - last.value));
    };
    kept.push_back(*std::max_element(
        all.begin() + static_cast<std::ptrdiff_t>(edge(bucket)),
        all.begin() + static_cast<std::ptrdiff_t>(next),
        [&](const Sample& one, const Sample& other) { return area(one) < area(other); }));
  }
  kept.push_back(all.back());
  return kept;
}

}  // namespace

void ValueHistory::add(double time, double number) {
  add({.time = time, .value = number});
}

void ValueHistory::add(double time, std::string_view name) {
  auto known = std::ranges::find(names_, name);
  if (known == names_.end()) {
    if (names_.size() == names_max) return;
    known = names_.emplace(names_.end(), name);
  }
  add({.time = time, .value = static_cast<double>(known - names_.begin()), .is_name = true});
}

void ValueHistory::add(const Sample& sample) {
  const bool is_same = !samples_.empty() && samples_.back().value == sample.value &&
                       samples_.back().is_name == sample.is_name;
  if (is_same) return;
  if (samples_.size() == samples_max) thin();
  samples_.push_back(sample);
}

void ValueHistory::thin() {
  const bool has_names = std::ranges::any_of(samples_, &Sample::is_name);
  if (has_names) {
    samples_.erase(samples_.begin(), samples_.begin() + samples_max / 2);
  } else {
    samples_ = thinned(samples_, samples_max / 2);
  }
}

Json ValueHistory::json() const {
  Json times = Json::array();
  Json values = Json::array();
  for (const Sample& sample : samples_) {
    times.push_back(sample.time);
    if (sample.is_name) {
      values.push_back(names_[static_cast<std::size_t>(sample.value)]);
    } else {
      values.push_back(sample.value);
    }
  }
  return {{"times", std::move(times)}, {"values", std::move(values)}};
}

}  // namespace canvoy::tools
