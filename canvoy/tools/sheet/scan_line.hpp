// Progress of a scan of a dictionary on a terminal: a line that is overwritten.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "canvoy/formats/sheet/sheet_scan.hpp"

namespace canvoy::tools {

class ScanLine {
 public:
  void show(const formats::SheetScan::Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal_ || now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    fmt::print(stderr, "\r{}/{}  {:04X}h", progress.done, progress.all, progress.index);
    std::fflush(stderr);
  }
  void end() const {
    if (shown_ != std::chrono::steady_clock::time_point{}) fmt::print(stderr, "\r\x1B[K");
  }

 private:
  bool is_terminal_ = ::isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point shown_{};
};

}  // namespace canvoy::tools
