#include "canvoy/tools/filter/filter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/filter/filter_parser.hpp"
#include "canvoy/tools/filter/filter_space.hpp"

namespace canvoy::tools {

void Filter::add(std::string_view text, const FilterNames& names) {
  all_.parts.push_back(parse_filter(text, names, conditions_));
  const std::string problem = find_contradiction(all_, conditions_, names);
  if (!problem.empty()) {
    throw UsageError(fmt::format("filter '{}': no frame can pass: {}", text, problem));
  }
}

bool Filter::passes(const FilterFrame& frame) {
  ++seen_;
  if (passed_ == 0) {
    for (FilterCondition& condition : conditions_) {
      if (!condition.was_true) condition.was_true = condition.holds(frame);
    }
  }
  const bool passes = holds(all_, frame);
  passed_ += passes ? 1 : 0;
  return passes;
}

bool Filter::holds(const FilterExpression& expression, const FilterFrame& frame) {
  const auto part_holds = [&](const FilterExpression& part) { return holds(part, frame); };
  switch (expression.kind) {
    case FilterExpression::Kind::all:
      return std::ranges::all_of(expression.parts, part_holds);
    case FilterExpression::Kind::any:
      return std::ranges::any_of(expression.parts, part_holds);
    case FilterExpression::Kind::none:
      return std::ranges::none_of(expression.parts, part_holds);
    case FilterExpression::Kind::condition:
      return conditions_[expression.condition].holds(frame);
  }
  return false;
}

/// `judge` tells the chance of a condition.
template <class Judge>
Filter::Chance Filter::chance(const FilterExpression& expression, const Judge& judge) {
  if (expression.kind == FilterExpression::Kind::condition) {
    return judge(conditions_[expression.condition]);
  }
  if (expression.kind == FilterExpression::Kind::none) {
    const Chance part = chance(expression.parts[0], judge);
    return part == Chance::maybe ? part : part == Chance::no ? Chance::yes : Chance::no;
  }
  const bool is_all = expression.kind == FilterExpression::Kind::all;
  Chance whole = is_all ? Chance::yes : Chance::no;
  for (const FilterExpression& part : expression.parts) {
    const Chance own = chance(part, judge);
    whole = is_all ? std::min(whole, own) : std::max(whole, own);
  }
  return whole;
}

bool Filter::may_pass(const FilterFrame& frame) {
  return chance(all_, [&frame](FilterCondition& condition) {
           const bool is_known = condition.by == FilterBy::bus || condition.by == FilterBy::node ||
                                 condition.by == FilterBy::service ||
                                 (condition.by == FilterBy::can_id && !frame.frame.is_extended());
           if (!is_known) return Chance::maybe;
           return condition.holds(frame) ? Chance::yes : Chance::no;
         }) != Chance::no;
}

bool Filter::may_pass(Duration from, Duration to, Duration first) {
  return chance(all_, [&](const FilterCondition& condition) {
           const bool is_since = condition.by == FilterBy::since_first;
           if (!is_since && condition.by != FilterBy::time) return Chance::maybe;
           const Duration zero = is_since ? first : Duration{};
           const FilterRanges span({(from - zero).count(), (to - zero).count()});
           if (condition.ranges.common(span).empty()) return Chance::no;
           return condition.ranges.others().common(span).empty() ? Chance::yes : Chance::maybe;
         }) != Chance::no;
}

std::vector<std::string_view> Filter::never_true() const {
  std::vector<std::string_view> texts;
  for (const FilterCondition& condition : conditions_) {
    if (!condition.was_true) texts.push_back(condition.written);
  }
  return texts;
}

}  // namespace canvoy::tools
