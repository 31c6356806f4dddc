// Controls of a seat, named by the words of its elements, and their positions.
//
//     SeatState seat;
//     seat.set(parse_control("joystick1.x", elements), 12'000);
//     OperatorHardware hardware = seat.inputs();
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "canvoy/devices/cia852/operator_hardware.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::tools {

/// Number of push-buttons or indicators in one byte.
inline constexpr unsigned switches_of_group = 8;

/// A control that an operator moves or presses: `joystick1.x`, `joystick1.b3`, `joystick1.hold-x`,
/// `foot-pedal1`, `foot-pedal1.hold`, `encoder1`, `wheel1`, `push-button-cluster1.b13`.
struct Control {
  enum class Kind : std::uint8_t {
    axis,
    joystick_button,
    joystick_hold,
    foot_pedal,
    foot_pedal_hold,
    encoder,
    wheel,
    push_button
  };
  Kind kind = Kind::axis;
  unsigned element = 1;
  unsigned part = 1;  ///< axis, button or direction, from 1

  friend bool operator==(const Control&, const Control&) = default;
};
/// Throws UsageError if a device with these elements has no such control.
Control parse_control(const std::string& text, const cia852::OperatorEnvironment& elements);

/// Positions of all controls.
class SeatState {
 public:
  /// Sets a control. Positions are limited to 16 bits; a button with 0 is off.
  void set(const Control& control, std::int64_t value);
  /// Turns a control by this many steps: encoders wrap around, wheels stop at their ends.
  void turn(const Control& control, std::int64_t steps);
  cia852::OperatorHardware inputs();

 private:
  std::int16_t axis(unsigned joystick, unsigned axis) const {
    return axes_[cia852::joystick_axis_sub(joystick, axis) - 1];
  }
  std::uint8_t buttons(unsigned joystick) const { return buttons_[joystick - 1]; }
  std::uint8_t holds(unsigned joystick) const { return holds_[joystick - 1]; }
  std::int16_t foot_pedal(unsigned pedal) const { return foot_pedals_[pedal - 1]; }
  bool foot_pedal_holds(unsigned pedal) const { return foot_pedal_holds_[pedal - 1]; }
  std::uint32_t encoder(unsigned encoder) const { return encoders_[encoder - 1]; }
  std::int16_t wheel(unsigned wheel) const { return wheels_[wheel - 1]; }
  std::uint8_t push_buttons(unsigned cluster, unsigned group) const {
    return push_buttons_[cia852::indicators_sub(cluster, group) - 1];
  }

  static constexpr std::size_t groups =
      std::size_t{cia852::push_button_clusters_max} * cia852::groups_of_cluster;
  std::array<std::int16_t, std::size_t{cia852::joysticks_max} * cia852::joystick_axes> axes_{};
  std::array<std::uint8_t, cia852::joysticks_max> buttons_{};
  std::array<std::uint8_t, cia852::joysticks_max> holds_{};
  std::array<std::int16_t, cia852::foot_pedals_max> foot_pedals_{};
  std::array<bool, cia852::foot_pedals_max> foot_pedal_holds_{};
  std::array<std::uint32_t, cia852::encoders_max> encoders_{};
  std::array<std::int16_t, cia852::wheels_max> wheels_{};
  std::array<std::uint8_t, groups> push_buttons_{};
};

}  // namespace canvoy::tools
