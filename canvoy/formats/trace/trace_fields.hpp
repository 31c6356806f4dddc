// Fields that several trace formats share: numbered channels, bytes in words, dates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

/// Number of digits of a time in seconds, after the decimal point.
inline constexpr unsigned microsecond_digits = 6;

/// Names of channels that a format counts from 1: channel 1 is can0, as in asc2log.
class TraceChannel {
 public:
  static constexpr std::int64_t number_max = 255;  ///< greater numbers are no channel

  /// Name of a channel, valid until another number is requested; empty if the number is invalid.
  std::string_view name(std::int64_t number) {
    return number == number_ ? std::string_view(name_) : change(number);
  }

 private:
  std::string_view change(std::int64_t number);

  std::int64_t number_ = 0;
  std::string name_;
};

/// Number of each channel name: can0 and a name without a number are channel 1. If a number is
/// taken by another name, the next free one is used, so that two buses stay separate.
class TraceChannelNumbers {
 public:
  std::size_t operator[](std::string_view channel) {
    return same_bytes(channel, latest_) && number_ != 0 ? number_ : change(channel);
  }

 private:
  std::size_t change(std::string_view channel);
  std::size_t find(std::string_view channel);

  std::array<std::string, TraceChannel::number_max> names_;
  std::string latest_;
  std::size_t number_ = 0;
};

/// Number of bytes of a CAN FD frame for a data length code, 0 to 15.
constexpr std::uint8_t fd_length(std::uint32_t code) {
  constexpr std::array<std::uint8_t, 16> lengths = {0, 1,  2,  3,  4,  5,  6,  7,
                                                    8, 12, 16, 20, 24, 32, 48, 64};
  return lengths[code & 0xF];
}

/// Takes up to `count` bytes, one word each, from the front of `text`.
void take_fd_bytes(std::string_view& text, std::size_t count, bool hexadecimal,
                   TraceFdContent& content);

/// Takes `count` bytes, one word each, from the front of `text` into the frame, in hexadecimal or
/// decimal digits. Bytes beyond the eighth are not taken.
bool take_bytes(std::string_view& text, unsigned count, bool hexadecimal, Frame& frame);

/// Reads `Wed Apr 16 09:21:13.159 am 2014` to microseconds since 1970; false on error. Weekday,
/// fraction and am or pm are optional; German months are accepted.
bool read_asc_date(std::string_view text, Duration& since_1970);

/// Reads `22:13:20.000125` to the time since midnight; false on error.
bool read_clock_time(std::string_view text, Duration& of_day);

}  // namespace canvoy::formats
