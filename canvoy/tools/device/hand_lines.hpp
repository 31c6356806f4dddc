// Lines of standard input that say what happens to devices that run: a script, or somebody who
// types.
//
//     HandLines lines;
//     lines.read([&](const std::string& order) { ... }, elapsed);   // often
#pragma once

#include <functional>
#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

class HandLines {
 public:
  /// Calls `take` for each line that has come, with a time behind it: `hire@12s` as it stands
  /// there, `hire` at `now`, which counts from the start, as do those times. Blank lines and
  /// comments
  /// (`# ...`) are passed over. What `take` throws as a UsageError is told on standard error, with
  /// the number of the line; all lines behind it are taken.
  void read(const std::function<void(const std::string& order)>& take, Duration now);

  bool has_failed() const { return has_failed_; }

 private:
  static constexpr std::size_t line_max = 1000;

  void end_line(const std::function<void(const std::string& order)>& take, Duration now);

  std::string line_;
  unsigned number_ = 0;
  bool has_ended_ = false;
  bool has_failed_ = false;
};

}  // namespace canvoy::tools
