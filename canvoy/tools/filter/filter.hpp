// Selects the frames to show: `--filter` of `canvoy decode` and `canvoy monitor`. docs/decode.md
// has the grammar.
//
//     Filter filter;
//     filter.add("node=10 and temperature>40degC", names);
//     if (filter.passes({.time = time, .bus = "can0", .frame = frame, .words = words})) show();
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

class Filter {
 public:
  /// Adds an expression that must be true as well. Throws UsageError with one line if it cannot be
  /// parsed, uses an unknown name, or can be true for no frame.
  void add(std::string_view text, const FilterNames& names);
  bool empty() const { return all_.parts.empty(); }

  /// True if the frame passes; an empty filter passes all.
  bool passes(const FilterFrame& frame);

  /// False if no frame passes that has this bus and CAN-ID, and service, node and client of these
  /// words; of a 29-bit frame, any CAN-ID. Counts nothing.
  bool may_pass(const FilterFrame& frame);
  /// False if no frame passes between these times, if the first frame came at `first`.
  bool may_pass(Duration from, Duration to, Duration first);

  /// Numbers of frames tested and passed.
  std::uint64_t seen() const { return seen_; }
  std::uint64_t passed() const { return passed_; }
  /// The conditions that were true for no frame, as written; only if no frame has passed.
  std::vector<std::string_view> never_true() const;

 private:
  enum class Chance : std::uint8_t { no, maybe, yes };

  bool holds(const FilterExpression& expression, const FilterFrame& frame);
  template <class Judge>
  Chance chance(const FilterExpression& expression, const Judge& judge);

  FilterExpression all_;
  std::vector<FilterCondition> conditions_;
  std::uint64_t seen_ = 0;
  std::uint64_t passed_ = 0;
};

}  // namespace canvoy::tools
