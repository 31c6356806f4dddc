// Lines for the user beside the output.
//
//     print_message(fmt::format("{}: {} frames are left out", path, count));
#pragma once

#include <string>
#include <string_view>

namespace canvoy::tools {

/// The text in lines of at most `columns` characters, broken at blanks, all but the first one
/// indented; 0: in one line.
std::string message_lines(std::string_view text, std::size_t columns);

/// Prints a line on stderr; on a terminal, in lines of its width.
void print_message(std::string_view text);

}  // namespace canvoy::tools
