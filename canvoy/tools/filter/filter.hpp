// Which frames are shown: `--filter` of canvoy decode and monitor. docs/decode.md has the grammar.
//
//     Filter filter;
//     filter.add("node=10 and temperature>40degC", names);
//     if (filter.passes({.time = time, .bus = "can0", .frame = frame, .words = words})) show();
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

class Filter {
 public:
  /// Another expression that has to hold, too. Throws UsageError with one line: where it cannot be
  /// understood, names what nothing is called, or can hold for no frame.
  void add(std::string_view text, const FilterNames& names);
  bool empty() const { return all_.parts.empty(); }

  /// An empty filter lets all pass.
  bool passes(const FilterFrame& frame);

  /// How many frames were looked at, and how many have passed.
  std::uint64_t seen() const { return seen_; }
  std::uint64_t passed() const { return passed_; }
  /// The conditions that held for no frame, as they were written; only where none has passed.
  std::vector<std::string_view> never_true() const;

 private:
  bool holds(const FilterExpression& expression, const FilterFrame& frame);

  FilterExpression all_;
  std::vector<FilterCondition> conditions_;
  std::uint64_t seen_ = 0;
  std::uint64_t passed_ = 0;
};

}  // namespace canvoy::tools
