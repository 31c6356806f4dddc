// Shows the meaning of the frames of a log, or writes them into another log: common part of `canvoy
// decode` and `canvoy monitor LOG`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy::tools {

struct LogOptions {
  std::string log = {};                  ///< `-` for the standard input
  std::vector<std::string> frames = {};  ///< `18A#AC0001`: decoded instead of a log
  std::string out = {};                  ///< another log; empty: lines on the standard output
  std::string parquet = {};              ///< a table of values; empty: none
  std::uint64_t count = 0;               ///< of frames to be shown; 0: all
  std::optional<Duration> limit = {};    ///< from the first frame on
  FramePrinterOptions printer = {};
};

/// Name of the argument in the help of commands.
std::string log_argument_text();

/// Returns the exit status. Throws Failure if the log cannot be read, has no frame, or the output
/// cannot be written. Unreadable lines are reported with their numbers, and skipped.
int decode_log(const LogOptions& options);

}  // namespace canvoy::tools
