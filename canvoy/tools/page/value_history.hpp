// A value of an object over time, for plots: at most samples_max samples, for any length. Numbers
// are thinned so that a curve keeps its shape; of names, the latest are kept.
//
//     ValueHistory history;
//     history.add(12.5, 48.25);
//     history.add(13.0, "ready");
//     history.json();  // {"times":[12.5,13.0],"values":[48.25,"ready"]}
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

class ValueHistory {
 public:
  static constexpr std::size_t samples_max = 1000;
  /// Maximum number of different names; values with others are ignored.
  static constexpr std::size_t names_max = 64;

  /// Adds a value that holds from this time on, in seconds; ignores one that is equal to the last.
  void add(double time, double number);
  /// Adds a state by its name.
  void add(double time, std::string_view name);

  /// `times`, and as many `values`: numbers, or names of states.
  nlohmann::ordered_json json() const;
  /// Pairs of time and number, `count_max` (3 or more) at most; null where a state begins that has
  /// no number. Empty if the earliest values are no longer known.
  nlohmann::ordered_json points(std::size_t count_max) const;

 private:
  struct Sample {
    double time = 0;
    double value = 0;  ///< a number, or a position in names_
    bool is_name = false;
  };

  void add(const Sample& sample);
  void thin();

  std::vector<Sample> samples_;
  std::vector<std::string> names_;
  bool is_cut_ = false;  ///< the earliest samples are gone
};

}  // namespace canvoy::tools
