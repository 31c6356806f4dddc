// Lines for a terminal: errors in colour, and no line longer than a row. Output to a file or a pipe
// is unchanged.
//
//     use_colour("auto");                       // or always, never
//     fmt::print("{}", terminal_text(lines, STDOUT_FILENO));
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace canvoy::tools {

/// `auto`: on a terminal, unless NO_COLOR is set. Throws UsageError for an unknown word.
void use_colour(const std::string& when);

/// True if output to this descriptor is to be in colour.
bool wants_colour(int descriptor);
/// Width of the terminal; 0: no terminal.
std::size_t terminal_width(int descriptor);

/// Colours marks, emergencies, faults, aborts and error frames, each up to the end of its line.
/// Colours take no columns.
std::string coloured(std::string_view lines);
/// Stands where a text was cut.
inline constexpr std::string_view ellipsis = "…";
/// Breaks each line into rows of at most this many characters, behind blanks where there are any;
/// further rows are indented. UTF-8.
std::string in_rows(std::string_view lines, std::size_t width);

/// Colours and breaks lines as needed for the descriptor.
std::string terminal_text(std::string_view lines, int descriptor);

}  // namespace canvoy::tools
