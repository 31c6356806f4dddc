// A whole terminal for one picture that is drawn repeatedly: the alternate screen, keys without
// Enter.
//
//     Screen screen;                 // the terminal is given back when it ends
//     screen.draw(lines);            // those that fit
//     while (const auto key = screen.key()) handle(*key);
#pragma once

#include <termios.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// A character, or one of these.
enum class Key : char32_t {
  enter = '\n',
  escape = 0x1B,
  backspace = 0x7F,
  up = 0x110000,
  down,
  page_up,
  page_down,
  home,
  end,
};

class Screen {
 public:
  struct Size {
    unsigned columns = 80;
    unsigned rows = 24;
    friend bool operator==(const Size&, const Size&) = default;
  };

  /// True if both input and output are terminals.
  static bool is_there();
  /// Present size of the standard output; 80 x 24 if unknown.
  static Size size();

  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Draws the lines, clipped to the screen.
  void draw(const std::vector<std::string>& lines);
  /// The next pressed key, without waiting.
  std::optional<Key> key();

 private:
  void read_keys();

  termios before_{};
  bool is_raw_ = false;
  std::string typed_;
};

/// The text in exactly this many columns: padded with blanks, or clipped, with an ellipsis in the
/// last column. UTF-8; escape sequences for the style of characters take no column.
std::string in_columns(std::string_view text, std::size_t columns);
/// Number of columns of a text.
std::size_t columns_of(std::string_view text);
/// The text in lines of at most this many columns, at least one line: broken behind blanks, and
/// within longer words. UTF-8, without escape sequences.
std::vector<std::string> in_lines(std::string_view text, std::size_t columns);

}  // namespace canvoy::tools
