#include "canvoy/tools/filter/filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/filter/filter_operand.hpp"
#include "canvoy/tools/filter/filter_space.hpp"
#include "canvoy/tools/filter/filter_token.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

namespace {

// Parses a filter: conditions (`node=5`, `temperature>40degC`), combined with and, or, not,
// parentheses.

/// Maximum nesting of parentheses and `not`.
inline constexpr unsigned filter_depth_max = 64;

inline constexpr unsigned filter_conditions_max = 64;

bool is_comparison(FilterTokenKind kind) {
  return kind >= FilterTokenKind::equal && kind <= FilterTokenKind::greater_or_equal;
}

class FilterParser {
 public:
  FilterParser(std::string_view filter, const FilterNames& names,
               std::vector<FilterCondition>& conditions)
      : filter_(filter), names_(names), conditions_(conditions), tokens_(filter_tokens(filter)) {}

  FilterExpression parse() {
    if (token().kind == FilterTokenKind::end) fail("it is empty");
    FilterExpression expression = parse_any();
    if (token().kind == FilterTokenKind::close) fail("this parenthesis was not opened");
    if (token().kind != FilterTokenKind::end)
      fail(fmt::format("'{}' does not belong here", token().text));
    return expression;
  }

 private:
  const FilterToken& token() const { return tokens_[next_]; }
  [[noreturn]] void fail(std::string_view problem) const {
    throw FilterError(filter_, token().position, problem);
  }
  bool take(FilterTokenKind kind) {
    if (token().kind != kind) return false;
    ++next_;
    return true;
  }

  FilterExpression parse_any() {
    FilterExpression made{.kind = FilterExpression::Kind::any};
    do {
      made.parts.push_back(parse_all());
    } while (take(FilterTokenKind::or_));
    return made.parts.size() == 1 ? FilterExpression(std::move(made.parts.front())) : made;
  }
  FilterExpression parse_all() {
    FilterExpression made{.kind = FilterExpression::Kind::all};
    do {
      made.parts.push_back(parse_one());
    } while (take(FilterTokenKind::and_));
    return made.parts.size() == 1 ? FilterExpression(std::move(made.parts.front())) : made;
  }
  FilterExpression parse_one() {
    if (depth_ == filter_depth_max) {
      fail(fmt::format("more than {} parentheses and 'not' in each other", filter_depth_max));
    }
    ++depth_;
    FilterExpression made;
    if (take(FilterTokenKind::not_)) {
      made.kind = FilterExpression::Kind::none;
      made.parts.push_back(parse_one());
    } else if (token().kind == FilterTokenKind::open) {
      made = parse_parentheses();
    } else {
      made = parse_condition();
    }
    --depth_;
    return made;
  }
  FilterExpression parse_parentheses() {
    const std::size_t opened = token().position;
    ++next_;
    FilterExpression made = parse_any();
    if (take(FilterTokenKind::close)) return made;
    if (token().kind != FilterTokenKind::end)
      fail(fmt::format("'{}' does not belong here", token().text));
    throw FilterError(filter_, opened, "this parenthesis is not closed");
  }

  FilterExpression parse_condition() {
    FilterClause clause{.filter = filter_};
    clause.subject = take_words(true, "a condition is expected: node=5, temperature>40");
    if (is_comparison(token().kind)) {
      clause.comparison = token().kind;
      ++next_;
      do {
        clause.operands.push_back(take_operand());
      } while (take(FilterTokenKind::comma));
      if (is_comparison(token().kind)) {
        --next_;
        fail(fmt::format("'and' or 'or' is missing in front of '{}'", token().text));
      }
    }
    const std::size_t begin = clause.subject.position;
    clause.text = filter_.substr(begin, tokens_[next_ - 1].behind - begin);
    if (++count_ > filter_conditions_max) {
      throw FilterError(filter_, begin,
                        fmt::format("a filter has at most {} conditions", filter_conditions_max));
    }
    FilterCondition condition = understand(clause, names_);
    FilterExpression made{.kind = FilterExpression::Kind::condition};
    made.condition = conditions_.size();
    conditions_.push_back(std::move(condition));
    const bool is_of_value = conditions_.back().by == FilterCondition::By::value;
    if (clause.comparison != FilterTokenKind::unequal || is_of_value) return made;
    FilterExpression others{.kind = FilterExpression::Kind::none};
    others.parts.push_back(std::move(made));
    return others;
  }

  FilterOperand take_operand() {
    FilterOperand operand{take_words(false, "a value is expected"), std::nullopt};
    if (take(FilterTokenKind::to))
      operand.last = take_words(false, "the end of a range is expected");
    return operand;
  }

  /// Consecutive words are one, with blanks.
  FilterPhrase take_words(bool with_commas, std::string_view expected) {
    FilterPhrase phrase{.position = token().position};
    phrase.is_quoted = token().kind == FilterTokenKind::quoted;
    while (true) {
      if (token().kind == FilterTokenKind::word || token().kind == FilterTokenKind::quoted) {
        const bool is_first = phrase.text.empty() || phrase.text.ends_with(", ");
        if (!is_first) phrase.text += ' ';
        phrase.text += token().text;
      } else if (with_commas && token().kind == FilterTokenKind::comma && !phrase.text.empty()) {
        phrase.text += ", ";
      } else {
        break;
      }
      ++next_;
    }
    if (phrase.text.empty() && !phrase.is_quoted) fail(expected);
    return phrase;
  }

  std::string_view filter_;
  const FilterNames& names_;
  std::vector<FilterCondition>& conditions_;
  std::vector<FilterToken> tokens_;
  std::size_t next_ = 0;
  unsigned depth_ = 0;
  unsigned count_ = 0;
};

/// Adds the conditions to the existing ones. Throws FilterError with position, reason and
/// suggestions; also if a condition can be true for no frame.
FilterExpression parse_filter(std::string_view filter, const FilterNames& names,
                              std::vector<FilterCondition>& conditions) {
  return FilterParser(filter, names, conditions).parse();
}

}  // namespace

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
