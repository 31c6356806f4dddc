// Splits a line of the screen output of candump. trace_candump.cpp uses it for lines that are not
// of `candump -l`.
#pragma once

#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// The words of the line, not converted. Valid as long as the line.
struct ScreenLine {
  std::string_view time = {};        ///< without parentheses; empty if there is none
  std::string_view channel = {};     ///< name of the bus
  std::string_view identifier = {};  ///< hexadecimal digits
  std::string_view length = {};      ///< `[8]`, `{9}`; of CAN FD `[08]`
  std::string_view bytes = {};       ///< words; `remote request` as it stands
  TraceDirection direction = TraceDirection::unknown;  ///< if the line gives it

  /// Splits `line` from its start to its length. True if it is a screen line.
  bool parse(std::string_view line);
};

/// Times of the lines: since 1970, since the first frame, or since the previous frame.
class ScreenTimes {
 public:
  /// Reads times as deltas, each added to the one before, or as they are.
  explicit ScreenTimes(bool are_deltas) : are_deltas_(are_deltas) {}
  /// True if some time in the lines of `head` is less than the previous one.
  static bool look_like_deltas(std::string_view head);
  /// Reads a time; without one, takes that of the previous line. False if it cannot be read.
  bool read(std::string_view text, Time& time);

 private:
  bool are_deltas_;
  Time latest_{};
};

/// Converts the words of a line to a frame.
TraceStep read_screen_line(const ScreenLine& line, ScreenTimes& times, TraceFrame& frame);

}  // namespace canvoy::formats
