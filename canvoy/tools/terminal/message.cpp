#include "canvoy/tools/terminal/message.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "canvoy/text/wrapped_text.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"

namespace canvoy::tools {

std::string message_lines(std::string_view text, std::size_t columns) {
  if (columns == 0) return std::string(text) + '\n';
  constexpr std::string_view indent = "  ";
  std::string lines;
  text::append_wrapped(lines, indent, text, columns);
  return lines.substr(indent.size());
}

void print_message(std::string_view text) {
  const std::size_t columns = terminal_width(STDERR_FILENO);
  fmt::print(stderr, "{}", message_lines(text, columns));
}

}  // namespace canvoy::tools
