#include "canvoy/tools/filter/filter_literal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <set>
#include <string>

#include "canvoy/can/real_text.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

std::optional<FilterTime> parse_filter_time(std::string_view text) {
  if (const auto span = parse_duration(text)) return FilterTime{*span, true};
  // As in a line, but with a unit added.
  if (const auto seconds = parse_duration(std::string(text) + "s")) {
    return FilterTime{*seconds, false};
  }
  const auto day = text::parse_time_of_day(text);
  if (!day) return std::nullopt;
  const auto since_1970 = std::chrono::sys_days(time_of_day_epoch).time_since_epoch();
  return FilterTime{Duration(since_1970) + std::chrono::days(day->days) +
                        std::chrono::milliseconds(day->milliseconds),
                    false};
}

namespace {

/// A leading number, and the text after it.
struct FilterNumber {
  double number = 0;
  std::string_view rest = {};
};

std::string_view without_blanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  return text;
}

std::optional<FilterNumber> number_in_front(std::string_view text) {
  FilterNumber made;
  const char* const end = text.data() + text.size();
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [last, error] = real_from_chars(text.data(), end, made.number);
  if (error != std::errc{} || !std::isfinite(made.number)) return std::nullopt;
  made.rest = without_blanks(text.substr(static_cast<std::size_t>(last - text.data())));
  return made;
}

std::optional<std::int64_t> raw_number(std::string_view text) {
  const bool has_prefix = text.starts_with("0x") || text.starts_with("0X");
  if (has_prefix) {
    text.remove_prefix(2);
  } else if (text.ends_with('h') || text.ends_with('H')) {
    text.remove_suffix(1);
  } else {
    return std::nullopt;
  }
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number, 16);
  const bool is_number = error == std::errc{} && last == end && number >= 0;
  return is_number ? std::optional(number) : std::nullopt;
}

/// `6010`, `6010h`, `0x6010`; a word of four letters that are also digits is a name.
std::optional<std::int64_t> index_number(std::string_view text) {
  constexpr std::size_t digits = 4;
  const bool is_plain = text.size() == digits;
  if (is_plain && text.find_first_of("0123456789") == std::string_view::npos) return std::nullopt;
  if (!is_plain) {
    const bool has_prefix = text.size() == digits + 2 && text.starts_with("0x");
    const bool has_suffix = text.size() == digits + 1 && text.ends_with('h');
    if (!has_prefix && !has_suffix) return std::nullopt;
  }
  return raw_number(is_plain ? fmt::format("{}h", text) : std::string(text));
}

bool is_numeric(const FilterCandidate& candidate) {
  return is_integer(candidate.entry->type) || is_real(candidate.entry->type);
}

/// If the node gives the unit itself, any unit is possible.
bool may_be_in(const FilterCandidate& candidate, Unit unit) {
  if (!is_numeric(candidate)) return false;
  const ValueInfo& value = candidate.value();
  return value.unit_entry.index != 0 || conversion(unit, value.unit).has_value();
}

BitRange bits_of(const FilterCandidate& candidate) {
  return candidate.field != nullptr ? canvoy::bits_of(*candidate.field)
                                    : canvoy::bits_of(*candidate.entry);
}

/// The least and the greatest number in the bits, in the unit of the value; nothing if other
/// entries decide, or it is no integer.
std::optional<std::pair<double, double>> numbers_of(const FilterCandidate& candidate) {
  const ValueInfo& value = candidate.value();
  const bool is_told = value.unit_entry.index != 0 || value.step.index != 0;
  if (is_told || !value.pieces.empty() || !is_integer(candidate.entry->type)) return std::nullopt;
  const BitRange bits = bits_of(candidate);
  const double count = std::ldexp(1.0, static_cast<int>(bits.bits));
  const double low = to_physical(bits.is_signed ? -count / 2 : 0, value.scale);
  const double high = to_physical((bits.is_signed ? count / 2 : count) - 1, value.scale);
  return std::pair(std::min(low, high), std::max(low, high));
}

bool may_be(const FilterCandidate& candidate, const FilterLiteral& literal) {
  if (!is_numeric(candidate)) return false;
  const auto numbers = numbers_of(candidate);
  if (!numbers) return true;
  double factor = 1;
  if (literal.unit) {
    factor = conversion(literal.unit->unit, candidate.value().unit).value_or(0);
    if (factor == 0) return false;
    factor *= literal.unit->count;
  }
  // Printed values are rounded by less than this.
  const double margin = std::max(1.0, std::abs(numbers->second)) * 1e-3;
  return literal.low.number * factor <= numbers->second + margin &&
         literal.high.number * factor >= numbers->first - margin;
}

class FilterComparison {
 public:
  FilterComparison(const FilterClause& clause, const FilterNames& names, const FilterObject& object)
      : clause_(clause), has_name_(!object.name.empty()), candidates_(names.find(object)) {
    const auto is_amount = [](const FilterCandidate& found) { return found.is_amount(); };
    leaves_out_codes_ = has_name_ && std::ranges::any_of(candidates_, is_amount);
    if (!leaves_out_codes_) return;
    std::erase_if(candidates_, [](const FilterCandidate& candidate) {
      return candidate.value().notation == Notation::hexadecimal;
    });
  }

  /// For a name: amounts are preferred, if there are any.
  bool leaves_out_codes() const { return leaves_out_codes_; }

  std::vector<FilterLiteral> literals() const {
    std::vector<FilterLiteral> made;
    made.reserve(clause_.operands.size());
    for (const FilterOperand& operand : clause_.operands) made.push_back(literal(operand));
    return made;
  }

 private:
  bool is_equation() const {
    return clause_.comparison == FilterTokenKind::equal ||
           clause_.comparison == FilterTokenKind::unequal;
  }
  [[noreturn]] void refuse(const FilterPhrase& phrase, std::string_view problem) const {
    throw FilterError(clause_.filter, phrase.position, problem);
  }

  FilterLiteral literal(const FilterOperand& operand) const {
    if (!is_equation() && (operand.last || clause_.operands.size() > 1)) {
      refuse(operand.first, "one value is expected behind < and >");
    }
    FilterLiteral made = point(operand.first);
    if (operand.last) {
      extend(made, operand.first, *operand.last);
    } else if (!is_equation()) {
      open(made, operand.first);
    }
    if (made.kind == FilterLiteral::Kind::number) check(made, operand.first);
    return made;
  }

  /// A range; the unit may be given at the end only: `20..40degC`.
  void extend(FilterLiteral& made, const FilterPhrase& begin, const FilterPhrase& end) const {
    const FilterLiteral last = point(end);
    if (made.kind != last.kind || made.kind == FilterLiteral::Kind::word) {
      refuse(begin, "a range is from one number to another");
    }
    if (made.unit && !last.unit) refuse(end, "the end of the range needs the unit, too");
    if (made.unit && last.unit) {
      const auto units = conversion(made.unit->unit, last.unit->unit);
      if (!units) refuse(end, "both ends of a range have to be in the same unit");
      made.low.number *= *units * made.unit->count / last.unit->count;
    }
    made.unit = last.unit;
    made.high = last.high;
    made.raw.high = last.raw.high;
    if (made.low.number > made.high.number || made.raw.low > made.raw.high) {
      refuse(begin, "the range ends before it begins");
    }
  }

  void open(FilterLiteral& made, const FilterPhrase& phrase) const {
    if (made.kind == FilterLiteral::Kind::word) {
      refuse(phrase, fmt::format("'{}' is no number: words are compared with = or !=", made.word));
    }
    const bool is_below = clause_.comparison < FilterTokenKind::greater;
    const bool is_open = clause_.comparison == FilterTokenKind::less ||
                         clause_.comparison == FilterTokenKind::greater;
    if (is_below) {
      made.high.is_open = is_open;
      made.low = FilterLiteral{}.low;
      made.raw = {0, made.raw.high - (is_open ? 1 : 0)};
    } else {
      made.low.is_open = is_open;
      made.high = FilterLiteral{}.high;
      if (is_open && made.raw.low == FilterRange{}.high) refuse(phrase, "nothing is above it");
      made.raw = {made.raw.low + (is_open ? 1 : 0), FilterRange{}.high};
    }
  }

  /// A single value. Its meaning depends on the candidates: `10Ah` is a charge, or hexadecimal.
  FilterLiteral point(const FilterPhrase& phrase) const {
    if (has_state(phrase.text)) return word(phrase);
    const auto number = number_in_front(phrase.text);
    const auto unit = number ? find_filter_unit(number->rest) : std::nullopt;
    const bool has_own_unit = unit && has_unit(unit->unit);
    if (number && (number->rest.empty() || has_own_unit)) {
      FilterLiteral made;
      made.low.number = number->number;
      made.high.number = number->number;
      if (!number->rest.empty()) made.unit = unit;
      return made;
    }
    if (const auto raw = raw_number(phrase.text)) {
      FilterLiteral made{.kind = FilterLiteral::Kind::raw};
      made.raw = {*raw, *raw};
      return made;
    }
    if (may_be_text() || candidates_.empty()) return word(phrase);
    if (number && unit) refuse_unit(phrase, number->rest);
    if (number) {
      refuse(phrase, fmt::format("'{}' is no unit{}", number->rest,
                                 did_you_mean(number->rest, filter_unit_names())));
    }
    refuse_state(phrase);
  }

  static FilterLiteral word(const FilterPhrase& phrase) {
    FilterLiteral made{.kind = FilterLiteral::Kind::word};
    made.word = phrase.text;
    return made;
  }

  bool has_state(std::string_view text) const {
    return std::ranges::any_of(candidates_, [text](const FilterCandidate& candidate) {
      return std::ranges::any_of(candidate.value().names, [text](const NamedValue& named) {
        return same_name(named.name, text);
      });
    });
  }
  bool has_unit(Unit unit) const {
    return std::ranges::any_of(candidates_, [unit](const FilterCandidate& candidate) {
      return may_be_in(candidate, unit);
    });
  }
  /// Strings, times and bytes are compared in their printed form.
  bool may_be_text() const {
    return std::ranges::any_of(
        candidates_, [](const FilterCandidate& candidate) { return !is_numeric(candidate); });
  }

  [[noreturn]] void refuse_unit(const FilterPhrase& phrase, std::string_view unit) const {
    std::set<std::string_view> units;
    for (const FilterCandidate& candidate : candidates_) {
      if (candidate.value().unit != Unit::none) units.insert(symbol(candidate.value().unit));
    }
    refuse(phrase, fmt::format("'{}' is not in {}, but {}", clause_.subject.text, unit,
                               units.empty() ? "has no unit"
                                             : fmt::format("in {}", fmt::join(units, ", "))));
  }
  [[noreturn]] void refuse_state(const FilterPhrase& phrase) const {
    std::set<std::string> states;
    for (const FilterCandidate& candidate : candidates_) {
      for (const NamedValue& named : candidate.value().names) states.emplace(named.name);
    }
    refuse(phrase,
           fmt::format("no value of '{}' is called '{}'{}", clause_.subject.text, phrase.text,
                       did_you_mean(phrase.text, {states.begin(), states.end()})));
  }

  void check(const FilterLiteral& literal, const FilterPhrase& phrase) const {
    // An index may be that of an undescribed object.
    const bool may_hold = clause_.comparison == FilterTokenKind::unequal || !has_name_ ||
                          std::ranges::any_of(candidates_, [&](const FilterCandidate& candidate) {
                            return may_be(candidate, literal);
                          });
    if (may_hold) return;
    const auto numbers = numbers_of(candidates_.front());
    const bool is_one = candidates_.size() == 1 && numbers;
    refuse(phrase,
           fmt::format("'{}' is never so{}", clause_.text,
                       is_one ? fmt::format(": it is {} to {} {}", numbers->first, numbers->second,
                                            symbol(candidates_.front().value().unit))
                              : ""));
  }

  const FilterClause& clause_;
  bool has_name_;
  std::vector<FilterCandidate> candidates_;
  bool leaves_out_codes_ = false;
};

std::optional<FilterObject> numbered_object(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto index = index_number(text.substr(0, colon));
  if (!index) return std::nullopt;
  FilterObject made{.indices = FilterRange{*index, *index}};
  if (colon == std::string_view::npos) return made;
  std::string_view digits = text.substr(colon + 1);
  if (digits.ends_with('h')) digits.remove_suffix(1);
  constexpr std::size_t digits_max = 2;
  const auto sub = raw_number(fmt::format("{}h", digits));
  if (!sub || digits.size() > digits_max) return std::nullopt;
  made.sub = static_cast<std::uint8_t>(*sub);
  return made;
}

}  // namespace

FilterObject filter_object(const FilterClause& clause, const FilterPhrase& phrase,
                           const FilterNames& names) {
  if (const auto numbered = numbered_object(phrase.text)) return *numbered;
  FilterObject made{.name = plain_name(phrase.text)};
  if (!made.name.empty() && !names.find(made).empty()) return made;
  std::vector<std::string> known = {"bus",    "node", "id",   "service",
                                    "object", "text", "time", "marks"};
  for (const std::string& name : filter_services()) known.push_back(name);
  for (std::string& name : names.all()) known.push_back(std::move(name));
  throw FilterError(
      clause.filter, phrase.position,
      fmt::format("no object is called '{}'{}", phrase.text, did_you_mean(phrase.text, known)));
}

FilterObject filter_objects(const FilterClause& clause, const FilterOperand& operand) {
  const auto first = index_number(operand.first.text);
  const auto last = operand.last ? index_number(operand.last->text) : std::nullopt;
  if (!first || !last || *last < *first) {
    throw FilterError(clause.filter, operand.first.position,
                      "a range of objects is from one index to another: 6000..67FF");
  }
  return {.indices = FilterRange{*first, *last}};
}

void compare(FilterValue& value, const FilterClause& clause, const FilterNames& names) {
  const FilterComparison comparison(clause, names, value.object());
  value.compare(clause.comparison == FilterTokenKind::unequal, comparison.literals());
  if (comparison.leaves_out_codes()) value.leave_out_codes();
}

}  // namespace canvoy::tools
