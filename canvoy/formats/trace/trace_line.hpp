// The text of a frame in a log, written from left to right into room for the longest line: it runs
// for every frame of files of gigabytes, so that nothing is formatted by a format string.
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
  /// Of all that is put into one line.
  static constexpr std::size_t length_max = 192;

  std::string_view view() const { return {room_.data(), length()}; }
  std::size_t length() const { return static_cast<std::size_t>(at_ - room_.data()); }

  void put(char character) { *at_++ = character; }
  void put(std::string_view text) {
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }
  /// Blanks up to a column, counted from 0; none where that is reached.
  void pad_to(std::size_t column) {
    while (length() < column) put(' ');
  }

  /// Capital digits, at least `digits` of them.
  void put_hex(std::uint32_t value, unsigned digits) {
    while (digits < 8 && value >> 4 * digits != 0) ++digits;
    for (unsigned digit = digits; digit > 0;) put(hex_characters[value >> 4 * --digit & 0xF]);
  }
  void put_hex_byte(std::uint8_t byte) {
    put(hex_characters[byte >> 4]);
    put(hex_characters[byte & 0xF]);
  }
  /// Digits from a column on become small letters.
  void lower_from(std::size_t column) {
    for (char* at = room_.data() + column; at != at_; ++at) {
      if (*at >= 'A' && *at <= 'F') *at = static_cast<char>(*at - 'A' + 'a');
    }
  }
  /// ` 1E 2F`
  void put_bytes(const Frame& frame) {
    for (const std::uint8_t byte : frame.payload()) {
      put(' ');
      put_hex_byte(byte);
    }
  }

  /// At least `width` characters, filled up with `fill` from the left.
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
    for (std::size_t at = count; at < width; ++at) put(fill);
    put(std::string_view(first, count));
  }
  /// `value` in units of 10^-places: at least `width` characters before the point.
  template <unsigned places>
  void put_fixed(std::uint64_t value, std::size_t width = 1, char fill = ' ') {
    constexpr std::uint64_t one = [] {
      std::uint64_t power = 1;
      for (unsigned place = 0; place < places; ++place) power *= 10;
      return power;
    }();
    put_decimal(value / one, width, fill);
    put('.');
    put_decimal(value % one, places, '0');
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

  static char* put_pair(char* before, unsigned number) {
    before -= 2;
    std::memcpy(before, &pairs[std::size_t{2} * number], 2);
    return before;
  }

  std::array<char, length_max> room_;
  char* at_ = room_.data();
};

}  // namespace canvoy::formats
