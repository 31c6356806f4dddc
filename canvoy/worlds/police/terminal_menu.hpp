// A menu of a client on the shared terminal: it takes number pad and display 1 when it is opened,
// and gives them back when it is done, or after a time without a key.
//
//     TerminalMenu menu(network, terminal, title_of(Client::radio));
//     menu.open("status?");
//     menu.finish("status 3", 2s);   // shows it so long
#pragma once

#include <string>
#include <string_view>

#include "canvoy/devices/cia447/terminal/terminal_client.hpp"

namespace canvoy::police {

class TerminalMenu {
 public:
  static constexpr Duration patience = 20s;  ///< time from one key to the next

  /// Both must outlive this object; `title` is that of display 1 while the menu is open.
  TerminalMenu(cia447::CarNetwork& network, cia447::TerminalClient& terminal,
               std::string_view title)
      : network_(network), terminal_(terminal), timer_(callback<&TerminalMenu::expired>(*this)) {
    terminal_.show(cia447::TerminalText::title, title);
  }
  TerminalMenu(const TerminalMenu&) = delete;
  TerminalMenu& operator=(const TerminalMenu&) = delete;

  /// Asks for number pad and display 1, and shows the text.
  void open(std::string_view text) {
    is_open_ = true;
    want(true);
    show(text);
    wait(patience);
  }
  /// True while it accepts keys.
  bool is_open() const { return is_open_; }
  /// Shows a text after a key, and waits for more keys.
  void show(std::string_view text) {
    terminal_.show(cia447::TerminalText::text_1, text);
    wait(patience);
  }
  /// Shows a text for this time, and accepts no more keys.
  void finish(std::string_view text, Duration shown) {
    terminal_.show(cia447::TerminalText::text_1, text);
    is_open_ = false;
    wait(shown);
  }
  /// Gives number pad and display back at once.
  void close() {
    is_open_ = false;
    want(false);
    network_.node().timers().disarm(timer_);
  }

 private:
  void want(bool is_wanted) {
    terminal_.want(cia447::TerminalPart::number_pad, is_wanted);
    terminal_.want(cia447::TerminalPart::display_1, is_wanted);
  }
  void wait(Duration duration) {
    network_.node().timers().arm(timer_, network_.node().now() + duration);
  }
  void expired(Time) { close(); }

  cia447::CarNetwork& network_;
  cia447::TerminalClient& terminal_;
  Timer timer_;
  bool is_open_ = false;
};

}  // namespace canvoy::police
