// Takes the fields of common lines of text logs from their front: numbers, hexadecimal digits and
// bytes, separated by blanks, not tabs. It runs for every frame of files of gigabytes; each format
// has a slower, tolerant path for other lines.
//
//     TraceScanner line("  12.000125 1  185  Rx  d 2 1E 2F");
//     if (!line.take_fixed<6>(time) || !line.take_blanks()) return carefully();
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

class TraceScanner {
 public:
  /// A character that ends the line must follow it (TraceLineParser::Behind).
  explicit TraceScanner(std::string_view line) : at_(line.data()), end_(at_ + line.size()) {}

  /// Skips any number of blanks: columns are padded with them.
  [[gnu::always_inline]] void skip_blanks() {
    while (end_ - at_ >= 4 && load_four(at_) == four_blanks) at_ += 4;
    while (*at_ == ' ') ++at_;
  }
  /// Takes at least one blank.
  [[gnu::always_inline]] bool take_blanks() {
    if (*at_ != ' ') return false;
    ++at_;
    if (*at_ == ' ') skip_blanks();
    return true;
  }
  /// Skips all up to the next blank.
  [[gnu::always_inline]] void skip_word() {
    while (static_cast<unsigned char>(*at_) > ' ') ++at_;
  }
  /// True if only blanks follow.
  bool is_at_end() {
    skip_blanks();
    return at_ == end_;
  }
  /// Takes one given character; false if another one is next.
  [[gnu::always_inline]] bool take(char character) {
    if (*at_ != character) return false;
    ++at_;
    return true;
  }

  /// Takes `12.000125`: 1 to 12 digits, and 1 to `places` digits of a fraction, in units of
  /// 10^-places.
  template <unsigned places>
  [[gnu::always_inline]] bool take_fixed(std::int64_t& number) {
    constexpr std::ptrdiff_t digits_max = 12;
    const char* const first = at_;
    std::uint64_t sum = 0;
    for (unsigned digit = 0; (digit = digit_at(at_)) < 10; ++at_) sum = sum * 10 + digit;
    // An overflowed value is not used.
    if (at_ == first || at_ - first > digits_max || *at_ != '.') return false;
    ++at_;
    if (digit_at(at_) > 9) return false;
    for (unsigned place = 0; place < places; ++place) {
      const unsigned digit = digit_at(at_);
      sum = sum * 10 + (digit < 10 ? digit : 0);
      if (digit < 10) ++at_;
    }
    number = static_cast<std::int64_t>(sum);
    return true;
  }
  /// All that was not taken.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  /// Takes one decimal digit; false if there is none.
  bool take_digit(unsigned& number) {
    number = digit_at(at_);
    if (number > 9) return false;
    ++at_;
    return true;
  }
  /// Takes 1 to 3 digits.
  [[gnu::always_inline]] bool take_number(unsigned& number) {
    constexpr std::ptrdiff_t digits_max = 3;
    const char* const first = at_;
    unsigned sum = 0;
    for (unsigned digit = 0; (digit = digit_at(at_)) < 10; ++at_) sum = sum * 10 + digit;
    number = sum;
    return at_ != first && at_ - first <= digits_max;
  }
  /// Takes up to 8 hexadecimal digits; returns their number, 0 if there are more.
  [[gnu::always_inline]] unsigned take_hex(std::uint32_t& number) {
    constexpr std::ptrdiff_t digits_max = 8;
    const char* const first = at_;
    std::uint32_t sum = 0;
    for (std::uint8_t digit = 0; (digit = hex_digit(*at_)) != no_hex_digit; ++at_) {
      sum = sum << 4 | digit;
    }
    number = sum;
    return at_ - first > digits_max ? 0 : static_cast<unsigned>(at_ - first);
  }
  /// Takes `Rx` or `Tx`; returns its first letter, else 0.
  [[gnu::always_inline]] char take_direction() {
    if ((*at_ != 'R' && *at_ != 'T') || at_[1] != 'x') return 0;
    at_ += 2;
    return at_[-2];
  }
  /// Takes ` 1E 2F` up to the end of the line or a blank; more blanks may precede the first byte.
  [[gnu::always_inline]] bool take_bytes(unsigned length, Frame& frame) {
    if (length > Frame::length_max) return false;
    if (length > 0) {
      if (!take_blanks()) return false;
      --at_;
    }
    if (end_ - at_ < static_cast<std::ptrdiff_t>(length) * byte_width) return false;
    if (!read_bytes(at_, length, frame.data.data())) return false;
    at_ += length * byte_width;
    frame.length = static_cast<std::uint8_t>(length);
    return at_ == end_ || *at_ == ' ';
  }

 private:
  static constexpr std::ptrdiff_t byte_width = 3;
  static constexpr std::uint32_t four_blanks = 0x2020'2020;

  /// The digit; above 9 if it is none.
  static unsigned digit_at(const char* at) {
    return static_cast<unsigned char>(*at) - unsigned{'0'};
  }
  /// Not inlined, since a scanner and its caller leave too few registers for this loop.
  [[gnu::noinline]] static bool read_bytes(const char* at, unsigned length, std::uint8_t* bytes) {
    unsigned digits = 0;
    unsigned blanks = 0;
    for (unsigned i = 0; i < length; ++i, at += byte_width) {
      const unsigned high = hex_digit(at[1]);
      const unsigned low = hex_digit(at[2]);
      digits |= high | low;
      blanks |= static_cast<unsigned>(at[0] ^ ' ');
      bytes[i] = static_cast<std::uint8_t>(high << 4 | low);
    }
    return digits < 16 && blanks == 0;
  }
  static std::uint32_t load_four(const char* text) {
    std::uint32_t characters = 0;
    std::memcpy(&characters, text, sizeof(characters));
    return characters;
  }

  const char* at_;
  const char* end_;
};

}  // namespace canvoy::formats
