// Sets of integers as ranges: the node-IDs, CAN-IDs and times that a filter passes.
//
//     FilterRanges ids({0x180, 0x1FF});
//     ids.contains(0x18A);
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace canvoy::tools {

/// From `low` to `high`, inclusive.
struct FilterRange {
  std::int64_t low = std::numeric_limits<std::int64_t>::min();
  std::int64_t high = std::numeric_limits<std::int64_t>::max();
  friend bool operator==(const FilterRange&, const FilterRange&) = default;
};

class FilterRanges {
 public:
  /// Makes an empty set.
  FilterRanges() = default;
  /// Makes a set of one range; empty if low is above high.
  explicit FilterRanges(FilterRange range) { add(range); }
  static FilterRanges all() { return FilterRanges(FilterRange{}); }

  bool empty() const { return ranges_.empty(); }
  bool contains(std::int64_t number) const {
    return std::ranges::any_of(ranges_, [number](const FilterRange& range) {
      return number >= range.low && number <= range.high;
    });
  }
  void add(FilterRange range) {
    if (range.low <= range.high) ranges_.push_back(range);
  }
  /// The numbers in both sets.
  FilterRanges common(const FilterRanges& others) const {
    FilterRanges made;
    for (const FilterRange& a : ranges_) {
      for (const FilterRange& b : others.ranges_) {
        made.add({std::max(a.low, b.low), std::min(a.high, b.high)});
      }
    }
    return made;
  }
  /// The numbers that are not in the set.
  FilterRanges others() const {
    FilterRanges made = all();
    for (const FilterRange& range : ranges_) {
      FilterRanges outside;
      if (range.low != FilterRange{}.low) outside.add({FilterRange{}.low, range.low - 1});
      if (range.high != FilterRange{}.high) outside.add({range.high + 1, FilterRange{}.high});
      made = made.common(outside);
    }
    return made;
  }

 private:
  std::vector<FilterRange> ranges_;
};

}  // namespace canvoy::tools
