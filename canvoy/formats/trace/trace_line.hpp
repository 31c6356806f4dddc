// The text of a frame in a log, written from left to right into a buffer for the longest line. It
// runs for every frame of files of gigabytes, so that no format strings are used.
//
//     TraceLine line;
//     line.put_fixed<6>(microseconds);      // 12.000125
//     line.put(' ');
//     line.put_hex(frame.id, 3);
//     bytes += line.view();
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
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
  /// Size of the array from which put_short() copies.
  static constexpr std::size_t short_max = 16;
  /// Adds the first `length` of these characters; copies all of them.
  void put_short(const std::array<char, short_max>& text, std::size_t length) {
    std::memcpy(at_, text.data(), short_max);
    at_ += length;
  }
  /// Adds the six digits of a number below 1,000,000.
  void put_six(std::uint32_t number) {
    char* const end = at_ + 6;
    put_pair(put_pair(put_pair(end, number % 100), number / 100 % 100), number / 10'000);
    at_ = end;
  }
  /// Adds a text, and blanks behind it up to so many characters.
  template <std::size_t width>
  void put_padded(std::string_view text) {
    std::memset(at_, ' ', width);  // of a constant length, which needs no call
    std::memcpy(at_, text.data(), text.size());
    at_ += std::max(width, text.size());
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
    char* at = at_;
    if (digits == 3 && value >> 12 == 0) {  // most identifiers
      *at = hex_characters[value >> 8];
      at_ = put_byte(at + 1, static_cast<std::uint8_t>(value));
      return;
    }
    while (digits < 8 && value >> 4 * digits != 0) ++digits;
    for (unsigned digit = digits; digit > 0;) *at++ = hex_characters[value >> 4 * --digit & 0xF];
    at_ = at;
  }
  /// Adds the bytes without blanks: `1E2F`.
  void put_pairs(std::span<const std::uint8_t> bytes) {
    char* at = at_;  // a member would be stored behind each character
    for (const std::uint8_t byte : bytes) at = put_byte(at, byte);
    at_ = at;
  }
  /// Digits from a column on become small letters.
  void lower_from(std::size_t column) {
    for (char* at = room_.data() + column; at != at_; ++at) {
      if (*at >= 'A' && *at <= 'F') *at = static_cast<char>(*at - 'A' + 'a');
    }
  }
  /// Adds the bytes: ` 1E 2F`.
  void put_bytes(const Frame& frame) {
    char* at = at_;
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

  static constexpr std::array<char, 512> hex_pairs = [] {
    std::array<char, 512> made{};
    for (std::size_t byte = 0; byte < 256; ++byte) {
      made[2 * byte] = hex_characters[byte >> 4];
      made[2 * byte + 1] = hex_characters[byte & 0xF];
    }
    return made;
  }();

  static char* put_byte(char* at, std::uint8_t byte) {
    std::memcpy(at, &hex_pairs[std::size_t{2} * byte], 2);
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

/// Times in seconds with six digits of a fraction: the text of the seconds is that of the line
/// before as long as they are the same.
class TraceSeconds {
 public:
  /// What stands before the decimal point.
  struct Form {
    char before = '\0';     ///< the first character; none if it is 0
    std::size_t width = 1;  ///< at least, at most 14 characters
    char fill = ' ';        ///< what the number is padded with on the left
  };
  /// The form of all times.
  explicit TraceSeconds(Form form) : form_(form) { change(0); }

  /// Adds a time.
  void put(TraceLine& line, std::uint64_t microseconds) {
    if (microseconds - begin_ >= second) change(microseconds);
    line.put_short(text_, length_);
    line.put_six(static_cast<std::uint32_t>(microseconds - begin_));
  }

 private:
  static constexpr std::uint64_t second = 1'000'000;

  void change(std::uint64_t microseconds) {
    const std::uint64_t seconds = microseconds / second;
    begin_ = seconds * second;
    TraceLine line;
    if (form_.before != '\0') line.put(form_.before);
    line.put_decimal(seconds, form_.width, form_.fill);
    line.put('.');
    length_ = line.length();
    std::memcpy(text_.data(), line.view().data(), std::min(length_, text_.size()));
  }

  Form form_;
  std::uint64_t begin_ = 0;
  std::array<char, TraceLine::short_max> text_{};
  std::size_t length_ = 0;
};

}  // namespace canvoy::formats
