// Lines of standard input with actions on running devices: a script, or typed lines.
//
//     HandLines lines;
//     lines.read([&](const std::string& order) { ... }, elapsed);   // often
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/gateway/line_reader.hpp"

namespace canvoy::tools {

/// Splits several orders in one text: `sign-on@1s,hire@2s` are two. A comma separates only after a
/// time; elsewhere it belongs to the value.
std::vector<std::string> separate_orders(const std::vector<std::string>& said);

class HandLines {
 public:
  /// Calls `take` for each line that has arrived, with its time appended: `hire@12s` as written,
  /// `hire` at `now`. Times count from the start. Skips blank lines and comments (`# ...`). A
  /// UsageError of `take` is reported on standard error with the line number; reading continues.
  void read(const std::function<void(const std::string& order)>& take, Duration now);

  bool has_failed() const { return has_failed_; }

 private:
  static constexpr std::size_t line_max = 1000;

  void take_line(const gateway::Line& line,
                 const std::function<void(const std::string& order)>& take, Duration now);

  gateway::LineReader reader_{line_max};
  unsigned number_ = 0;
  bool has_ended_ = false;
  bool has_failed_ = false;
};

}  // namespace canvoy::tools
