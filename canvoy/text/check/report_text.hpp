// Results of a conformance test, as text and as JSON.
//
//     fmt::print("{}", result_text(result));
//     fmt::print("{}", summary_text(head, report));
//     write_file("check.html", report_html(head, report));
#pragma once

#include <string>

#include "canvoy/text/check/check.hpp"

namespace canvoy::conformance {

/// Conditions of a test.
struct ReportHead {
  /// Name of the bus, as given.
  std::string bus = {};
  unsigned bit_rate = 0;   ///< in bit/s; 0: unknown
  std::string sheet = {};  ///< file name; empty: none
  /// Name of the profile; empty: none.
  std::string profile = {};
  std::string version = {};  ///< of the program
  /// Date of the start.
  std::string date = {};
  /// True if objects of the application were written (--moves).
  bool moves = false;
};

/// Width of a terminal.
inline constexpr std::size_t report_columns = 80;

/// Text of a result: one line, and for a failure what was sent, expected and heard, in lines of 80
/// columns.
std::string result_text(const TestResult& result);
/// Text with the tested device, a table of the groups, and what was not restored.
std::string summary_text(const ReportHead& head, const Report& report);
/// Text with one case per line, as for --list.
std::string list_text(const TestCases& cases);
/// JSON Lines: one object for each case, and a summary at the end.
std::string report_json(const ReportHead& head, const Report& report);
/// JSON Lines: one object for each case, as for --list.
std::string list_json(const TestCases& cases);
/// A page without scripts.
std::string report_html(const ReportHead& head, const Report& report);

/// One line for each frame of a failure, with its time since the first: `SDO request: read
/// 1000h:00h`.
std::vector<std::string> frame_lines(const TestResult& result, std::size_t columns);

}  // namespace canvoy::conformance
