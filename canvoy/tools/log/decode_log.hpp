// Shows what the frames of a log mean, or writes it into another log: what `canvoy decode` and
// `canvoy monitor LOG` have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/log/frame_printer.hpp"

namespace canvoy::tools {

struct LogOptions {
  std::string log = {};                  ///< `-` for the standard input
  std::vector<std::string> frames = {};  ///< `18A#AC0001`: they are decoded in place of a log
  std::string out = {};                  ///< another log; empty: lines on the standard output
  std::uint64_t count = 0;               ///< of frames to be shown; 0: all
  std::optional<Duration> limit = {};    ///< from the first frame on
  FramePrinterOptions printer = {};
};

/// What the argument is called in the help of commands.
std::string log_argument_text();

/// Returns the exit status; throws Failure where the log cannot be read, has no frame, or nothing
/// can be written. Lines that cannot be read are told of with their numbers, and passed over.
int decode_log(const LogOptions& options);

}  // namespace canvoy::tools
