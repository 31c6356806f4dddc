#include "canvoy/tools/page/trend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

bool is_passed_over(std::string_view name) {
  constexpr std::array<std::string_view, 4> lists = {"nodes", "buses", "landings", "time"};
  return std::ranges::find(lists, name) != lists.end();
}

/// Keeps the first of two, the third of four: the rest covers the same time.
void halve(std::vector<float>& numbers) {
  for (std::size_t i = 0; 2 * i < numbers.size(); ++i) numbers[i] = numbers[2 * i];
  numbers.resize((numbers.size() + 1) / 2);
}

/// Enough digits for a curve; a JSON number needs no others.
Json number_json(float number) {
  if (!std::isfinite(number)) return nullptr;
  constexpr double thousandths = 1000;
  return std::round(double{number} * thousandths) / thousandths;
}

}  // namespace

std::vector<std::string> listed_names(std::string_view list) {
  std::vector<std::string> words;
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(','));
    words.emplace_back(word);
    list.remove_prefix(std::min(word.size() + 1, list.size()));
  }
  return words;
}

void Trend::add(Time now, const Json& snapshot) {
  if (times_.size() == samples_max) thin();
  times_.push_back(static_cast<float>(in_seconds(now - Time{})));
  std::string place;
  note(place, snapshot);
  next_ = now + period_;
}

void Trend::note(std::string& place, const Json& value) {
  if (value.is_number()) {
    auto known = values_.find(place);
    if (known == values_.end()) {
      if (values_.size() == numbers_max) return;
      known = values_.emplace(place, std::vector<float>()).first;
    }
    known->second.resize(times_.size() - 1, no_number);
    known->second.push_back(value.get<float>());
    return;
  }
  if (!value.is_structured()) return;
  const std::size_t length = place.size();
  std::size_t number = 0;
  for (const auto& [key, part] : value.items()) {
    const std::string name = value.is_array() ? std::to_string(number++) : key;
    if (is_passed_over(name)) continue;
    if (length != 0) place += '.';
    place += name;
    note(place, part);
    place.resize(length);
  }
}

void Trend::thin() {
  for (auto& [name, numbers] : values_) {
    numbers.resize(times_.size(), no_number);
    halve(numbers);
  }
  halve(times_);
  period_ *= 2;
}

Json Trend::json(std::span<const std::string> names) const {
  Json times = Json::array();
  for (const float time : times_) times.push_back(number_json(time));
  Json values = Json::object();
  for (const std::string& name : names) {
    const auto known = values_.find(name);
    if (known == values_.end()) continue;
    Json list = Json::array();
    for (std::size_t i = 0; i < times_.size(); ++i) {
      list.push_back(number_json(i < known->second.size() ? known->second[i] : no_number));
    }
    values[name] = std::move(list);
  }
  return {{"times", std::move(times)}, {"values", std::move(values)}};
}

}  // namespace canvoy::tools
