// Lines for the standard output, written in blocks: at a rate of millions per second there is no
// time for a system call each. On a terminal each line appears at once.
//
//     LineOutput output;
//     output.lines() += "a line\n";
//     output.pass_on();
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "canvoy/tools/terminal/terminal_text.hpp"

namespace canvoy::tools {

class LineOutput {
 public:
  /// `plain`: for programs; else formatted for a terminal, if it is one.
  explicit LineOutput(bool plain = false)
      : is_dressed_(!plain && (wants_colour(STDOUT_FILENO) || terminal_width(STDOUT_FILENO) != 0)) {
    lines_.reserve(full + line_length);
  }

  /// The lines to write next; whole lines are appended.
  std::string& lines() { return lines_; }
  /// Writes the lines if there are many. Throws std::system_error if they cannot be written, like
  /// {fmt}.
  void pass_on() {
    if (lines_.size() >= full || is_watched_) flush();
  }
  void flush() {
    if (is_dressed_) lines_ = terminal_text(lines_, STDOUT_FILENO);
    const bool written = std::fwrite(lines_.data(), 1, lines_.size(), stdout) == lines_.size() &&
                         std::fflush(stdout) == 0;
    lines_.clear();
    if (!written) throw std::system_error(errno, std::generic_category());
  }

 private:
  static constexpr std::size_t full = 256 * 1024;
  static constexpr std::size_t line_length = 4096;

  std::string lines_;
  bool is_dressed_;
  bool is_watched_ = ::isatty(STDOUT_FILENO) == 1;
};

}  // namespace canvoy::tools
