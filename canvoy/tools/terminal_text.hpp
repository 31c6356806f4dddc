// Lines as a terminal shows them best: what is wrong in colour, and no line longer than a row. What
// goes into a file or a pipe stays as it is.
//
//     use_colour("auto");                       // or always, never
//     fmt::print("{}", terminal_text(lines, STDOUT_FILENO));
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace canvoy::tools {

/// `auto`: on a terminal, unless NO_COLOR is set. Throws UsageError for another word.
void use_colour(const std::string& when);

/// Whether what goes to this descriptor is to be in colour.
bool wants_colour(int descriptor);
/// Of the terminal there; 0: it is none.
std::size_t terminal_width(int descriptor);

/// Marks, emergencies, faults, aborts and error frames in colour, each up to the end of its line.
/// Colours take no room.
std::string coloured(std::string_view lines);
/// No line has more characters than this; one that is cut ends with an ellipsis. UTF-8.
std::string clipped(std::string_view lines, std::size_t width);

/// Both, as the descriptor wants it.
std::string terminal_text(std::string_view lines, int descriptor);

}  // namespace canvoy::tools
