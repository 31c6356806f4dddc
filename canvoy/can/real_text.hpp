// Reads numbers with a fraction where the standard library may read whole ones only: libc++ has
// std::from_chars() of double from version 20 on.
//
//     const std::string_view text = "12.5 V";
//     double volts = 0;
//     const auto [rest, error] = real_from_chars(text.data(), text.data() + text.size(), volts);
#pragma once

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace canvoy {

namespace detail {

/// As std::from_chars() does, by strtod(): who calls it has the locale "C". Linear in the text.
inline std::from_chars_result real_by_strtod(const char* first, const char* last, double& number) {
  const std::string text(first, last);
  const bool is_negative = text.starts_with('-');
  const char begin = text.size() > is_negative ? text[is_negative] : '\0';
  const bool is_word = begin == 'i' || begin == 'I' || begin == 'n' || begin == 'N';
  if (!is_word && begin != '.' && (begin < '0' || begin > '9')) {
    return {first, std::errc::invalid_argument};
  }
  // Of hexadecimal digits the zero before their x is read.
  const std::size_t x = text.find_first_of("xX");
  const bool is_hexadecimal = x == is_negative + std::size_t{1} && begin == '0';
  const std::string read = is_hexadecimal ? text.substr(0, x) : text;
  char* end = nullptr;
  const int errno_before = std::exchange(errno, 0);
  const double value = std::strtod(read.c_str(), &end);
  // It has ERANGE for numbers that are merely subnormal as well.
  const bool is_out_of_range = errno == ERANGE && (value == 0 || std::isinf(value));
  errno = errno_before;
  if (end == read.c_str()) return {first, std::errc::invalid_argument};
  const char* const rest = first + (end - read.c_str());
  if (is_out_of_range) return {rest, std::errc::result_out_of_range};
  number = value;
  return {rest, std::errc{}};
}

}  // namespace detail

/// As std::from_chars(first, last, number): `rest` is behind what was read, and `number` stays as
/// it is where nothing could be.
inline std::from_chars_result real_from_chars(const char* first, const char* last, double& number) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, number);
#else
  return detail::real_by_strtod(first, last, number);
#endif
}

}  // namespace canvoy
