// What a conformance test has found, for people and for programs.
//
//     fmt::print("{}", result_text(result));
//     fmt::print("{}", summary_text(head, report));
//     write_file("check.html", report_html(head, report));
#pragma once

#include <string>

#include "canvoy/words/check/check.hpp"

namespace canvoy::conformance {

/// Where it was tried, and with what.
struct ReportHead {
  /// As it was named.
  std::string bus = {};
  unsigned bit_rate = 0;   ///< in bit/s; 0: not known
  std::string sheet = {};  ///< the file; empty: none
  /// Its name; empty: none.
  std::string profile = {};
  std::string version = {};  ///< of the program
  /// When it began.
  std::string date = {};
  /// Whether the application was written (--moves).
  bool moves = false;
};

/// Of a terminal.
inline constexpr std::size_t report_columns = 80;

/// A line, and of a failure what was sent, expected and heard: lines of 80 columns.
std::string result_text(const TestResult& result);
/// Who was tried, a table of the classes, and what could not be put back.
std::string summary_text(const ReportHead& head, const Report& report);
/// A case each as in --list.
std::string list_text(const TestCases& cases);
/// One JSON object a line: a case each, and at the end the whole.
std::string report_json(const ReportHead& head, const Report& report);
/// The same as one JSON object a line.
std::string list_json(const TestCases& cases);
/// One page without scripts.
std::string report_html(const ReportHead& head, const Report& report);

/// `SDO request: read 1000h:00h`, a line for each frame of a failure, with its time since the
/// first.
std::vector<std::string> frame_lines(const TestResult& result, std::size_t columns);

}  // namespace canvoy::conformance
