// The parts of a terminal, and their states (CiA 447-3, 4.2.9).
#pragma once

#include <cstdint>

namespace canvoy::cia447 {

/// Parts up to the second display are locked as a whole; of an icon display, each icon is locked
/// separately.
enum class TerminalPart : std::uint8_t {
  number_pad,
  function_pad,
  control_pad,
  switch_pad,  ///< of the steering wheel
  emergency_key,
  display_1,
  display_2,
  buzzer,
  warnings,
  icon_display_1,
  icon_display_2
};
inline constexpr unsigned terminal_part_count = 11;  ///< parts, the icon displays included
inline constexpr unsigned lockable_part_count = 7;   ///< parts that are locked as a whole

/// State of a part of the terminal.
enum class PartState : std::uint8_t { working, off, failure, not_available };

}  // namespace canvoy::cia447
