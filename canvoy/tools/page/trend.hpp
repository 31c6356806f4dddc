// Numbers of a world or a bus over its whole run, for curves beside its picture: at most
// samples_max of each, for any length.
//
//     if (trend.is_due(now)) trend.add(now, network.snapshot());
//     trend.json({"plant.current_a", "waiting"});
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

/// Splits `a,b` into both: the names of a request.
std::vector<std::string> listed_names(std::string_view list);

class Trend {
 public:
  static constexpr std::size_t samples_max = 600;
  /// Maximum number of numbers of a snapshot; further ones are ignored.
  static constexpr std::size_t numbers_max = 128;

  bool is_due(Time now) const { return now >= next_; }
  /// Adds the numbers of a snapshot, by path: `plant.current_a`, `lifts.0.position_m`. Ignores
  /// other values, and lists of nodes, buses and landings.
  void add(Time now, const nlohmann::ordered_json& snapshot);
  void clear() { *this = {}; }

  /// `times`, and `values` by name: as many of each, null where there was none. Unknown names are
  /// omitted.
  nlohmann::ordered_json json(std::span<const std::string> names) const;

 private:
  static constexpr Duration first_period = 1s;

  void note(std::string& place, const nlohmann::ordered_json& value);
  void thin();

  Duration period_ = first_period;
  Time next_{};
  std::vector<float> times_;  ///< in seconds
  /// Shorter than times_ if no value came since.
  std::map<std::string, std::vector<float>, std::less<>> values_;
};

}  // namespace canvoy::tools
