// The text of a frame in a log, written from left to right into a buffer for the longest line. It
// runs for every frame of files of gigabytes, so that no format strings are used.
//
//     TraceLine line;
//     line.put_fixed<6>(microseconds);      // 12.000125
//     line.put(' ');
//     line.put_hex(frame.id, 3);
//     bytes += line.view();
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "canvoy/can/frame.hpp"

namespace canvoy::formats {

class TraceLine {
 public:
  /// Limit for all that is put into one line; not checked.
  static constexpr std::size_t length_max = 192;

  /// The line so far, valid until it changes.
  std::string_view view() const { return {room_.data(), length()}; }
  /// Characters so far.
  std::size_t length() const { return static_cast<std::size_t>(at_ - room_.data()); }

  /// Starts an empty line.
  void clear() { at_ = room_.data(); }
  /// Adds a character.
  void put(char character) { *at_++ = character; }
  /// Adds a text.
  void put(std::string_view text) {
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }
  /// Adds blanks up to a column, counted from 0; none if the line is that long.
  void pad_to(std::size_t column) {
    if (length() >= column) return;
    const std::size_t count = column - length();
    std::memset(at_, ' ', count);
    at_ += count;
  }

  /// Adds upper-case hexadecimal digits, at least `digits`.
  void put_hex(std::uint32_t value, unsigned digits) {
    while (digits < 8 && value >> 4 * digits != 0) ++digits;
    char* at = at_;
    for (unsigned digit = digits; digit > 0;) *at++ = hex_characters[value >> 4 * --digit & 0xF];
    at_ = at;
  }
  /// Adds two upper-case digits.
  void put_hex_byte(std::uint8_t byte) { at_ = put_byte(at_, byte); }
  /// Digits from a column on become small letters.
  void lower_from(std::size_t column) {
    for (char* at = room_.data() + column; at != at_; ++at) {
      if (*at >= 'A' && *at <= 'F') *at = static_cast<char>(*at - 'A' + 'a');
    }
  }
  /// Adds the bytes: ` 1E 2F`.
  void put_bytes(const Frame& frame) {
    char* at = at_;  // a member would be stored behind each character
    for (const std::uint8_t byte : frame.payload()) {
      *at = ' ';
      at = put_byte(at + 1, byte);
    }
    at_ = at;
  }

  /// Adds at least `width` characters, padded on the left with `fill`.
  void put_decimal(std::uint64_t value, std::size_t width = 1, char fill = ' ') {
    std::array<char, 20> digits{};
    char* const end = digits.data() + digits.size();
    char* first = end;
    for (; value >= 100; value /= 100) first = put_pair(first, static_cast<unsigned>(value % 100));
    if (value >= 10) {
      first = put_pair(first, static_cast<unsigned>(value));
    } else {
      *--first = static_cast<char>('0' + value);
    }
    const auto count = static_cast<std::size_t>(end - first);
    char* at = at_;
    for (std::size_t place = count; place < width; ++place) *at++ = fill;
    std::memcpy(at, first, count);
    at_ = at + count;
  }
  /// Adds `value` in units of 10^-places, with at least `width` characters before the decimal
  /// point.
  template <unsigned places>
  void put_fixed(std::uint64_t value, std::size_t width = 1, char fill = ' ') {
    constexpr std::uint64_t one = [] {
      std::uint64_t power = 1;
      for (unsigned place = 0; place < places; ++place) power *= 10;
      return power;
    }();
    put_decimal(value / one, width, fill);
    std::uint64_t fraction = value % one;
    char* at = at_ + 1 + places;
    for (unsigned place = places; place > 1; place -= 2, fraction /= 100) {
      at = put_pair(at, static_cast<unsigned>(fraction % 100));
    }
    if (places % 2 != 0) *--at = static_cast<char>('0' + fraction);
    *at_ = '.';
    at_ += 1 + places;
  }

 private:
  static constexpr std::string_view hex_characters = "0123456789ABCDEF";
  static constexpr std::array<char, 200> pairs = [] {
    std::array<char, 200> made{};
    for (std::size_t number = 0; number < 100; ++number) {
      made[2 * number] = static_cast<char>('0' + number / 10);
      made[2 * number + 1] = static_cast<char>('0' + number % 10);
    }
    return made;
  }();

  static char* put_byte(char* at, std::uint8_t byte) {
    at[0] = hex_characters[byte >> 4];
    at[1] = hex_characters[byte & 0xF];
    return at + 2;
  }
  static char* put_pair(char* before, unsigned number) {
    before -= 2;
    std::memcpy(before, &pairs[std::size_t{2} * number], 2);
    return before;
  }

  std::array<char, length_max> room_;
  char* at_ = room_.data();
};

}  // namespace canvoy::formats
