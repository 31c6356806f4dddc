#include "canvoy/tools/filter/filter_token.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace canvoy::tools {

namespace {

constexpr std::size_t filter_length_max = 4096;

bool is_white(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool is_word_end(std::string_view rest) {
  constexpr std::string_view signs = "()<>=!&|,\"";
  return is_white(rest.front()) || signs.find(rest.front()) != std::string_view::npos ||
         rest.starts_with("..");
}

struct FilterSign {
  std::string_view text;
  FilterTokenKind kind;
};

/// If two begin alike, the longer one is first.
constexpr auto signs = std::to_array<FilterSign>({
    {"..", FilterTokenKind::to},
    {"==", FilterTokenKind::equal},
    {"=", FilterTokenKind::equal},
    {"!=", FilterTokenKind::unequal},
    {"!", FilterTokenKind::not_},
    {"<=", FilterTokenKind::less_or_equal},
    {"<", FilterTokenKind::less},
    {">=", FilterTokenKind::greater_or_equal},
    {">", FilterTokenKind::greater},
    {"&&", FilterTokenKind::and_},
    {"&", FilterTokenKind::and_},
    {"||", FilterTokenKind::or_},
    {"|", FilterTokenKind::or_},
    {"(", FilterTokenKind::open},
    {")", FilterTokenKind::close},
    {",", FilterTokenKind::comma},
});

constexpr auto words_of_logic = std::to_array<FilterSign>({
    {"and", FilterTokenKind::and_},
    {"or", FilterTokenKind::or_},
    {"not", FilterTokenKind::not_},
});

bool is_same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return x == y || (x | 0x20) == y; });
}

FilterTokenKind kind_of_word(std::string_view word) {
  for (const FilterSign& sign : words_of_logic) {
    if (is_same_word(word, sign.text)) return sign.kind;
  }
  return FilterTokenKind::word;
}

class FilterScanner {
 public:
  explicit FilterScanner(std::string_view filter) : filter_(filter) {}

  FilterToken next() {
    while (at_ < filter_.size() && is_white(filter_[at_])) ++at_;
    if (at_ == filter_.size()) return {FilterTokenKind::end, at_, at_, {}};
    if (filter_[at_] == '"' || filter_[at_] == '\'') return quoted();
    for (const FilterSign& sign : signs) {
      if (filter_.substr(at_).starts_with(sign.text)) return take(sign.kind, sign.text.size());
    }
    std::size_t size = 1;
    while (at_ + size < filter_.size() && !is_word_end(filter_.substr(at_ + size))) ++size;
    return take(kind_of_word(filter_.substr(at_, size)), size);
  }

 private:
  FilterToken take(FilterTokenKind kind, std::size_t size) {
    at_ += size;
    return {kind, at_ - size, at_, filter_.substr(at_ - size, size)};
  }
  FilterToken quoted() {
    const std::size_t end = filter_.find(filter_[at_], at_ + 1);
    if (end == std::string_view::npos) {
      throw FilterError(filter_, at_, "the quote that begins here has no end");
    }
    const std::size_t begin = at_;
    at_ = end + 1;
    return {FilterTokenKind::quoted, begin, at_, filter_.substr(begin + 1, end - begin - 1)};
  }

  std::string_view filter_;
  std::size_t at_ = 0;
};

/// Number of UTF-8 characters that begin before the byte, plus one.
std::size_t character_at(std::string_view text, std::size_t position) {
  return 1 + static_cast<std::size_t>(std::ranges::count_if(
                 text.substr(0, position), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

FilterError::FilterError(std::string_view filter, std::size_t position, std::string_view problem)
    : UsageError(fmt::format("filter '{}', character {}: {}", filter,
                             character_at(filter, position), problem)) {}

std::vector<FilterToken> filter_tokens(std::string_view filter) {
  if (filter.size() > filter_length_max) {
    throw UsageError(fmt::format("a filter has at most {} bytes", filter_length_max));
  }
  FilterScanner scanner(filter);
  std::vector<FilterToken> tokens;
  do {
    tokens.push_back(scanner.next());
  } while (tokens.back().kind != FilterTokenKind::end);
  return tokens;
}

}  // namespace canvoy::tools
