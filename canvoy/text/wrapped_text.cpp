#include "canvoy/text/wrapped_text.hpp"

#include <algorithm>

namespace canvoy::text {

void append_wrapped(std::string& lines, std::string_view head, std::string_view text,
                    std::size_t columns) {
  lines += head;
  std::size_t column = head.size();
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    text.remove_prefix(std::min(blank + 1, text.size()));
    if (!is_first && column + 1 + word.size() > columns) {
      lines += '\n';
      lines.append(head.size(), ' ');
      column = head.size();
      is_first = true;
    }
    if (!is_first) lines += ' ';
    column += word.size() + (is_first ? 0 : 1);
    lines += word;
    is_first = false;
  }
  lines += '\n';
}

}  // namespace canvoy::text
