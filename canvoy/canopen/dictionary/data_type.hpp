// The data types of CiA 301, and the odd-sized integers that CiA 447 adds at 60h to 7Ah (CiA 301,
// 7.4.7).
#pragma once

#include <cstdint>
#include <iterator>

namespace canvoy {

/// Type of an entry, with its index in the dictionary as the number: EDS files and the objects
/// 0001h to 001Bh use it (CiA 301, 7.4.7.1).
enum class DataType : std::uint8_t {
  boolean = 0x01,
  integer8 = 0x02,
  integer16 = 0x03,
  integer32 = 0x04,
  unsigned8 = 0x05,
  unsigned16 = 0x06,
  unsigned32 = 0x07,
  real32 = 0x08,
  visible_string = 0x09,
  octet_string = 0x0A,
  unicode_string = 0x0B,
  time_of_day = 0x0C,
  time_difference = 0x0D,
  domain = 0x0F,
  integer24 = 0x10,
  real64 = 0x11,
  integer40 = 0x12,
  integer48 = 0x13,
  integer56 = 0x14,
  integer64 = 0x15,
  unsigned24 = 0x16,
  unsigned40 = 0x18,
  unsigned48 = 0x19,
  unsigned56 = 0x1A,
  unsigned64 = 0x1B,
  unsigned2 = 0x60,   ///< CiA 447: the first of the odd-sized unsigned integers, see bit_length
  unsigned31 = 0x7A,  ///< CiA 447: the last of them
  utf8_string = 0x7B,
};

namespace detail {

inline constexpr std::uint8_t standard_bit_lengths[] = {0,  1,  8,  16, 32, 8,  16, 32, 32, 0,
                                                        0,  0,  48, 48, 0,  0,  24, 64, 40, 48,
                                                        56, 64, 24, 0,  40, 48, 56, 64};
inline constexpr std::uint8_t odd_bit_lengths[] = {2,  3,  4,  5,  6,  7,  9,  10, 11,
                                                   12, 13, 14, 15, 17, 18, 19, 20, 21,
                                                   22, 23, 25, 26, 27, 28, 29, 30, 31};

}  // namespace detail

/// Length in bits of a type with values of one length; 0 for strings and domains.
constexpr unsigned bit_length(DataType type) {
  const auto code = static_cast<unsigned>(type);
  constexpr auto first_odd = static_cast<unsigned>(DataType::unsigned2);
  if (code < std::size(detail::standard_bit_lengths)) return detail::standard_bit_lengths[code];
  return code - first_odd < std::size(detail::odd_bit_lengths)
             ? detail::odd_bit_lengths[code - first_odd]
             : 0;
}

/// Like bit_length(), but in whole bytes, as SDO transfers the value.
constexpr unsigned byte_length(DataType type) {
  return (bit_length(type) + 7) / 8;
}

/// True for strings: values of any length up to the capacity of the entry.
constexpr bool is_string(DataType type) {
  return type == DataType::visible_string || type == DataType::octet_string ||
         type == DataType::unicode_string || type == DataType::utf8_string;
}
/// True for IEEE 754 numbers of 32 or 64 bits. They have no limits and no sentinel.
constexpr bool is_real(DataType type) {
  return type == DataType::real32 || type == DataType::real64;
}

/// True for integers in two's complement, of 8 to 64 bits. The odd-sized types of CiA 447 have no
/// sign.
constexpr bool is_signed(DataType type) {
  return (type >= DataType::integer8 && type <= DataType::integer32) ||
         type == DataType::integer24 ||
         (type >= DataType::integer40 && type <= DataType::integer64);
}
/// True for Boolean and all integers: types with ordered values, which may have limits.
constexpr bool is_integer(DataType type) {
  return bit_length(type) != 0 && !is_real(type) && type != DataType::time_of_day &&
         type != DataType::time_difference;
}

}  // namespace canvoy
