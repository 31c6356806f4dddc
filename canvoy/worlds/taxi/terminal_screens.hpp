// The two displays of the terminal in a taxi: the fare on display 1, position and destination of
// the car on display 2.
//
//     TerminalScreens screens(sabotage);
//     environment.provide(Callback<cia447::TerminalHardware()>::to<&TerminalScreens::hardware>(screens));
//     read_fare(screens.fare())
#pragma once

#include <array>
#include <string>

#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"

namespace canvoy::taxi {

/// Text on a display of the terminal.
struct Screen {
  unsigned holder = 0;  ///< device that holds the display; 0: the car has it
  std::string text;     ///< empty: the display is off, or has none
};

class TerminalScreens {
 public:
  /// `sabotage` must outlive this object.
  explicit TerminalScreens(const Sabotage& sabotage) : sabotage_(sabotage) {}
  TerminalScreens(const TerminalScreens&) = delete;
  TerminalScreens& operator=(const TerminalScreens&) = delete;

  /// The result must not outlive this object.
  cia447::TerminalHardware hardware() { return {.show = callback<&TerminalScreens::show>(*this)}; }
  /// Settings with three lines for position, destination and distance.
  cia447::TerminalSettings settings() {
    return {.display_2 = {.lines = 3, .columns = 16, .characters = 48}};
  }
  /// Clears both displays: call it when the terminal has no power.
  void darken() { screens_ = {}; }

  /// Display 1 and display 2.
  const std::array<Screen, 2>& both() const { return screens_; }
  /// Text of display 1.
  const std::string& fare() const { return screens_[0].text; }
  /// Text of display 2.
  const std::string& place() const { return screens_[1].text; }

 private:
  void show(const cia447::DisplayContent& content) {
    const bool is_first = content.display == cia447::TerminalDisplay::display_1;
    if (is_first && sabotage_.cuts_screen) return;
    screens_[is_first ? 0 : 1] = {content.holder,
                                  content.is_on ? std::string(content.text) : std::string()};
  }

  const Sabotage& sabotage_;
  std::array<Screen, 2> screens_;
};

}  // namespace canvoy::taxi
