// The hardware of an operator environment (CiA 852), by its elements. A plant, a Linux input device
// or a board implements it; elements are numbered from 1 (5.3).
//
//     OperatorHardware seat = {.joystick_axis = Callback<std::int16_t(unsigned, unsigned)>::to<
//                                  &Seat::axis>(seat_board)};
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia852 {

/// Positions have the full scale of 16 bits. Callbacks of missing elements may be omitted: they
/// read as 0, and show nothing.
struct OperatorHardware {
  /// `axis`: 1 is x, 2 is y, 3 is z.
  Callback<std::int16_t(unsigned joystick, unsigned axis)> joystick_axis = {};
  Callback<std::uint8_t(unsigned joystick)> joystick_buttons =
      {};  ///< bit 0 is button 1 (Figure 4)
  /// Directions in which the position is held: bit 0 is x, 1 is y, 2 is z (Figure 5).
  Callback<std::uint8_t(unsigned joystick)> joystick_memory = {};
  Callback<std::int16_t(unsigned pedal)> foot_pedal = {};  ///< position
  Callback<bool(unsigned pedal)> foot_pedal_memory = {};   ///< true while the position is held
  Callback<std::uint32_t(unsigned encoder)> encoder = {};  ///< position, wraps at 2^32
  Callback<std::int16_t(unsigned wheel)> wheel = {};       ///< position
  /// Eight push-buttons of a cluster: groups count from 1, bit 0 is the first of them.
  Callback<std::uint8_t(unsigned cluster, unsigned group)> push_buttons = {};

  /// Eight indicators of a cluster.
  Callback<void(unsigned cluster, unsigned group, std::uint8_t lit)> show_indicators = {};
  /// Shows a parameter of a display, as its output value.
  Callback<void(unsigned display, unsigned parameter, std::int16_t value)> show_parameter = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(OperatorHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::joystick_axis; } || requires { &Plain::joystick_buttons; } ||
          requires { &Plain::joystick_memory; } || requires { &Plain::foot_pedal; } ||
          requires { &Plain::foot_pedal_memory; } || requires { &Plain::encoder; } ||
          requires { &Plain::wheel; } || requires { &Plain::push_buttons; } ||
          requires { &Plain::show_indicators; } || requires { &Plain::show_parameter; },
      "the class has no member function of OperatorHardware: joystick_axis, joystick_buttons, "
      "joystick_memory, foot_pedal, foot_pedal_memory, encoder, wheel, push_buttons, "
      "show_indicators or show_parameter");
  if constexpr (requires { &Plain::joystick_axis; })
    hardware.joystick_axis = callback<&Plain::joystick_axis>(plain);
  if constexpr (requires { &Plain::joystick_buttons; })
    hardware.joystick_buttons = callback<&Plain::joystick_buttons>(plain);
  if constexpr (requires { &Plain::joystick_memory; })
    hardware.joystick_memory = callback<&Plain::joystick_memory>(plain);
  if constexpr (requires { &Plain::foot_pedal; })
    hardware.foot_pedal = callback<&Plain::foot_pedal>(plain);
  if constexpr (requires { &Plain::foot_pedal_memory; })
    hardware.foot_pedal_memory = callback<&Plain::foot_pedal_memory>(plain);
  if constexpr (requires { &Plain::encoder; }) hardware.encoder = callback<&Plain::encoder>(plain);
  if constexpr (requires { &Plain::wheel; }) hardware.wheel = callback<&Plain::wheel>(plain);
  if constexpr (requires { &Plain::push_buttons; })
    hardware.push_buttons = callback<&Plain::push_buttons>(plain);
  if constexpr (requires { &Plain::show_indicators; })
    hardware.show_indicators = callback<&Plain::show_indicators>(plain);
  if constexpr (requires { &Plain::show_parameter; })
    hardware.show_parameter = callback<&Plain::show_parameter>(plain);
}

}  // namespace canvoy::cia852
