// Contents that the displays of a terminal show for add-on devices (CiA 447-3, 6099h, 609Ah,
// 609Eh).
#pragma once

#include <cstdint>
#include <string_view>

namespace canvoy::cia447 {

/// One of the two text displays.
enum class TerminalDisplay : std::uint8_t { display_1, display_2 };

/// Valid during the call. UTF-8 that has room on the display.
struct DisplayContent {
  TerminalDisplay display = TerminalDisplay::display_1;  ///< on which it is
  /// Holder; 0: the car itself, with contents that are not known here.
  unsigned holder = 0;
  bool is_on = true;         ///< false: dark
  std::string_view title{};  ///< display 1 only
  std::string_view text{};   ///< lines are separated as the sender has it
};

}  // namespace canvoy::cia447
