#include "canvoy/tools/terminal/screen.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "canvoy/tools/terminal/terminal_text.hpp"

namespace canvoy::tools {

namespace {

constexpr std::string_view begin_of_screen = "\x1b[?1049h\x1b[?25l\x1b[2J";
constexpr std::string_view end_of_screen = "\x1b[?25h\x1b[?1049l";
constexpr char escape_sign = '\x1b';

void write_to_terminal(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

/// Length of the escape sequence at the start of a text: `\x1b[1;7m`.
std::size_t sequence_length(std::string_view text) {
  if (text.size() < 2 || text[0] != escape_sign || text[1] != '[') return 0;
  std::size_t length = 2;
  while (length < text.size() && (text[length] < '@' || text[length] > '~')) ++length;
  return length < text.size() ? length + 1 : text.size();
}

/// Number of bytes of the first character of a text.
std::size_t character_length(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80)
    ++length;
  return length;
}

constexpr std::array<std::pair<std::string_view, Key>, 12> sequences = {{
    {"\x1b[A", Key::up},
    {"\x1b[B", Key::down},
    {"\x1bOA", Key::up},
    {"\x1bOB", Key::down},
    {"\x1b[5~", Key::page_up},
    {"\x1b[6~", Key::page_down},
    {"\x1b[H", Key::home},
    {"\x1b[F", Key::end},
    {"\x1b[1~", Key::home},
    {"\x1b[4~", Key::end},
    {"\x1bOH", Key::home},
    {"\x1bOF", Key::end},
}};

}  // namespace

bool Screen::is_there() {
  return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1;
}

Screen::Size Screen::size() {
  winsize found{};
  const bool is_known =
      ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &found) == 0 && found.ws_row != 0 && found.ws_col != 0;
  return is_known ? Size{found.ws_col, found.ws_row} : Size{};
}

Screen::Screen() {
  is_raw_ = ::tcgetattr(STDIN_FILENO, &before_) == 0;
  if (is_raw_) {
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  write_to_terminal(begin_of_screen);
}

Screen::~Screen() {
  write_to_terminal(end_of_screen);
  if (is_raw_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void Screen::draw(const std::vector<std::string>& lines) {
  const Size room = size();
  std::string text = "\x1b[H";
  for (std::size_t i = 0; i < lines.size() && i < room.rows; ++i) {
    if (i != 0) text += "\r\n";
    // After a line that fills the last column there is nothing to clear.
    text += columns_of(lines[i]) < room.columns ? lines[i] + "\x1b[K"
                                                : in_columns(lines[i], room.columns);
    text += "\x1b[0m";
  }
  if (lines.size() < room.rows) text += "\x1b[J";
  write_to_terminal(text);
}

void Screen::read_keys() {
  pollfd ready = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (::poll(&ready, 1, 0) != 1) return;
  std::array<char, 64> bytes{};
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count > 0) typed_.append(bytes.data(), static_cast<std::size_t>(count));
}

std::optional<Key> Screen::key() {
  if (typed_.empty()) read_keys();
  if (typed_.empty()) return std::nullopt;
  for (const auto& [text, key] : sequences) {
    if (!typed_.starts_with(text)) continue;
    typed_.erase(0, text.size());
    return key;
  }
  if (const std::size_t unknown = sequence_length(typed_); unknown > 0) {
    typed_.erase(0, unknown);
    return key();
  }
  const char first = typed_.front();
  typed_.erase(0, 1);
  if (first == '\r') return Key::enter;
  if (first == '\b') return Key::backspace;
  return static_cast<Key>(static_cast<unsigned char>(first));
}

std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const std::size_t sequence = sequence_length(text);
    if (sequence == 0) ++columns;
    text.remove_prefix(sequence != 0 ? sequence : character_length(text));
  }
  return columns;
}

std::string in_columns(std::string_view text, std::size_t columns) {
  std::string made;
  std::size_t used = 0;
  const bool is_cut = columns_of(text) > columns;
  while (!text.empty()) {
    const std::size_t sequence = sequence_length(text);
    const std::size_t length = sequence != 0 ? sequence : character_length(text);
    if (is_cut && sequence == 0 && used + 1 == columns) {
      made += ellipsis;
    } else if (sequence != 0 || used < columns) {
      made.append(text.substr(0, length));
    }
    if (sequence == 0) ++used;
    text.remove_prefix(length);
  }
  if (used < columns) made.append(columns - used, ' ');
  return made;
}

std::vector<std::string> in_lines(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  do {
    std::size_t end = 0;
    for (std::size_t used = 0; used < std::max<std::size_t>(columns, 1) && end < text.size();
         ++used)
      end += character_length(text.substr(end));
    const std::size_t blank = end < text.size() ? text.rfind(' ', end) : std::string_view::npos;
    if (blank != std::string_view::npos && blank > 0) end = blank;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  } while (!text.empty());
  return lines;
}

}  // namespace canvoy::tools
