// A line that candump shows on the screen, taken apart; trace_candump.cpp reads it where a line is
// none of candump -l.
#pragma once

#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// Its words, not yet read. They live as long as the line.
struct ScreenLine {
  std::string_view time = {};  ///< without its parentheses; empty where there is none
  std::string_view channel = {};
  std::string_view identifier = {};
  std::string_view length = {};  ///< `[8]`, `{9}`; of CAN FD `[08]`
  std::string_view bytes = {};
  TraceDirection direction = TraceDirection::unknown;

  /// Whether `line` is one, from its front to its length.
  bool parse(std::string_view line);
};

/// The times of the lines: from 1970 on, from the first frame on, or from the frame before.
class ScreenTimes {
 public:
  explicit ScreenTimes(bool are_deltas) : are_deltas_(are_deltas) {}
  /// Whether some time of the lines of `head` is less than that before it.
  static bool look_like_deltas(std::string_view head);
  /// That of the line before where there is none; false where it cannot be read.
  bool read(std::string_view text, Time& time);

 private:
  bool are_deltas_;
  Time latest_{};
};

TraceStep read_screen_line(const ScreenLine& line, ScreenTimes& times, TraceFrame& frame);

}  // namespace canvoy::formats
