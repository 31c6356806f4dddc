// Names of entries and fields, which may contain a number: in a description, `#` stands for it.
//
//     is_named("TPDO # mapping parameter", 20, "TPDO 20 mapping parameter")  // true
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace canvoy {

/// A name, of an entry or a field, as a template argument.
template <std::size_t size>
struct Name {
  char characters[size]{};  ///< ends with 0

  /// Copies a literal.
  constexpr Name(const char (&text)[size]) {  // NOLINT(google-explicit-constructor)
    std::copy_n(text, size, characters);
  }
  /// The name without its final 0.
  constexpr std::string_view text() const { return {characters, size - 1}; }
};

/// True if decimal digits, without leading zeros, are this number.
constexpr bool is_decimal(std::string_view digits, unsigned number) {
  if (digits.empty() || (digits.front() == '0' && digits.size() > 1)) return false;
  for (; !digits.empty(); digits.remove_suffix(1), number /= 10) {
    if (digits.back() != static_cast<char>('0' + number % 10)) return false;
    if (number == 0 && digits.size() > 1) return false;
  }
  return number == 0;
}

/// True if `text` is a described name with its number inserted, or the described name itself.
constexpr bool is_named(std::string_view described, unsigned number, std::string_view text) {
  if (described == text) return true;
  const std::size_t place = described.find('#');
  if (place == std::string_view::npos) return false;
  const std::string_view front = described.substr(0, place);
  const std::string_view back = described.substr(place + 1);
  if (text.size() <= front.size() + back.size()) return false;
  if (!text.starts_with(front) || !text.ends_with(back)) return false;
  text.remove_prefix(front.size());
  text.remove_suffix(back.size());
  return is_decimal(text, number);
}

}  // namespace canvoy
