#include "canvoy/tools/filter/filter_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <limits>
#include <map>
#include <optional>

#include "canvoy/tools/filter/filter_operand.hpp"

namespace canvoy::tools {

namespace {

/// With more alternatives, the search ends.
constexpr std::size_t spaces_max = 64;
constexpr unsigned services_max = 1200;
constexpr unsigned numbers_of_pdo = 512;

using FilterServices = std::bitset<services_max>;

/// The service names of frames, in plain form.
const std::vector<std::string>& all_services() {
  static const auto made = [] {
    std::vector<std::string> services;
    for (const std::string& name : filter_services()) {
      const std::string plain = plain_name(name);
      if (!plain.ends_with('#')) {
        services.push_back(plain);
        continue;
      }
      for (unsigned number = 1; number <= numbers_of_pdo; ++number) {
        services.push_back(plain.substr(0, plain.size() - 1) + std::to_string(number));
      }
    }
    return services;
  }();
  return made;
}

template <class Is>
FilterServices services_where(const Is& is) {
  FilterServices made;
  const std::vector<std::string>& all = all_services();
  for (std::size_t i = 0; i < all.size(); ++i) made.set(i, is(all[i]));
  return made;
}

bool has_values(const std::string& service) {
  return service.find("pdo") != std::string::npos || service.find("sdo r") == 0;
}
/// Some PDOs of CiA 407 and 417 have no node, others have one.
bool has_node(const std::string& service) {
  for (const char* name : {"nmt", "sync", "time", "29 bit frame", "error frame"}) {
    if (service == name) return false;
  }
  return true;
}
bool has_can_id(const std::string& service) {
  return service != "error frame";
}

const FilterServices& every_service() {
  static const FilterServices made = services_where([](const std::string&) { return true; });
  return made;
}

/// An amount of one object, in one unit.
struct FilterInterval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::optional<Unit> unit = {};
};

/// Properties of the frames that pass one alternative of a filter.
struct FilterSpace {
  std::optional<std::vector<std::string>> buses = {};  ///< nothing: all
  std::vector<std::string> other_buses = {};           ///< excluded ones
  FilterRanges ids = FilterRanges::all();
  FilterRanges times = FilterRanges::all();
  FilterRanges spans = FilterRanges::all();
  FilterServices services = every_service();
  std::vector<std::pair<FilterObject, FilterInterval>> amounts = {};
  bool is_narrowed = false;
};

/// The range of numbers for a value; nothing if it is not a single range.
std::optional<FilterInterval> interval_of(const FilterValue& value) {
  if (!value.compares() || value.is_negated() || value.literals().size() != 1) return std::nullopt;
  const FilterLiteral& literal = value.literals().front();
  if (literal.kind != FilterLiteral::Kind::number) return std::nullopt;
  FilterInterval made{literal.low.number, literal.high.number, std::nullopt};
  if (literal.unit) {
    made.unit = literal.unit->unit;
    made.low *= literal.unit->count;
    made.high *= literal.unit->count;
  }
  // Maximum rounding of a printed value.
  constexpr double margin = 0.5;
  if (!literal.low.is_open) made.low -= margin;
  if (!literal.high.is_open) made.high += margin;
  return made;
}

/// True if a frame has at most one such value: each profile has only one, and a frame belongs to
/// one profile.
bool is_one(const FilterObject& object, const FilterNames& names) {
  if (object.indices && object.indices->low == object.indices->high && object.sub) return true;
  const std::vector<FilterCandidate> candidates = names.find(object);
  std::map<const Profile*, unsigned> counts;
  for (const FilterCandidate& found : candidates) {
    const bool is_single = found.object->count == 1 && found.profile->block_count == 1 &&
                           found.entry->last_sub() == found.entry->sub_first;
    if (!is_single || ++counts[found.profile] > 1) return false;
  }
  return !counts.empty();
}

bool narrow_amount(FilterSpace& space, const FilterObject& object, const FilterInterval& wanted) {
  for (auto& [known, interval] : space.amounts) {
    if (known != object || interval.unit != wanted.unit) continue;
    interval.low = std::max(interval.low, wanted.low);
    interval.high = std::min(interval.high, wanted.high);
    return interval.low <= interval.high;
  }
  space.amounts.emplace_back(object, wanted);
  return true;
}

/// Requirements of a condition, determined once.
struct FilterDemand {
  FilterServices services;                    ///< of frames for which it may be true
  std::optional<FilterInterval> amount = {};  ///< of the only value of its object
};

FilterDemand demand_of(const FilterCondition& condition, const FilterNames& names) {
  static const FilterServices with_values = services_where(has_values);
  static const FilterServices with_node = services_where(has_node);
  static const FilterServices with_can_id = services_where(has_can_id);
  if (condition.by == FilterBy::node) return {with_node};
  if (condition.by == FilterBy::can_id) return {with_can_id};
  if (condition.by == FilterBy::service) {
    return {services_where([&](const std::string& service) {
      return std::ranges::any_of(condition.names,
                                 [&](const std::string& name) { return has_name(service, name); });
    })};
  }
  if (condition.by != FilterBy::value) return {every_service()};
  FilterDemand made{with_values, interval_of(condition.value)};
  if (made.amount && !is_one(condition.value.object(), names)) made.amount.reset();
  return made;
}

class FilterSearch {
 public:
  FilterSearch(const std::vector<FilterCondition>& conditions, const FilterNames& names)
      : conditions_(conditions) {
    for (const FilterCondition& condition : conditions) {
      demands_.push_back(demand_of(condition, names));
    }
  }

  /// Reason why no frame passes, or an empty text.
  std::string search(const FilterExpression& expression) {
    const std::vector<FilterSpace> spaces = narrow({FilterSpace{}}, expression, true);
    return spaces.empty() && !gave_up_ ? reason_ : "";
  }

 private:
  using FilterSpaces = std::vector<FilterSpace>;

  FilterSpaces narrow(FilterSpaces spaces, const FilterExpression& expression, bool is_true) {
    if (gave_up_) return spaces;
    using enum FilterExpression::Kind;
    if (expression.kind == none) return narrow(std::move(spaces), expression.parts[0], !is_true);
    if (expression.kind == condition) {
      std::erase_if(spaces, [&](FilterSpace& space) {
        return !narrow(space, expression.condition, is_true);
      });
      return spaces;
    }
    // A negated conjunction: one of its parts is negated.
    if ((expression.kind == all) == is_true) {
      for (const FilterExpression& part : expression.parts) {
        spaces = narrow(std::move(spaces), part, is_true);
      }
      return spaces;
    }
    FilterSpaces made;
    for (const FilterExpression& part : expression.parts) {
      for (FilterSpace& space : narrow(spaces, part, is_true)) made.push_back(std::move(space));
      gave_up_ = gave_up_ || made.size() > spaces_max;
      if (gave_up_) break;
    }
    return made;
  }

  bool narrow(FilterSpace& space, std::size_t place, bool is_true) {
    const FilterCondition& condition = conditions_[place];
    if (narrow_by(space, condition, demands_[place], is_true)) {
      space.is_narrowed = true;
      return true;
    }
    if (reason_.empty()) {
      reason_ = fmt::format("'{}' {}", condition.written,
                            space.is_narrowed ? "excludes what it is joined with" : "is never so");
    }
    return false;
  }

  static bool narrow_by(FilterSpace& space, const FilterCondition& condition,
                        const FilterDemand& demand, bool is_true) {
    if (is_true) {
      space.services &= demand.services;
    } else if (condition.by == FilterBy::service) {
      space.services &= ~demand.services;
    }
    if (space.services.none()) return false;
    switch (condition.by) {
      case FilterBy::bus:
        return narrow_buses(space, condition.names, is_true);
      case FilterBy::can_id:
        // An error frame has no CAN-ID, so a negated CAN-ID condition is true for it.
        return !is_true || narrow_ranges(space.ids, condition.ranges, true);
      case FilterBy::value:
        return !is_true || !demand.amount ||
               narrow_amount(space, condition.value.object(), *demand.amount);
      case FilterBy::time:
        return narrow_ranges(space.times, condition.ranges, is_true);
      case FilterBy::since_first:
        return narrow_ranges(space.spans, condition.ranges, is_true);
      case FilterBy::node:
      case FilterBy::service:
      case FilterBy::text:
      case FilterBy::marks:
        break;
    }
    return true;
  }

  static bool narrow_ranges(FilterRanges& own, const FilterRanges& ranges, bool is_true) {
    own = own.common(is_true ? ranges : ranges.others());
    return !own.empty();
  }
  static bool narrow_buses(FilterSpace& space, const std::vector<std::string>& names,
                           bool is_true) {
    if (!is_true) {
      space.other_buses.insert(space.other_buses.end(), names.begin(), names.end());
    } else if (!space.buses) {
      space.buses = names;
    } else {
      std::erase_if(*space.buses, [&](const std::string& bus) {
        return std::ranges::find(names, bus) == names.end();
      });
    }
    if (!space.buses) return true;
    std::erase_if(*space.buses, [&](const std::string& bus) {
      return std::ranges::find(space.other_buses, bus) != space.other_buses.end();
    });
    return !space.buses->empty();
  }

  const std::vector<FilterCondition>& conditions_;
  std::vector<FilterDemand> demands_;
  bool gave_up_ = false;
  std::string reason_;
};

}  // namespace

std::string find_contradiction(const FilterExpression& expression,
                               const std::vector<FilterCondition>& conditions,
                               const FilterNames& names) {
  return FilterSearch(conditions, names).search(expression);
}

}  // namespace canvoy::tools
