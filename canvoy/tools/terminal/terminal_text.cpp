#include "canvoy/tools/terminal/terminal_text.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

enum class ColourWhen : std::uint8_t { automatic, always, never };
ColourWhen colour_when = ColourWhen::automatic;

constexpr std::string_view red = "\x1B[31m";
constexpr std::string_view yellow = "\x1B[33m";
constexpr std::string_view plain = "\x1B[0m";

struct ColouredWord {
  std::string_view word;
  std::string_view colour;
};
constexpr auto coloured_words = std::to_array<ColouredWord>({
    {"[!] ", red},
    {"EMCY ", red},
    {"EMERGENCY ", red},
    {"abort ", red},
    {"error frame ", red},
    {"FAIL", red},
    {"FAULT begins", yellow},
    {"fault ends", yellow},
});

/// Calls `action` with each line, without its line end, and whether it has one.
template <class Action>
void each_line(std::string_view lines, const Action& action) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    action(lines.substr(0, end), end < lines.size());
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
}

/// News about a node is not part of the error in a line.
std::size_t end_of_trouble(std::string_view line) {
  return std::min(line.find(" => "), line.size());
}

void append_coloured(std::string& text, std::string_view line) {
  const ColouredWord* first = nullptr;
  std::size_t begin = line.size();
  for (const ColouredWord& each : coloured_words) {
    const std::size_t at = line.find(each.word);
    if (at >= begin) continue;
    begin = at;
    first = &each;
  }
  if (first == nullptr) {
    text += line;
    return;
  }
  const std::size_t end = std::max(begin, end_of_trouble(line));
  text.append(line.substr(0, begin)).append(first->colour);
  text.append(line.substr(begin, end - begin)).append(plain).append(line.substr(end));
}

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
}

/// A change of colour at the front, which takes no columns.
std::size_t colour_length(std::string_view line) {
  return line.starts_with('\x1B') ? std::min(line.find('m'), line.size() - 1) + 1 : 0;
}

std::size_t room_of(std::string_view line) {
  std::size_t room = 0;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t colour = colour_length(line.substr(at));
    if (colour == 0 && begins_character(line[at])) ++room;
    at += std::max<std::size_t>(colour, 1);
  }
  return room;
}

/// Column where a line goes on in further rows: that of its text behind columns of a table.
std::size_t hanging_indent(std::string_view line, std::size_t width) {
  constexpr std::size_t usual = 4;
  const std::size_t gap = line.substr(0, width / 2).rfind("  ");
  const std::size_t begin = line.find_first_not_of(' ', gap == std::string_view::npos ? 0 : gap);
  const bool has_columns = gap != std::string_view::npos && begin < width / 2;
  return std::min(has_columns ? room_of(line.substr(0, begin)) : usual, width / 2);
}

void append_in_rows(std::string& text, std::string_view line, std::size_t width) {
  const std::size_t indent = hanging_indent(line, width);
  std::size_t room = 0;
  std::size_t blank = 0;  // the last one at which the row may end; 0: none
  bool has_text = false;  // before it
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t colour = colour_length(line.substr(at));
    const bool begins = colour == 0 && begins_character(line[at]);
    if (begins && line[at] == ' ' && has_text) blank = at;
    has_text = has_text || (begins && line[at] != ' ');
    if (begins && room == width) {
      const std::size_t end = blank != 0 ? blank : at;
      text.append(line.substr(0, end));
      line.remove_prefix(end);
      line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
      if (room_of(line) == 0) break;
      text.append(1, '\n').append(indent, ' ');
      room = indent;
      at = 0;
      blank = 0;
      continue;
    }
    if (begins) ++room;
    at += std::max<std::size_t>(colour, 1);
  }
  text += line;
}

}  // namespace

void use_colour(const std::string& when) {
  constexpr std::array<std::string_view, 3> words = {"auto", "always", "never"};
  const auto* found = std::ranges::find(words, when);
  if (found == words.end()) {
    throw UsageError(fmt::format("--colour: '{}' is none of auto, always and never", when));
  }
  colour_when = static_cast<ColourWhen>(found - words.begin());
}

bool wants_colour(int descriptor) {
  if (colour_when != ColourWhen::automatic) return colour_when == ColourWhen::always;
  const char* unwanted = std::getenv("NO_COLOR");
  return ::isatty(descriptor) == 1 && (unwanted == nullptr || *unwanted == '\0');
}

std::size_t terminal_width(int descriptor) {
  winsize size{};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string coloured(std::string_view lines) {
  std::string text;
  each_line(lines, [&text](std::string_view line, bool has_break) {
    append_coloured(text, line);
    if (has_break) text += '\n';
  });
  return text;
}

std::string in_rows(std::string_view lines, std::size_t width) {
  std::string text;
  each_line(lines, [&text, width](std::string_view line, bool has_break) {
    append_in_rows(text, line, width);
    if (has_break) text += '\n';
  });
  return text;
}

std::string terminal_text(std::string_view lines, int descriptor) {
  const std::size_t width = terminal_width(descriptor);
  const std::string text = wants_colour(descriptor) ? coloured(lines) : std::string(lines);
  return width == 0 ? text : in_rows(text, width);
}

}  // namespace canvoy::tools
