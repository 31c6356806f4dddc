#include "canvoy/tools/terminal/typing.hpp"

#include <algorithm>

namespace canvoy::tools {

namespace {

void take_back(std::string& text) {
  const auto is_continued = [](char byte) { return (byte & 0xC0) == 0x80; };
  while (text.size() > 1 && is_continued(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

std::optional<long> rows_moved(Key key, std::size_t shown, std::size_t count) {
  // One row of the page stays visible.
  const auto page = static_cast<long>(std::max<std::size_t>(shown, 2)) - 1;
  switch (key) {
    case Key::up:
      return -1;
    case Key::down:
      return 1;
    case Key::page_up:
      return -page;
    case Key::page_down:
      return page;
    case Key::home:
      return -static_cast<long>(count);
    case Key::end:
      return static_cast<long>(count);
    default:
      return std::nullopt;
  }
}

std::size_t moved_row(std::size_t row, long rows, std::size_t count) {
  const long last = std::max(0L, static_cast<long>(count) - 1);
  return static_cast<std::size_t>(std::clamp(static_cast<long>(row) + rows, 0L, last));
}

void type_key(std::string& text, Key key) {
  constexpr char32_t bytes_end = 0x100;
  const auto character = static_cast<char32_t>(key);
  if (key == Key::backspace) return take_back(text);
  if (character >= ' ' && character < bytes_end) text += static_cast<char>(character);
}

}  // namespace canvoy::tools
