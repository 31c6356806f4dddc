// Names that appear in the first line of a compiler's error message. In C++20 the text of a
// static_assert is a literal, and the cause of a failed constant expression is reported many lines
// below; but compilers print the name of an undefined type, with its arguments, at once:
//
// `error: ... incomplete type 'canvoy::wrong::Device<canvoy::Words<22>{"1018h Identity object"},
// canvoy::Words<14>{"01h Vendor-ID"}, canvoy::Words<31>{"CiA 301: every device has it"}>'`
//
//     static_assert(Must<is_there, wrong::Device<object_words, entry_words, rule>>::hold);
//
// clang truncates texts of more than 36 characters: rules are no longer than that.
#pragma once

#include <cstddef>
#include <string_view>

namespace canvoy {

/// A text as a template argument, which compilers print in full.
template <std::size_t size>
struct Words {
  char text[size]{};  ///< ends with 0

  constexpr Words() = default;
  /// Copies a literal, with its final 0.
  constexpr Words(const char (&literal)[size]) {  // NOLINT(google-explicit-constructor)
    for (std::size_t i = 0; i < size; ++i) text[i] = literal[i];
  }
};

/// If the condition is false, a compiler needs the size of `Wrong`, and names that type.
template <bool condition, class Wrong>
struct Must {
  static constexpr bool hold = true;  ///< true, or a compile error
};
/// The case that does not hold: compiles only if `Wrong` is defined.
template <class Wrong>
struct Must<false, Wrong> {
  static constexpr bool hold = sizeof(Wrong) != 0;  ///< asks for the size of `Wrong`
};

namespace detail {

constexpr char hexadecimal_digit(unsigned number) {
  return "0123456789ABCDEF"[number % 16];
}
/// Writes a number with `digits` hexadecimal digits and an `h`.
constexpr char* write_hexadecimal(char* text, unsigned number, unsigned digits) {
  while (digits-- > 0) *text++ = hexadecimal_digit(number >> (4 * digits));
  *text++ = 'h';
  return text;
}
template <std::size_t length>
consteval auto words(std::string_view text) {
  Words<length + 1> words;
  for (std::size_t i = 0; i < length; ++i) words.text[i] = text[i];
  words.text[length] = '\0';  // otherwise clang may print numbers
  return words;
}
/// Texts like `1018h Identity object` or `01h Vendor-ID`; the number alone if the name is empty.
template <unsigned digits, std::size_t length>
consteval auto numbered_words(unsigned number, std::string_view name) {
  Words<digits + 1 + (length == 0 ? 0 : 1 + length) + 1> words;
  char* text = write_hexadecimal(words.text, number, digits);
  if (length != 0) *text++ = ' ';
  for (const char each : name) *text++ = each;
  *text = '\0';
  return words;
}

}  // namespace detail

/// Undefined types: their names are the error message of the compiler.
namespace wrong {

/// An entry that a device lacks, or has in a form that is not allowed.
template <Words object, Words entry, Words rule>
struct Device;

}  // namespace wrong
}  // namespace canvoy
