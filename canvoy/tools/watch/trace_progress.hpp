// Progress of reading a long file, in percent, on the terminal.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>

#include "canvoy/tools/watch/log_reader.hpp"

namespace canvoy::tools {

/// Reports nothing for pipes and short files, and only to a terminal.
class TraceProgress {
 public:
  /// `prints_lines`: lines go to the standard output, which must not mix with the progress.
  explicit TraceProgress(const LogReader& trace, bool prints_lines = false)
      : shown_(trace.size() > long_file && ::isatty(STDERR_FILENO) == 1 &&
               !(prints_lines && ::isatty(STDOUT_FILENO) == 1)) {}
  TraceProgress(const TraceProgress&) = delete;
  TraceProgress& operator=(const TraceProgress&) = delete;
  ~TraceProgress() { clear(); }

  /// Clears the progress for a message.
  void clear() {
    if (is_on_line_) fmt::print(stderr, "\r      \r");
    is_on_line_ = false;
  }

  /// Cheap enough for every frame.
  void show(const LogReader& trace) {
    if (!shown_ || trace.position() < next_) return;
    percent_ = trace.position() * 100 / trace.size();
    next_ = (percent_ + 1) * trace.size() / 100;
    fmt::print(stderr, "\r{:3} % ", percent_);
    is_on_line_ = true;
  }

 private:
  static constexpr std::uint64_t long_file = 64'000'000;

  bool shown_;
  bool is_on_line_ = false;
  std::uint64_t percent_ = 0;
  std::uint64_t next_ = long_file / 100;
};

}  // namespace canvoy::tools
