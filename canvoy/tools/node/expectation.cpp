#include "canvoy/tools/node/expectation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

using Comparison = Expectation::Comparison;

std::string without_edges(std::string_view text) {
  return std::string(formats::trimmed(text));
}

bool is_about_equality(Comparison comparison) {
  return comparison == Comparison::equal || comparison == Comparison::unequal;
}

bool compare_numbers(double left, Comparison comparison, double right) {
  constexpr double tolerance = 1e-9;
  const double margin = tolerance * std::max({1.0, std::abs(left), std::abs(right)});
  const bool is_equal = std::abs(left - right) <= margin;
  switch (comparison) {
    case Comparison::equal:
      return is_equal;
    case Comparison::unequal:
      return !is_equal;
    case Comparison::less:
      return left < right && !is_equal;
    case Comparison::at_most:
      return left < right || is_equal;
    case Comparison::greater:
      return left > right && !is_equal;
    case Comparison::at_least:
      return left > right || is_equal;
  }
  return false;
}

/// An undescribed entry: a number of this size.
EntryInfo plain_entry(std::size_t size) {
  using enum DataType;
  constexpr std::array types = {unsigned8,  unsigned16, unsigned24, unsigned32,
                                unsigned40, unsigned48, unsigned56, unsigned64};
  if (size == 0 || size > types.size()) return EntryInfo{.type = octet_string};
  return EntryInfo{.type = types.at(size - 1)};
}

const ValueInfo& value_info_of(const EntryInfo& entry) {
  const FieldInfo* only = only_field(entry);
  return only != nullptr ? only->value : entry.value;
}

Reading reading_of(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  const FieldInfo* only = only_field(entry);
  return only != nullptr ? read_field(entry, *only, bytes) : read_value(entry, bytes);
}

struct ExpectedRange {
  std::string first;
  std::string last;
};

/// The ends of `20..30degC`; the first one takes the unit of the last if it has none. Nothing if
/// the text is no range.
std::optional<ExpectedRange> range_of(std::string_view text) {
  constexpr std::string_view digits = "0123456789.";
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  ExpectedRange made{without_edges(text.substr(0, dots)), without_edges(text.substr(dots + 2))};
  const std::size_t unit = made.last.find_last_of(digits) + 1;
  const bool is_plain = made.first.find_first_not_of("+-0123456789.") == std::string::npos;
  if (is_plain && !made.first.empty()) made.first += made.last.substr(unit);
  return made;
}

/// Nothing: not a range of numbers of this value.
std::optional<std::pair<double, double>> amounts_of(const ValueInfo& value, std::string_view text) {
  const auto range = range_of(text);
  if (!range) return std::nullopt;
  const auto low = parse_amount(value, range->first);
  const auto high = parse_amount(value, range->last);
  if (!low || !high) return std::nullopt;
  if (*low > *high) throw UsageError(fmt::format("'{}': the range ends before it begins", text));
  return std::pair(*low, *high);
}

/// `OBJECT in 20..30degC`; nothing for another form.
std::optional<Expectation> parse_membership(std::string_view text) {
  constexpr std::string_view word = " in ";
  const std::size_t at = text.rfind(word);
  if (at == std::string_view::npos) return std::nullopt;
  Expectation made{.object = without_edges(text.substr(0, at)),
                   .value = without_edges(text.substr(at + word.size())),
                   .is_range = true};
  const bool is_understood = !made.object.empty() && range_of(made.value).has_value();
  return is_understood ? std::optional(std::move(made)) : std::nullopt;
}

}  // namespace

bool Expectation::holds(const EntryInfo* known, std::span<const std::uint8_t> bytes) const {
  const EntryInfo entry = known != nullptr ? *known : plain_entry(bytes.size());
  const bool is_number = is_integer(entry.type) || is_real(entry.type);
  const auto range = is_number && is_about_equality(comparison)
                         ? amounts_of(value_info_of(entry), value)
                         : std::nullopt;
  if (range) {
    const Reading reading = reading_of(entry, bytes);
    const bool is_in = reading.kind == Reading::Kind::number &&
                       compare_numbers(reading.number, Comparison::at_least, range->first) &&
                       compare_numbers(reading.number, Comparison::at_most, range->second);
    return is_in == (comparison == Comparison::equal);
  }
  if (is_range) {
    const std::string_view unit = symbol(value_info_of(entry).unit);
    throw UsageError(fmt::format("'{}' is no range of numbers{}{}: write FROM..TO", value,
                                 unit.empty() ? " here" : " in ", unit));
  }
  const auto amount = is_number ? parse_amount(value_info_of(entry), value) : std::nullopt;
  if (amount) {
    const Reading reading = reading_of(entry, bytes);
    // A sentinel is no number, and thus unequal to any.
    if (reading.kind != Reading::Kind::number) return comparison == Comparison::unequal;
    return compare_numbers(reading.number, comparison, *amount);
  }
  if (!is_about_equality(comparison)) {
    const std::string_view unit = symbol(value_info_of(entry).unit);
    throw UsageError(fmt::format("'{}' is no number{}{}: words are compared with = or !=", value,
                                 unit.empty() ? " here" : " in ", unit));
  }
  const std::string text = text::value_text(&entry, bytes);
  const bool says_so = same_name(text, value) || text == '"' + value + '"';
  if (says_so) return comparison == Comparison::equal;
  const std::vector<std::uint8_t> wanted = parse_value(entry, value);
  return std::ranges::equal(wanted, bytes) == (comparison == Comparison::equal);
}

std::optional<Duration> take_span(std::string& text, std::string_view word) {
  const std::string behind = fmt::format(" {} ", word);
  const std::size_t at = text.rfind(behind);
  // Quoted text is not parsed.
  const std::size_t quote = text.find_last_of("\"'");
  const bool is_text = quote != std::string::npos && at < quote;
  if (at == std::string::npos || is_text) return std::nullopt;
  const Duration time = parse_duration_argument(without_edges(text.substr(at + behind.size())));
  text = without_edges(text.substr(0, at));
  return time;
}

Expectation parse_expectation(std::string_view given) {
  std::string text(given);
  Expectation made;
  made.within = take_span(text, "within");
  if (!made.within) made.holding = take_span(text, "for");
  const std::size_t sign = text.find_first_of("=!<>");
  const auto refuse = [given] {
    throw UsageError(fmt::format(
        "'{}' is not understood: write OBJECT > VALUE within 2s, with =, !=, <, <=, > or >=, or "
        "OBJECT in FROM..TO",
        given));
  };
  if (sign == std::string::npos) {
    auto membership = parse_membership(text);
    if (!membership) refuse();
    membership->within = made.within;
    membership->holding = made.holding;
    return *std::move(membership);
  }
  if (sign == 0) refuse();
  const char first = text[sign];
  std::size_t end = sign + 1;
  const bool has_equal_sign = end < text.size() && text[end] == '=';
  if (has_equal_sign) ++end;
  if (first == '!' && !has_equal_sign) refuse();
  made.comparison = first == '='   ? Comparison::equal
                    : first == '!' ? Comparison::unequal
                    : first == '<' ? (has_equal_sign ? Comparison::at_most : Comparison::less)
                                   : (has_equal_sign ? Comparison::at_least : Comparison::greater);
  made.object = without_edges(text.substr(0, sign));
  made.value = without_edges(text.substr(end));
  if (made.object.empty() || made.value.empty()) refuse();
  return made;
}

}  // namespace canvoy::tools
