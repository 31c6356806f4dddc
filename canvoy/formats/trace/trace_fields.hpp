// Fields that several formats of traces share: channels by number, bytes in words, dates.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::formats {

/// Of a time in seconds, behind the point.
inline constexpr unsigned microsecond_digits = 6;

/// The name of the channels that a format counts from 1: channel 1 is can0, as for asc2log.
class TraceChannel {
 public:
  static constexpr std::int64_t number_max = 255;

  /// Lives until another number is asked for; empty where it is none.
  std::string_view name(std::int64_t number) {
    return number == number_ ? std::string_view(name_) : change(number);
  }

 private:
  std::string_view change(std::int64_t number);

  std::int64_t number_ = 0;
  std::string name_;
};

/// Takes `count` bytes, a word each, from the front of `text` into the frame, in hexadecimal or
/// decimal digits; bytes beyond the eighth are not there to be taken.
bool take_bytes(std::string_view& text, unsigned count, bool hexadecimal, Frame& frame);

/// `Wed Apr 16 09:21:13.159 am 2014`, where weekday, fraction and am or pm may be missing, and
/// German months are known too: microseconds since 1970, or false.
bool read_asc_date(std::string_view text, Duration& since_1970);

/// `22:13:20.000125`: since midnight, or false.
bool read_clock_time(std::string_view text, Duration& of_day);

}  // namespace canvoy::formats
