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

std::vector<std::string_view> Filter::never_true() const {
  std::vector<std::string_view> texts;
  for (const FilterCondition& condition : conditions_) {
    if (!condition.was_true) texts.push_back(condition.written);
  }
  return texts;
}

}  // namespace canvoy::tools
