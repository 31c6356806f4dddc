// Words and numbers at the front of a line of a trace. The functions run for every frame of files
// of gigabytes: they are inline and read each character once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace canvoy::formats {

inline constexpr std::uint8_t no_hex_digit = 0xFF;  ///< entry of hex_digits

/// The value of each character as a hexadecimal digit.
inline constexpr std::array<std::uint8_t, 256> hex_digits = [] {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(no_hex_digit);
  for (std::uint8_t value = 0; value < 10; ++value) digits[std::size_t{'0'} + value] = value;
  for (std::uint8_t value = 10; value < 16; ++value) {
    digits[std::size_t{'A'} + value - 10] = value;
    digits[std::size_t{'a'} + value - 10] = value;
  }
  return digits;
}();

/// Value of a digit of either case, or no_hex_digit.
inline std::uint8_t hex_digit(char character) {
  return hex_digits[static_cast<std::uint8_t>(character)];
}

namespace detail {

template <class Number>
[[gnu::always_inline]] inline Number load(const char* text) {
  Number number{};
  std::memcpy(&number, text, sizeof(number));
  return number;
}

/// The first and the last bytes, as two numbers that may overlap; `size` is that of one number at
/// least, and of two at most.
template <class Number>
[[gnu::always_inline]] inline bool same_ends(const char* a, const char* b, std::size_t size) {
  const std::size_t last = size - sizeof(Number);
  return ((load<Number>(a) ^ load<Number>(b)) |
          (load<Number>(a + last) ^ load<Number>(b + last))) == 0;
}

}  // namespace detail

/// Like ==, but always inline, and without a call for the names of buses: it is asked for every
/// frame.
[[gnu::always_inline]] inline bool same_bytes(std::string_view a, std::string_view b) {
  const std::size_t size = a.size();
  if (size != b.size()) return false;
  if (size >= 4 && size <= 8) return detail::same_ends<std::uint32_t>(a.data(), b.data(), size);
  if (size > 8 && size <= 16) return detail::same_ends<std::uint64_t>(a.data(), b.data(), size);
  return size == 0 || std::memcmp(a.data(), b.data(), size) == 0;
}

/// True for a blank or a tab.
inline bool is_blank(char character) {
  return character == ' ' || character == '\t';
}

/// Removes leading blanks and tabs.
inline void skip_blanks(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

/// Takes leading blanks and the word after them; empty at the end of the line.
inline std::string_view take_word(std::string_view& text) {
  skip_blanks(text);
  std::size_t length = 0;
  while (length < text.size() && !is_blank(text[length])) ++length;
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

/// Reads all of `word`: 1 to 18 decimal digits.
inline bool read_decimal(std::string_view word, std::int64_t& value) {
  if (word.empty() || word.size() > 18) return false;
  std::int64_t sum = 0;
  for (const char character : word) {
    if (character < '0' || character > '9') return false;
    sum = sum * 10 + (character - '0');
  }
  value = sum;
  return true;
}

/// Reads all of `word`: 1 to 8 hexadecimal digits.
inline bool read_hex(std::string_view word, std::uint32_t& value) {
  if (word.empty() || word.size() > 8) return false;
  std::uint32_t sum = 0;
  for (const char character : word) {
    const std::uint8_t digit = hex_digit(character);
    if (digit == no_hex_digit) return false;
    sum = sum << 4 | digit;
  }
  value = sum;
  return true;
}

/// Reads all of `word`: `1700000000.000125`, or without a fraction, in units of `10^-digits`. Cuts
/// off further digits of the fraction; the integer part has at most 18 - digits.
inline bool read_fixed(std::string_view word, std::size_t digits, std::int64_t& value) {
  const auto is_digit = [&](std::size_t at) {
    return at < word.size() && word[at] >= '0' && word[at] <= '9';
  };
  std::int64_t sum = 0;
  std::size_t at = 0;
  for (; is_digit(at); ++at) {
    if (at == 18 - digits) return false;
    sum = sum * 10 + (word[at] - '0');
  }
  const std::size_t point = at;
  if (point == 0 || (at < word.size() && word[at] != '.') || at + 1 == word.size()) return false;
  if (at < word.size()) ++at;
  for (; is_digit(at) && at <= point + digits; ++at) sum = sum * 10 + (word[at] - '0');
  for (std::size_t given = at > point ? at - point - 1 : 0; given < digits; ++given) sum *= 10;
  while (is_digit(at)) ++at;
  value = sum;
  return at == word.size();
}

}  // namespace canvoy::formats
