// A text of ASCII that is composed without a heap.
//
//     FixedText<64> text;
//     text.add("k ").add(24'000).add(" of ").add_minute(1'795'435'200);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia447 {

template <std::size_t capacity>
class FixedText {
 public:
  /// The text; valid as long as this, and until the next add().
  std::string_view view() const { return {text_.data(), length_}; }

  /// Leaves out what has no room.
  FixedText& add(std::string_view text) {
    const std::size_t count = std::min(text.size(), text_.size() - length_);
    std::copy_n(text.begin(), count, text_.begin() + static_cast<std::ptrdiff_t>(length_));
    length_ += count;
    return *this;
  }
  /// Right-aligned in `width`, at most 20, filled in front with this character.
  FixedText& add(std::uint64_t number, std::size_t width = 1, char filler = ' ',
                 unsigned base = 10) {
    constexpr std::size_t digits_max = 20;
    std::array<char, digits_max> digits;
    digits.fill(filler);
    std::size_t first = digits_max;
    do {
      digits[--first] = "0123456789ABCDEF"[number % base];
      number /= base;
    } while (number != 0);
    first = std::min(first, digits_max - width);
    return add(std::string_view(digits.data() + first, digits_max - first));
  }
  /// `6055h`.
  FixedText& add_hexadecimal(std::uint64_t number, std::size_t width) {
    return add(number, width, '0', 16).add("h");
  }
  /// `2026-11-23 12:00`, of seconds since 1970-01-01.
  FixedText& add_minute(std::int64_t seconds) {
    const CivilTime at = civil_time(seconds);
    return add(static_cast<std::uint64_t>(at.year), 4, '0')
        .add("-")
        .add(at.month, 2, '0')
        .add("-")
        .add(at.day, 2, '0')
        .add(" ")
        .add(at.hour, 2, '0')
        .add(":")
        .add(at.minute, 2, '0');
  }
  /// `2026-11-23 12:00:00`.
  FixedText& add_second(std::int64_t seconds) {
    return add_minute(seconds).add(":").add(civil_time(seconds).second, 2, '0');
  }

 private:
  std::array<char, capacity> text_{};
  std::size_t length_ = 0;
};

}  // namespace canvoy::cia447
