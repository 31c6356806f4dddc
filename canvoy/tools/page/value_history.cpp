#include "canvoy/tools/page/value_history.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Largest-Triangle-Three-Buckets (Steinarsson, 2013), with buckets of equal time: of each the
/// sample that makes the largest triangle with the one kept before and the mean of the next bucket.
/// First and last stay. Buckets of as many samples each would leave fewer of the beginning with
/// each call. At most `count` samples, fewer where some buckets are empty.
template <class Sample>
std::vector<Sample> thinned(const std::vector<Sample>& all, std::size_t count) {
  const double begin = all.front().time;
  const double width = (all.back().time - begin) / static_cast<double>(count - 2);
  const auto end_of_bucket = [&](std::size_t from) {
    const double end = begin + (std::floor((all[from].time - begin) / width) + 1) * width;
    std::size_t to = from + 1;
    while (to + 1 < all.size() && all[to].time < end) ++to;
    return to;
  };
  std::vector<Sample> kept{all.front()};
  for (std::size_t from = 1; from + 1 < all.size();) {
    const std::size_t to = end_of_bucket(from);
    const std::size_t after = to + 1 < all.size() ? end_of_bucket(to) : all.size();
    double time = 0;
    double value = 0;
    for (std::size_t i = to; i < after; ++i) {
      time += all[i].time / static_cast<double>(after - to);
      value += all[i].value / static_cast<double>(after - to);
    }
    const Sample& last = kept.back();
    const auto area = [&](const Sample& it) {
      return std::abs((last.time - time) * (it.value - last.value) -
                      (last.time - it.time) * (value - last.value));
    };
    kept.push_back(*std::max_element(
        all.begin() + static_cast<std::ptrdiff_t>(from),
        all.begin() + static_cast<std::ptrdiff_t>(to),
        [&](const Sample& one, const Sample& other) { return area(one) < area(other); }));
    from = to;
  }
  kept.push_back(all.back());
  // More only if time has not gone on.
  if (kept.size() > count) {
    kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(count));
  }
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
    is_cut_ = true;
  } else {
    samples_ = thinned(samples_, samples_max / 2);
  }
}

Json ValueHistory::points(std::size_t count_max) const {
  Json points = Json::array();
  if (is_cut_) return points;
  const bool has_names = std::ranges::any_of(samples_, &Sample::is_name);
  const bool is_thinned = samples_.size() > count_max && !has_names;
  for (const Sample& sample : is_thinned ? thinned(samples_, count_max) : samples_) {
    points.push_back(
        Json::array({sample.time, sample.is_name ? Json(nullptr) : Json(sample.value)}));
  }
  return points;
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
